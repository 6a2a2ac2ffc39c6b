// SPDX-License-Identifier: MIT
// Reading numbers and durations as people write them, and the messages for those that can't be read.
#include "core/setup/inputs.h"
#include "core/setup/numbers.h"

#include <QTest>

#include <cmath>

using namespace inspector;

class TestNumbers : public QObject {
    Q_OBJECT

private slots:
    void durationsAreReadInSeconds_data();
    void durationsAreReadInSeconds();
    void refusedDurationSaysItsUnit();
    void radiansAreThoseThatWereTyped();
    void radiansOfARoundAngleAreItsDegrees();
    void numbersAreReadInTheUnitOfTheirRange_data();
    void numbersAreReadInTheUnitOfTheirRange();
    void whatCantBeReadIsRefusedWithTheReason_data();
    void whatCantBeReadIsRefusedWithTheReason();
    void wholeNumbersHaveNoFraction();
    void wholeNumberIsNoShare();
    void everyCutOfARefusedTextIsReadOrRefusedInOneLine();
    void textOfADurationReadsBackBitByBit();
    void textOfADurationHasAUnitOfItsSize_data();
    void textOfADurationHasAUnitOfItsSize();
};

namespace {

constexpr double kAny = std::numeric_limits<double>::max();

} // namespace

void TestNumbers::durationsAreReadInSeconds_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("seconds");
    QTest::newRow("no unit") << "5" << 5.0;
    QTest::newRow("s") << "5 s" << 5.0;
    QTest::newRow("ms, the double nearest to 0.009") << "9ms" << 0.009;
    QTest::newRow("us") << "5 us" << 5e-6;
    QTest::newRow("micro sign") << QStringLiteral("5 \u00b5s") << 5e-6;
    QTest::newRow("Greek mu") << QStringLiteral("5\u03bcs") << 5e-6;
    QTest::newRow("ns") << "7 ns" << 7e-9;
    QTest::newRow("min") << "2 min" << 120.0;
    QTest::newRow("quotient") << "1/60" << 1.0 / 60.0;
    QTest::newRow("quotient with unit") << "1 / 60 min" << 1.0;
    QTest::newRow("exponent") << "1e-3" << 0.001;
    QTest::newRow("comma") << "0,9 s" << 0.9;
    QTest::newRow("point first") << ".5" << 0.5;
    QTest::newRow("point last") << "5." << 5.0;
    QTest::newRow("plus, spaces") << "  +5  ms " << 0.005;
    QTest::newRow("minus as typeset") << QStringLiteral("\u2212"
                                                        "5 ms")
                                      << -0.005;
    QTest::newRow("space that doesn't break") << QStringLiteral("5\u00a0ms") << 0.005;
}

void TestNumbers::durationsAreReadInSeconds() {
    QFETCH(QString, text);
    QFETCH(double, seconds);
    const NumberReading read = readDuration(text, -kAny, kAny);
    QVERIFY2(read.value, qPrintable(read.problem));
    QVERIFY(*read.value == seconds);
}

void TestNumbers::refusedDurationSaysItsUnit() {
    QCOMPARE(readDuration("20", 1e-6, 10.0).problem,
             QString("expected a duration from 1e-06 s to 10 s (as 5 ms or 1/60), found '20'"));
}

void TestNumbers::radiansAreThoseThatWereTyped() {
    for (const double typed : {0.05, -0.04, 0.1, 0.02, 0.001, -0.2}) {
        const NumberReading read = readNumber(QString::number(typed) + " rad", {-90.0, 90.0, "deg"});
        QVERIFY(read.value);
        QVERIFY2(radians(*read.value) == typed, qPrintable(QString::number(typed)));
    }
}

