// SPDX-License-Identifier: MIT
// The table of parameter rows: complete, consistent, and the only definition of parameters.
#include "support/compare.h"
#include "support/special_values.h"
#include "support/stepper_rows.h"

#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <cmath>
#include <cstring>
#include <vector>

using namespace support;

namespace {

using RowPtr = const phys_param_row *;

/// The library's rows and those of all built-in steppers.
std::vector<RowPtr> allRows() {
    std::vector<RowPtr> rows;
    uint32_t count = 0;
    const phys_param_row *const first = phys_param_rows(&count);
    for (uint32_t i = 0; i < count; ++i) rows.push_back(first + i);
    for (const QByteArray &id : stepperIds()) {
        phys_stepper_info info;
        phys_registry_find(nullptr, id.constData(), &info, nullptr);
        for (uint32_t i = 0; i < info.row_count; ++i) {
            if (std::find(rows.begin(), rows.end(), info.rows[i]) == rows.end()) rows.push_back(info.rows[i]);
        }
    }
    return rows;
}

phys_params initialParams() {
    phys_params params;
    phys_params_init(&params, sizeof params);
    return params;
}

bool isWhole(const phys_param_row &row) { return row.flags & (PHYS_ROW_CHOICE | PHYS_ROW_SWITCH); }

} // namespace

class TestParameterRows : public QObject {
    Q_OBJECT

private slots:
    void rowIsComplete_data() { addRows(); }
    void rowIsComplete();
    void rangesAreNested_data() { addRows(); }
    void rangesAreNested();
    void rowPointsAtAValueOfItsOwn_data() { addRows(); }
    void rowPointsAtAValueOfItsOwn();
    void valueSetIsTheValueGot_data() { addRows(); }
    void valueSetIsTheValueGot();
    void valueOutOfRangeIsRefusedAndNothingSet_data() { addRows(); }
    void valueOutOfRangeIsRefusedAndNothingSet();
    void idsAreUnique();
    void initGivesEachRowsInitialValue();
    void initialParamsAreValid();
    void checkRefusesWhatSetRefuses();
    void rigidModelWantsRollingFrictionAtMostSlidingFriction();
    void ownRowsBecomeInitialAndTheRestZero_data() { addStepperRows(); }
    void ownRowsBecomeInitialAndTheRestZero();
    void levelBoardHasGravityStraightDown();
    void refusedInitialValueLeavesParamsAlone();
    void tiltKeepsGravitysStrength();
    void tiltIsTheSlopeAlongItsAxis();
    void manyTiltsGiveTheBitsOfEach();
    void oneWrongTiltWritesNothing();

private:
    void addRows();
};

void TestParameterRows::addRows() {
    QTest::addColumn<RowPtr>("row");
    for (const RowPtr row : allRows()) QTest::newRow(row->id) << row;
}

void TestParameterRows::rowIsComplete() {
    QFETCH(RowPtr, row);
    QVERIFY(QRegularExpression("^[a-z][a-z_]*$").match(row->id).hasMatch());
    for (const char *text : {row->label, row->help}) QVERIFY(text && text[0] != '\0' && !std::strchr(text, '\n'));
    QVERIFY(row->unit && row->choices);
    QVERIFY2(std::strstr(row->help, "Default: "), "the help names the default");
    const QList<QByteArray> choices = QByteArray(row->choices).split('\n');
    if (row->flags & PHYS_ROW_CHOICE)
        QCOMPARE(choices.size(), static_cast<qsizetype>(row->max - row->min) + 1);
    else
        QCOMPARE(row->choices, "");
}

void TestParameterRows::rangesAreNested() {
    QFETCH(RowPtr, row);
    QVERIFY(row->min <= row->low && row->low < row->high && row->high <= row->max);
    QVERIFY(row->initial >= row->low && row->initial <= row->high);
    QVERIFY(row->step > 0.0 && row->step <= row->high - row->low);
}

