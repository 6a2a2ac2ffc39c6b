// SPDX-License-Identifier: MIT
// Each status of physics.h can occur: one way to reach it through the C API, and a check that no status lacks one.
#include "support/experiment.h"
#include "support/failing_allocator.h"
#include "support/stepper_rows.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <stdexcept>
#include <vector>

using namespace support;

namespace {

/// A way to a status: calls that end with it, and the line that goes with it.
struct Way {
    phys_status status;
    std::function<phys_status(phys_error *)> walk;
};

struct NamedStatus {
    phys_status status;
    const char *name;
};

#define STATUS_ROW(name, value, text) {name, #name},
const std::vector<NamedStatus> kStatuses{PHYS_STATUS_LIST(STATUS_ROW)};
#undef STATUS_ROW

phys_status createScene(const SceneBuilder &builder, phys_error *err) {
    ScenePtr scene = builder.build(err);
    return scene ? PHYS_OK : err->status;
}

phys_status loadScene(const char *path, phys_error *err) {
    phys_scene *scene = nullptr;
    const phys_status status = phys_scene_load(path, &scene, err);
    phys_scene_destroy(scene);
    return status;
}

phys_status loadMazeWith(const char *text, phys_error *err) {
    const QTemporaryDir folder;
    QFile file(folder.filePath("maze.txt"));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) < 0) return PHYS_OK;
    file.close();
    return loadScene(file.fileName().toUtf8().constData(), err);
}

phys_status stepWith(Experiment &ball, double dt, phys_error *err) {
    return phys_step(ball.stepper(), &ball.params, dt, &ball.state, &ball.state, nullptr, err);
}

phys_status stepAfter(const std::function<void(Experiment &)> &change, phys_error *err) {
    Experiment ball(openFloor(), PHYS_STEPPER_DEFAULT);
    change(ball);
    return stepWith(ball, 0.01, err);
}

phys_status createSceneWithoutMemory(phys_error *err) {
    const SceneBuilder room = squareRoom(1.0);
    const AllocationsLeft none(0);
    return createScene(room, err);
}

/// Between walls that are closer together than the ball is wide.
phys_status wedge(phys_error *err) {
    Experiment ball(SceneBuilder().ball(0.5).floor(-9, -9, 9, 9).wall(-9, -9, -0.25, 9).wall(0.25, -9, 9, 9),
                    PHYS_STEPPER_DEFAULT);
    return stepWith(ball, 0.01, err);
}

/// From wall to wall so often that any cap is exceeded: with substeps in one stepper, with impacts in the other.
phys_status race(const char *stepper, phys_error *err) {
    Experiment ball(squareRoom(1.0), stepper);
    ball.params.restitution_wall = 1.0;
    ball.setPosition(0.5, 0.5);
    ball.roll(1e6, 0.0);
    return stepWith(ball, 1.0, err);
}

phys_status createStepper(const char *id, const SceneBuilder &builder, phys_error *err) {
    const ScenePtr scene = builder.build(err);
    phys_stepper *stepper = nullptr;
    const phys_status status = phys_stepper_create(nullptr, id, scene.get(), &stepper, err);
    phys_stepper_destroy(stepper);
    return status;
}

RegistryPtr emptyRegistry() {
    phys_registry *registry = nullptr;
    phys_registry_create(&registry, nullptr);
    return RegistryPtr(registry);
}

phys_status stepAPluginThatGivesNan(phys_error *err) {
    const RegistryPtr registry = emptyRegistry();
    if (const phys_status status = phys_registry_load_file(registry.get(), PLUGIN, err)) return status;
    const Experiment ball(openFloor(), PHYS_STEPPER_DEFAULT);
    phys_stepper *created = nullptr;
    if (const phys_status status = phys_stepper_create(registry.get(), "nan", ball.scene(), &created, err))
        return status;
    const StepperPtr stepper(created);
    phys_state state = ball.state;
    return phys_step(stepper.get(), &ball.params, 0.01, &state, &state, nullptr, err);
}

/// The caller's own function, called back during a scan, throws an exception that C code can't handle.
phys_status scanAndThrow(phys_error *err) {
    const auto throwing = [](void *, const char *, phys_status, const char *) { throw std::runtime_error("enough"); };
    return phys_registry_scan(emptyRegistry().get(), PLUGINS, throwing, nullptr, err);
}

