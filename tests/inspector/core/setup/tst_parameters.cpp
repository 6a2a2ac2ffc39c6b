// SPDX-License-Identifier: MIT
// Parameters are generated from rows and nothing else.
#include "core/setup/handles.h"
#include "core/setup/parameters.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace inspector;

class TestParameters : public QObject {
    Q_OBJECT

private slots:
    void rowsAreTheBoardsThenTheLibrarysWithoutInputs();
    void everyValueStartsAtItsRowsInitialOne();
    void everyRowCanBeSetToBothEndsOfItsRange();
    void valueBeyondTheRangeIsRefusedWithOneLineAndChangesNothing();
    void notANumberIsRefused();
    void dashesAndUnderscoresNameTheSameRow();
    void unknownIdIsRefused();
    void severalValuesAreSetTogetherOrNotAtAll();
    void changedIsSentOnceForEachChangedValue();
    void tiltTurnsGravity();
    void gravityStrengthScalesGravity();
    void setValueArrivesInTheInputs();
    void steppersOwnRowsComeAndGo();
};

namespace {

std::vector<phys_param_row> libraryRows() {
    uint32_t count = 0;
    const phys_param_row *rows = phys_param_rows(&count);
    return {rows, rows + count};
}

} // namespace

void TestParameters::rowsAreTheBoardsThenTheLibrarysWithoutInputs() {
    QByteArrayList expected;
    for (const phys_param_row &row : boardRows()) expected += row.id;
    for (const phys_param_row &row : libraryRows())
        if (!(row.flags & PHYS_ROW_INPUT)) expected += row.id;
    const Parameters parameters;
    QByteArrayList found;
    for (int i = 0; i < parameters.count(); ++i) found += parameters.row(i).id;
    QCOMPARE(found, expected);
}

void TestParameters::everyValueStartsAtItsRowsInitialOne() {
    const Parameters parameters;
    for (int i = 0; i < parameters.count(); ++i) {
        QCOMPARE(parameters.value(i), parameters.row(i).initial);
        QVERIFY(parameters.isInitial(i));
    }
}

void TestParameters::everyRowCanBeSetToBothEndsOfItsRange() {
    for (int i = 0; i < Parameters().count(); ++i) {
        Parameters parameters; // a new object, so that no other value interferes
        const phys_param_row &row = parameters.row(i);
        for (const double end : {row.min, row.max}) {
            QString error;
            QVERIFY2(parameters.set(i, end, &error), qPrintable(error));
            QCOMPARE(parameters.value(i), end);
        }
    }
}

void TestParameters::valueBeyondTheRangeIsRefusedWithOneLineAndChangesNothing() {
    Parameters parameters;
    QSignalSpy changed(&parameters, &Parameters::changed);
    for (int i = 0; i < parameters.count(); ++i) {
        QString error;
        const double above = parameters.row(i).max + 1.0;
        if (std::isinf(above) || above == parameters.row(i).max) continue;
        QVERIFY(!parameters.set(i, above, &error));
        QVERIFY2(error.contains(QString::fromUtf8(parameters.row(i).id)), qPrintable(error));
        QVERIFY(!error.contains(QLatin1Char('\n')));
        QVERIFY(parameters.isInitial(i));
    }
    QCOMPARE(changed.count(), 0);
}

void TestParameters::notANumberIsRefused() {
    Parameters parameters;
    for (int i = 0; i < parameters.count(); ++i) {
        QString error;
        QVERIFY(!parameters.set(i, std::nan(""), &error));
        QVERIFY(!error.isEmpty());
        QVERIFY(parameters.isInitial(i));
    }
}

void TestParameters::dashesAndUnderscoresNameTheSameRow() {
    const Parameters parameters;
    QVERIFY(parameters.indexOf("rolling_friction") >= 0);
    QCOMPARE(parameters.indexOf("rolling-friction"), parameters.indexOf("rolling_friction"));
}

