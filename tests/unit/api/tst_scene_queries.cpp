// SPDX-License-Identifier: MIT
// Queries of a scene: boxes, bounds, start, planarity, and contacts compared with a plain computation.
#include "support/compare.h"
#include "support/experiment.h"
#include "support/random.h"
#include "support/tolerance.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

using namespace support;

namespace {

/// Distance of a point from a box: model.md 5.1 written out plainly. Negative inside.
double distanceTo(const phys_box &box, const phys_vec3 &p) {
    double square = 0.0;
    double depth = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = (&box.min.x)[axis];
        const double high = (&box.max.x)[axis];
        const double value = (&p.x)[axis];
        const double outside = std::max({low - value, 0.0, value - high});
        square += outside * outside;
        depth = std::min({depth, value - low, high - value});
    }
    return square > 0.0 ? std::sqrt(square) : -depth;
}

std::vector<phys_contact> contactsOf(const phys_scene *scene, const phys_vec3 &centre, double reach) {
    std::vector<phys_contact> contacts(4096);
    uint32_t count = 0;
    const phys_status status =
        phys_scene_contacts(scene, &centre, reach, contacts.data(), static_cast<uint32_t>(contacts.size()), &count);
    contacts.resize(status == PHYS_OK ? count : 0);
    return contacts;
}

/// The only contact at a place.
phys_contact contactAt(const phys_scene *scene, const phys_vec3 &centre, double reach) {
    const auto contacts = contactsOf(scene, centre, reach);
    return contacts.size() == 1 ? contacts.front() : phys_contact{{}, {}, NAN, PHYS_NO_BOX, 0};
}

SceneBuilder unitBox() { return SceneBuilder().ball(0.25).box({{0, 0, 0}, {1, 1, 1}}).start({5, 5, 5}); }

} // namespace

class TestSceneQueries : public QObject {
    Q_OBJECT

private slots:
    void boxesAreGivenBackAsTheyCame();
    void descriptionMayGoAfterCreation();
    void boundsEncloseAllBoxes();
    void sceneWithoutBoxesHasZeroBoundsAndNoContacts();
    void startIsAtRestAtTimeZero();
    void contactOfAFace_data();
    void contactOfAFace();
    void contactOfAnEdge();
    void contactOfACorner();
    void centreInsideLeavesThroughTheNearestFace();
    void contactsMatchAPlainComputation();
    void contactsComeInOrderOfTheirBoxes();
    void flushAndIdenticalBoxesAreOneContact();
    void capacityKeepsTheFirstContactsAndCountsAll();
    void reachIsIncluded();
    void planarScene_data();
    void planarScene();
    void hashIsFnv1aOfAllBytes();
    void hashSeesEveryByte();
    void energyIsThatOfItsFormula();
};

void TestSceneQueries::boxesAreGivenBackAsTheyCame() {
    const SceneBuilder room = squareRoom(4.0);
    const ScenePtr scene = room.build();
    QCOMPARE(static_cast<size_t>(phys_scene_box_count(scene.get())), room.boxes().size());
    QVERIFY(std::memcmp(phys_scene_boxes(scene.get()), room.boxes().data(), room.boxes().size() * sizeof(phys_box)) ==
            0);
}

void TestSceneQueries::descriptionMayGoAfterCreation() {
    std::vector<phys_box> boxes{{{0, 0, 0}, {1, 1, 1}}};
    phys_scene_desc desc;
    QCOMPARE(phys_scene_desc_init(&desc, sizeof desc), PHYS_OK);
    desc.boxes = boxes.data();
    desc.box_count = 1;
    phys_scene *raw = nullptr;
    QCOMPARE(phys_scene_create(&desc, &raw, nullptr), PHYS_OK);
    const ScenePtr scene(raw);
    boxes[0] = {};
    COMPARE_EXACT(phys_scene_boxes(raw)[0].max.x, 1.0);
}

void TestSceneQueries::boundsEncloseAllBoxes() {
    const ScenePtr scene = squareRoom(4.0).box({{1, 1, 0}, {2, 2, 9}}).build();
    phys_box bounds;
    QCOMPARE(phys_scene_bounds(scene.get(), &bounds), PHYS_OK);
    const phys_box expected{{-0.5, -0.5, -0.0625}, {4.5, 4.5, 9}};
    QVERIFY(sameBits(bounds, expected));
}

