// SPDX-License-Identifier: MIT
// Messages equal those of snprintf in the C locale, and numbers are read like from_chars does.
#include "base/text.h"

#include <QtTest>

#include <bit>
#include <cstdio>
#include <limits>
#include <random>

class TextTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAreWrittenAsSnprintfDoes() {
        std::mt19937_64 engine(1);
        char ours[100], theirs[100];
        for (int i = 0; i < 20000; ++i) {
            const uint64_t bits = engine();
            const double number = i % 2 ? std::bit_cast<double>(bits) : static_cast<double>(int64_t(bits)) * 0x1p-40;
            const int whole = static_cast<int>(bits);
            if (std::isnan(number)) continue;
            const char *format = "%g|%.9g|%d|%u|%x|%02x|%llu|%llx|%zu|%c|%%";
            const auto write = [&](auto function, char *out) {
                function(out, sizeof ours, format, number, number, whole, whole, whole, whole & 0xff,
                         static_cast<unsigned long long>(bits), static_cast<unsigned long long>(bits), size_t(bits),
                         'a' + i % 26);
            };
            write([](char *out, size_t size, const char *f, auto... part) { phys::writeText(out, size, f, part...); },
                  ours);
            write([](char *out, size_t size, const char *f, auto... part) { std::snprintf(out, size, f, part...); },
                  theirs);
            QCOMPARE(ours, theirs);
        }
    }

    void stringsAreCutAtTheirPrecision() {
        char text[40];
        phys::writeText(text, sizeof text, "'%.*s' '%.3s' '%s'", 2, "wall", "maze", "ball");
        QCOMPARE(text, "'wa' 'maz' 'ball'");
        phys::writeText(text, sizeof text, "'%.*s'", 0, std::string_view().data());
        QCOMPARE(text, "''");
    }

    void whatFindsNoRoomIsCutBetweenCharacters_data() {
        QTest::addColumn<int>("size");
        QTest::addColumn<QByteArray>("expected");
        const QByteArray text = "aλ€𝄞b"; // of 1, 2, 3, 4 and 1 bytes
        for (int size = 1; size <= text.size() + 1; ++size) {
            const int room = size - 1;
            const int whole = room < 1 ? 0 : room < 3 ? 1 : room < 6 ? 3 : room < 10 ? 6 : room < 11 ? 10 : 11;
            QTest::addRow("%d bytes", size) << size << text.left(whole);
        }
    }
    void whatFindsNoRoomIsCutBetweenCharacters() {
        QFETCH(int, size);
        QFETCH(QByteArray, expected);
        char text[20];
        phys::writeText(text, static_cast<size_t>(size), "%s", "aλ€𝄞b");
        QCOMPARE(QByteArray(text), expected);
    }

    void whatIsNotVisibleIsShownByItsBytes_data() {
        QTest::addColumn<QByteArray>("given");
        QTest::addColumn<QByteArray>("shown");
        const auto row = [](const char *name, const QByteArray &given, const QByteArray &shown) {
            QTest::newRow(name) << given << shown;
        };
        row("letters of any script", "Käse λ€𝄞", "Käse λ€𝄞");
        row("ends of lines", "a\nb\r\tc", "a\\nb\\r\\tc");
        row("colours of a terminal", "\x1b[31m", "\\x1b[31m");
        row("a control character of two bytes", "\xc2\x9b", "\\xc2\\x9b");
        row("the end of a line in Unicode", "\xe2\x80\xa8", "\\xe2\\x80\\xa8");
        row("Latin-1", "K\xe4se", "K\\xe4se");
        row("half a character", "\xe2\x82", "\\xe2\\x82");
        row("a long form", "\xc0\xaf", "\\xc0\\xaf");
        row("a surrogate", "\xed\xa0\x80", "\\xed\\xa0\\x80");
        row("a backslash", "a\\n", "a\\n");
    }
    void whatIsNotVisibleIsShownByItsBytes() {
        QFETCH(QByteArray, given);
        QFETCH(QByteArray, shown);
        char text[80];
        phys::writeText(text, sizeof text, "'%s'", given.constData());
        QCOMPARE(QByteArray(text), "'" + shown + "'");
    }

    void whatIsNoNumberIsNamed() {
        char text[40];
        phys::writeText(text, sizeof text, "%g %g", std::numeric_limits<double>::quiet_NaN(),
                        -std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(text, "nan nan");
    }

    void numbersAreReadBackToTheLastBit() {
        std::mt19937_64 engine(2);
        char text[40];
        for (int i = 0; i < 20000; ++i) {
            const double number = std::bit_cast<double>(engine());
            if (!std::isfinite(number)) continue;
            phys::writeText(text, sizeof text, "%.17g", number);
            double read = 0.0;
            QVERIFY2(phys::parseNumber(text, read), text);
            QCOMPARE(std::bit_cast<uint64_t>(read), std::bit_cast<uint64_t>(number));
        }
    }

    void allDigitsAreTheFewestThatReadBack_data() {
        QTest::addColumn<double>("number");
        QTest::addColumn<QByteArray>("expected");
        const auto row = [](double number, const char *expected) {
            QTest::newRow(expected) << number << QByteArray(expected);
        };
        row(0.1, "0.1");
        row(-1e9, "-1e+09");
        row(1e6, "1000000");
        row(1.0000000001e9, "1000000000.1");
        row(0x1.0000000000001p0, "1.0000000000000002");
        row(1.0 / 60.0, "0.016666666666666666");
    }
    void allDigitsAreTheFewestThatReadBack() {
        QFETCH(double, number);
        QFETCH(QByteArray, expected);
        char text[40];
        phys::writeText(text, sizeof text, "%.17g", number);
        QCOMPARE(QByteArray(text), expected);
    }

    void whatIsNoNumberIsRefused_data() {
        QTest::addColumn<QByteArray>("word");
        for (const char *word : {"", "+1", "1e", "e5", "0x10", "inf", "nan", "1,5", " 1", "1 ", "1.5.2", "--1", "1e999",
                                 "1e-999", ".", "-", "1d3"}) {
            QTest::addRow("'%s'", word) << QByteArray(word);
        }
    }
    void whatIsNoNumberIsRefused() {
        QFETCH(QByteArray, word);
        double number = 7.0;
        QVERIFY(!phys::parseNumber({word.constData(), static_cast<size_t>(word.size())}, number));
        QCOMPARE(number, 7.0);
    }
};

QTEST_GUILESS_MAIN(TextTest)
#include "tst_text.moc"
