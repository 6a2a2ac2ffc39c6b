// SPDX-License-Identifier: MIT
// The autopilot and its map of the maze.
#include "core/pilot/autopilot.h"
#include "core/program/headless.h"
#include "inspector/core/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace inspector;

class TestAutopilot : public QObject {
    Q_OBJECT

private slots:
    void clearanceIsTheRoomBesideTheBall();
    void wallsAreNotFree();
    void holesInTheFloorAreNotFree();
    void wayLeadsFromTheStartToOutside_data() { addLevels(); }
    void wayLeadsFromTheStartToOutside();
    void wayKeepsOffTheWalls_data() { addLevels(); }
    void wayKeepsOffTheWalls();
    void spaceOfAnyProportionsIsBounded_data();
    void spaceOfAnyProportionsIsBounded();
    void boxesThatCoverEachOtherThousandfoldAreRefused();
    void everyLevelIsWonByEveryStepperInBothModels_data();
    void everyLevelIsWonByEveryStepperInBothModels();
    void tiltNeverExceedsAPersons();
    void sameRunTwiceGivesTheSameBits();
    void ballPutElsewhereFindsItsWay();
    void closedMazeIsRefusedWithOneLine();
    void openBoardsHaveAWayOutWhateverTheirSize();

private:
    static void addLevels();
};

namespace {

// The centre of a square floor of 0.2 m, walled in on all sides; one wall can be left out.
Scene walledFloor(bool isClosed) {
    std::vector<phys_box> boxes{{{-0.1, -0.1, -0.01}, {0.1, 0.1, 0.0}},
                                {{-0.11, -0.1, -0.01}, {-0.1, 0.1, 0.02}},
                                {{-0.1, -0.11, -0.01}, {0.1, -0.1, 0.02}},
                                {{-0.1, 0.1, -0.01}, {0.1, 0.11, 0.02}}};
    if (isClosed) boxes.push_back({{0.1, -0.1, -0.01}, {0.11, 0.1, 0.02}});
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = boxes.data();
    description.box_count = uint32_t(boxes.size());
    return makeScene(description, nullptr);
}

// The path that the autopilot follows from the start, from cell to cell.
std::vector<Point> wayOutOf(const Scene &scene) {
    phys_state start;
    phys_scene_start(scene.get(), &start);
    const FreeSpace space(scene.get());
    const WayOut way(space);
    std::vector<Point> points;
    FreeSpace::Cell cell = space.nearestFree({start.position.x, start.position.y});
    for (; cell != FreeSpace::kNowhere; cell = way.next(cell)) points.push_back(space.centre(cell));
    return points;
}

bool alwaysOn(const Engine &) { return true; }

constexpr double kPatience = 60.0; // s, simulated: several times what the longest level takes

} // namespace

void TestAutopilot::addLevels() {
    QTest::addColumn<int>("level");
    for (int level = 1; level <= 10; ++level) QTest::addRow("%02d", level) << level;
}

// Cells are a quarter of a radius wide, so the nearest centre is within sqrt(2)/8 of a radius of the point asked for.
void TestAutopilot::clearanceIsTheRoomBesideTheBall() {
    const Scene scene = walledFloor(true);
    const FreeSpace space(scene.get());
    const double radius = phys_scene_radius(scene.get());
    const double error = std::sqrt(2.0) / 8.0 * radius;
    for (const double distance : {0.001, 0.004, 0.008}) {
        const double x = -0.1 + radius + distance; // this far from touching the left wall
        QVERIFY(std::abs(space.clearance(space.cellAt({x, 0.0})) - distance) <= error);
    }
}

void TestAutopilot::wallsAreNotFree() {
    const Scene scene = walledFloor(true);
    const FreeSpace space(scene.get());
    QVERIFY(space.isFree(space.cellAt({0.0, 0.0})));
    QVERIFY(!space.isFree(space.cellAt({-0.105, 0.0}))); // inside the wall
    QVERIFY(!space.isFree(space.cellAt({-0.097, 0.0}))); // closer to the wall than the radius
    QVERIFY(space.isOutside(space.cellAt({0.12, 0.0})));
    QVERIFY(!space.isFree(space.cellAt({5.0, 0.0})));
}