// Of each tenth of a degree, by both ways to round them.
void TestNumbers::radiansOfARoundAngleAreItsDegrees() {
    for (int tenth = -1800; tenth <= 1800; ++tenth) {
        const double angle = tenth / 10.0;
        for (const double typed : {radians(angle), angle * (3.141592653589793 / 180.0)}) {
            const NumberReading read = readNumber(QString::number(typed, 'g', 17) + " rad", {-kAny, kAny, "deg"});
            QVERIFY(read.value);
            QVERIFY2(*read.value == angle, qPrintable(QString::number(*read.value, 'g', 17)));
        }
    }
}

void TestNumbers::numbersAreReadInTheUnitOfTheirRange_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("value");
    QTest::newRow("degrees") << "3 deg"
                             << "deg" << 3.0;
    QTest::newRow("degree sign") << QStringLiteral("3\u00b0") << "deg" << 3.0;
    QTest::newRow("radians") << "3.141592653589793 rad"
                             << "deg" << 180.0;
    QTest::newRow("mm of metres") << "9 mm"
                                  << "m" << 0.009;
    QTest::newRow("mm/s") << "9 mm/s"
                          << "m/s" << 0.009;
    QTest::newRow("superscript") << QStringLiteral("9.81 m/s\u00b2") << "m/s^2" << 9.81;
    QTest::newRow("quotient") << "1/3"
                              << "" << 1.0 / 3.0;
    QTest::newRow("eighth with comma") << "0,125"
                                       << "" << 0.125;
    QTest::newRow("per cent of nothing else") << "50%"
                                              << "" << 0.5;
    QTest::newRow("per cent of per cent") << "50 %"
                                          << "%" << 50.0;
    QTest::newRow("four places") << "1,0000"
                                 << "" << 1.0;
    QTest::newRow("negative") << "-1e+2"
                              << "" << -100.0;
}

void TestNumbers::numbersAreReadInTheUnitOfTheirRange() {
    QFETCH(QString, text);
    QFETCH(QString, unit);
    QFETCH(double, value);
    const NumberReading read = readNumber(text, {-kAny, kAny, unit});
    QVERIFY2(read.value, qPrintable(read.problem));
    QVERIFY(*read.value == value);
}

void TestNumbers::whatCantBeReadIsRefusedWithTheReason_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("problem"); // after "expected a number from 0 to 10, found "
    QTest::newRow("nothing") << ""
                             << ""
                             << "nothing";
    QTest::newRow("word") << "fast"
                          << ""
                          << "'fast'";
    QTest::newRow("too large") << "11"
                               << ""
                               << "'11'";
    QTest::newRow("too small") << "-1"
                               << ""
                               << "'-1'";
    QTest::newRow("nan") << "NaN"
                         << ""
                         << "'NaN', which isn't a finite number";
    QTest::newRow("infinite") << "-inf"
                              << ""
                              << "'-inf', which isn't a finite number";
    QTest::newRow("two meanings") << "1,000"
                                  << ""
                                  << "'1,000', which can mean two numbers: write a point, or no comma";
    QTest::newRow("beyond doubles") << "1e999"
                                    << ""
                                    << "'1e999', which is beyond what a number can hold";
    QTest::newRow("by zero") << "1/0"
                             << ""
                             << "'1/0', which divides by zero";
    QTest::newRow("two quotients") << "1/2/3"
                                   << ""
                                   << "'1/2/3'";
    QTest::newRow("hexadecimal") << "0x10"
                                 << ""
                                 << "'0x10', where no unit belongs";
    QTest::newRow("two points") << "1.2.3"
                                << ""
                                << "'1.2.3'";
    QTest::newRow("two numbers") << "1 2"
                                 << ""
                                 << "'1 2'";
    QTest::newRow("unit") << "5 ms"
                          << ""
                          << "'5 ms', where no unit belongs";
    QTest::newRow("per cent of a unit") << "5%"
                                        << "s"
                                        << "'5%', whose unit isn't one of: ns us ms s min";
    QTest::newRow("unit of another kind") << "5 m"
                                          << "s"
                                          << "'5 m', whose unit isn't one of: ns us ms s min";
    QTest::newRow("no unit at all") << "5 apples"
                                    << "m/s^2"
                                    << "'5 apples', whose unit isn't m/s\u00b2";
    QTest::newRow("line break") << "1\n2"
                                << ""
                                << "'1\\n2'";
    QTest::newRow("other digits") << QStringLiteral("\u0665") << "" << QStringLiteral("'\u0665'");
}