void TestSceneQueries::sceneWithoutBoxesHasZeroBoundsAndNoContacts() {
    const ScenePtr scene = SceneBuilder().build();
    QVERIFY(scene);
    QCOMPARE(phys_scene_box_count(scene.get()), 0U);
    QVERIFY(phys_scene_boxes(scene.get()) == nullptr);
    phys_box bounds;
    QCOMPARE(phys_scene_bounds(scene.get(), &bounds), PHYS_OK);
    const phys_box zero{};
    QVERIFY(sameBits(bounds, zero));
    QVERIFY(contactsOf(scene.get(), {0, 0, 0}, 1e6).empty());
}

void TestSceneQueries::startIsAtRestAtTimeZero() {
    const ScenePtr scene = squareRoom(4.0).start(1.5, 2.5).build();
    phys_state start;
    std::memset(static_cast<void *>(&start), 0xff, sizeof start);
    QCOMPARE(phys_scene_start(scene.get(), &start), PHYS_OK);
    phys_state expected{};
    expected.position = {1.5, 2.5, 0.0625};
    expected.orientation[3] = 1.0;
    QVERIFY(sameBits(start, expected));
}

void TestSceneQueries::contactOfAFace_data() {
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("side");
    const char *const names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        QTest::addRow("below in %s", names[axis]) << axis << -1.0;
        QTest::addRow("above in %s", names[axis]) << axis << 1.0;
    }
}

void TestSceneQueries::contactOfAFace() {
    QFETCH(int, axis);
    QFETCH(double, side);
    const ScenePtr scene = unitBox().build();
    phys_vec3 centre{0.5, 0.5, 0.5};
    (&centre.x)[axis] = 0.5 + side * 1.0;
    const phys_contact contact = contactAt(scene.get(), centre, 1.0);
    COMPARE_EXACT(contact.gap, 0.25);
    QCOMPARE(contact.feature, static_cast<uint32_t>(PHYS_FEATURE_FACE));
    for (int i = 0; i < 3; ++i) {
        COMPARE_EXACT((&contact.normal.x)[i], i == axis ? side : 0.0);
        COMPARE_EXACT((&contact.point.x)[i], i == axis ? 0.5 + side * 0.5 : 0.5);
    }
}

void TestSceneQueries::contactOfAnEdge() {
    const ScenePtr scene = unitBox().build();
    const phys_contact contact = contactAt(scene.get(), {1.375, 1.5, 0.5}, 1.0); // 3, 4, 5 times an eighth
    COMPARE_EXACT(contact.gap, 0.625 - 0.25);
    COMPARE_EXACT(contact.normal.x, 0.6);
    COMPARE_EXACT(contact.normal.y, 0.8);
    COMPARE_EXACT(contact.normal.z, 0.0);
    QCOMPARE(contact.feature, static_cast<uint32_t>(PHYS_FEATURE_EDGE));
}

void TestSceneQueries::contactOfACorner() {
    const ScenePtr scene = unitBox().build();
    const phys_contact contact = contactAt(scene.get(), {1.25, 1.5, 1.5}, 1.0); // 1, 2, 2, 3 times a quarter
    COMPARE_EXACT(contact.gap, 0.75 - 0.25);
    QVERIFY(contact.point.x == 1.0 && contact.point.y == 1.0 && contact.point.z == 1.0);
    COMPARE_WITHIN(contact.normal.x, 1.0 / 3.0, kUnit);
    COMPARE_WITHIN(contact.normal.y, 2.0 / 3.0, kUnit);
    QCOMPARE(contact.feature, static_cast<uint32_t>(PHYS_FEATURE_CORNER));
}

