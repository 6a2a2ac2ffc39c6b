// SPDX-License-Identifier: MIT
// A batch gives the same bits as phys_step in a loop, whatever its strides, stop flags and failures.
#include "support/failing_allocator.h"
#include "support/handles.h"
#include "support/random.h"
#include "support/scene_builder.h"
#include "support/stepper_rows.h"

#include <QTest>

#include <cstring>
#include <functional>
#include <vector>

using namespace support;

namespace {

/// A room with an inner wall and no wall on its right, where balls leave it.
ScenePtr openRoom() {
    return SceneBuilder()
        .ball(0.0625)
        .floor(0, 0, 4, 2)
        .wall(-0.25, -0.25, 4, 0)
        .wall(-0.25, 2, 4, 2.25)
        .wall(-0.25, 0, 0, 2)
        .wall(1.5, 0.75, 1.75, 1.25)
        .start(0.5, 0.5)
        .build();
}

/// A floor alone; or tiles with walls, kerbs, low roofs and floating boxes, on a coarse raster: many are flush, and
/// many gaps are as wide as the ball.
ScenePtr clutteredFloor(Random &random) {
    SceneBuilder scene;
    if (random.below(5) == 0) return scene.ball(0.0625).start(0.5, 0.5).floor(0, 0, 4, 2).build();
    scene.ball(0.0625).start(0.5, 0.5).floor(0, 0, 2, 2).floor(2, 0, 4, 2);
    for (const uint32_t count = 4 + random.below(12); scene.boxes().size() < count;) {
        const double x = 0.125 * random.below(30), y = 0.125 * random.below(14);
        const double width = 0.125 * (1 + random.below(6)), depth = 0.125 * (1 + random.below(3));
        const bool isAlongX = random.below(2);
        const double bottoms[] = {0, 0, 0, 0, 0.0625, 0.15}, heights[] = {0.25, 0.25, 0.25, 0.0625, 0.03, 0.1};
        const double bottom = bottoms[random.below(6)], top = bottom + heights[random.below(6)];
        scene.box({{x, y, bottom}, {x + (isAlongX ? width : depth), y + (isAlongX ? depth : width), top}});
    }
    return scene.build();
}

/// A batch and the arrays that it points to, with `padding` bytes between elements.
struct Case {
    uint64_t balls, steps;
    double dt;
    uint32_t stopFlags;
    bool ownParams, hasGravity, gravityPerBall, gravityPerStep, hasPath, hasTally;
    size_t padding;
    uint64_t every;
    std::vector<phys_params> params;
    std::vector<phys_vec3> gravity; // of ball b and step s: [b * steps + s]
    std::vector<phys_state> starts;

    const phys_params &paramsOf(uint64_t ball) const { return params[ownParams ? ball : 0]; }
    const phys_vec3 &gravityOf(uint64_t ball, uint64_t step) const {
        return gravity[(gravityPerBall ? ball * steps : 0) + (gravityPerStep ? step : 0)];
    }
};

struct Results {
    std::vector<phys_state> states, path;
    std::vector<uint64_t> done;
    std::vector<phys_status> statuses;
    std::vector<uint64_t> impacts; ///< if requested
    std::vector<double> energyLost;