void TestParameterRows::rowPointsAtAValueOfItsOwn() {
    QFETCH(RowPtr, row);
    const size_t size = row->flags & PHYS_ROW_CHOICE ? sizeof(uint32_t) : sizeof(double);
    QVERIFY(row->offset >= offsetof(phys_params, model) && row->offset + size <= sizeof(phys_params));
    QVERIFY(row->offset % size == 0);
    phys_params params = initialParams();
    const phys_params before = params;
    const double other = row->initial == row->max ? row->min : row->max;
    QCOMPARE(phys_param_set(&params, row, other, nullptr), PHYS_OK);
    QVERIFY(std::memcmp(&params, &before, row->offset) == 0);
    const size_t end = row->offset + size;
    const auto bytes = [](const phys_params &p) { return reinterpret_cast<const char *>(&p); };
    QVERIFY(std::memcmp(bytes(params) + end, bytes(before) + end, sizeof params - end) == 0);
}

void TestParameterRows::valueSetIsTheValueGot() {
    QFETCH(RowPtr, row);
    phys_params params = initialParams();
    for (const double value : {row->min, row->low, row->initial, row->high, row->max}) {
        QCOMPARE(phys_param_set(&params, row, value, nullptr), PHYS_OK);
        COMPARE_EXACT(phys_param_get(&params, row), value);
    }
}

void TestParameterRows::valueOutOfRangeIsRefusedAndNothingSet() {
    QFETCH(RowPtr, row);
    std::vector<double> wrong{std::nextafter(row->min, -kInfinity), std::nextafter(row->max, kInfinity), kNaN,
                              kInfinity, -kInfinity};
    if (isWhole(*row)) wrong.push_back(row->min + 0.5);
    for (const double value : wrong) {
        phys_params params = initialParams();
        const phys_params before = params;
        phys_error error;
        QCOMPARE(phys_param_set(&params, row, value, &error), PHYS_ERROR_RANGE);
        QVERIFY2(std::strstr(error.text, row->id), error.text);
        QVERIFY(sameBits(params, before));
    }
}

void TestParameterRows::idsAreUnique() {
    QSet<QByteArray> ids;
    for (const RowPtr row : allRows()) {
        QVERIFY2(!ids.contains(row->id), row->id);
        ids.insert(row->id);
    }
}

void TestParameterRows::initGivesEachRowsInitialValue() {
    const phys_params params = initialParams();
    uint32_t count = 0;
    const phys_param_row *const rows = phys_param_rows(&count);
    for (uint32_t i = 0; i < count; ++i) COMPARE_EXACT(phys_param_get(&params, rows + i), rows[i].initial);
    QCOMPARE(params.options, 0U);
    QCOMPARE(params.reserved, 0U);
    for (const double value : params.stepper) COMPARE_EXACT(value, 0.0);
}

void TestParameterRows::initialParamsAreValid() {
    const phys_params params = initialParams();
    phys_error error;
    QVERIFY2(phys_params_check(&params, &error) == PHYS_OK, error.text);
}

void TestParameterRows::checkRefusesWhatSetRefuses() {
    uint32_t count = 0;
    const phys_param_row *const rows = phys_param_rows(&count);
    for (uint32_t i = 0; i < count; ++i) {
        if (rows[i].flags & PHYS_ROW_CHOICE) continue;
        for (const double value : {std::nextafter(rows[i].max, kInfinity), kNaN}) {
            phys_params params = initialParams();
            std::memcpy(reinterpret_cast<char *>(&params) + rows[i].offset, &value, sizeof value);
            phys_error error;
            QCOMPARE(phys_params_check(&params, &error), PHYS_ERROR_RANGE);
            QVERIFY2(std::strstr(error.text, rows[i].id), error.text);
        }
    }
}

void TestParameterRows::rigidModelWantsRollingFrictionAtMostSlidingFriction() {
    phys_params params = initialParams();
    params.rolling_friction = params.sliding_friction = 0.25;
    params.model = PHYS_MODEL_RIGID;
    QCOMPARE(phys_params_check(&params, nullptr), PHYS_OK);
    params.rolling_friction = std::nextafter(0.25, 1.0);
    QCOMPARE(phys_params_check(&params, nullptr), PHYS_ERROR_RANGE);
    params.model = PHYS_MODEL_ROLLING;
    QCOMPARE(phys_params_check(&params, nullptr), PHYS_OK);
}

