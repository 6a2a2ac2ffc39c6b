// SPDX-License-Identifier: MIT
// Appendable structs of another size: one shorter than the first version or longer than this one is refused by name.
// tests/gates/abi/check_growth tests that a library whose structs have grown accepts older ones.
#include "support/compare.h"
#include "support/experiment.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace support;

namespace {

using Init = std::function<phys_status(size_t)>;
using Use = std::function<phys_status(uint32_t, phys_error *)>;

phys_status useDescription(uint32_t size, phys_error *error) {
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.struct_size = size;
    phys_scene *scene = nullptr;
    const phys_status status = phys_scene_create(&desc, &scene, error);
    phys_scene_destroy(scene);
    return status;
}

phys_status stepWithParams(uint32_t size, phys_error *error) {
    Experiment ball(openFloor(), PHYS_STEPPER_DEFAULT);
    ball.params.struct_size = size;
    return phys_step(ball.stepper(), &ball.params, 0.01, &ball.state, &ball.state, nullptr, error);
}

phys_status requireWithParams(uint32_t size, phys_error *error) {
    Experiment ball(openFloor(), PHYS_STEPPER_DEFAULT);
    ball.params.struct_size = size;
    phys_requirements unused;
    return phys_stepper_requirements(ball.stepper(), &ball.params, 0.01, &ball.state, &unused, error);
}

phys_status checkParams(uint32_t size, phys_error *error) {
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.struct_size = size;
    return phys_params_check(&params, error);
}

phys_status setParam(uint32_t size, phys_error *error) {
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.struct_size = size;
    return phys_param_set(&params, &phys_param_rows(nullptr)[4], 0.25, error);
}

phys_status stepWithReport(uint32_t size, phys_error *error) {
    Experiment ball(openFloor(), PHYS_STEPPER_DEFAULT);
    ball.report.struct_size = size;
    return phys_step(ball.stepper(), &ball.params, 0.01, &ball.state, &ball.state, &ball.report, error);
}

} // namespace

/// The last members of the structs of version 1.0.
constexpr size_t kFirstDesc = offsetof(phys_scene_desc, start) + sizeof(phys_vec3);
constexpr size_t kFirstParams = offsetof(phys_params, stepper) + PHYS_STEPPER_VALUES * sizeof(double);
constexpr size_t kFirstReport = offsetof(phys_report, energy_scheme) + sizeof(double);

class Appendable : public QObject {
    Q_OBJECT

private slots:
    void initTakesItsSizeOnly_data();
    void initTakesItsSizeOnly();
    void anotherSizeIsRefusedByName_data();
    void anotherSizeIsRefusedByName();
    void anotherSizeIsRefusedWhereThereIsNoLine();
    void aRowBehindTheStructReadsAsItsInitialValue();
    void aRowBehindTheStructIsNotWritten();
};

void Appendable::initTakesItsSizeOnly_data() {
    QTest::addColumn<Init>("init");
    QTest::addColumn<size_t>("size");
    QTest::addColumn<size_t>("first");
    static phys_scene_desc desc;
    static phys_params params;
    static phys_report report;
    QTest::newRow("scene_desc") << Init([](size_t size) { return phys_scene_desc_init(&desc, size); }) << sizeof desc
                                << kFirstDesc;
    QTest::newRow("params") << Init([](size_t size) { return phys_params_init(&params, size); }) << sizeof params
                            << kFirstParams;
    QTest::newRow("report") << Init([](size_t size) { return phys_report_init(&report, size); }) << sizeof report
                            << kFirstReport;
}

void Appendable::initTakesItsSizeOnly() {
    QFETCH(Init, init);
    QFETCH(size_t, size);
    QFETCH(size_t, first);
    QCOMPARE(init(size), PHYS_OK);
    for (const size_t wrong : {size_t{0}, first - 8, first - 1, size + 1, size + 8})
        QCOMPARE(init(wrong), PHYS_ERROR_ARGUMENT);
}