    bool operator==(const Results &other) const {
        const auto same = [](const std::vector<phys_state> &a, const std::vector<phys_state> &b) {
            return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
        };
        return same(states, other.states) && same(path, other.path) && done == other.done &&
               statuses == other.statuses && impacts == other.impacts && energyLost == other.energyLost;
    }
};

phys_params drawParams(Random &random, uint32_t model) {
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.model = model;
    params.restitution_wall = random.between(0, 1);
    params.rolling_friction = random.below(3) ? random.between(0, 0.01) : 0.0;
    params.wall_friction = random.below(2) ? random.between(0, 0.5) : 0.0;
    params.options = random.below(2) ? PHYS_OPTION_ORIENTATION : 0;
    if (random.below(12) == 0) params.restitution_wall = 1.5; // not allowed
    return params;
}

phys_vec3 drawGravity(Random &random) {
    const uint32_t kind = random.below(200);
    if (kind == 0) return {0, 0, 2e6};      // not allowed
    if (kind == 1) return {0, 0, 1.0};      // not allowed on the floor
    if (kind == 2) return {NAN, 0.0, -9.8}; // no number
    return {random.between(-2, 2.5), random.between(-2, 2), -9.75};
}

Case draw(Random &random) {
    Case made{};
    made.balls = 1 + random.below(5);
    made.steps = random.below(60);
    made.dt = random.below(10) ? random.between(0.001, 0.03) : 0.0;
    const uint32_t flags[] = {0, PHYS_OUT, PHYS_AT_REST, PHYS_OUT | PHYS_AIRBORNE | PHYS_SLIPPING};
    made.stopFlags = flags[random.below(4)];
    made.ownParams = random.below(2);
    made.hasGravity = random.below(4);
    made.gravityPerBall = random.below(2);
    made.gravityPerStep = random.below(2);
    made.hasPath = random.below(2);
    made.hasTally = random.below(3) == 0;
    made.padding = size_t{8} * random.below(3);
    made.every = 1 + random.below(7);
    const uint32_t model = random.below(2);
    for (uint64_t i = 0; i < made.balls; ++i) made.params.push_back(drawParams(random, model));
    for (uint64_t i = 0; i < made.balls * made.steps + 1; ++i) made.gravity.push_back(drawGravity(random));
    for (uint64_t i = 0; i < made.balls; ++i) {
        phys_state state{};
        state.position = {random.between(0.1, 3.9), random.between(0.1, 1.9), 0.0625};
        state.velocity = {random.between(-1, 3), random.between(-1, 1), 0.0};
        state.orientation[3] = random.below(15) ? 1.0 : 0.5; // 0.5: not a rotation
        state.flags = random.below(15) ? 0 : PHYS_OUT;
        made.starts.push_back(state);
    }
    return made;
}

/// Many balls for a long time under tilts that mostly last: they lean, roll along walls and rest.
Case drawLong(Random &random) {
    Case made{};
    made.balls = 1 + random.below(19);
    made.steps = 150;
    made.dt = random.between(0.002, 0.02);
    made.stopFlags = random.below(3) ? 0 : PHYS_OUT;
    made.hasGravity = made.gravityPerBall = made.gravityPerStep = made.hasPath = true;
    made.hasTally = random.below(4) == 0;
    made.every = 1;
    phys_params params = drawParams(random, random.below(2));
    params.restitution_wall = random.below(2) ? 0.0 : 0.5;
    params.options = 0;
    if (random.below(3) == 0) params.sliding_friction = params.rolling_friction = 0.0;
    made.params = {params};
    phys_vec3 gravity{};
    const uint64_t lasts = random.below(3) ? 50 : 1 + random.below(3); // steps
    for (uint64_t i = 0; i < made.balls * made.steps + 1; ++i) {
        const double strength = random.below(4) ? 1.0 : 0.0;
        if (i % lasts == 0) gravity = {strength * random.between(-2, 2), random.between(-2, 2), -9.75};
        made.gravity.push_back(gravity);
    }
    const double fastest = random.below(3) ? 1.0 : 6.0;
    for (uint64_t i = 0; i < made.balls; ++i) {
        phys_state state{};
        state.position = {0.125 * random.below(30) + 0.0625, 0.125 * random.below(14) + 0.0625, 0.0625};
        if (random.below(2)) state.velocity = {fastest * random.between(-1, 1), fastest * random.between(-1, 1), 0.0};
        if (random.below(4) == 0) state.spin = {0.0, 0.0, random.between(-9, 9)};
        if (random.below(8) == 0) state.time = 0.1; // not the time that its steps took
        state.step = random.below(3);
        state.orientation[3] = 1.0;
        made.starts.push_back(state);
    }
    return made;
}

uint64_t pathLength(const Case &given) { return given.hasPath ? given.steps / given.every : 0; }

/// Initial values of the tallies, to which the batch adds.
constexpr uint64_t kImpactsBefore = 3;
constexpr double kEnergyBefore = 0.25; // J/kg

uint64_t impactsIn(const phys_report &report) {
    const auto isImpact = [](const phys_event &event) { return event.kind == PHYS_EVENT_IMPACT; };
    return report.events_lost +
           static_cast<uint64_t>(std::count_if(report.events, report.events + report.event_count, isImpact));
}

Results stepOneByOne(phys_stepper *stepper, const Case &given) {
    Results results;
    std::vector<phys_event> events(64);
    phys_report report;
    phys_report_init(&report, sizeof report);
    report.events = events.data();
    report.event_capacity = static_cast<uint32_t>(events.size());
    for (uint64_t ball = 0; ball < given.balls; ++ball) {
        phys_state state = given.starts[ball];
        phys_params params = given.paramsOf(ball);
        phys_status status = PHYS_OK;
        uint64_t done = 0, impacts = kImpactsBefore;
        double energyLost = kEnergyBefore;
        std::vector<phys_state> path;
        while (done < given.steps && !(state.flags & given.stopFlags)) {
            if (given.hasGravity) params.gravity = given.gravityOf(ball, done);
            status = phys_step(stepper, &params, given.dt, &state, &state, given.hasTally ? &report : nullptr, nullptr);
            if (status) break;
            ++done;
            impacts += impactsIn(report);
            energyLost += report.lost_impact + report.lost_rolling + report.lost_slip;
            if (given.hasPath && done % given.every == 0) path.push_back(state);
        }
        path.resize(pathLength(given), state);
        results.states.push_back(state);
        results.path.insert(results.path.end(), path.begin(), path.end());
        results.done.push_back(done);
        results.statuses.push_back(status);
        if (!given.hasTally) continue;
        results.impacts.push_back(impacts);
        results.energyLost.push_back(energyLost);
    }
    return results;
}

/// Elements with padding between them.
template<class T>
class Strided {
public:
    Strided(const std::vector<T> &elements, size_t padding)
        : m_count(elements.size())
        , m_stride(sizeof(T) + padding)
        , m_bytes(m_stride * elements.size() + 1) {
        for (size_t i = 0; i < m_count; ++i) std::memcpy(m_bytes.data() + i * m_stride, &elements[i], sizeof(T));
    }
    T *data() { return reinterpret_cast<T *>(m_bytes.data()); }
    size_t stride() const { return m_stride; }
    std::vector<T> elements() const {
        std::vector<T> all(m_count);
        for (size_t i = 0; i < m_count; ++i) std::memcpy(&all[i], m_bytes.data() + i * m_stride, sizeof(T));
        return all;
    }

private:
    size_t m_count, m_stride;
    std::vector<unsigned char> m_bytes;
};

/// run(batch): calls phys_batch_run as often as it likes.
Results runBatch(const Case &given, const std::function<phys_status(phys_batch &)> &run,
                 phys_status *returned = nullptr) {
    Results results;
    Strided<phys_state> states(given.starts, given.padding);
    Strided<phys_params> params(given.params, given.padding);
    results.path.resize(given.balls * pathLength(given));
    results.done.resize(given.balls);
    results.statuses.resize(given.balls, 77);
    if (given.hasTally) {
        results.impacts.resize(given.balls, kImpactsBefore);
        results.energyLost.resize(given.balls, kEnergyBefore);
    }
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.stop_flags = given.stopFlags;
    batch.ball_count = given.balls;
    batch.step_count = given.steps;
    batch.dt = given.dt;
    batch.params = params.data();
    batch.params_stride = given.ownParams ? params.stride() : 0;
    batch.gravity = given.hasGravity ? given.gravity.data() : nullptr;
    batch.gravity_ball_stride = given.gravityPerBall ? given.steps * sizeof(phys_vec3) : 0;
    batch.gravity_step_stride = given.gravityPerStep ? sizeof(phys_vec3) : 0;
    batch.states = states.data();
    batch.states_stride = states.stride();
    batch.path = results.path.empty() ? nullptr : results.path.data();
    batch.path_ball_stride = pathLength(given) * sizeof(phys_state);
    batch.path_every = given.every;
    batch.steps_done = results.done.data();
    batch.statuses = results.statuses.data();
    batch.impacts = given.hasTally ? results.impacts.data() : nullptr;
    batch.energy_lost = given.hasTally ? results.energyLost.data() : nullptr;
    const phys_status status = run(batch);
    if (returned) *returned = status;
    results.states = states.elements();
    return results;
}

/// Invalid parameters that all balls share fail the whole batch.
bool sharedParamsAreWrong(const Case &given) { return !given.ownParams && given.params[0].restitution_wall > 1.0; }

StepperPtr stepperOf(const QByteArray &id, const phys_scene *scene, const phys_registry *registry = nullptr) {
    phys_stepper *stepper = nullptr;
    phys_stepper_create(registry, id, scene, &stepper, nullptr);
    return StepperPtr(stepper);
}

/// Two balls that roll, with nothing wrong.
Case plainCase(uint64_t balls = 2, uint64_t steps = 10) {
    Case made{};
    made.balls = balls;
    made.steps = steps;
    made.dt = 0.01;
    made.every = 1;
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.gravity = {1.0, 0.5, -9.75};
    made.params.assign(balls, params);
    phys_state state{};
    state.position = {0.5, 0.5, 0.0625};
    state.orientation[3] = 1.0;
    made.starts.assign(balls, state);
    return made;
}

using RowPtr = const phys_param_row *;

/// The rows of the library and of the stepper.
std::vector<RowPtr> rowsOf(const QByteArray &stepper) {
    std::vector<RowPtr> rows;
    uint32_t count = 0;
    const phys_param_row *const first = phys_param_rows(&count);
    for (uint32_t i = 0; i < count; ++i) rows.push_back(first + i);
    phys_stepper_info info;
    phys_registry_find(nullptr, stepper.constData(), &info, nullptr);
    rows.insert(rows.end(), info.rows, info.rows + info.row_count);
    return rows;
}

} // namespace

