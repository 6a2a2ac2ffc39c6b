// SPDX-License-Identifier: MIT
// Whether the witness itself is right: its integrator compared with 25 digits, its geometry and its text formats.
#include <QTemporaryDir>
#include <QTest>

#include "case.h"
#include "converge.h"
#include "draw.h"
#include "free_space.h"
#include "integrator/brute_force.h"
#include "split.h"
#include "survey.h"

#include "support/handles.h"

#include <fstream>

namespace {

using namespace witness;

const std::vector<Case> &references() {
    static const std::vector<Case> kReferences = readCases(WITNESS_FOLDER "/references.cases");
    return kReferences;
}

struct Miss {
    Real place = 0;
    Real velocity = 0;
    bool isRestRight = true;
};

support::ScenePtr sceneOf(const std::vector<phys_box> &boxes, double radius) {
    const phys_scene_desc desc = descOf(boxes, radius, {0, 0, radius});
    phys_scene *scene = nullptr;
    phys_scene_create(&desc, &scene, nullptr);
    return support::ScenePtr(scene);
}

/// The largest differences from the samples of a reference.
Miss missOf(const Case &scene, Real tolerance) {
    BruteForce force(scene.boxes, scene.radius, tolerance);
    Motion motion = {vectorOf(scene.start.position), vectorOf(scene.start.velocity), vectorOf(scene.start.spin)};
    Miss miss;
    Real time = 0;
    Real begin = 0;
    for (const Leg &leg : scene.legs) {
        phys_params params = scene.params;
        params.gravity = leg.gravity;
        const Law law = lawOf(params, scene.radius);
        const Real end = begin + leg.dt * leg.steps;
        for (const Sample &sample : scene.samples) {
            if (sample.time <= begin + 1e-12L || sample.time > end + 1e-12L) continue;
            if (!force.run(law, sample.time - time, motion)) return {1, 1, false};
            time = sample.time;
            miss.place = std::max(miss.place, length(motion.place - sample.place));
            miss.velocity = std::max({miss.velocity, length(motion.velocity - sample.velocity),
                                      scene.radius * length(motion.spin - sample.spin)});
            miss.isRestRight = miss.isRestRight && force.isAtRest(law, motion) == sample.isAtRest;
        }
        if (time < end && !force.run(law, end - time, motion)) return {1, 1, false};
        time = begin = end;
    }
    return miss;
}

} // namespace

class Witness : public QObject {
    Q_OBJECT

private slots:
    void bruteForceConvergesToTheReferences_data();
    void bruteForceConvergesToTheReferences();
    void bruteForcePressesWithTheLeastSum_data();
    void bruteForcePressesWithTheLeastSum();
    void bruteForceLetsResistanceSlowABallAlongAWall();
    void bruteForceNeverMakesEnergy();
    void bruteForceFollowsTheMirror();
    void aClosedWallCantBePassed();
    void aWallWithAnEndCanBeWalkedAroundIfThereIsTime();
    void partsOfAStepShowAnErrorOfItsSize_data();
    void partsOfAStepShowAnErrorOfItsSize();
    void aThroatIsPassedWhereOneOfItsThreeContactsEnds();
    void aBallThatLeavesAGapOfItsDiameterHasNoTruth();
    void aCaseReadsBackAsItWasWritten();
    void aWrongLineOfACaseIsNamed();
    void aKnownFaultIsMatchedByItsWords();
    void theSameNumberDrawsTheSameScene();
    void threadsShareTheRunsOfASurvey();
};

void Witness::bruteForceConvergesToTheReferences_data() {
    QTest::addColumn<int>("index");
    for (size_t i = 0; i < references().size(); ++i) QTest::newRow(references()[i].name.c_str()) << int(i);
}

