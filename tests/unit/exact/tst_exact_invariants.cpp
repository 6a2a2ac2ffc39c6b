// SPDX-License-Identifier: MIT
// Invariants of any scene, tested in random rooms: model.md 9. The seed of a failure is in its row's name.
#include "run.h"

#include <QtTest>

#include <functional>
#include <random>

using exact::kU;
using exact::Run;
using exact::Turn;

namespace {

struct Segment {
    double gx, gy, duration;
};

/// A room of 1 m with boxes, posts or tiles in it; all lengths are multiples of 2^-10, so that rotations keep them
/// exact.
struct Room {
    std::vector<phys_box> boxes;
    double radius, x, y, vx, vy, restitution, friction;
    std::vector<Segment> segments;
};

class Dice {
public:
    explicit Dice(uint32_t seed)
        : m_engine(seed) {}
    double operator()(double low, double high) {
        const double unit = static_cast<double>(m_engine()) / 4294967296.0;
        return std::round((low + (high - low) * unit) * 1024.0) / 1024.0;
    }
    bool chance(double part) { return (*this)(0.0, 1.0) < part; }

private:
    std::mt19937 m_engine;
};

bool isFree(const Room &room, double x, double y) {
    for (size_t i = 1; i < room.boxes.size(); ++i) {
        const phys_box &box = room.boxes[i];
        const double dx = std::max({box.min.x - x, x - box.max.x, 0.0});
        const double dy = std::max({box.min.y - y, y - box.max.y, 0.0});
        if (dx * dx + dy * dy < room.radius * room.radius) return false;
    }
    return true;
}

Room randomRoom(uint32_t seed) {
    Dice dice(seed);
    Room room;
    room.radius = dice(0.01, 0.06);
    room.boxes = {exact::floorOver(-0.125, -0.125, 1.125, 1.125), exact::wall(-0.125, -0.125, 1.125, 0.0),
                  exact::wall(-0.125, 1.0, 1.125, 1.125), exact::wall(-0.125, 0.0, 0.0, 1.0),
                  exact::wall(1.0, 0.0, 1.125, 1.0)};
    for (int i = 0; i < 4; ++i) {
        const double x = dice(0.1, 0.8), y = dice(0.1, 0.8);
        const double size = dice.chance(0.5) ? 0.25 : 0.02;
        room.boxes.push_back(exact::wall(x, y, x + dice(0.002, size), y + dice(0.002, size)));
    }
    do {
        room.x = dice(0.0, 1.0);
        room.y = dice(0.0, 1.0);
    } while (!isFree(room, room.x, room.y) || room.x < room.radius || room.x > 1.0 - room.radius ||
             room.y < room.radius || room.y > 1.0 - room.radius);
    room.vx = dice(-1.0, 1.0);
    room.vy = dice(-1.0, 1.0);
    room.restitution = dice.chance(0.2) ? 0.0 : dice(0.25, 1.0);
    room.friction = dice.chance(0.5) ? 0.0 : dice(0.001, 0.05);
    for (int i = 0; i < 3; ++i) room.segments.push_back({dice(-1.5, 1.5), dice(-1.5, 1.5), dice(0.1, 1.0)});
    return room;
}

phys_vec3 same(const phys_vec3 &v) { return v; }

/// The states at the end of each segment of the rotated room; each segment is cut into `parts` steps.
std::vector<phys_state> play(const Room &room, int parts = 1, const Turn &turn = same, double scale = 1.0) {
    std::vector<phys_box> boxes;
    for (const phys_box &box : room.boxes) boxes.push_back(exact::turned(box, turn));
    for (phys_box &box : boxes) {
        for (double *value = &box.min.x; value <= &box.max.z; ++value) *value *= scale;
    }
    const double speed = std::sqrt(scale);
    phys_vec3 p = turn({room.x, room.y, room.radius}), v = turn({room.vx, room.vy, 0.0});
    p = {p.x * scale, p.y * scale, p.z * scale};
    Run run(boxes, room.radius * scale, p, {v.x * speed, v.y * speed, 0.0});
    run.params.restitution_wall = room.restitution;
    run.params.rolling_friction = room.friction;
    std::vector<phys_state> states;
    for (const Segment &segment : room.segments) {
        run.params.gravity = turn({segment.gx, segment.gy, -9.75});
        for (int i = 0; i < parts; ++i) run.step(segment.duration * speed / parts);
        states.push_back(run.state);
    }
    return states;
}

double distance(const phys_state &a, const phys_state &b) {
    return exact::difference(a, b.position.x, b.position.y, b.velocity.x, b.velocity.y);
}

bool sameMotion(const phys_state &found, const phys_state &wanted, const Turn &turn, double scale) {
    const phys_vec3 p = turn(wanted.position), v = turn(wanted.velocity);
    const double speed = std::sqrt(scale);
    return found.position.x == p.x * scale && found.position.y == p.y * scale && found.velocity.x == v.x * speed &&
           found.velocity.y == v.y * speed;
}

constexpr uint32_t kRooms = 60;

} // namespace