class TestBatch : public QObject {
    Q_OBJECT

private slots:
    void sameBitsAsSingleSteps_data() { addStepperRows(); }
    void sameBitsAsSingleSteps();
    void sameBitsAmongWallsKerbsAndRoofs_data() { addStepperRows(); }
    void sameBitsAmongWallsKerbsAndRoofs();
    void sameBitsWhateverARowIsSetTo_data();
    void sameBitsWhateverARowIsSetTo();
    void rangesTogetherGiveTheWhole();
    void pluginsRunThroughTheirStep();
    void nothingIsAllocated_data() { addStepperRows(); }
    void nothingIsAllocated();
    void batchWithoutTalliesInItIsTaken();
    void noBallsNeedNoStates();
    void wrongBatchIsRefusedAndNothingTouched_data();
    void wrongBatchIsRefusedAndNothingTouched();
    void firstFailureIsToldWhereStatusesAreNotAskedFor();
    void oneStateCannotServeTwoBalls();
};

void TestBatch::sameBitsAsSingleSteps() {
    QFETCH(QByteArray, stepper);
    const ScenePtr scene = openRoom();
    const StepperPtr single = stepperOf(stepper, scene.get());
    const StepperPtr many = stepperOf(stepper, scene.get());
    Random random(testSeed());
    uint64_t failures = 0;
    for (int i = 0; i < 150; ++i) {
        const Case given = draw(random);
        if (sharedParamsAreWrong(given)) continue;
        const Results expected = stepOneByOne(single.get(), given);
        const Results found = runBatch(
            given, [&](phys_batch &batch) { return phys_batch_run(many.get(), &batch, 0, batch.ball_count, nullptr); });
        QVERIFY2(found == expected, qPrintable(QString("case %1 of seed %2").arg(i).arg(testSeed())));
        for (const phys_status status : expected.statuses) failures += status != PHYS_OK;
    }
    QVERIFY(failures > 20); // otherwise the failures weren't tested
}

