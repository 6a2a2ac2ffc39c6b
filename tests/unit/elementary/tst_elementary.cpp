// SPDX-License-Identifier: MIT
// The elementary functions compared with references.txt, which references.py computes with mpmath, and identities.
#include "unit/elementary/functions.h"

#include <QtTest>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

namespace fn = phys::elementary;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

struct Reference {
    std::string function;
    double x, y, nearest, lacks; ///< the exact value is `nearest` and `lacks` units in its last place
};

double number(std::istream &in) { // streams don't read hexadecimal numbers
    std::string word;
    in >> word;
    return std::strtod(word.c_str(), nullptr);
}

std::vector<Reference> references() {
    std::ifstream file(ELEMENTARY_REFERENCES);
    std::vector<Reference> all;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream in(line);
        Reference reference{};
        in >> reference.function;
        for (double *value : {&reference.x, &reference.y, &reference.nearest, &reference.lacks}) *value = number(in);
        all.push_back(reference);
    }
    return all;
}

/// One unit in the last place.
double unitOf(double value) { return std::ldexp(1.0, std::max(std::ilogb(std::abs(value)) - 52, -1074)); }

double distance(double got, const Reference &reference) {
    if (got == reference.nearest) return std::abs(reference.lacks);
    return std::abs((got - reference.nearest) / unitOf(reference.nearest) - reference.lacks);
}

bool isNegativeZero(double value) { return value == 0.0 && std::signbit(value); }

} // namespace

class ElementaryTest : public QObject {
    Q_OBJECT

private slots:
    void isWithinOneUnitOfTheExactValue_data() {
        QTest::addColumn<std::string>("function");
        for (const elementary::Function &function : elementary::kFunctions) {
            QTest::newRow(function.name.data()) << std::string(function.name);
        }
    }
    void isWithinOneUnitOfTheExactValue() {
        QFETCH(std::string, function);
        int count = 0;
        for (const Reference &reference : references()) {
            if (reference.function != function) continue;
            ++count;
            const double got = elementary::find(function)->at(reference.x, reference.y);
            QVERIFY2(distance(got, reference) <= 1.0, qPrintable(QStringLiteral("of %1, %2: %3 units off")
                                                                     .arg(reference.x, 0, 'g', 17)
                                                                     .arg(reference.y, 0, 'g', 17)
                                                                     .arg(distance(got, reference))));
        }
        QVERIFY(count > 40);
    }

    void oddFunctionsAreOddToTheLastBit() {
        std::mt19937_64 engine(1);
        std::uniform_real_distribution<double> angle(-10.0, 10.0);
        for (int i = 0; i < 10000; ++i) {
            const double x = angle(engine), y = angle(engine);
            QCOMPARE(fn::sin(-x), -fn::sin(x));
            QCOMPARE(fn::cos(-x), fn::cos(x));
            QCOMPARE(fn::atan2(-x, y), -fn::atan2(x, y));
            QCOMPARE(fn::hypot(x, y), fn::hypot(-y, x));
        }
    }

    void zerosKeepTheirSigns() {
        QVERIFY(isNegativeZero(fn::sin(-0.0)));
        QVERIFY(isNegativeZero(fn::expm1(-0.0)));
        QVERIFY(isNegativeZero(fn::log1p(-0.0)));
        QVERIFY(isNegativeZero(fn::atan2(-0.0, 1.0)));
        QCOMPARE(fn::atan2(-0.0, -1.0), -M_PI);
        QCOMPARE(fn::atan2(0.0, -0.0), M_PI);
    }

    void endsOfTheRangeAreAsInC() {
        QCOMPARE(fn::exp(std::nextafter(0x1.62e42fefa39efp9, kInfinite)), kInfinite);
        QCOMPARE(fn::exp(-746.0), 0.0);
        QCOMPARE(fn::exp(-kInfinite), 0.0);
        QCOMPARE(fn::exp(0.0), 1.0);
        QCOMPARE(fn::expm1(-kInfinite), -1.0);
        QCOMPARE(fn::log(0.0), -kInfinite);
        QCOMPARE(fn::log(1.0), 0.0);
        QVERIFY(std::isnan(fn::log(-1.0)));
        QCOMPARE(fn::log1p(-1.0), -kInfinite);
        QVERIFY(std::isnan(fn::log1p(-2.0)));
        QCOMPARE(fn::root(0.0, 3), 0.0);
        QVERIFY(std::isnan(fn::sin(2.0 * fn::kLargestAngle)));
        QCOMPARE(fn::hypot(kInfinite, 1.0), kInfinite);
        QCOMPARE(fn::hypot(0.0, -3.0), 3.0);
        for (const elementary::Function &function : elementary::kFunctions)
            QVERIFY(std::isnan(function.at(kNotANumber, 2.0)));
    }
};

QTEST_GUILESS_MAIN(ElementaryTest)
#include "tst_elementary.moc"
