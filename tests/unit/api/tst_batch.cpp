// SPDX-License-Identifier: MIT
// A batch gives the same bits as phys_step in a loop, whatever its strides, stop flags and failures.
#include "batch_case.h"
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
using namespace batch_case;

namespace {

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

/// Invalid parameters that all balls share fail the whole batch.
bool sharedParamsAreWrong(const Case &given) { return !given.ownParams && given.params[0].restitution_wall > 1.0; }

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
        b.step_count = kMostSteps;
        b.path_ball_stride = 256;
    });
    row("steps", "step_count is 9007199254740993; expected at most 2^53 = 9007199254740992",
        [](phys_batch &b, uint64_t &, uint64_t &) { b.step_count = kMostSteps + 1; });
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