void TestBatch::sameBitsAmongWallsKerbsAndRoofs() {
    QFETCH(QByteArray, stepper);
    Random random(testSeed());
    for (int i = 0; i < 200; ++i) {
        const ScenePtr scene = clutteredFloor(random);
        QVERIFY(scene);
        const StepperPtr single = stepperOf(stepper, scene.get());
        const StepperPtr many = stepperOf(stepper, scene.get());
        const Case given = drawLong(random);
        const Results expected = stepOneByOne(single.get(), given);
        const Results found = runBatch(
            given, [&](phys_batch &batch) { return phys_batch_run(many.get(), &batch, 0, batch.ball_count, nullptr); });
        QVERIFY2(found == expected, qPrintable(QString("case %1 of seed %2").arg(i).arg(testSeed())));
    }
}

void TestBatch::sameBitsWhateverARowIsSetTo_data() {
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<RowPtr>("row");
    for (const QByteArray &id : stepperIds()) {
        for (const RowPtr row : rowsOf(id)) QTest::addRow("%s, %s", id.constData(), row->id) << id << row;
    }
}

/// The balls roll where nothing is near, so they run in lanes.
void TestBatch::sameBitsWhateverARowIsSetTo() {
    QFETCH(QByteArray, stepper);
    QFETCH(RowPtr, row);
    const ScenePtr scene = openRoom();
    const StepperPtr single = stepperOf(stepper, scene.get());
    const StepperPtr many = stepperOf(stepper, scene.get());
    for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
        Case given = plainCase();
        const bool isWhole = row->flags & (PHYS_ROW_CHOICE | PHYS_ROW_SWITCH);
        const double value = isWhole ? row->high : row->low + 0.25 * (row->high - row->low);
        for (phys_params &params : given.params) {
            params.model = model;
            QCOMPARE(phys_param_set(&params, row, value, nullptr), PHYS_OK);
        }
        for (phys_state &state : given.starts) state.velocity = {0.5, 0.25, 0.0};
        const Results expected = stepOneByOne(single.get(), given);
        const Results found = runBatch(
            given, [&](phys_batch &batch) { return phys_batch_run(many.get(), &batch, 0, batch.ball_count, nullptr); });
        QVERIFY(found == expected);
    }
}