void TestSceneQueries::centreInsideLeavesThroughTheNearestFace() {
    const ScenePtr scene = unitBox().build();
    const phys_contact contact = contactAt(scene.get(), {0.5, 0.875, 0.5}, 0.0);
    COMPARE_EXACT(contact.gap, -0.125 - 0.25);
    COMPARE_EXACT(contact.normal.y, 1.0);
    COMPARE_EXACT(contact.point.y, 1.0);
    QCOMPARE(contact.feature, static_cast<uint32_t>(PHYS_FEATURE_INSIDE));
    // Ties go to -x first: model.md 5.7.
    COMPARE_EXACT(contactAt(scene.get(), {0.5, 0.5, 0.5}, 0.0).normal.x, -1.0);
}

void TestSceneQueries::contactsMatchAPlainComputation() {
    Random random(testSeed());
    qInfo("seed %llu: contacts equal a plain computation", static_cast<unsigned long long>(testSeed()));
    for (int round = 0; round < 40; ++round) {
        SceneBuilder builder = SceneBuilder().ball(0.125).start(0, 0);
        const uint32_t count = 1 + random.below(40);
        // Cells of a chequerboard: separate or touching at corners, so that nothing is merged and the boxes are
        // unchanged.
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t row = i / 6;
            const double x = 2.0 * (i % 6) + row % 2;
            const double y = row;
            builder.box({{x, y, random.between(-1.0, 0.5)}, {x + 1.0, y + 1.0, random.between(0.5, 1.5)}});
        }
        const ScenePtr scene = builder.build();
        QVERIFY(scene);
        for (int probe = 0; probe < 100; ++probe) {
            const phys_vec3 centre{random.between(-2, 14), random.between(-2, 9), random.between(-2, 3)};
            const double reach = random.below(2) ? random.between(0.0, 0.0625) : random.between(0.0, 6.0);
            const auto contacts = contactsOf(scene.get(), centre, reach);
            size_t expected = 0;
            for (uint32_t i = 0; i < count; ++i) {
                const double distance = distanceTo(builder.boxes()[i], centre);
                if (distance > 0.125 + reach) continue;
                QVERIFY(expected < contacts.size());
                QCOMPARE(contacts[expected].box, i);
                COMPARE_WITHIN(contacts[expected].gap, distance - 0.125, rounding(4, 16.0));
                ++expected;
            }
            QCOMPARE(contacts.size(), expected);
        }
    }
}

void TestSceneQueries::contactsComeInOrderOfTheirBoxes() {
    const ScenePtr scene = squareRoom(4.0).build();
    const auto contacts = contactsOf(scene.get(), {2, 2, 0.0625}, 10.0);
    QCOMPARE(contacts.size(), size_t{5});
    for (size_t i = 0; i < contacts.size(); ++i) QCOMPARE(contacts[i].box, static_cast<uint32_t>(i));
}

void TestSceneQueries::flushAndIdenticalBoxesAreOneContact() {
    // Two tiles, a wall, the wall again, and a box within it that shares no cross-section with it.
    const ScenePtr scene = SceneBuilder()
                               .ball(0.125)
                               .start(0, 0)
                               .floor(0, -1, 1, 1)
                               .floor(-1, -1, 0, 1)
                               .wall(0.5, -1, 0.75, 1)
                               .wall(0.5, -1, 0.75, 1)
                               .wall(0.5, -0.5, 0.625, 0.5)
                               .build();
    const auto boxesAt = [&](double x) {
        std::vector<uint32_t> boxes;
        for (const phys_contact &contact : contactsOf(scene.get(), {x, 0, 0.125}, 10.0)) boxes.push_back(contact.box);
        return boxes;
    };
    QCOMPARE(boxesAt(0.25), (std::vector<uint32_t>{0, 2, 4})); // over the first tile
    QCOMPARE(boxesAt(-0.25), (std::vector<uint32_t>{1, 2, 4}));
    QCOMPARE(boxesAt(0.0), (std::vector<uint32_t>{0, 2, 4})); // over the seam: the lowest of both
}

