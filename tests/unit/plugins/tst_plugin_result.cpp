// SPDX-License-Identifier: MIT
// Faults of a plugin's functions end with one status and one line, and the caller's state and report are unchanged.
#include "support/compare.h"

#include <QTest>
#include <cfenv>

#include <physics/physics.h>

#include <array>

using support::sameBits;

namespace {

constexpr double kBallRadius = 0.25;
constexpr double kDt = 0.5;

phys_params defaultParams() {
    phys_params params;
    phys_params_init(&params, sizeof params);
    return params;
}

} // namespace

class PluginResult : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void aGoodResultComesOutAsItIs();
    void aWrongStepIsRefused_data();
    void aWrongStepIsRefused();
    void aGoodReportComesOutAsItIs_data();
    void aGoodReportComesOutAsItIs();
    void theHostPutsTheEnergiesIn();
    void anInputWrittenToStaysAsItWas();
    void paramsWrittenToStayAsTheyWere();
    void theHostRoundsAsBefore();
    void aWrongCreationIsRefused_data();
    void aWrongCreationIsRefused();
    void anExceptionAtDestructionStaysInside();
    void anExceptionOfRequirementsIsRefused();
    void reasonsWithoutAnEndAreEnded();
    void reasonsAreOneLineOfUtf8();
    void unknownStagesAreRefused();
    void requirementsThatAreNotToldAreUnsupported();
    void dtZeroNeverReachesThePlugin();
    void aPluginsStepperIsMarked();

private:
    phys_stepper *stepper(const char *id, phys_error *error = nullptr) const {
        phys_stepper *result = nullptr;
        phys_stepper_create(m_registry, id, m_scene, &result, error);
        return result;
    }

    phys_registry *m_registry = nullptr;
    phys_scene *m_scene = nullptr;
    phys_params m_params = defaultParams();
    phys_state m_start{};
};

void PluginResult::initTestCase() {
    phys_error error{};
    QCOMPARE(phys_registry_create(&m_registry, &error), PHYS_OK);
    QVERIFY2(phys_registry_load_file(m_registry, FIXTURES "/misbehaving/misbehaving.so", &error) == PHYS_OK,
             error.text);
    const phys_box floor{{-10, -10, -1}, {10, 10, 0}};
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.boxes = &floor;
    desc.box_count = 1;
    desc.radius = kBallRadius;
    desc.start = {1, 2, kBallRadius};
    QCOMPARE(phys_scene_create(&desc, &m_scene, &error), PHYS_OK);
    QCOMPARE(phys_scene_start(m_scene, &m_start), PHYS_OK);
}

void PluginResult::cleanupTestCase() {
    phys_scene_destroy(m_scene);
    phys_registry_destroy(m_registry);
}

void PluginResult::aGoodResultComesOutAsItIs() {
    phys_stepper *behaves = stepper("behaves");
    QVERIFY(behaves);
    phys_state expected = m_start;
    expected.position.x += 1.0;
    expected.time = kDt;
    expected.step = 1;
    phys_state out{};
    QCOMPARE(phys_step(behaves, &m_params, kDt, &m_start, &out, nullptr, nullptr), PHYS_OK);
    QVERIFY(sameBits(out, expected));
    phys_stepper_destroy(behaves);
}