void TestBatch::rangesTogetherGiveTheWhole() {
    const ScenePtr scene = openRoom();
    Random random(testSeed());
    for (int i = 0; i < 50; ++i) {
        const Case given = draw(random);
        if (sharedParamsAreWrong(given)) continue;
        const StepperPtr stepper = stepperOf(PHYS_STEPPER_DEFAULT, scene.get());
        const uint64_t cut = random.below(static_cast<uint32_t>(given.balls) + 1);
        const Results whole = runBatch(given, [&](phys_batch &batch) {
            return phys_batch_run(stepper.get(), &batch, 0, batch.ball_count, nullptr);
        });
        const Results parts = runBatch(given, [&](phys_batch &batch) {
            phys_batch_run(stepper.get(), &batch, cut, batch.ball_count - cut, nullptr);
            return phys_batch_run(stepper.get(), &batch, 0, cut, nullptr);
        });
        QVERIFY2(parts == whole, qPrintable(QString("case %1 of seed %2").arg(i).arg(testSeed())));
    }
}

void TestBatch::pluginsRunThroughTheirStep() {
    phys_registry *made = nullptr;
    QCOMPARE(phys_registry_create(&made, nullptr), PHYS_OK);
    const RegistryPtr registry(made);
    phys_error error{};
    QVERIFY2(phys_registry_load_file(registry.get(), PLUGIN, &error) == PHYS_OK, error.text);
    const ScenePtr scene = openRoom();
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(registry.get(), i, &info) == PHYS_OK; ++i) {
        const bool damagesMemory = QByteArray(info.id).startsWith("writes-beyond");
        if (!(info.flags & PHYS_STEPPER_PLUGIN) || damagesMemory) continue;
        const StepperPtr stepper = stepperOf(info.id, scene.get(), registry.get());
        if (!stepper) continue; // it is expected to fail
        const Case given = plainCase();
        const Results expected = stepOneByOne(stepper.get(), given);
        const Results found = runBatch(given, [&](phys_batch &batch) {
            return phys_batch_run(stepper.get(), &batch, 0, batch.ball_count, nullptr);
        });
        QVERIFY2(found == expected, info.id);
    }
}