class ExactInvariants : public QObject {
    Q_OBJECT
private slots:
    void energyBalances_data() { addRooms(); }
    void energyBalances();
    void slipBetweenSmoothWallsMakesNoEnergy();
    void splitStepsAreTheWholeStep_data() { addRooms(); }
    void splitStepsAreTheWholeStep();
    void turnedRoomTurnsTheWay_data() { addRooms(); }
    void turnedRoomTurnsTheWay();
    void fourTimesAsLargeIsTwiceAsSlow_data() { addRooms(); }
    void fourTimesAsLargeIsTwiceAsSlow();
    void orderOfBoxesIsNothing_data() { addRooms(); }
    void orderOfBoxesIsNothing();
    void cutBoxesAreWholeOnes_data() { addRooms(); }
    void cutBoxesAreWholeOnes();
    void wayBackIsTheWay();
    void velocitiesSuperpose();

private:
    static void addRooms() {
        QTest::addColumn<uint32_t>("seed");
        for (uint32_t seed = 1; seed <= kRooms; ++seed) QTest::addRow("seed %u", seed) << seed;
    }
};

void ExactInvariants::energyBalances() {
    QFETCH(uint32_t, seed);
    const Room room = randomRoom(seed);
    Run run(room.boxes, room.radius, {room.x, room.y, room.radius}, {room.vx, room.vy, 0.0});
    run.params.restitution_wall = room.restitution;
    run.params.rolling_friction = room.friction;
    for (const Segment &segment : room.segments) {
        run.params.gravity = {segment.gx, segment.gy, -9.75};
        run.step(segment.duration);
        // Energies are near 1; an event costs a few of their roundings.
        const double events = run.report.event_count + run.report.events_lost;
        QVERIFY2(std::abs(run.report.energy_scheme) <= 8.0 * kU * (1.0 + events),
                 qPrintable(QString::number(run.report.energy_scheme)));
    }
}

// So slippery that balls still slip when they have leant on a wall for long, and turn round with hardly any slip.
void ExactInvariants::slipBetweenSmoothWallsMakesNoEnergy() {
    constexpr double kRadius = 0.0625, kWidth = 0.5; // m
    constexpr double kFastest = 4.0;                 // m/s: falling across the room
    constexpr double kSlipsEnd = 3.2e-12;            // by which a slip's end may change velocities, relative to them
    constexpr uint32_t kRuns = 2000;
    const std::vector<phys_box> boxes{exact::floorOver(-1, -1, 1, 1), exact::wall(-1, -1, -kWidth, 1),
                                      exact::wall(kWidth, -1, 1, 1), exact::wall(-1, -1, 1, -kWidth),
                                      exact::wall(-1, kWidth, 1, 1)};
    for (uint32_t seed = 1; seed <= kRuns; ++seed) {
        Dice dice(seed);
        const double x = dice.chance(0.5) ? kWidth - kRadius : dice(-0.375, 0.375), y = dice(-0.375, 0.375);
        Run run(boxes, kRadius, {x, y, kRadius}, {0.0, dice(-1.0, 1.0), 0.0});
        run.params.model = PHYS_MODEL_RIGID;
        run.params.restitution_wall = dice(0.0, 1.0);
        run.params.sliding_friction = std::exp2(dice(-10.0, -2.0));
        run.params.gravity = {dice(0.0, 4.0), dice(-4.0, 4.0), -9.0};
        run.state.spin = {dice(-16.0, 16.0), dice(-16.0, 16.0), dice(-16.0, 16.0)};
        const double dt = std::exp2(dice(-6.0, 0.0));
        for (int i = 0; i < 64; ++i) {
            run.step(dt);
            const double made = run.report.energy_scheme;
            QVERIFY2(made <= kSlipsEnd * kFastest * kFastest,
                     qPrintable(QString("seed %1, step %2: %3 J/kg").arg(seed).arg(i).arg(made)));
        }
    }
}

