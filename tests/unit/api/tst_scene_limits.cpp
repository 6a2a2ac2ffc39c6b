// SPDX-License-Identifier: MIT
// Scenes of very many boxes, in any arrangement: created within the memory that physics.h states, and queried
// correctly.
#include "support/failing_allocator.h"
#include "support/random.h"
#include "support/scene_builder.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace support;

namespace {

/// phys_scene_create's documentation.
constexpr double kBytesPerBox = 400.0;
constexpr double kBytesBesides = 1e6;

using Boxes = std::vector<phys_box>;

/// All overlapping, no two alike, each covering nearly the whole board.
Boxes overlapping(uint32_t count) {
    Boxes boxes;
    for (uint32_t i = 0; i < count; ++i) {
        boxes.push_back({{-10 + (i % 64) * 1e-5, -10 + (i / 64) * 1e-5, 0}, {10, 10, 0.1 + i * 1e-6}});
    }
    return boxes;
}

/// Each flush pair makes the next one possible: a rectangle that grows alternately at two sides.
Boxes spiral(uint32_t count) {
    Boxes boxes{{{0, 0, 0}, {1, 1, 3}}};
    double x = 1.0;
    double y = 1.0;
    while (boxes.size() < count) {
        boxes.push_back({{x, 0, 0}, {x + 1, y, 3}});
        x += 1.0;
        boxes.push_back({{0, y, 0}, {x, y + 1, 3}});
        y += 1.0;
    }
    return boxes;
}

Boxes scattered(uint32_t count) {
    Random random(1);
    Boxes boxes{{{-100, -100, -1}, {100, 100, 0}}};
    while (boxes.size() < count) {
        const phys_vec3 low{random.between(-100, 99), random.between(-100, 99), random.between(-1, 0)};
        boxes.push_back({low, {low.x + random.between(0, 1), low.y + random.between(0, 1), low.z + 1}});
    }
    return boxes;
}

/// A floor of tiles, which becomes one box.
Boxes tiles(uint32_t count) {
    Boxes boxes;
    const auto side = static_cast<uint32_t>(std::sqrt(count));
    for (uint32_t i = 0; i < side * side; ++i) {
        const double x = i % side;
        const double y = i / side;
        boxes.push_back({{x, y, -1}, {x + 1, y + 1, 0}});
    }
    return boxes;
}

Boxes tower(uint32_t count) {
    Boxes boxes;
    for (uint32_t i = 0; i < count; ++i) boxes.push_back({{0, 0, 2.0 * i}, {1, 1, 2.0 * i + 1}});
    return boxes;
}

Boxes longRow(uint32_t count) {
    Boxes boxes;
    for (uint32_t i = 0; i < count; ++i) boxes.push_back({{100.0 * i, 0, 0}, {100.0 * i + 1, 1, 1}});
    return boxes;
}

/// Bars across the whole board in both directions.
Boxes lattice(uint32_t count) {
    Boxes boxes;
    for (uint32_t i = 0; i < count / 2; ++i) {
        boxes.push_back({{0.01 * i, -1, 0}, {0.01 * i + 0.005, 0.005 * count + 1, 1}});
        boxes.push_back({{-1, 0.01 * i, 0.5}, {0.005 * count + 1, 0.01 * i + 0.005, 1.5}});
    }
    return boxes;
}

ScenePtr build(const Boxes &boxes, double radius, phys_error &error) {
    SceneBuilder builder = SceneBuilder().ball(radius).start({0.5, 0.5, 500.0});
    for (const phys_box &box : boxes) builder.box(box);
    return builder.build(&error);
}

} // namespace

class TestSceneLimits : public QObject {
    Q_OBJECT

private slots:
    void memoryIsBounded_data();
    void memoryIsBounded();
    void contactsAreFoundWhateverTheCells();
    void theBallMustNotBeLostBesideTheCoordinates();
};

void TestSceneLimits::memoryIsBounded_data() {
    QTest::addColumn<std::function<Boxes(uint32_t)>>("make");
    QTest::addColumn<double>("radius");
    using Make = std::function<Boxes(uint32_t)>;
    QTest::newRow("boxes that overlap all over") << Make(overlapping) << 0.006;
    QTest::newRow("boxes that merge one after another") << Make(spiral) << 0.1;
    QTest::newRow("scattered boxes") << Make(scattered) << 0.1;
    QTest::newRow("tiles") << Make(tiles) << 0.1;
    QTest::newRow("a tower") << Make(tower) << 0.1;
    QTest::newRow("a long row and a tiny ball") << Make(longRow) << 1e-5;
    QTest::newRow("bars both ways") << Make(lattice) << 0.001;
}

void TestSceneLimits::memoryIsBounded() {
    QFETCH(std::function<Boxes(uint32_t)>, make);
    QFETCH(double, radius);
    for (const uint32_t count : {1'000U, 20'000U}) {
        const Boxes boxes = make(count);
        phys_scene_desc desc;
        phys_scene_desc_init(&desc, sizeof desc);
        desc.boxes = boxes.data();
        desc.box_count = static_cast<uint32_t>(boxes.size());
        desc.radius = radius;
        phys_error error{};
        phys_scene *scene = nullptr;
        restartPeak();
        QVERIFY2(phys_scene_create(&desc, &scene, &error) == PHYS_OK, error.text);
        phys_scene_destroy(scene);
        const auto peak = static_cast<double>(peakBytes());
        const double most = kBytesBesides + kBytesPerBox * desc.box_count;
        QVERIFY2(peak <= most, qPrintable(QString("%1 boxes take %2 bytes").arg(desc.box_count).arg(peak)));
    }
}

/// Coarse cells list more boxes than are near; none may be missing, and none listed twice.
void TestSceneLimits::contactsAreFoundWhateverTheCells() {
    const Boxes boxes = overlapping(300);
    phys_error error{};
    const ScenePtr scene = build(boxes, 0.006, error);
    QVERIFY2(scene, error.text);
    std::vector<phys_contact> contacts(boxes.size() + 1);
    const phys_vec3 centre{9.5, 10.002, 0.05};
    uint32_t count = 0;
    QCOMPARE(
        phys_scene_contacts(scene.get(), &centre, 0.0, contacts.data(), static_cast<uint32_t>(contacts.size()), &count),
        PHYS_OK);
    QCOMPARE(count, static_cast<uint32_t>(boxes.size()));
    for (uint32_t i = 0; i < count; ++i) QCOMPARE(contacts[i].box, i);
}

void TestSceneLimits::theBallMustNotBeLostBesideTheCoordinates() {
    phys_error error{};
    QVERIFY(!openFloor(1e6).ball(0.9e-6).build(&error));
    QCOMPARE(error.status, PHYS_ERROR_SCENE);
    QCOMPARE(QString(error.text),
             QString("radius is 9e-07 m beside a coordinate of 1000000 m; expected at least 1e-06 m"));
    QVERIFY2(openFloor(1e6).ball(1e-6).build(&error), error.text);
}

QTEST_GUILESS_MAIN(TestSceneLimits)
#include "tst_scene_limits.moc"