void TestBatch::nothingIsAllocated() {
    QFETCH(QByteArray, stepper);
    const ScenePtr scene = openRoom();
    const StepperPtr many = stepperOf(stepper, scene.get());
    phys_status status = PHYS_ERROR_MEMORY;
    runBatch(
        plainCase(3, 200),
        [&](phys_batch &batch) {
            const AllocationsLeft none(0);
            return phys_batch_run(many.get(), &batch, 0, batch.ball_count, nullptr);
        },
        &status);
    QCOMPARE(status, PHYS_OK);
}

// Like programs compiled against a header without `impacts` and later members.
void TestBatch::batchWithoutTalliesInItIsTaken() {
    const ScenePtr scene = openRoom();
    const StepperPtr stepper = stepperOf(PHYS_STEPPER_DEFAULT, scene.get());
    Case given = plainCase();
    const Results expected = stepOneByOne(stepper.get(), given);
    uint64_t behind = 7; // would be written if it were read as a member
    const Results found = runBatch(given, [&](phys_batch &batch) {
        batch.struct_size = offsetof(phys_batch, impacts);
        batch.impacts = &behind;
        return phys_batch_run(stepper.get(), &batch, 0, batch.ball_count, nullptr);
    });
    QVERIFY(found == expected);
    QCOMPARE(behind, uint64_t{7});
}

using Change = std::function<void(phys_batch &, uint64_t &first, uint64_t &count)>;

/// As an empty std::vector has it.
void TestBatch::noBallsNeedNoStates() {
    const ScenePtr scene = openRoom();
    const StepperPtr stepper = stepperOf(PHYS_STEPPER_DEFAULT, scene.get());
    phys_params params;
    phys_params_init(&params, sizeof params);
    phys_batch batch;
    phys_batch_init(&batch, sizeof batch);
    batch.params = &params;
    batch.dt = 0.01;
    batch.step_count = 5;
    phys_error error{};
    QVERIFY2(phys_batch_run(stepper.get(), &batch, 0, 0, &error) == PHYS_OK, error.text);
}