void Witness::bruteForceConvergesToTheReferences() {
    QFETCH(int, index);
    const Case &scene = references()[static_cast<size_t>(index)];
    const Miss coarse = missOf(scene, 1e-7L);
    const Miss fine = missOf(scene, 1e-13L);
    const QByteArray figures = QByteArray::number(double(fine.place)) + " m, " +
                               QByteArray::number(double(fine.velocity)) + " m/s; coarse " +
                               QByteArray::number(double(coarse.place)) + " m";
    QVERIFY2(fine.place < 1e-8L && fine.velocity < 1e-7L, figures);
    QVERIFY2(fine.place <= coarse.place + 1e-9L, figures);
    QVERIFY2(fine.isRestRight, "rest");
}

void Witness::bruteForcePressesWithTheLeastSum_data() {
    QTest::addColumn<double>("spin");
    QTest::addColumn<bool>("isOnFloor");
    QTest::newRow("onto the steep edge") << 20.0 << false;
    QTest::newRow("onto the flat edge") << -20.0 << true;
}

/// A ball spins in a slot whose bottom and smooth edges it touches. Friction of the bottom would drive it onto an edge:
/// onto the steep one, with a sum of pressures 2 % larger than that of the edges alone, which therefore carry it; onto
/// the flat one, with a smaller sum.
void Witness::bruteForcePressesWithTheLeastSum() {
    QFETCH(double, spin);
    QFETCH(bool, isOnFloor);
    constexpr double kRadius = 5.0;
    const std::vector<phys_box> boxes = {
        {{-9, -9, -9}, {9, 9, 0}}, {{-9, -9, 0}, {-1.4, 9, 0.2}}, {{4, -9, 0}, {9, 9, 2}}};
    const Law law{true, kRadius, {0, 0, -10}, 0, 0, 0.5, 0, 0};
    Motion motion = {{0, 0, kRadius}, {0, 0, 0}, {0, spin, 0}};
    BruteForce force(boxes, kRadius);
    QVERIFY(force.run(law, 0.1L, motion));
    QCOMPARE(std::abs(motion.spin.y - spin) > 1e-12L, isOnFloor);
    QVERIFY(length(motion.place - Vector{0, 0, kRadius}) < 1e-12L);
}

/// A ball that rolls on a floor and on the wall that it leans on. Forces between both, which move nothing, could use up
/// all friction of the floor: those are the least.
void Witness::bruteForceLetsResistanceSlowABallAlongAWall() {
    const std::vector<phys_box> boxes = {{{-9, -9, -9}, {9, 9, 0}}, {{-9, 1, 0}, {9, 9, 9}}};
    const Law law{true, 1, {-3, 5, -8}, 0, 0, 0.12L, 0.4L, 0.01L};
    Motion motion = {{0, 0, 1}, {-1, 0, 0}, {0, -1, -1}};
    BruteForce force(boxes, 1);
    QVERIFY(force.run(law, 0.1L, motion));
    const Real acceleration = -5 / 9.0L * (3 - 0.01L * 8); // the spins about both axes add 2/5 to the inertia each
    QVERIFY(std::abs(motion.velocity.x - (-1 + 0.1L * acceleration)) < 1e-12L);
}

/// Over random scenes of all kinds: kinetic and potential energy after each hundredth of a second.
void Witness::bruteForceNeverMakesEnergy() {
    for (size_t kind = 0; kind < kinds().size(); ++kind) {
        if (kinds()[kind] == "overlapping") continue;
        const Case scene = drawSmoothCase(kind, 7, PHYS_MODEL_RIGID);
        phys_params params = scene.params;
        params.gravity = scene.legs[0].gravity;
        const Law law = lawOf(params, scene.radius);
        BruteForce force(scene.boxes, scene.radius);
        Motion motion = {vectorOf(scene.start.position), vectorOf(scene.start.velocity), vectorOf(scene.start.spin)};
        const auto energy = [&] {
            const Real turning = scene.radius * length(motion.spin);
            return dot(motion.velocity, motion.velocity) / 2 + turning * turning / 5 - dot(law.gravity, motion.place);
        };
        Real before = energy();
        for (int i = 0; i < 10; ++i) {
            QVERIFY(force.run(law, 0.01L, motion));
            const Real after = energy();
            QVERIFY2(after <= before + 1e-11L, (scene.name + ": " + std::to_string(double(after - before))).c_str());
            before = after;
        }
    }
}