void TestSceneQueries::capacityKeepsTheFirstContactsAndCountsAll() {
    const ScenePtr scene = squareRoom(4.0).build();
    const phys_vec3 centre{2, 2, 0.0625};
    const auto all = contactsOf(scene.get(), centre, 10.0);
    for (uint32_t capacity = 0; capacity <= 5; ++capacity) {
        std::vector<phys_contact> some(6);
        std::memset(static_cast<void *>(some.data()), 0x5a, some.size() * sizeof(phys_contact));
        const std::vector<phys_contact> before = some;
        uint32_t count = 0;
        phys_contact *const out = capacity > 0 ? some.data() : nullptr;
        QCOMPARE(phys_scene_contacts(scene.get(), &centre, 10.0, out, capacity, &count), PHYS_OK);
        QCOMPARE(count, 5U);
        QVERIFY(std::memcmp(some.data(), all.data(), capacity * sizeof(phys_contact)) == 0);
        QVERIFY(sameBits(some[capacity], before[capacity]));
    }
}

void TestSceneQueries::reachIsIncluded() {
    const ScenePtr scene = unitBox().build();
    QCOMPARE(contactsOf(scene.get(), {1.5, 0.5, 0.5}, 0.25).size(), size_t{1});
    QCOMPARE(contactsOf(scene.get(), {std::nextafter(1.5, 2.0), 0.5, 0.5}, 0.25).size(), size_t{0});
}

void TestSceneQueries::planarScene_data() {
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<bool>("planar");
    // R = 1/16: the equator is at z = 1/16, the ball's top at 1/8.
    QTest::newRow("a wall above the ball") << 0.0 << 1.0 << true;
    QTest::newRow("a wall up to the equator") << 0.0 << 0.0625 << true;
    QTest::newRow("a kerb below the equator") << 0.0 << 0.03125 << false;
    QTest::newRow("a beam above the equator") << 0.09375 << 1.0 << false;
    QTest::newRow("a bridge above the ball") << 0.125 << 1.0 << true;
    QTest::newRow("something under the floor") << -1.0 << -0.5 << true;
    QTest::newRow("a wall from under the floor") << -1.0 << 1.0 << true;
}

void TestSceneQueries::planarScene() {
    QFETCH(double, low);
    QFETCH(double, high);
    QFETCH(bool, planar);
    const ScenePtr scene = openFloor(1.0).box({{0.5, -0.5, low}, {0.75, 0.5, high}}).build();
    phys_error error{};
    const phys_status status = phys_scene_check_planar(scene.get(), &error);
    QCOMPARE(status, planar ? PHYS_OK : PHYS_ERROR_UNSUPPORTED);
    if (!planar) QVERIFY2(QByteArray(error.text).contains("box 1"), error.text);
}

void TestSceneQueries::hashIsFnv1aOfAllBytes() {
    // FNV-1a of 128 zero bytes: the offset basis times the prime to the 128th.
    uint64_t expected = 0xcbf29ce484222325U;
    for (int i = 0; i < 128; ++i) expected *= 0x100000001b3U;
    const phys_state zero{};
    QCOMPARE(phys_state_hash(&zero), expected);
}

void TestSceneQueries::hashSeesEveryByte() {
    phys_state state{};
    const uint64_t before = phys_state_hash(&state);
    for (size_t i = 0; i < sizeof state; ++i) {
        phys_state changed{};
        reinterpret_cast<unsigned char *>(&changed)[i] = 1;
        QVERIFY(phys_state_hash(&changed) != before);
    }
}

void TestSceneQueries::energyIsThatOfItsFormula() {
    Experiment ball(squareRoom(4.0), PHYS_STEPPER_DEFAULT);
    ball.params.gravity = {0.5, -0.25, -8.0};
    ball.state.position = {1.0, 2.0, 0.0625};
    ball.state.velocity = {0.5, -0.25, 0.125};
    ball.state.spin = {16.0, -32.0, 8.0};
    double energy = 0.0;
    QCOMPARE(phys_energy(ball.scene(), &ball.params, &ball.state, &energy), PHYS_OK);
    // v^2/2 + (R om)^2/5 - g.p, model.md 9.
    const double expected = (0.25 + 0.0625 + 0.015625) / 2.0 + (1.0 + 4.0 + 0.25) / 5.0 - (0.5 - 0.5 - 0.5);
    COMPARE_WITHIN(energy, expected, rounding(8, 2.0));
}

QTEST_GUILESS_MAIN(TestSceneQueries)
#include "tst_scene_queries.moc"
