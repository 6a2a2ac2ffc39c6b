// SPDX-License-Identifier: MIT
// Exits of mazes: what is marked in mazes that have no .obj of their own.
#include "core/pilot/exits.h"
#include "inspector/core/scenes.h"

using namespace inspector;

class TestExits : public QObject {
    Q_OBJECT

private slots:
    void gapInAWallIsAnExit();
    void closedRoomHasNone();
    void ballThatFallsOntoTheFloorFindsTheGap();
    void gapThatTheBallCantReachIsNone();
    void twoGapsAreTwoExits();
    void edgeOfTheFloorBeforeTheGapIsRolledOver();
    void gapBeyondAHoleIsNone();
    void airWithoutABoardHasNone();
    void mazeTooLargeToSearchIsNotCalledClosed();
    void ballInAWallIsNotCalledLockedIn();
    void levelsHaveAtLeastOne_data();
    void levelsHaveAtLeastOne();
};

namespace {

// A room of 0.1 m; its right wall leaves the gaps from `first` to `second` and beyond `third` free.
std::vector<phys_box> room() {
    return {{{-0.05, -0.05, -0.01}, {0.05, 0.05, 0.0}},
            {{-0.05, -0.05, 0.0}, {-0.045, 0.05, 0.02}},
            {{-0.05, -0.05, 0.0}, {0.05, -0.045, 0.02}},
            {{-0.05, 0.045, 0.0}, {0.05, 0.05, 0.02}}};
}

phys_box rightWall(double from, double to) { return {{0.045, from, 0.0}, {0.05, to, 0.02}}; }

// fall: of the ball at its start onto the floor, m.
std::optional<std::vector<phys_box>> foundIn(const std::vector<phys_box> &boxes, double fall = 0.0) {
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes.data();
    description.box_count = uint32_t(boxes.size());
    QString error;
    description.start.z += fall;
    const Scene scene = makeScene(description, &error);
    if (!scene) qFatal("%s", qPrintable(error));
    return exitsOf(scene.get());
}

std::vector<phys_box> exitsIn(const std::vector<phys_box> &boxes) { return foundIn(boxes).value(); }

} // namespace

void TestExits::gapInAWallIsAnExit() {
    std::vector<phys_box> boxes = room();
    boxes.push_back(rightWall(-0.05, 0.0));
    const std::vector<phys_box> exits = exitsIn(boxes);
    QCOMPARE(exits.size(), size_t(1));
    const phys_box exit = exits.front();
    QVERIFY(exit.max.x > 0.045);  // at the wall
    QVERIFY(exit.min.y > -0.006); // in the gap, to a cell
    QVERIFY(exit.max.y < 0.05 && exit.max.y > 0.04);
    QCOMPARE(exit.min.z, 0.0); // on the floor
    QVERIFY(exit.max.z < 0.001);
}

void TestExits::closedRoomHasNone() {
    std::vector<phys_box> boxes = room();
    boxes.push_back(rightWall(-0.05, 0.05));
    QVERIFY(exitsIn(boxes).empty());
}

void TestExits::ballThatFallsOntoTheFloorFindsTheGap() {
    std::vector<phys_box> boxes = room();
    boxes.push_back(rightWall(-0.05, 0.0));
    const std::vector<phys_box> exits = foundIn(boxes, 0.1).value();
    QCOMPARE(exits.size(), size_t(1));
    QCOMPARE(exits.front().min.z, 0.0);
}

// The gap is behind another wall.
void TestExits::gapThatTheBallCantReachIsNone() {
    std::vector<phys_box> boxes = room();
    boxes.push_back(rightWall(-0.05, 0.0));
    boxes.push_back({{0.02, -0.05, 0.0}, {0.025, 0.05, 0.02}});
    QVERIFY(exitsIn(boxes).empty());
}

void TestExits::twoGapsAreTwoExits() {
    std::vector<phys_box> boxes = room();
    boxes.push_back(rightWall(-0.01, 0.01));
    QCOMPARE(exitsIn(boxes).size(), size_t(2));
}

// As in a maze drawn by hand, whose floor ends where its walls begin.
void TestExits::edgeOfTheFloorBeforeTheGapIsRolledOver() {
    std::vector<phys_box> boxes = room();
    boxes.front().max.x = 0.045;
    boxes.push_back(rightWall(-0.05, 0.0));
    QCOMPARE(exitsIn(boxes).size(), size_t(1));
}

// Into which the ball falls: it is wider than a radius.
void TestExits::gapBeyondAHoleIsNone() {
    std::vector<phys_box> boxes = room();
    boxes.front().max.x = 0.04;
    boxes.push_back(rightWall(-0.05, 0.0));
    QVERIFY(exitsIn(boxes).empty());
}

void TestExits::airWithoutABoardHasNone() { QVERIFY(exitsIn({}).empty()); }

void TestExits::mazeTooLargeToSearchIsNotCalledClosed() {
    std::vector<phys_box> boxes = room();
    boxes.push_back({{20.0, 20.0, -0.01}, {20.1, 20.1, 0.0}});
    QVERIFY(!foundIn(boxes));
}

void TestExits::ballInAWallIsNotCalledLockedIn() {
    std::vector<phys_box> boxes = room();
    boxes.push_back({{-0.03, -0.03, 0.0}, {0.03, 0.03, 0.02}});
    QVERIFY(!foundIn(boxes));
}

void TestExits::levelsHaveAtLeastOne_data() {
    QTest::addColumn<int>("level");
    for (int level = 1; level <= 10; ++level) QTest::addRow("%d", level) << level;
}

void TestExits::levelsHaveAtLeastOne() {
    QFETCH(int, level);
    QVERIFY(!exitsOf(levelScene(level).get()).value().empty());
}

QTEST_GUILESS_MAIN(TestExits)
#include "tst_exits.moc"