void Witness::bruteForceFollowsTheMirror() {
    for (size_t kind = 0; kind < kinds().size(); ++kind) {
        if (kinds()[kind] == "overlapping") continue;
        const Case scene = drawSmoothCase(kind, 12, PHYS_MODEL_RIGID);
        Case image = scene;
        for (phys_box &box : image.boxes)
            box = {{-box.max.x, box.min.y, box.min.z}, {-box.min.x, box.max.y, box.max.z}};
        std::reverse(image.boxes.begin(), image.boxes.end());
        Vector ends[2];
        for (const bool isImage : {false, true}) {
            const Case &one = isImage ? image : scene;
            const Real sign = isImage ? -1 : 1;
            phys_params params = scene.params;
            params.gravity = scene.legs[0].gravity;
            params.gravity.x *= double(sign);
            const Vector v = vectorOf(scene.start.velocity);
            const Vector w = vectorOf(scene.start.spin);
            const Vector p = vectorOf(scene.start.position);
            Motion motion = {{sign * p.x, p.y, p.z}, {sign * v.x, v.y, v.z}, {w.x, sign * w.y, sign * w.z}};
            BruteForce force(one.boxes, one.radius);
            QVERIFY(force.run(lawOf(params, one.radius), 0.05L, motion));
            ends[isImage] = {sign * motion.place.x, motion.place.y, motion.place.z};
        }
        const Real off = length(ends[0] - ends[1]);
        QVERIFY2(off < 1e-9L, (scene.name + ": " + std::to_string(double(off))).c_str());
    }
}

void Witness::aClosedWallCantBePassed() {
    const phys_box boxes[] = {{{0, -100, -100}, {0.001, 100, 100}}};
    const FreeSpace space(boxes, 0.5);
    QVERIFY(space.isReachable({-1, 0, 0}, {-2, 3, 0}, 10));
    QVERIFY(!space.isReachable({-1, 0, 0}, {1, 0, 0}, 10));
}

void Witness::aWallWithAnEndCanBeWalkedAroundIfThereIsTime() {
    const phys_box boxes[] = {{{0, -100, -100}, {0.001, 2, 100}}};
    const FreeSpace space(boxes, 0.5);
    QVERIFY(!space.isReachable({-1, 0, 0}, {1, 0, 0}, 2));
    QVERIFY(space.isReachable({-1, 0, 0}, {1, 0, 0}, 3)); // past y = 2.5
}

void Witness::partsOfAStepShowAnErrorOfItsSize_data() {
    QTest::addColumn<bool>("isExact");
    QTest::newRow("exact") << true;
    QTest::newRow("swept") << false;
}

/// A ball that resistance slows down, far from all walls: only the order of the scheme matters.
void Witness::partsOfAStepShowAnErrorOfItsSize() {
    QFETCH(bool, isExact);
    const std::vector<phys_box> floor = {{{-1, -1, -0.02}, {1, 1, 0}}};
    const support::ScenePtr scene = sceneOf(floor, 0.006);
    phys_stepper *created = nullptr;
    QCOMPARE(phys_stepper_create(nullptr, QTest::currentDataTag(), scene.get(), &created, nullptr), PHYS_OK);
    const support::StepperPtr stepper(created);
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.rolling_friction = 0.01;
    params.gravity = {0.3, 0.1, -9.8};
    phys_state state;
    phys_scene_start(scene.get(), &state);
    state.velocity = {0.1, -0.2, 0};
    const std::optional<SplitDifference> difference = splitDifference(stepper.get(), params, 0.1, state, 0.006);
    QVERIFY(difference);
    QCOMPARE(difference->apart <= 1e-15, isExact);
}

void Witness::aThroatIsPassedWhereOneOfItsThreeContactsEnds() {
    Case scene = emptyCase();
    scene.radius = 5;
    scene.boxes = {{{3, -9, 0}, {9, -4, 9}}, {{-9, -9, 0}, {-3, -4, 9}}, {{-9, 5, 0}, {9, 9, 4}}};
    QVERIFY(!passesThroat(scene, {{0, 0, 1}, {0, 0, 2}}));
    QVERIFY(passesThroat(scene, {{0, 0, 1}, {0, 0, 6}}));
    QVERIFY(!passesThroat(scene, {{0, 0, 5}, {0, 0, 6}}));
    scene.boxes[2].min.y = -9; // on one side of the ball
    scene.boxes[2].max.y = -5;
    QVERIFY(!passesThroat(scene, {{0, 0, 1}, {0, 0, 6}}));
}