void PluginResult::aWrongStepIsRefused_data() {
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("line");

    const auto result = [](const char *id, const QByteArray &line) {
        QTest::newRow(id) << int(PHYS_ERROR_PLUGIN_RESULT) << line;
    };
    result("nan", "the result of plugin stepper 'nan' has a number that isn't finite or beyond 2^100: position (nan, "
                  "2, 0.25), velocity "
                  "(0, 0, 0), spin (0, 0, 0)");
    result("infinity", "the result of plugin stepper 'infinity' has a number that isn't finite or beyond 2^100: "
                       "position (1, 2, 0.25), "
                       "velocity (0, 0, inf), spin (0, 0, 0)");
    result("time-not-advanced",
           "the result of plugin stepper 'time-not-advanced' has time 0 s and step 0; expected 0.5 s and 1");
    result("step-counted-twice",
           "the result of plugin stepper 'step-counted-twice' has time 0.5 s and step 2; expected 0.5 s and 1");
    result("unknown-flags", "the result of plugin stepper 'unknown-flags' has the flags 0x30; known bits are 0xf");
    result("orientation-not-unit", "the result of plugin stepper 'orientation-not-unit' has the orientation (2, 0, 0, "
                                   "1); expected a unit quaternion");
    const QByteArray rest = "' has the flag PHYS_AT_REST and a velocity or spin; expected none of them";
    result("rests-moving", "the result of plugin stepper 'rests-moving" + rest);
    result("rests-spinning", "the result of plugin stepper 'rests-spinning" + rest);
    result("turns-unasked", "the result of plugin stepper 'turns-unasked' has another orientation; expected the same "
                            "without PHYS_OPTION_ORIENTATION");
    const auto reported = [&](const char *id, const QByteArray &what) {
        result(id, QByteArray("plugin stepper '") + id + "' reports " + what);
    };
    reported("too-many-events", "event_count 3; expected at most event_capacity");
    result("own-buffer",
           "plugin stepper 'own-buffer' changed the report's size or its event buffer; expected them untouched");
    reported("nan-in-report", "lost_impact nan; expected a number from 0 to 2^300");
    reported("penetration-negative", "penetration -1; expected a number from 0 to 2^100");
    reported("slip-infinite", "lost_slip -inf; expected a number within +-2^300");
    reported("loses-everything", "lost_impact 1e+308; expected a number from 0 to 2^300");
    reported("impact-gains", "lost_impact -1; expected a number from 0 to 2^300");
    reported("rolling-gains", "lost_rolling -1; expected a number from 0 to 2^300");
    reported("stop-with-a-box", "event 1 with box 0; expected PHYS_NO_BOX");
    reported("passes-the-cap", "substeps 9; expected at most substep_cap");
    reported("event-of-kind-0", "event 1 with kind 0; expected 1 .. 7");
    reported("event-of-kind-99", "event 0 with kind 99; expected 1 .. 7");
    reported("event-of-no-such-box", "event 0 with box 12345; expected one of the scene's");
    reported("impact-without-a-box", "event 0 with box 4294967295; expected one of the scene's");
    const QByteArray moment = "; expected a moment of the step, after those of the events before";
    reported("event-too-late", "event 0 with time 5" + moment);
    reported("event-too-early", "event 0 with time -1" + moment);
    reported("events-out-of-order", "event 1 with time 0.125" + moment);
    reported("event-at-no-time", "event 1 with time nan" + moment);
    reported("event-nowhere", "event 0 with point.y nan; expected a number within +-2^100");
    reported("event-with-a-long-normal", "event 0 with |normal|^2 1.17; expected 1");
    reported("event-with-a-normal-of-no-box", "event 1 with |normal|^2 1.17; expected 0 without a box");
    reported("impact-from-behind", "event 0 with speed_before 3; expected a number below 0, from -2^100 on");
    reported("impact-inwards", "event 0 with speed_after -1; expected a number from 0 to 2^100");
    reported("speed-negative", "event 1 with speed_before -2; expected a number from 0 to 2^100");
    reported("speed-infinite", "event 1 with speed_after inf; expected a number from 0 to 2^100");
    result("throws", "step of plugin stepper 'throws' threw an exception: no reason to go on; expected a status");
    result("throws-number", "step of plugin stepper 'throws-number' threw an exception; expected a status");
    result("positive-status",
           "step of plugin stepper 'positive-status' returned the status 42; expected 0 or a PHYS_ERROR_* code");
    result("unknown-status",
           "step of plugin stepper 'unknown-status' returned the status -4711; expected 0 or a PHYS_ERROR_* code");

    const auto failure = [](const char *id, const QByteArray &line) {
        QTest::newRow(id) << int(PHYS_ERROR_UNSUPPORTED) << line;
    };
    failure(
        "fails-silently",
        "step of plugin stepper 'fails-silently' failed without a reason: this stepper can't do what the scene, the "
        "parameters or the state ask for");
    failure("fails-with-reason", "this scene has no air");
    failure("fails-endlessly", QByteArray(sizeof(phys_error::text) - 1, 'x'));
}