void TestBatch::wrongBatchIsRefusedAndNothingTouched_data() {
    QTest::addColumn<Change>("change");
    QTest::addColumn<QByteArray>("named");
    const auto row = [](const char *name, const char *named, const Change &change) {
        QTest::newRow(name) << change << QByteArray(named);
    };
    row("struct_size", "struct_size", [](phys_batch &b, uint64_t &, uint64_t &) { b.struct_size = 8; });
    row("a longer struct", "struct_size", [](phys_batch &b, uint64_t &, uint64_t &) { b.struct_size += 8; });
    row("states", "states is NULL", [](phys_batch &b, uint64_t &, uint64_t &) { b.states = nullptr; });
    row("params", "params is NULL", [](phys_batch &b, uint64_t &, uint64_t &) { b.params = nullptr; });
    row("dt", "dt is -1", [](phys_batch &b, uint64_t &, uint64_t &) { b.dt = -1; });
    row("dt that is no number", "dt is nan", [](phys_batch &b, uint64_t &, uint64_t &) { b.dt = NAN; });
    row("stop flags", "stop_flags", [](phys_batch &b, uint64_t &, uint64_t &) { b.stop_flags = 0x40; });
    row("first", "the batch has 2", [](phys_batch &, uint64_t &first, uint64_t &) { first = 3; });
    row("count", "the batch has 2", [](phys_batch &, uint64_t &, uint64_t &count) { count = 3; });
    row("first and count that wrap", "the batch has 2", [](phys_batch &, uint64_t &first, uint64_t &count) {
        first = 1;
        count = UINT64_MAX;
    });
    row("states that overlap", "states_stride", [](phys_batch &b, uint64_t &, uint64_t &) { b.states_stride = 64; });
    row("states askew", "states_stride", [](phys_batch &b, uint64_t &, uint64_t &) { b.states_stride = 129; });
    row("params askew", "params_stride", [](phys_batch &b, uint64_t &, uint64_t &) { b.params_stride = 3; });
    row("path without every", "path_every", [](phys_batch &b, uint64_t &, uint64_t &) {
        b.path = b.states;
        b.path_every = 0;
    });
    row("paths that overlap", "path_ball_stride", [](phys_batch &b, uint64_t &, uint64_t &) {
        b.path = b.states;
        b.path_every = 1;
        b.path_ball_stride = 128;
    });
    row("paths longer than memory", "path_ball_stride", [](phys_batch &b, uint64_t &, uint64_t &) {
        b.path = b.states;
        b.path_every = 1;
        b.step_count = (uint64_t{1} << 57) + 1; // times 128 bytes: 128 beyond 2^64
        b.path_ball_stride = 256;
    });
}

void TestBatch::wrongBatchIsRefusedAndNothingTouched() {
    QFETCH(Change, change);
    QFETCH(QByteArray, named);
    const ScenePtr scene = openRoom();
    const StepperPtr stepper = stepperOf(PHYS_STEPPER_DEFAULT, scene.get());
    phys_status status = PHYS_OK;
    phys_error error{};
    const Case given = plainCase();
    const Results found = runBatch(
        given,
        [&](phys_batch &batch) {
            uint64_t first = 0;
            uint64_t count = batch.ball_count;
            change(batch, first, count);
            return phys_batch_run(stepper.get(), &batch, first, count, &error);
        },
        &status);
    QCOMPARE(status, PHYS_ERROR_ARGUMENT);
    QVERIFY2(QByteArray(error.text).contains(named), error.text);
    const Results untouched{given.starts, {}, {0, 0}, {77, 77}, {}, {}};
    QVERIFY(found == untouched);
}

void TestBatch::firstFailureIsToldWhereStatusesAreNotAskedFor() {
    const ScenePtr scene = openRoom();
    const StepperPtr stepper = stepperOf(PHYS_STEPPER_DEFAULT, scene.get());
    Case given = plainCase(3, 5);
    given.ownParams = true;
    given.params[1].restitution_wall = 2.0;
    phys_error error{};
    phys_status status = PHYS_OK;
    const Results found = runBatch(
        given,
        [&](phys_batch &batch) {
            batch.statuses = nullptr;
            return phys_batch_run(stepper.get(), &batch, 0, 3, &error);
        },
        &status);
    QCOMPARE(status, PHYS_ERROR_RANGE);
    QCOMPARE(QString(error.text), QString("ball 1 fails in step 0: restitution_wall is 2; allowed is 0 .. 1"));
    QCOMPARE(found.done, (std::vector<uint64_t>{5, 0, 5}));
}

void TestBatch::oneStateCannotServeTwoBalls() {
    const ScenePtr scene = openRoom();
    const StepperPtr stepper = stepperOf(PHYS_STEPPER_DEFAULT, scene.get());
    for (const uint64_t balls : {1U, 2U}) {
        phys_status status = PHYS_OK;
        runBatch(
            plainCase(balls),
            [&](phys_batch &batch) {
                batch.states_stride = 0;
                return phys_batch_run(stepper.get(), &batch, 0, balls, nullptr);
            },
            &status);
        QCOMPARE(status, balls == 1 ? PHYS_OK : PHYS_ERROR_ARGUMENT);
    }
}

QTEST_GUILESS_MAIN(TestBatch)
#include "tst_batch.moc"