void Witness::aBallThatLeavesAGapOfItsDiameterHasNoTruth() {
    Case scene = emptyCase();
    scene.radius = 0.006;
    scene.boxes = {{{-1, -1, -0.1}, {1, 1, 0}}, {{-1, 0.006, 0}, {0.01, 1, 0.02}}, {{-1, -1, 0}, {0.01, -0.006, 0.02}}};
    scene.start.position = {0, 0, 0.006};
    scene.start.velocity = {0.2, 0, 0};
    scene.legs = {{{0, 0, -9.8}, 0.04, 1}};
    QVERIFY(Truth::of(scene));
    scene.legs = {{{0, 0, -9.8}, 0.06, 1}};
    QVERIFY(!Truth::of(scene));
}

void Witness::aCaseReadsBackAsItWasWritten() {
    QTemporaryDir folder;
    const std::string path = folder.filePath("a.case").toStdString();
    for (size_t kind = 0; kind < kinds().size(); ++kind) {
        Case scene = drawCase(kind, 3, PHYS_MODEL_RIGID);
        scene.note = "two\nlines";
        scene.check = "energy";
        std::ofstream(path) << textOf(scene);
        const std::vector<Case> read = readCases(path);
        QCOMPARE(read.size(), size_t(1));
        QCOMPARE(textOf(read[0]), textOf(scene));
    }
}

void Witness::aWrongLineOfACaseIsNamed() {
    QTemporaryDir folder;
    const std::string path = folder.filePath("a.case").toStdString();
    std::ofstream(path) << "case a\nradius 0,006\n";
    try {
        readCases(path);
        QFAIL("read a wrong number");
    } catch (const std::runtime_error &error) {
        QCOMPARE(std::string(error.what()), path + ":2: expected a number, found '0,006'");
    }
}

void Witness::aKnownFaultIsMatchedByItsWords() {
    QTemporaryDir folder;
    const std::string path = folder.filePath("known").toStdString();
    std::ofstream(path) << "# comment\nexact * tiles inside floors are solid from above only\n";
    const KnownFaults known(path);
    QVERIFY(known.contain("exact", "rigid", "tiles", "inside"));
    QVERIFY(!known.contain("exact", "rigid", "tiles", "law"));
    QVERIFY(!known.contain("swept", "rigid", "tiles", "inside"));
}

void Witness::threadsShareTheRunsOfASurvey() {
    Plan plan;
    plan.steppers = {"swept"};
    plan.kinds = {0, 1, 2};
    plan.firstSeed = 4;
    plan.runs = 24;
    plan.withLaw = false;
    const Survey alone = survey(plan);
    plan.threads = 3;
    const Survey shared = survey(plan);
    QCOMPARE(alone.runs, uint64_t(24));
    QCOMPARE(alone.nextSeed, uint64_t(8));
    QCOMPARE(shared.runs, alone.runs);
    QCOMPARE(shared.nextSeed, alone.nextSeed);
    for (const auto &[name, row] : alone.rows) {
        QCOMPARE(shared.rows.at(name).steps, row.steps);
        QVERIFY(shared.rows.at(name).byStatus == row.byStatus);
    }
}

void Witness::theSameNumberDrawsTheSameScene() {
    QCOMPARE(textOf(drawCase(2, 5, PHYS_MODEL_RIGID)), textOf(drawCase(2, 5, PHYS_MODEL_RIGID)));
    QVERIFY(textOf(drawCase(2, 5, PHYS_MODEL_RIGID)) != textOf(drawCase(2, 6, PHYS_MODEL_RIGID)));
}

QTEST_GUILESS_MAIN(Witness)
#include "tst_witness.moc"
