// SPDX-License-Identifier: MIT
// Lets the first, second, third ... allocation of every allocating function fail, until it succeeds: the function
// reports the failure, leaves its output unchanged and leaks no memory.
#include "support/failing_allocator.h"

#include <QTest>

#include <physics/physics.h>

#include <functional>
#include <vector>

namespace {

/// create(err) makes something or fails; destroy frees it.
struct Maker {
    std::function<phys_status(phys_error *)> create;
    std::function<void()> destroy;
    std::function<bool()> isUntouched;
};

phys_status createWith(long allocations, const Maker &maker, phys_error *error) {
    const support::AllocationsLeft left(allocations);
    return maker.create(error);
}

/// The number of allocations that it needed; negative: minus the number of the failing one that was handled wrongly.
long allocationsUntilSuccess(const Maker &maker, QByteArray &problem) {
    for (long allowed = 0; allowed < 100000; ++allowed) {
        phys_error error{};
        const long before = support::liveBlocks();
        const phys_status status = createWith(allowed, maker, &error);
        if (status == PHYS_OK) {
            maker.destroy();
            return allowed;
        }
        if (status != PHYS_ERROR_MEMORY)
            problem = QByteArray("ends with ") + phys_status_name(status);
        else if (error.status != status || !error.text[0])
            problem = "says nothing";
        else if (support::liveBlocks() != before)
            problem = "loses memory";
        else if (!maker.isUntouched())
            problem = "touches its output";
        if (!problem.isEmpty()) return -allowed;
    }
    problem = "never succeeds";
    return -1;
}

/// Boxes enough for grids, merging and several allocations of each vector.
std::vector<phys_box> rowsOfWalls() {
    std::vector<phys_box> boxes{{{0, 0, -1}, {50, 50, 0}}, {{50, 0, -1}, {100, 50, 0}}};
    for (int i = 0; i < 40; ++i) boxes.push_back({{2.0 * i, 10, 0}, {2.0 * i + 1, 20, 2}});
    return boxes;
}

} // namespace

class OutOfMemory : public QObject {
    Q_OBJECT

private slots:
    void creatingAScene();
    void loadingALevel();
    void creatingARegistry();
    void loadingAPlugin();
    void scanningAFolder();
    void creatingAStepper_data();
    void creatingAStepper();
    void steppingAllocatesNothing_data();
    void steppingAllocatesNothing();

private:
    static void listSteppers();
};

void OutOfMemory::creatingAScene() {
    const std::vector<phys_box> boxes = rowsOfWalls();
    phys_scene_desc desc;
    phys_scene_desc_init(&desc, sizeof desc);
    desc.boxes = boxes.data();
    desc.box_count = static_cast<uint32_t>(boxes.size());
    desc.radius = 0.5;
    desc.start = {1, 1, 0.5};
    phys_scene *scene = nullptr;
    QByteArray problem;
    const long count = allocationsUntilSuccess({[&](phys_error *err) { return phys_scene_create(&desc, &scene, err); },
                                                [&] { phys_scene_destroy(scene); }, [&] { return !scene; }},
                                               problem);
    QVERIFY2(problem.isEmpty(), problem + " at allocation " + QByteArray::number(-count));
    QVERIFY(count > 10);
}

void OutOfMemory::loadingALevel() {
    phys_scene *scene = nullptr;
    QByteArray problem;
    const long count = allocationsUntilSuccess({[&](phys_error *err) { return phys_scene_load(LEVEL, &scene, err); },
                                                [&] { phys_scene_destroy(scene); }, [&] { return !scene; }},
                                               problem);
    QVERIFY2(problem.isEmpty(), problem + " at allocation " + QByteArray::number(-count));
    QVERIFY(count > 10);
}

void OutOfMemory::creatingARegistry() {
    phys_registry *registry = nullptr;
    QByteArray problem;
    const long count = allocationsUntilSuccess({[&](phys_error *err) { return phys_registry_create(&registry, err); },
                                                [&] { phys_registry_destroy(registry); }, [&] { return !registry; }},
                                               problem);
    QVERIFY2(problem.isEmpty(), problem + " at allocation " + QByteArray::number(-count));
    QVERIFY(count > 0);
}