void PluginResult::aWrongStepIsRefused() {
    QFETCH(int, status);
    QFETCH(QByteArray, line);
    phys_stepper *wrong = stepper(QTest::currentDataTag());
    QVERIFY(wrong);
    std::array<phys_event, 2> events{};
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events.data();
    report.event_capacity = events.size();
    report.substeps = 99; // not to be overwritten by a failing step
    const phys_report given = report;

    phys_state state = m_start;
    phys_error error{};
    QCOMPARE(phys_step(wrong, &m_params, kDt, &state, &state, &report, &error), status);
    QCOMPARE(error.status, status);
    QCOMPARE(QByteArray(error.text), line);
    QVERIFY(sameBits(state, m_start));
    QVERIFY(sameBits(report, given));
    // Without an error to write to, the same.
    QCOMPARE(phys_step(wrong, &m_params, kDt, &state, &state, &report, nullptr), status);
    phys_stepper_destroy(wrong);
}

void PluginResult::aGoodReportComesOutAsItIs_data() {
    QTest::addColumn<uint32_t>("events");
    QTest::newRow("good-events") << 2U;
    QTest::newRow("passes-without-a-cap") << 0U;
    QTest::newRow("behaves") << 0U;
}

void PluginResult::aGoodReportComesOutAsItIs() {
    QFETCH(uint32_t, events);
    phys_stepper *good = stepper(QTest::currentDataTag());
    QVERIFY(good);
    std::array<phys_event, 2> buffer{};
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = buffer.data();
    report.event_capacity = buffer.size();
    phys_state out{};
    phys_error error{};
    QVERIFY2(!phys_step(good, &m_params, kDt, &m_start, &out, &report, &error), error.text);
    QCOMPARE(report.event_count, events);
    phys_stepper_destroy(good);
}

void PluginResult::theHostPutsTheEnergiesIn() {
    phys_stepper *claims = stepper("claims-energies");
    QVERIFY(claims);
    phys_report report;
    phys_report_init(&report, sizeof report);
    phys_state out{};
    QCOMPARE(phys_step(claims, &m_params, kDt, &m_start, &out, &report, nullptr), PHYS_OK);
    double energy = 0.0; // of a ball that stands still
    phys_energy(m_scene, &m_params, &m_start, &energy);
    QCOMPARE(report.energy_before, energy);
    QCOMPARE(report.energy_after, energy);
    QCOMPARE(report.energy_scheme, 0.0);
    phys_stepper_destroy(claims);
}

void PluginResult::paramsWrittenToStayAsTheyWere() {
    phys_stepper *wrong = stepper("writes-params");
    QVERIFY(wrong);
    phys_params params = m_params;
    phys_state out{};
    QCOMPARE(phys_step(wrong, &params, kDt, &m_start, &out, nullptr, nullptr), PHYS_OK);
    QVERIFY(sameBits(params, m_params));
    phys_stepper_destroy(wrong);
}

void PluginResult::anInputWrittenToStaysAsItWas() {
    phys_stepper *wrong = stepper("writes-input");
    QVERIFY(wrong);
    const phys_state in = m_start;
    phys_state out{};
    QCOMPARE(phys_step(wrong, &m_params, kDt, &in, &out, nullptr, nullptr), PHYS_OK);
    QVERIFY(sameBits(in, m_start));
    phys_stepper_destroy(wrong);
}

void PluginResult::theHostRoundsAsBefore() {
    phys_stepper *wrong = stepper("rounds-upwards");
    QVERIFY(wrong);
    phys_state out{};
    QCOMPARE(phys_step(wrong, &m_params, kDt, &m_start, &out, nullptr, nullptr), PHYS_OK);
    const int found = std::fegetround();
    std::fesetround(FE_TONEAREST);
    QCOMPARE(found, FE_TONEAREST);
    phys_stepper_destroy(wrong);
}

void PluginResult::aWrongCreationIsRefused_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("throws-at-creation") << QByteArray(
        "create of plugin stepper 'throws-at-creation' threw an exception: std::bad_alloc; expected a status");
    QTest::newRow("garbage-at-creation") << QByteArray(
        "create of plugin stepper 'garbage-at-creation' returned the status 1; expected 0 or a PHYS_ERROR_* code");
}

void PluginResult::aWrongCreationIsRefused() {
    QFETCH(QByteArray, line);
    phys_error error{};
    phys_stepper *untouched = reinterpret_cast<phys_stepper *>(this);
    phys_stepper *const before = untouched;
    QCOMPARE(phys_stepper_create(m_registry, QTest::currentDataTag(), m_scene, &untouched, &error),
             PHYS_ERROR_PLUGIN_RESULT);
    QCOMPARE(QByteArray(error.text), line);
    QCOMPARE(untouched, before);
}