void TestParameters::unknownIdIsRefused() {
    Parameters parameters;
    QString error;
    QCOMPARE(parameters.indexOf("colour"), -1);
    QVERIFY(!parameters.set({{"colour", 1.0}}, &error));
    QVERIFY2(error.contains("colour"), qPrintable(error));
    QVERIFY(std::isnan(parameters.value(-1)));
}

void TestParameters::severalValuesAreSetTogetherOrNotAtAll() {
    Parameters parameters;
    QString error;
    QVERIFY(!parameters.set({{"tilt_x", 3.0}, {"rolling_friction", -1.0}}, &error));
    QCOMPARE(parameters.value(parameters.indexOf("tilt_x")), 0.0);
    // Rigid needs rolling_friction <= sliding_friction: each alone would be refused in one of the two orders.
    QVERIFY2(
        parameters.set({{"rolling_friction", 0.9}, {"model", PHYS_MODEL_RIGID}, {"sliding_friction", 0.95}}, &error),
        qPrintable(error));
    QCOMPARE(parameters.inputs().params.rolling_friction, 0.9);
}

void TestParameters::changedIsSentOnceForEachChangedValue() {
    Parameters parameters;
    QSignalSpy changed(&parameters, &Parameters::changed);
    const int tilt = parameters.indexOf("tilt_x");
    QVERIFY(parameters.set(tilt, 2.0));
    QVERIFY(parameters.set(tilt, 2.0)); // no change
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].toInt(), tilt);
    QCOMPARE(changed[0][1].toDouble(), 2.0);
}

void TestParameters::tiltTurnsGravity() {
    Parameters parameters;
    QVERIFY(parameters.set({{"tilt_x", 5.0}, {"tilt_y", -3.0}}));
    const Inputs inputs = parameters.inputs();
    phys_vec3 expected;
    phys_gravity_from_tilt(inputs.tilt.x, inputs.tilt.y, 9.81, &expected);
    QCOMPARE(degrees(inputs.tilt.x), 5.0);
    QCOMPARE(degrees(inputs.tilt.y), -3.0);
    QCOMPARE(inputs.params.gravity.x, expected.x);
    QCOMPARE(inputs.params.gravity.y, expected.y);
    QCOMPARE(inputs.params.gravity.z, expected.z);
    QVERIFY(inputs.params.gravity.x > 0.0 && inputs.params.gravity.y < 0.0);
}

void TestParameters::gravityStrengthScalesGravity() {
    Parameters parameters;
    QVERIFY(parameters.set({{"gravity", 1.62}}));
    QCOMPARE(parameters.inputs().params.gravity.z, -1.62);
}

void TestParameters::setValueArrivesInTheInputs() {
    Parameters parameters;
    QVERIFY(parameters.set({{"restitution_wall", 0.25}}));
    QCOMPARE(parameters.inputs().params.restitution_wall, 0.25);
}

void TestParameters::steppersOwnRowsComeAndGo() {
    phys_param_row own = boardRows()[0];
    own.id = "own_value";
    own.min = own.low = 1.0;
    own.initial = 2.0;
    const phys_param_row *rows[] = {&own};
    phys_stepper_info info{};
    info.rows = rows;
    info.row_count = 1;

    Parameters parameters;
    const int common = parameters.count();
    QSignalSpy rowsChanged(&parameters, &Parameters::rowsChanged);
    parameters.setStepper(info);
    QCOMPARE(parameters.count(), common + 1);
    QCOMPARE(parameters.indexOf("own_value"), common);
    QCOMPARE(parameters.value(common), 2.0);
    QVERIFY(parameters.set(common, 3.0));
    QCOMPARE(parameters.inputs().params.stepper[0], 3.0);
    QCOMPARE(parameters.value(parameters.indexOf("tilt_x")), 0.0); // its own store, although the offset is the same

    parameters.setStepper(phys_stepper_info{});
    QCOMPARE(parameters.count(), common);
    QCOMPARE(parameters.inputs().params.stepper[0], 0.0);
    QCOMPARE(rowsChanged.count(), 2);
}

QTEST_GUILESS_MAIN(TestParameters)
#include "tst_parameters.moc"