std::vector<Way> ways() {
    return {
        {PHYS_OK, [](phys_error *e) { return stepAfter([](Experiment &) {}, e); }},
        {PHYS_ERROR_ARGUMENT, [](phys_error *e) { return loadScene(nullptr, e); }},
        {PHYS_ERROR_RANGE,
         [](phys_error *e) { return stepAfter([](Experiment &ball) { ball.params.restitution_wall = 2.0; }, e); }},
        {PHYS_ERROR_STATE,
         [](phys_error *e) { return stepAfter([](Experiment &ball) { ball.state.orientation[3] = 0.0; }, e); }},
        {PHYS_ERROR_MEMORY, createSceneWithoutMemory},
        {PHYS_ERROR_FILE, [](phys_error *e) { return loadScene("/nowhere/maze.txt", e); }},
        {PHYS_ERROR_SYNTAX, [](phys_error *e) { return loadMazeWith("not a maze\n", e); }},
        {PHYS_ERROR_SCENE, [](phys_error *e) { return createScene(openFloor().ball(0.0), e); }},
        {PHYS_ERROR_UNKNOWN_STEPPER, [](phys_error *e) { return createStepper("leapfrog", openFloor(), e); }},
        {PHYS_ERROR_UNSUPPORTED,
         [](phys_error *e) {
             const ScenePtr scene = openFloor().box({{1, -1, 0}, {2, 1, 0.03125}}).build(e);
             return phys_scene_check_planar(scene.get(), e);
         }},
        {PHYS_ERROR_STUCK, wedge},
        {PHYS_ERROR_SUBSTEP_CAP, [](phys_error *e) { return race("symplectic-euler", e); }},
        {PHYS_ERROR_EVENT_CAP, [](phys_error *e) { return race("swept", e); }},
        {PHYS_ERROR_PLUGIN_REFUSED,
         [](phys_error *e) { return phys_registry_load_file(emptyRegistry().get(), LEVEL, e); }},
        {PHYS_ERROR_PLUGIN_RESULT, stepAPluginThatGivesNan},
        {PHYS_ERROR_INTERNAL, scanAndThrow},
    };
}

/// Names of the statuses that no way leads to.
QByteArrayList withoutAWay(const std::vector<NamedStatus> &statuses) {
    const std::vector<Way> all = ways();
    QByteArrayList names;
    for (const auto &[status, name] : statuses) {
        const auto leadsThere = [status = status](const Way &way) { return way.status == status; };
        if (std::ranges::none_of(all, leadsThere)) names.append(name);
    }
    return names;
}

} // namespace

class EveryStatus : public QObject {
    Q_OBJECT

private slots:
    void isReached_data();
    void isReached();
    void hasAWay() { QCOMPARE(withoutAWay(kStatuses), QByteArrayList()); }
    void wouldBeMissedWithoutAWay();
    void anUnknownIdIsToldWithoutMemory();
};

void EveryStatus::isReached_data() {
    QTest::addColumn<int>("status");
    QTest::addColumn<std::function<phys_status(phys_error *)>>("walk");
    for (const Way &way : ways()) QTest::newRow(phys_status_name(way.status)) << way.status << way.walk;
}

void EveryStatus::isReached() {
    QFETCH(int, status);
    QFETCH(std::function<phys_status(phys_error *)>, walk);
    phys_error error{};
    QCOMPARE(phys_status_name(walk(&error)), phys_status_name(status));
    QCOMPARE(error.status, status);
    QCOMPARE(error.text[0] == '\0', status == PHYS_OK);
}

void EveryStatus::wouldBeMissedWithoutAWay() {
    std::vector<NamedStatus> grown = kStatuses;
    grown.push_back({-16, "PHYS_ERROR_NEW"});
    QCOMPARE(withoutAWay(grown), QByteArrayList{"PHYS_ERROR_NEW"});
}

void EveryStatus::anUnknownIdIsToldWithoutMemory() {
    phys_stepper_info info;
    phys_error error{};
    phys_status status = PHYS_OK;
    {
        const AllocationsLeft none(0);
        status = phys_registry_find(nullptr, "rk5", &info, &error);
    }
    QCOMPARE(status, PHYS_ERROR_UNKNOWN_STEPPER);
    QCOMPARE(QByteArray(error.text), "no stepper has the id 'rk5'; known are " + stepperIds().join(", "));
}

QTEST_GUILESS_MAIN(EveryStatus)
#include "tst_every_status.moc"