void ExactInvariants::splitStepsAreTheWholeStep() {
    QFETCH(uint32_t, seed);
    const Room room = randomRoom(seed);
    constexpr int kParts = 7;
    constexpr double kNudge = 1e-9;
    const std::vector<phys_state> whole = play(room), split = play(room, kParts);
    std::array<Room, 4> nudged{room, room, room, room};
    nudged[0].x += kNudge;
    nudged[1].y += kNudge;
    nudged[2].vx += kNudge;
    nudged[3].vy += kNudge;
    std::array<std::vector<phys_state>, 4> others;
    for (size_t i = 0; i < nudged.size(); ++i) others[i] = play(nudged[i]);
    double growth = 1.0;
    for (size_t i = 0; i < whole.size(); ++i) {
        for (const auto &other : others) growth = std::max(growth, distance(other[i], whole[i]) / kNudge);
        if (growth > 1e6) return; // chaotic: no comparison is possible any more
        // Each new phase costs a few roundings, which grow like any error.
        const double phases = kParts * double(i + 1) + 16.0;
        QVERIFY2(distance(split[i], whole[i]) <= 4.0 * kU * phases * growth,
                 qPrintable(QString("segment %1: %2, growth %3").arg(i).arg(distance(split[i], whole[i])).arg(growth)));
    }
}

void ExactInvariants::turnedRoomTurnsTheWay() {
    QFETCH(uint32_t, seed);
    const Room room = randomRoom(seed);
    const std::vector<phys_state> wanted = play(room);
    const Turn turns[] = {[](phys_vec3 v) {
                              return phys_vec3{-v.x, v.y, v.z};
                          },
                          [](phys_vec3 v) {
                              return phys_vec3{v.x, -v.y, v.z};
                          },
                          [](phys_vec3 v) {
                              return phys_vec3{v.y, v.x, v.z};
                          },
                          [](phys_vec3 v) {
                              return phys_vec3{-v.y, v.x, v.z};
                          }};
    for (const Turn &turn : turns) {
        const std::vector<phys_state> found = play(room, 1, turn);
        for (size_t i = 0; i < wanted.size(); ++i) QVERIFY(sameMotion(found[i], wanted[i], turn, 1.0));
    }
}

void ExactInvariants::fourTimesAsLargeIsTwiceAsSlow() {
    QFETCH(uint32_t, seed);
    const Room room = randomRoom(seed);
    const std::vector<phys_state> wanted = play(room), found = play(room, 1, same, 4.0);
    for (size_t i = 0; i < wanted.size(); ++i) QVERIFY(sameMotion(found[i], wanted[i], same, 4.0));
}

void ExactInvariants::orderOfBoxesIsNothing() {
    QFETCH(uint32_t, seed);
    Room room = randomRoom(seed);
    const std::vector<phys_state> wanted = play(room);
    std::reverse(room.boxes.begin(), room.boxes.end());
    const std::vector<phys_state> found = play(room);
    for (size_t i = 0; i < wanted.size(); ++i) QVERIFY(sameMotion(found[i], wanted[i], same, 1.0));
}

void ExactInvariants::cutBoxesAreWholeOnes() {
    QFETCH(uint32_t, seed);
    Room room = randomRoom(seed);
    const std::vector<phys_state> wanted = play(room);
    std::vector<phys_box> halves;
    for (const phys_box &box : room.boxes) {
        phys_box left = box, right = box;
        left.max.x = right.min.x = 0.5 * (box.min.x + box.max.x);
        halves.insert(halves.end(), {left, right});
    }
    room.boxes = halves;
    const std::vector<phys_state> found = play(room);
    for (size_t i = 0; i < wanted.size(); ++i) QVERIFY(sameMotion(found[i], wanted[i], same, 1.0));
}

void ExactInvariants::wayBackIsTheWay() {
    Run run({exact::floorOver(-2, -2, 2, 2), exact::wall(1, -1, 2, 1), exact::wall(-1, 0.5, 1, 1)}, 0.125,
            {0, 0, 0.125}, {1, 0.25, 0});
    run.setLaw(-0.25, 0.125, 0.0);
    run.params.restitution_wall = 1.0;
    run.step(1.5);
    QVERIFY(!run.eventsOf(PHYS_EVENT_IMPACT).empty());
    run.state.velocity = {-run.state.velocity.x, -run.state.velocity.y, 0.0};
    run.step(1.5);
    QVERIFY(exact::difference(run.state, 0.0, 0.0, -1.0, -0.25) <= 16.0 * kU);
}

void ExactInvariants::velocitiesSuperpose() {
    const auto after = [](double vx, double vy) {
        Run run({exact::floorOver(-2, -2, 2, 2)}, 0.125, {0, 0, 0.125}, {vx, vy, 0});
        run.setLaw(0.25, -0.5, 0.0);
        run.step(1.0);
        return run.state;
    };
    const phys_state slow = after(0.125, 0.25), fast = after(0.125 + 0.5, 0.25 - 0.375);
    QCOMPARE(fast.position.x, slow.position.x + 0.5);
    QCOMPARE(fast.position.y, slow.position.y - 0.375);
}

QTEST_GUILESS_MAIN(ExactInvariants)
#include "tst_exact_invariants.moc"