void OutOfMemory::loadingAPlugin() {
    phys_registry *registry = nullptr;
    QCOMPARE(phys_registry_create(&registry, nullptr), PHYS_OK);
    const uint32_t builtIn = phys_registry_count(registry);
    QByteArray problem;
    const long count =
        allocationsUntilSuccess({[&](phys_error *err) { return phys_registry_load_file(registry, GOOD_PLUGIN, err); },
                                 [] {}, [&] { return phys_registry_count(registry) == builtIn; }},
                                problem);
    QVERIFY2(problem.isEmpty(), problem + " at allocation " + QByteArray::number(-count));
    QVERIFY(count > 2);
    QCOMPARE(phys_registry_count(registry), builtIn + 1);
    phys_registry_destroy(registry);
}

void OutOfMemory::scanningAFolder() {
    phys_registry *registry = nullptr;
    QCOMPARE(phys_registry_create(&registry, nullptr), PHYS_OK);
    const Maker scan{[&](phys_error *err) { return phys_registry_scan(registry, GOOD_PLUGINS, nullptr, nullptr, err); },
                     [] {},
                     {}}; // files that were loaded before memory ran out stay loaded
    long allowed = 0;
    phys_status status = createWith(allowed, scan, nullptr);
    for (; status == PHYS_ERROR_MEMORY && allowed < 100000; status = createWith(allowed, scan, nullptr)) ++allowed;
    QCOMPARE(status, PHYS_OK);
    QVERIFY(allowed > 5);
    phys_registry_destroy(registry);
}

void OutOfMemory::listSteppers() {
    QTest::addColumn<QByteArray>("id");
    phys_stepper_info info;
    for (uint32_t i = 0; phys_registry_info(nullptr, i, &info) == PHYS_OK; ++i)
        QTest::newRow(info.id) << QByteArray(info.id);
}

void OutOfMemory::creatingAStepper_data() { listSteppers(); }

void OutOfMemory::creatingAStepper() {
    QFETCH(QByteArray, id);
    phys_scene *scene = nullptr;
    QCOMPARE(phys_scene_load(LEVEL, &scene, nullptr), PHYS_OK);
    phys_stepper *stepper = nullptr;
    QByteArray problem;
    const long count = allocationsUntilSuccess(
        {[&](phys_error *err) { return phys_stepper_create(nullptr, id.constData(), scene, &stepper, err); },
         [&] { phys_stepper_destroy(stepper); }, [&] { return !stepper; }},
        problem);
    QVERIFY2(problem.isEmpty(), problem + " at allocation " + QByteArray::number(-count));
    QVERIFY(count > 0);
    phys_scene_destroy(scene);
}

void OutOfMemory::steppingAllocatesNothing_data() { listSteppers(); }

void OutOfMemory::steppingAllocatesNothing() {
    QFETCH(QByteArray, id);
    phys_scene *scene = nullptr;
    phys_stepper *stepper = nullptr;
    phys_state state;
    phys_params params;
    QCOMPARE(phys_scene_load(LEVEL, &scene, nullptr), PHYS_OK);
    QCOMPARE(phys_stepper_create(nullptr, id.constData(), scene, &stepper, nullptr), PHYS_OK);
    phys_scene_start(scene, &state);
    phys_params_init(&params, sizeof params);
    phys_gravity_from_tilt(0.1, 0.05, 9.81, &params.gravity);
    phys_status status = PHYS_OK;
    {
        const support::AllocationsLeft none(0);
        for (int i = 0; i < 500 && !status; ++i)
            status = phys_step(stepper, &params, 0.01, &state, &state, nullptr, nullptr);
    }
    QCOMPARE(status, PHYS_OK);
    phys_stepper_destroy(stepper);
    phys_scene_destroy(scene);
}

QTEST_GUILESS_MAIN(OutOfMemory)
#include "tst_out_of_memory.moc"