void TestNumbers::whatCantBeReadIsRefusedWithTheReason() {
    QFETCH(QString, text);
    QFETCH(QString, unit);
    QFETCH(QString, problem);
    const NumberReading read = readNumber(text, {0.0, 10.0, unit});
    QVERIFY(!read.value);
    QCOMPARE(read.problem, QString("expected a number from 0 to 10%1, found %2")
                               .arg(unit.isEmpty() ? "" : " " + printedUnit(unit), problem));
}

void TestNumbers::wholeNumbersHaveNoFraction() {
    QCOMPARE(readWholeNumber("1e3", {1, 1e9}).value, 1000.0);
    QCOMPARE(readWholeNumber("2.5", {1, 1e9}).problem, QString("expected a whole number from 1 to 1e+09, found '2.5'"));
}

void TestNumbers::wholeNumberIsNoShare() {
    QCOMPARE(readWholeNumber("400%", {1, 1e9}).problem,
             QString("expected a whole number from 1 to 1e+09, found '400%', which is a share of something"));
}

// A refusal has no value, and one line that quotes the input.
void TestNumbers::everyCutOfARefusedTextIsReadOrRefusedInOneLine() {
    const QString text = QStringLiteral("-1,5e+3/.5e-1 \u00b5s\n\u202e \u2212nan 1.2.3 \x1b[2J") + QString(100000, '1');
    for (qsizetype begin = 0; begin < 40; ++begin)
        for (qsizetype length = 0; length < 50; ++length) {
            const NumberReading read = readDuration(text.mid(begin, length == 49 ? -1 : length), 1e-6, 10.0);
            QVERIFY(read.value ? std::isfinite(*read.value) : read.problem.startsWith("expected a duration from"));
            QVERIFY(!read.problem.contains('\n') && !read.problem.contains(QChar(0x1b)) && read.problem.size() < 600);
        }
}

void TestNumbers::textOfADurationReadsBackBitByBit() {
    QCOMPARE(durationText(0.005), QString("5 ms"));
    QCOMPARE(durationText(1.0 / 60.0), QString("1/60 s"));
    QCOMPARE(durationText(0.0001), QString("0.1 ms"));
    for (const double seconds : {1e-6, 1.0 / 3.0, 0.1 + 0.2, 2.0 / 3.0, 0.0123456789012345678, 10.0, 1.0 / 44100.0})
        QVERIFY2(readDuration(durationText(seconds), 0.0, kAny).value == seconds, qPrintable(durationText(seconds)));
    for (const double seconds : usualStepSizes())
        QVERIFY2(readDuration(durationText(seconds), 0.0, kAny).value == seconds, qPrintable(durationText(seconds)));
}

void TestNumbers::textOfADurationHasAUnitOfItsSize_data() {
    QTest::addColumn<double>("seconds");
    QTest::addColumn<QString>("text");
    QTest::newRow("us") << 1e-6 << QStringLiteral("1 \u00b5s");
    QTest::newRow("tens of us") << 5e-5 << QStringLiteral("50 \u00b5s");
    QTest::newRow("tenth of a ms") << 1e-4 << "0.1 ms";
    QTest::newRow("ms") << 0.25 << "250 ms";
    QTest::newRow("s") << 10.0 << "10 s";
}

void TestNumbers::textOfADurationHasAUnitOfItsSize() {
    QFETCH(double, seconds);
    QFETCH(QString, text);
    QCOMPARE(durationText(seconds), text);
}

QTEST_GUILESS_MAIN(TestNumbers)
#include "tst_numbers.moc"