void PluginResult::anExceptionAtDestructionStaysInside() {
    phys_stepper *wrong = stepper("throws-at-destruction");
    QVERIFY(wrong);
    phys_stepper_destroy(wrong);
}

void PluginResult::anExceptionOfRequirementsIsRefused() {
    phys_stepper *wrong = stepper("throws-requirements");
    QVERIFY(wrong);
    phys_requirements requirements{};
    requirements.substeps = 99;
    phys_error error{};
    QCOMPARE(phys_stepper_requirements(wrong, &m_params, kDt, &m_start, &requirements, &error),
             PHYS_ERROR_PLUGIN_RESULT);
    QCOMPARE(error.text, "requirements of plugin stepper 'throws-requirements' threw an exception: I require nothing; "
                         "expected a status");
    QCOMPARE(requirements.substeps, 99U);
    phys_stepper_destroy(wrong);
}

void PluginResult::reasonsWithoutAnEndAreEnded() {
    phys_stepper *wrong = stepper("endless-requirements");
    QVERIFY(wrong);
    phys_requirements requirements{};
    QCOMPARE(phys_stepper_requirements(wrong, &m_params, kDt, &m_start, &requirements, nullptr), PHYS_OK);
    for (const char(&reason)[120] : requirements.reasons) QCOMPARE(qstrlen(reason), 119U);
    phys_stepper_destroy(wrong);
}

void PluginResult::reasonsAreOneLineOfUtf8() {
    phys_stepper *wrong = stepper("odd-requirements");
    QVERIFY(wrong);
    phys_requirements requirements{};
    QCOMPARE(phys_stepper_requirements(wrong, &m_params, kDt, &m_start, &requirements, nullptr), PHYS_OK);
    QCOMPARE(requirements.reasons[0], "one\\ntwo\\xff");
    phys_stepper_destroy(wrong);
}

void PluginResult::unknownStagesAreRefused() {
    phys_stepper *wrong = stepper("unknown-requirements");
    QVERIFY(wrong);
    phys_requirements requirements{};
    phys_error error{};
    QCOMPARE(phys_stepper_requirements(wrong, &m_params, kDt, &m_start, &requirements, &error),
             PHYS_ERROR_PLUGIN_RESULT);
    QCOMPARE(error.text, "requirements of plugin stepper 'unknown-requirements' have the unknown stages 0x40; known "
                         "bits are 0x3f");
    QCOMPARE(requirements.stages, 0U);
    phys_stepper_destroy(wrong);
}

void PluginResult::requirementsThatAreNotToldAreUnsupported() {
    phys_stepper *behaves = stepper("behaves");
    QVERIFY(behaves);
    phys_requirements requirements{};
    phys_error error{};
    QCOMPARE(phys_stepper_requirements(behaves, &m_params, kDt, &m_start, &requirements, &error),
             PHYS_ERROR_UNSUPPORTED);
    QCOMPARE(error.text, "stepper 'behaves' doesn't tell what it requires");
    phys_stepper_destroy(behaves);
}

void PluginResult::dtZeroNeverReachesThePlugin() {
    phys_stepper *wrong = stepper("throws");
    QVERIFY(wrong);
    phys_state out{};
    QCOMPARE(phys_step(wrong, &m_params, 0.0, &m_start, &out, nullptr, nullptr), PHYS_OK);
    QVERIFY(sameBits(out, m_start));
    phys_stepper_destroy(wrong);
}

void PluginResult::aPluginsStepperIsMarked() {
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(m_registry, "behaves", &info, nullptr), PHYS_OK);
    QCOMPARE(info.flags, uint32_t(PHYS_STEPPER_PLUGIN));
    QCOMPARE(info.file, FIXTURES "/misbehaving/misbehaving.so");
    QCOMPARE(phys_registry_find(m_registry, "rk4", &info, nullptr), PHYS_OK);
    QCOMPARE(info.flags & PHYS_STEPPER_PLUGIN, 0U);
    QCOMPARE(info.file, "");
}

QTEST_GUILESS_MAIN(PluginResult)
#include "tst_plugin_result.moc"