void TestAutopilot::holesInTheFloorAreNotFree() {
    const std::array<phys_box, 2> floors{
        {{{-0.1, -0.1, -0.01}, {0.03, 0.1, 0.0}}, {{0.06, -0.1, -0.01}, {0.1, 0.1, 0.0}}}};
    phys_scene_desc description;
    phys_scene_desc_init(&description, sizeof description);
    description.boxes = floors.data();
    description.box_count = uint32_t(floors.size());
    const Scene scene = makeScene(description, nullptr);
    const FreeSpace space(scene.get());
    QVERIFY(space.isFree(space.cellAt({0.02, 0.0})));
    QVERIFY(!space.isFree(space.cellAt({0.045, 0.0})));
    QVERIFY(space.isFree(space.cellAt({0.07, 0.0})));
}

void TestAutopilot::wayLeadsFromTheStartToOutside() {
    QFETCH(int, level);
    const Scene scene = levelScene(level);
    const std::vector<Point> way = wayOutOf(scene);
    QVERIFY(!way.empty());
    phys_box bounds;
    phys_scene_bounds(scene.get(), &bounds);
    const Point end = way.back();
    QVERIFY(end.x < bounds.min.x || end.x > bounds.max.x || end.y < bounds.min.y || end.y > bounds.max.y);
    // A neighbour is at most a diagonal of a cell away.
    const double reach = std::sqrt(2.0) * FreeSpace(scene.get()).spacing() * (1.0 + 1e-9);
    for (size_t i = 1; i < way.size(); ++i)
        QVERIFY(std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y) <= reach);
}

// Against the library's own contact query, not the grid.
void TestAutopilot::wayKeepsOffTheWalls() {
    QFETCH(int, level);
    const Scene scene = levelScene(level);
    phys_state start;
    phys_scene_start(scene.get(), &start);
    for (const Point &point : wayOutOf(scene)) {
        const phys_vec3 centre{point.x, point.y, start.position.z};
        std::array<phys_contact, 16> contacts;
        uint32_t count = 0;
        phys_scene_contacts(scene.get(), &centre, 0.0, contacts.data(), uint32_t(contacts.size()), &count);
        for (uint32_t i = 0; i < count; ++i) QVERIFY2(contacts[i].normal.z > 0.99, "a wall touches the ball");
    }
}

void TestAutopilot::spaceOfAnyProportionsIsBounded_data() {
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("width");
    QTest::addColumn<double>("radius");
    for (const double length : {1e-3, 1e5, 9e8})
        for (const double width : {1e-3, 1e5})
            for (const double radius : {1e-6, 1.0})
                if (radius > 1e-11 * std::max(length, width)) // else it is lost in rounding and refused
                    QTest::addRow("%g %g %g", length, width, radius) << length << width << radius;
}

// The number of cells is bounded, and the result is a path or one line.
void TestAutopilot::spaceOfAnyProportionsIsBounded() {
    QFETCH(double, length);
    QFETCH(double, width);
    QFETCH(double, radius);
    const phys_box floor{{-length, -width, -1.0}, {length, width, 0.0}};
    const phys_scene_desc description{sizeof description, 1, &floor, radius, {0.0, 0.0, radius}};
    QString error;
    const Scene scene = makeScene(description, &error);
    QVERIFY2(scene, qPrintable(error));
    QVERIFY(FreeSpace(scene.get()).cellCount() <= 3'000'001);
    QVERIFY(Autopilot::create(scene.get(), &error) || error.startsWith("autopilot: "));
}

void TestAutopilot::boxesThatCoverEachOtherThousandfoldAreRefused() {
    std::vector<phys_box> boxes;
    for (int i = 1; i <= 2000; ++i) boxes.push_back({{-1.0 * i, i - 2001.0, -1.0}, {1.0 * i, 2001.0 - i, 0.0}});
    const phys_scene_desc description{sizeof description, uint32_t(boxes.size()), boxes.data(), 0.01, {0.0, 0.0, 0.01}};
    const Scene scene = makeScene(description, nullptr);
    QVERIFY(scene);
    QString error;
    QVERIFY(!Autopilot::create(scene.get(), &error));
    QCOMPARE(error, QString("autopilot: the boxes overlap too often for a way to be looked for"));
}