void Appendable::anotherSizeIsRefusedByName_data() {
    QTest::addColumn<Use>("use");
    QTest::addColumn<uint32_t>("size");
    QTest::addColumn<uint32_t>("first");
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("phys_scene_create") << Use(useDescription) << uint32_t(sizeof(phys_scene_desc))
                                       << uint32_t(kFirstDesc) << QByteArray("desc");
    const auto size = static_cast<uint32_t>(sizeof(phys_params));
    QTest::newRow("phys_step, params") << Use(stepWithParams) << size << uint32_t(kFirstParams) << QByteArray("params");
    QTest::newRow("phys_stepper_requirements")
        << Use(requireWithParams) << size << uint32_t(kFirstParams) << QByteArray("params");
    QTest::newRow("phys_params_check") << Use(checkParams) << size << uint32_t(kFirstParams) << QByteArray("params");
    QTest::newRow("phys_param_set") << Use(setParam) << size << uint32_t(kFirstParams) << QByteArray("params");
    QTest::newRow("phys_step, report") << Use(stepWithReport) << uint32_t(sizeof(phys_report)) << uint32_t(kFirstReport)
                                       << QByteArray("report");
}

void Appendable::anotherSizeIsRefusedByName() {
    QFETCH(Use, use);
    QFETCH(uint32_t, size);
    QFETCH(uint32_t, first);
    QFETCH(QByteArray, name);
    QCOMPARE(use(size, nullptr), PHYS_OK);
    for (const uint32_t wrong : {0U, first - 8, size + 8}) {
        phys_error error{};
        QCOMPARE(use(wrong, &error), PHYS_ERROR_ARGUMENT);
        const QByteArray line = name + ".struct_size is " + QByteArray::number(wrong) + "; expected " +
                                QByteArray::number(size) + ": call phys_";
        QVERIFY2(QByteArray(error.text).startsWith(line), error.text);
    }
}

void Appendable::anotherSizeIsRefusedWhereThereIsNoLine() {
    Experiment ball(openFloor(), "rk4");
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(nullptr, "rk4", &info, nullptr), PHYS_OK);
    const phys_params before = ball.params;
    for (const uint32_t wrong : {0U, uint32_t(kFirstParams) - 8, uint32_t(sizeof(phys_params)) + 8, UINT32_MAX}) {
        ball.params.struct_size = wrong;
        ball.params.stepper[0] = 9.0;
        double energy = 7.0;
        QCOMPARE(phys_energy(ball.scene(), &ball.params, &ball.state, &energy), PHYS_ERROR_ARGUMENT);
        QCOMPARE(phys_stepper_info_init_params(&info, &ball.params), PHYS_ERROR_ARGUMENT);
        QVERIFY(energy == 7.0 && ball.params.stepper[0] == 9.0);
    }
    ball.params.struct_size = sizeof(phys_params);
    QCOMPARE(phys_stepper_info_init_params(&info, &ball.params), PHYS_OK);
    QVERIFY(sameBits(ball.params, before));
}

/// Like the row of a member that a later version has appended.
phys_param_row laterRow() {
    phys_param_row row = phys_param_rows(nullptr)[1];
    row.id = "later";
    row.offset = sizeof(phys_params);
    row.initial = 0.25;
    return row;
}

void Appendable::aRowBehindTheStructReadsAsItsInitialValue() {
    phys_params params[2]; // the second one is what would be read
    phys_params_init(&params[0], sizeof params[0]);
    phys_params_init(&params[1], sizeof params[1]);
    const phys_param_row row = laterRow();
    COMPARE_EXACT(phys_param_get(&params[0], &row), 0.25);
}

void Appendable::aRowBehindTheStructIsNotWritten() {
    phys_params params[2];
    phys_params_init(&params[0], sizeof params[0]);
    phys_params_init(&params[1], sizeof params[1]);
    const phys_params behind = params[1];
    const phys_param_row row = laterRow();
    phys_error error{};
    QCOMPARE(phys_param_set(&params[0], &row, 0.5, &error), PHYS_ERROR_ARGUMENT);
    const QByteArray size = QByteArray::number(uint(sizeof params[0]));
    QCOMPARE(QByteArray(error.text),
             "params.struct_size is " + size + "; later needs " + QByteArray::number(uint(sizeof params[0] + 8)));
    QVERIFY(sameBits(params[1], behind));
}

QTEST_GUILESS_MAIN(Appendable)
#include "tst_appendable.moc"