void TestParameterRows::ownRowsBecomeInitialAndTheRestZero() {
    QFETCH(QByteArray, stepper);
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(nullptr, stepper.constData(), &info, nullptr), PHYS_OK);
    phys_params params = initialParams();
    for (double &value : params.stepper) value = 7.0;
    QCOMPARE(phys_stepper_info_init_params(&info, &params), PHYS_OK);
    phys_params expected = initialParams();
    for (uint32_t i = 0; i < info.row_count; ++i) {
        QCOMPARE(phys_param_set(&expected, info.rows[i], info.rows[i]->initial, nullptr), PHYS_OK);
    }
    QVERIFY(sameBits(params, expected));
}

void TestParameterRows::refusedInitialValueLeavesParamsAlone() {
    phys_param_row row = *phys_param_rows(nullptr);
    row.offset = offsetof(phys_params, stepper);
    row.initial = row.max + 1.0;
    const phys_param_row *rows[] = {&row};
    phys_stepper_info info{};
    info.rows = rows;
    info.row_count = 1;
    phys_params params = initialParams();
    for (double &value : params.stepper) value = 7.0;
    const phys_params before = params;
    QCOMPARE(phys_stepper_info_init_params(&info, &params), PHYS_ERROR_RANGE);
    QVERIFY(sameBits(params, before));
}

void TestParameterRows::levelBoardHasGravityStraightDown() {
    phys_vec3 gravity;
    QCOMPARE(phys_gravity_from_tilt(0.0, 0.0, 9.81, &gravity), PHYS_OK);
    COMPARE_EXACT(gravity.x, 0.0);
    COMPARE_EXACT(gravity.y, 0.0);
    COMPARE_EXACT(gravity.z, -9.81);
}

void TestParameterRows::tiltKeepsGravitysStrength() {
    for (int i = -6; i <= 6; ++i) {
        for (int j = -6; j <= 6; ++j) {
            phys_vec3 g;
            QCOMPARE(phys_gravity_from_tilt(0.25 * i, 0.25 * j, 9.81, &g), PHYS_OK);
            // Half a dozen roundings, and that of the tangent.
            COMPARE_WITHIN(std::sqrt(g.x * g.x + g.y * g.y + g.z * g.z), 9.81, 9.81 * 16.0 * 0x1p-53);
            QVERIFY(g.z < 0.0);
        }
    }
}

void TestParameterRows::tiltIsTheSlopeAlongItsAxis() {
    phys_vec3 g;
    QCOMPARE(phys_gravity_from_tilt(0.1, -0.2, 9.81, &g), PHYS_OK);
    COMPARE_WITHIN(g.x / -g.z, std::tan(0.1), 0x1p-52);
    COMPARE_WITHIN(g.y / -g.z, -std::tan(0.2), 0x1p-52);
}

void TestParameterRows::manyTiltsGiveTheBitsOfEach() {
    std::vector<double> alongX, alongY, strengths;
    for (int i = -6; i <= 6; ++i) {
        alongX.push_back(0.25 * i);
        alongY.push_back(0.0625 * i * i - 1.0);
        strengths.push_back(i + 6.0);
    }
    std::vector<phys_vec3> found(alongX.size());
    QCOMPARE(phys_gravities_from_tilts(found.size(), alongX.data(), alongY.data(), strengths.data(), found.data()),
             PHYS_OK);
    for (size_t i = 0; i < found.size(); ++i) {
        phys_vec3 expected;
        QCOMPARE(phys_gravity_from_tilt(alongX[i], alongY[i], strengths[i], &expected), PHYS_OK);
        QVERIFY(std::memcmp(&found[i], &expected, sizeof expected) == 0);
    }
    QCOMPARE(phys_gravities_from_tilts(0, nullptr, nullptr, nullptr, nullptr), PHYS_OK);
}

void TestParameterRows::oneWrongTiltWritesNothing() {
    const double tilts[] = {0.1, 0.2, 2.0}, strengths[] = {9.81, 9.81, 9.81};
    phys_vec3 found[3] = {};
    QCOMPARE(phys_gravities_from_tilts(3, tilts, tilts, strengths, found), PHYS_ERROR_ARGUMENT);
    for (const phys_vec3 &gravity : found) COMPARE_EXACT(gravity.z, 0.0);
}

QTEST_GUILESS_MAIN(TestParameterRows)
#include "tst_parameter_rows.moc"