void TestAutopilot::everyLevelIsWonByEveryStepperInBothModels_data() {
    QTest::addColumn<int>("level");
    QTest::addColumn<QByteArray>("stepper");
    QTest::addColumn<int>("model");
    for (uint32_t i = 0; i < phys_registry_count(nullptr); ++i) {
        phys_stepper_info info;
        phys_registry_info(nullptr, i, &info);
        for (const int model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID})
            for (int level = 1; level <= 10; ++level)
                QTest::addRow("%02d %s %s", level, info.id, model == PHYS_MODEL_RIGID ? "rigid" : "rolling")
                    << level << QByteArray(info.id) << model;
    }
}

void TestAutopilot::everyLevelIsWonByEveryStepperInBothModels() {
    QFETCH(int, level);
    QFETCH(QByteArray, stepper);
    QFETCH(int, model);
    QString error;
    Options options;
    options.registry = makeRegistry(&error);
    options.stepper = stepper;
    options.autopilot = true;
    options.settings = {{"model", double(model)}};
    const auto engine = makeEngine(options, levelsIn(LEVELS_FOLDER)[size_t(level) - 1], &error);
    QVERIFY2(engine, qPrintable(error));
    const Outcome outcome = play(*engine, {kPatience, false}, alwaysOn);
    QVERIFY2(outcome.error.isEmpty(), qPrintable(outcome.error));
    QVERIFY(outcome.isWon());
}

void TestAutopilot::tiltNeverExceedsAPersons() {
    const Scene scene = levelScene(6);
    const auto engine = engineOn(scene);
    engine->setPilot(Autopilot::create(scene.get(), nullptr));
    const Outcome outcome = play(*engine, {kPatience, false}, [](const Engine &now) {
        const Tilt tilt = now.inputs().tilt;
        return std::max(std::abs(tilt.x), std::abs(tilt.y)) <= radians(kPlayTilt);
    });
    QVERIFY(outcome.isWon()); // a larger tilt would have ended the run
}

void TestAutopilot::sameRunTwiceGivesTheSameBits() {
    std::array<uint64_t, 2> hashes{};
    for (uint64_t &hash : hashes) {
        const Scene scene = levelScene(7);
        const auto engine = engineOn(scene);
        engine->setPilot(Autopilot::create(scene.get(), nullptr));
        QVERIFY(play(*engine, {kPatience, false}, alwaysOn).isWon());
        hash = phys_state_hash(&engine->state());
    }
    QCOMPARE(hashes[0], hashes[1]);
}

// The pilot gets the ball out from anywhere on the board, even if it is moving.
void TestAutopilot::ballPutElsewhereFindsItsWay() {
    const Scene scene = levelScene(4);
    const auto pilot = Autopilot::create(scene.get(), nullptr);
    const FreeSpace space(scene.get());
    int places = 0;
    for (FreeSpace::Cell cell = 0; cell < space.cellCount(); cell += 397) { // a prime: spreads over rows and columns
        if (!space.isFree(cell) || space.isOutside(cell)) continue;
        const auto engine = engineOn(scene);
        phys_state state = engine->state();
        state.position.x = space.centre(cell).x;
        state.position.y = space.centre(cell).y;
        state.velocity = {places % 2 ? 0.3 : -0.3, places % 3 ? 0.2 : -0.2, 0.0};
        engine->setState(state);
        engine->setPilot(pilot);
        const Outcome outcome = play(*engine, {kPatience, false}, alwaysOn);
        QVERIFY2(outcome.isWon(), qPrintable(QString("from %1, %2").arg(state.position.x).arg(state.position.y)));
        ++places;
    }
    QVERIFY(places > 20);
}

void TestAutopilot::closedMazeIsRefusedWithOneLine() {
    QString error;
    QVERIFY(!Autopilot::create(walledFloor(true).get(), &error));
    QVERIFY2(error.startsWith("autopilot: no way leads out"), qPrintable(error));
    QVERIFY(Autopilot::create(walledFloor(false).get(), nullptr));
}

// A large board's cells are wider than the ball, and so is the rim around it that belongs to the grid.
void TestAutopilot::openBoardsHaveAWayOutWhateverTheirSize() {
    for (const double half : {0.1, 2.0, 18.0, 60.0, 500.0, 1200.0, 3600.0, 6000.0}) {
        QString error;
        QVERIFY2(Autopilot::create(sceneOf({{{-half, -half, -0.01}, {half, half, 0.0}}}).get(), &error),
                 qPrintable(QString("%1 m: ").arg(half) + error));
    }
}

QTEST_GUILESS_MAIN(TestAutopilot)
#include "tst_autopilot.moc"
