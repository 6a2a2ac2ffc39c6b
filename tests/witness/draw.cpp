// SPDX-License-Identifier: MIT
#include "draw.h"

#include "integrator/touch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace witness {

namespace {

/// SplitMix64.
class Dice {
public:
    explicit Dice(uint64_t seed)
        : m_state(seed) {}

    uint64_t bits() {
        uint64_t z = m_state += 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53);
    }
    /// Uniform over orders of magnitude.
    double magnitude(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
    int below(int count) { return static_cast<int>(bits() % static_cast<uint64_t>(count)); }
    bool chance(double probability) { return between(0, 1) < probability; }
    double sign() { return chance(0.5) ? 1 : -1; }
    template<class T, size_t size>
    const T &oneOf(const T (&values)[size]) {
        return values[below(size)];
    }

private:
    uint64_t m_state;
};

constexpr double kGravity = 9.81;

struct Sketch {
    Dice dice;
    Case scene;
    double r; ///< the ball's radius

    /// A box with its lengths in radii.
    void box(double x0, double y0, double z0, double x1, double y1, double z1) {
        scene.boxes.push_back({{std::min(x0, x1) * r, std::min(y0, y1) * r, std::min(z0, z1) * r},
                               {std::max(x0, x1) * r, std::max(y0, y1) * r, std::max(z0, z1) * r}});
    }
    void floor() { box(-40, -40, -3, 40, 40, 0); }
    void place(double x, double y, double z) { scene.start.position = {x * r, y * r, z * r}; }
    void velocity(double x, double y, double z) {
        const double unit = std::sqrt(kGravity * r);
        scene.start.velocity = {x * unit, y * unit, z * unit};
    }
    /// Directed towards a point (in radii), at a speed in units of sqrt(g R).
    void moveTowards(double x, double y, double z, double speed) {
        const double dx = x - scene.start.position.x / r;
        const double dy = y - scene.start.position.y / r;
        const double dz = z - scene.start.position.z / r;
        const double way = std::sqrt(dx * dx + dy * dy + dz * dz);
        if (way > 0) velocity(speed * dx / way, speed * dy / way, speed * dz / way);
    }
    double speed() { return dice.chance(0.2) ? 0 : dice.magnitude(0.02, 20); }
};

/// On the floor, moving, unless another start is drawn afterwards.
void rollOnFloor(Sketch &s) {
    s.place(s.dice.between(-4, 4), s.dice.between(-4, 4), 1);
    s.moveTowards(s.dice.between(-4, 4), s.dice.between(-4, 4), 1, s.speed());
}

void boxes(Sketch &s) {
    s.floor();
    rollOnFloor(s);
    const int count = 1 + s.dice.below(5);
    for (int i = 0; i < count; ++i) {
        const double x = s.dice.between(-8, 8);
        const double y = s.dice.between(-8, 8);
        const double z = s.dice.chance(0.7) ? -0.5 : s.dice.between(0, 3);
        s.box(x, y, z, x + s.dice.magnitude(0.1, 10), y + s.dice.magnitude(0.1, 10), z + s.dice.magnitude(0.3, 8));
    }
    if (s.dice.chance(0.4)) s.place(s.dice.between(-4, 4), s.dice.between(-4, 4), s.dice.between(1, 8));
}

void cornersTouch(Sketch &s) {
    s.floor();
    const double height = s.dice.chance(0.5) ? 3 : s.dice.between(0.3, 2);
    s.box(0, 0, 0, 5, 5, height);
    s.box(-5, -5, 0, 0, 0, s.dice.chance(0.5) ? height : s.dice.between(0.3, 3));
    s.place(-s.dice.between(1.2, 4), s.dice.between(1.2, 4), s.dice.chance(0.7) ? 1 : s.dice.between(1, 5));
    s.moveTowards(s.dice.between(-1, 1), s.dice.between(-1, 1), 1, s.speed());
}

void notch(Sketch &s) {
    if (s.dice.chance(0.7)) s.floor();
    const double wide = s.dice.between(0.2, 1.9);
    s.box(-5, 1, 0, 0, 4, 4);
    s.box(wide, s.dice.between(0.2, 2), 0, wide + 4, 4, s.dice.between(0.5, 4));
    if (s.dice.chance(0.5)) s.box(-5, 3, 0, 6, 3 + s.dice.magnitude(1e-3, 2), 4);
    s.place(s.dice.between(-1, 2.5), -s.dice.between(0.5, 3), 1);
    s.moveTowards(wide / 2, 1, 1, s.speed());
}

void gap(Sketch &s) {
    s.floor();
    constexpr double kWidths[] = {1.0, 1.2, 1.4, 1.41, 1.9, 1.99998, 2.0, 2.0 * (1 + 1e-14), 2.002};
    const double width = s.dice.chance(0.5) ? s.dice.oneOf(kWidths) : s.dice.between(1.0, 2.002);
    const double height = s.dice.chance(0.6) ? 3 : s.dice.between(0.4, 2);
    s.box(-width / 2 - 3, 0, 0, -width / 2, 5, height);
    s.box(width / 2, 0, 0, width / 2 + 3, 5, s.dice.chance(0.5) ? height : s.dice.between(0.4, 3));
    s.place(s.dice.chance(0.3) ? 0 : s.dice.between(-1.5, 1.5), -s.dice.between(0.9, 4), 1);
    s.moveTowards(s.dice.chance(0.3) ? s.scene.start.position.x / s.r : 0, 2, 1, s.speed());
}

void kerb(Sketch &s) {
    s.floor();
    const double height = s.dice.chance(0.5) ? s.dice.between(0.02, 1.2) : s.dice.magnitude(1e-9, 0.1);
    s.box(2, s.dice.chance(0.5) ? -8 : s.dice.between(-1, 1), s.dice.chance(0.8) ? 0 : height / 2, 8, 8, height);
    if (s.dice.chance(0.3)) s.box(-8, 2, 0, 8, 8, s.dice.between(0.05, 1.2));
    s.place(s.dice.chance(0.3) ? 1 : s.dice.between(-3, 1), s.dice.between(-2, 0.9), 1);
    s.moveTowards(4, s.dice.between(-2, 2), 1, s.speed());
}

void shelf(Sketch &s) {
    if (s.dice.chance(0.5)) s.floor();
    s.box(1, -6, -3, 4, 6, s.dice.chance(0.5) ? 12 : s.dice.between(2, 8));
    const double z = s.dice.between(1, 4);
    s.box(-s.dice.between(0, 4), -3, z, 1, 3, z + s.dice.magnitude(1e-3, 2));
    s.place(s.dice.chance(0.5) ? 0 : s.dice.between(-3, 0), s.dice.between(-3, 3), z + s.dice.between(2, 8));
    s.velocity(s.dice.between(-1, 1), s.dice.between(-3, 3), s.dice.between(-3, 3));
}

void roof(Sketch &s) {
    s.floor();
    const double height = s.dice.chance(0.3) ? 2 : s.dice.between(1.2, 4);
    const double thickness = s.dice.magnitude(1e-3, 3);
    s.box(s.dice.between(-3, 1), -6, height, 6, 6, height + thickness);
    if (s.dice.chance(0.4)) s.box(3, -6, 0, 5, 6, 5);
    s.place(-s.dice.between(0, 4), s.dice.between(-2, 2), s.dice.between(1, std::max(1.0, height - 1)));
    s.moveTowards(3, s.dice.between(-2, 2), s.dice.between(0.5, 3), s.speed());
}

void tiles(Sketch &s) {
    constexpr double kCracks[] = {0, 1e-12, 1e-6, 1e-3, 0.02, 0.2, 0.8, 1.5, 1.9, 2.0};
    const double crack = s.dice.chance(0.7) ? s.dice.oneOf(kCracks) : s.dice.magnitude(1e-9, 2);
    const double size = s.dice.between(1, 8);
    for (int i = -2; i < 3; ++i) {
        const double low = s.dice.chance(0.8) ? 0 : -s.dice.magnitude(1e-9, 0.3);
        s.box(i * (size + crack), -20, -3, i * (size + crack) + size, 20, low);
    }
    s.place(size / 2, s.dice.between(-2, 2), 1);
    const double x = s.dice.chance(0.5) ? s.dice.between(-1.5, 2.5) * size : size / 2 + 5;
    if (s.dice.chance(0.1)) s.place(size + crack / 2, 0, 1);
    s.moveTowards(x, s.dice.between(-3, 3), 1, s.speed());
}

void pit(Sketch &s) {
    const double half = s.dice.between(0.6, 4);
    const double depth = s.dice.magnitude(0.02, 5);
    s.box(-20, -20, -8, -half, 20, 0);
    s.box(half, -20, -8, 20, 20, 0);
    s.box(-half, -20, -8, half, 20, -depth);
    if (s.dice.chance(0.5)) s.box(-half, half, -8, half, 20, 0);
    s.place(-half - s.dice.between(0, 3), s.dice.between(-2, 2), 1);
    s.moveTowards(s.dice.between(-half, half + 2), s.dice.between(-2, 2), 1, s.speed());
    if (s.dice.chance(0.3)) s.place(s.dice.between(-half, half) * 0.5, 0, 2);
}

void hole(Sketch &s) {
    const double half = s.dice.between(0.5, 2.5);
    s.box(-20, -20, -2, -half, 20, 0);
    s.box(half, -20, -2, 20, 20, 0);
    s.box(-half, -20, -2, half, -half, 0);
    s.box(-half, half, -2, half, 20, 0);
    s.place(-half - s.dice.between(0, 3), s.dice.between(-1, 1), 1);
    s.moveTowards(0, s.dice.between(-half, half), 1, s.speed());
}

void stairs(Sketch &s) {
    const double rise = s.dice.magnitude(0.05, 1.5);
    const double tread = s.dice.between(0.7, 4);
    for (int i = 0; i < 6; ++i) s.box(i * tread, -10, -10, (i + 1) * tread, 10, -i * rise);
    s.place(s.dice.between(0, 1) * tread, 0, 1);
    s.moveTowards(3 * tread, s.dice.between(-3, 3), 1, s.speed());
    if (s.dice.chance(0.3)) s.place(4.5 * tread, 0, 1), s.moveTowards(0, 0, 1, s.speed());
}

void thin(Sketch &s) {
    if (s.dice.chance(0.8)) s.floor();
    const double thickness = s.dice.magnitude(1e-9, 0.1);
    s.box(2, -10, s.dice.chance(0.7) ? 0 : 0.5, 2 + thickness, 10, s.dice.between(1, 6));
    if (s.dice.chance(0.5)) s.box(-10, 3, 0, 10, 3 + thickness, s.dice.between(1, 6));
    if (s.dice.chance(0.3)) s.box(-10, -10, 4, 10, 10, 4 + thickness);
    s.place(s.dice.between(-4, 1), s.dice.between(-3, 2), s.dice.chance(0.6) ? 1 : s.dice.between(1, 3));
    s.moveTowards(4, s.dice.between(-2, 6), s.dice.between(1, 3),
                  s.dice.chance(0.3) ? s.dice.magnitude(20, 2000) : s.speed());
}

void thick(Sketch &s) {
    s.box(-1e3, -1e3, -1e3, 1e3, 1e3, 0);
    s.box(1.5, -1e2, -5, 1e3, 1e2, 1e2);
    s.box(-1e2, 1.5, -1e2, 1e2, 1e3, s.dice.magnitude(0.3, 1e2));
    s.place(s.dice.between(-6, 0.5), s.dice.between(-6, 0.5), s.dice.chance(0.6) ? 1 : s.dice.between(1, 6));
    s.moveTowards(2, s.dice.between(-2, 2), 1, s.speed());
}

void air(Sketch &s) {
    s.place(0, 0, 0);
    const int count = 1 + s.dice.below(5);
    for (int i = 0; i < count; ++i) {
        const double x = s.dice.between(-6, 6);
        const double y = s.dice.between(-6, 6);
        const double z = s.dice.between(-8, 2);
        s.box(x, y, z, x + s.dice.magnitude(0.01, 6), y + s.dice.magnitude(0.01, 6), z + s.dice.magnitude(0.01, 6));
    }
    s.velocity(s.dice.between(-2, 2), s.dice.between(-2, 2), s.dice.between(-2, 2));
}

void pressed(Sketch &s) {
    s.floor();
    const double height = s.dice.chance(0.6) ? 3 : s.dice.between(0.3, 2);
    s.box(1, -8, 0, 4, 8, height);
    if (s.dice.chance(0.6)) s.box(-8, 1, 0, 8, 4, s.dice.chance(0.6) ? 3 : s.dice.between(0.3, 2));
    if (s.dice.chance(0.3)) s.box(-8, -8, 2, 8, 8, 3);
    if (s.dice.chance(0.3)) s.box(-4, -8, 0, -1, 8, s.dice.between(0.5, 3));
    s.place(0, 0, 1);
    if (s.dice.chance(0.6)) s.velocity(s.dice.between(0, 2), s.dice.between(-1, 2), s.dice.chance(0.7) ? 0 : -1);
}

void overlapping(Sketch &s) {
    if (s.dice.chance(0.8)) s.floor();
    const int count = 1 + s.dice.below(3);
    for (int i = 0; i < count; ++i) {
        const double x = s.dice.between(-1.5, 1);
        const double y = s.dice.between(-1.5, 1);
        s.box(x, y, s.dice.between(-1, 1), x + s.dice.magnitude(0.05, 5), y + s.dice.magnitude(0.05, 5),
              s.dice.between(1, 3));
    }
    s.place(s.dice.between(-1.5, 1.5), s.dice.between(-1.5, 1.5), s.dice.between(-0.2, 2));
    s.velocity(s.dice.between(-1, 1), s.dice.between(-1, 1), s.dice.between(-1, 1));
}

void boardEdge(Sketch &s) {
    s.box(-10, -10, -2, s.dice.between(0, 1), 10, 0);
    if (s.dice.chance(0.3)) s.box(1.5, -10, -8, 12, 10, -s.dice.between(0, 6));
    s.place(-s.dice.between(0, 2), s.dice.between(-1, 1), 1);
    s.moveTowards(3, s.dice.between(-4, 4), 1, s.speed());
    if (s.dice.chance(0.2)) s.place(s.dice.between(-1, 3), 0, -4), s.moveTowards(0, 0, 0, s.speed());
}

void room(Sketch &s) {
    const double size = s.dice.between(1.05, 5);
    const double wall = s.dice.magnitude(1e-6, 2);
    s.box(-size - wall, -size - wall, -wall, size + wall, size + wall, 0);
    s.box(-size - wall, -size - wall, 2 * size, size + wall, size + wall, 2 * size + wall);
    s.box(-size - wall, -size - wall, 0, -size, size + wall, 2 * size);
    s.box(size, -size - wall, 0, size + wall, size + wall, 2 * size);
    s.box(-size, -size - wall, 0, size, -size, 2 * size);
    s.box(-size, size, 0, size, size + wall, 2 * size);
    if (s.dice.chance(0.5)) s.box(0, 0, 0, s.dice.between(0.1, 2), s.dice.between(0.1, 2), s.dice.between(0.1, 2));
    s.place(-size + 1.02, -size + 1.02, s.dice.between(1, 1.05));
    const double v = s.dice.magnitude(0.1, 300);
    s.velocity(v * s.dice.between(-1, 1), v * s.dice.between(-1, 1), v * s.dice.between(-1, 1));
}

/// Slippery, with smooth walls: balls still slip when they have leant on a wall for long.
void slippery(Sketch &s) {
    const double width = s.dice.between(2, 10), wall = s.dice.magnitude(0.01, 2);
    s.box(-width - wall, -width - wall, -wall, width + wall, width + wall, 0);
    s.box(-width - wall, -width - wall, 0, -width, width + wall, 3);
    s.box(width, -width - wall, 0, width + wall, width + wall, 3);
    s.box(-width, -width - wall, 0, width, -width, 3);
    s.box(-width, width, 0, width, width + wall, 3);
    s.scene.params.sliding_friction = s.dice.magnitude(1e-3, 0.3);
    s.scene.params.wall_friction = 0;
    s.scene.params.rolling_friction = std::min(s.scene.params.rolling_friction, s.scene.params.sliding_friction);
    const double most = width - 1;
    s.place(s.dice.chance(0.5) ? most : s.dice.between(-most, most), s.dice.between(-most, most), 1);
    s.velocity(0, s.dice.between(-5, 5), 0);
    const uint32_t steps = 8;
    for (int legs = 1 + s.dice.below(3); legs > 0; --legs) {
        const phys_vec3 gravity{s.dice.between(-5, 5), s.dice.between(-5, 5), -kGravity};
        s.scene.legs.push_back({gravity, s.dice.magnitude(0.01, 0.5) * std::sqrt(s.r / 0.006), steps});
    }
}

/// Rolls on the floor round a pillar's upright edge: the normal of a contact that sticks turns.
void uprightEdge(Sketch &s) {
    s.floor();
    const double angle = s.dice.between(0.02, 1.55), out = s.dice.chance(0.7) ? 0 : s.dice.magnitude(1e-9, 0.5);
    s.box(-4, -4, 0, -std::cos(angle), -std::sin(angle), 3);
    if (s.dice.chance(0.2)) s.box(-4, 1.5, 0, 4, 4, s.dice.between(0.1, 3));
    s.place(out * std::cos(angle), out * std::sin(angle), 1);
    const double speed = s.dice.sign() * s.dice.magnitude(0.02, 2);
    s.velocity(-speed * std::sin(angle), speed * std::cos(angle), 0);
    s.scene.start.spin.z = speed * std::sqrt(kGravity / s.r);
    const double press = s.dice.magnitude(0.05, 1) * kGravity, along = s.dice.between(-0.5, 0.5) * kGravity;
    s.scene.legs.push_back({{-press * std::cos(angle) - along * std::sin(angle),
                             -press * std::sin(angle) + along * std::cos(angle), -kGravity},
                            s.dice.magnitude(1e-4, 1e-2) * std::sqrt(s.r / 0.006),
                            12});
}

/// Between two upright edges, on a floor or falling along them.
void groove(Sketch &s) {
    const double left = s.dice.between(0.05, 1.5), right = s.dice.chance(0.3) ? left : s.dice.between(0.05, 1.5);
    const double height = s.dice.chance(0.7) ? 8 : s.dice.between(0.3, 3);
    if (s.dice.chance(0.7)) s.floor();
    s.box(-6, std::cos(left), 0, -std::sin(left), 6, height);
    s.box(std::sin(right), std::cos(right), 0, 6, 6, s.dice.chance(0.7) ? height : s.dice.between(0.3, 8));
    if (s.dice.chance(0.3)) s.box(-6, -5, 0, 6, s.dice.chance(0.2) ? -1 : -s.dice.between(1, 2), height);
    if (s.dice.chance(0.7)) { // rough enough that friction can hold the ball between both
        s.scene.params.sliding_friction = s.dice.magnitude(0.05, 3);
        s.scene.params.wall_friction = s.dice.magnitude(0.05, 3);
        s.scene.params.rolling_friction = std::min(s.scene.params.rolling_friction, s.scene.params.sliding_friction);
    }
    s.place(0, 0, s.dice.chance(0.6) ? 1 : s.dice.between(1, 6));
    const double up = s.scene.start.position.z > s.r ? s.dice.between(-2, 2) : 0;
    s.velocity(0, s.dice.chance(0.7) ? 0 : s.dice.between(-1, 1), up);
}

/// On the bottom of a slot, touching both of its edges, mostly with a wall behind.
void slot(Sketch &s) {
    const double left = s.dice.between(0.1, 1.5), right = s.dice.chance(0.3) ? left : s.dice.between(0.1, 1.5);
    s.floor();
    s.box(-6, -8, -1, -std::sin(left), 8, 1 - std::cos(left));
    s.box(std::sin(right), -8, -1, 6, 8, 1 - std::cos(right));
    if (s.dice.chance(0.8)) s.box(-6, -8, 0, 6, -1, s.dice.chance(0.7) ? 4 : s.dice.between(0.1, 2));
    if (s.dice.chance(0.7)) { // rough enough to be driven by friction
        s.scene.params.sliding_friction = s.dice.magnitude(0.05, 3);
        s.scene.params.wall_friction = s.dice.chance(0.5) ? 0 : s.dice.magnitude(0.05, 3);
        s.scene.params.rolling_friction = std::min(s.scene.params.rolling_friction, s.scene.params.sliding_friction);
    }
    s.place(0, s.dice.chance(0.7) ? 0 : s.dice.magnitude(1e-9, 2), 1);
    s.velocity(0, s.dice.chance(0.7) ? 0 : s.dice.between(-2, 2), 0);
    const phys_vec3 gravity{s.dice.between(-3, 3), s.dice.between(-3, 5), -kGravity};
    s.scene.legs.push_back({gravity, s.dice.magnitude(1e-3, 0.1) * std::sqrt(s.r / 0.006), 4});
}

/// Height of what lies below a point, in radii; 0 if nothing does.
double topBelow(const Sketch &s, double x, double y) {
    double top = 0;
    for (const phys_box &box : s.scene.boxes) {
        if (box.min.x <= x * s.r && x * s.r <= box.max.x && box.min.y <= y * s.r && y * s.r <= box.max.y)
            top = std::max(top, box.max.z / s.r);
    }
    return top;
}

/// In round numbers, as people type them: diagonals, corners and borders that are met exactly, pulls that are equal.
void roundNumbers(Sketch &s) {
    const auto quarters = [&](int least, int most) { return 0.25 * (least + s.dice.below(most - least + 1)); };
    s.r = s.scene.radius = 0x1p-7;
    const double x = quarters(-4, 4), y = quarters(-4, 4);
    switch (s.dice.below(3)) {
    case 0: { // a corner of a pit or, of four boxes, of a hole
        const double depth = s.dice.chance(0.5) ? 9 : quarters(1, 8), wide = quarters(2, 12);
        s.box(-30, -30, -12, x, 30, 0);
        s.box(x, y, -12, 30, 30, 0);
        if (s.dice.chance(0.5)) s.box(x + wide, -30, -12, 30, y, 0);
        if (s.dice.chance(0.5)) s.box(x, -30, -12, x + wide, y - wide, 0);
        if (depth < 9) s.box(x, -30, -12, 30, y, -depth);
        break;
    }
    case 1: { // an inner corner of kerbs or walls
        const double height = quarters(1, 10);
        s.floor();
        s.box(x + 1, -8, 0, 8, 8, height);
        s.box(-8, y + 1, 0, 8, 8, s.dice.chance(0.7) ? height : quarters(1, 10));
        break;
    }
    default:
        s.floor();
        for (int count = 1 + s.dice.below(4); count > 0; --count) {
            const double left = quarters(-12, 12), front = quarters(-12, 12), low = quarters(-2, 8);
            s.box(left, front, low, left + quarters(1, 16), front + quarters(1, 16), low + quarters(1, 8));
        }
    }
    const double back = s.dice.chance(0.2) ? 0 : quarters(1, 8);
    const int aside = s.dice.chance(0.5) ? 1 : s.dice.below(3) - 1; // the diagonal, or along an axis
    const double left = x - back, front = y + aside * back;
    s.place(left, front, topBelow(s, left, front) + (s.dice.chance(0.7) ? 1 : quarters(5, 16)));
    const double speed = s.dice.chance(0.3) ? 0 : quarters(1, 8);
    s.velocity(speed, -aside * speed, 0);
    const double pull = s.dice.chance(0.1) ? 0 : quarters(-2, 4) * kGravity;
    const phys_vec3 gravity{pull, s.dice.chance(0.5) ? -aside * pull : quarters(-2, 2) * kGravity, -kGravity};
    s.scene.legs.push_back({gravity, s.dice.magnitude(1e-3, 0.3), 4});
}

struct Kind {
    const char *name;
    void (*draw)(Sketch &);
    /// Whether smooth cases start beside the place: right on a border or a corner the integrator isn't to be relied on.
    bool isShifted = false;
};
constexpr Kind kKinds[] = {
    {"boxes", boxes},
    {"corners_touch", cornersTouch},
    {"notch", notch},
    {"gap", gap},
    {"kerb", kerb},
    {"shelf", shelf},
    {"roof", roof},
    {"tiles", tiles},
    {"pit", pit},
    {"hole", hole},
    {"stairs", stairs},
    {"thin", thin},
    {"thick", thick},
    {"air", air},
    {"pressed", pressed},
    {"overlapping", overlapping},
    {"board_edge", boardEdge},
    {"room", room},
    {"slippery", slippery},
    {"upright_edge", uprightEdge},
    {"groove", groove},
    {"slot", slot},
    {"round_numbers", roundNumbers, true},
};

void drawRadius(Sketch &s) {
    constexpr double kUsual[] = {0.005, 0.006, 0.0078125};
    s.r = s.dice.chance(0.8) ? s.dice.oneOf(kUsual) : s.dice.magnitude(1e-4, 1);
    s.scene.radius = s.r;
}

void drawCoefficients(Sketch &s) {
    constexpr double kRestitutions[] = {0, 0, 1e-9, 0.3, 0.5, 0.8, 0.99, 1 - 1e-12, 1};
    constexpr double kFrictions[] = {0, 0, 1e-12, 0.05, 0.1, 0.3, 0.5, 0.6, 1, 2, 1e6};
    phys_params &params = s.scene.params;
    params.restitution_wall = s.dice.oneOf(kRestitutions);
    params.restitution_floor = s.dice.oneOf(kRestitutions);
    params.sliding_friction = s.dice.oneOf(kFrictions);
    params.wall_friction = s.dice.oneOf(kFrictions);
    constexpr double kRolling[] = {0, 0, 1e-12, 1e-3, 0.01, 0.1, 0.5};
    params.rolling_friction = s.dice.oneOf(kRolling);
    if (params.model == PHYS_MODEL_RIGID)
        params.rolling_friction = std::min(params.rolling_friction, params.sliding_friction);
}

void drawSpin(Sketch &s) {
    const phys_vec3 &v = s.scene.start.velocity;
    s.scene.start.spin = {-v.y / s.r, v.x / s.r, s.scene.start.spin.z};
    if (s.scene.params.model != PHYS_MODEL_RIGID || s.dice.chance(0.3)) return;
    const double most = s.dice.magnitude(0.1, 10) * std::sqrt(kGravity / s.r);
    s.scene.start.spin = {s.dice.between(-most, most), s.dice.between(-most, most), s.dice.between(-most, most)};
}

phys_vec3 drawGravity(Dice &dice) {
    if (dice.chance(0.05)) return {0, 0, 0};
    const double strength = dice.chance(0.9) ? kGravity : dice.magnitude(1e-3, 1e3);
    if (dice.chance(0.1)) return {0, 0, -strength};
    const double turn = dice.chance(0.3) ? dice.below(8) * (std::acos(-1.0) / 4) : dice.between(-3.15, 3.15);
    const double tilt = dice.chance(0.8) ? dice.magnitude(1e-3, 0.9) : dice.between(0, 3.14);
    return {strength * std::sin(tilt) * std::cos(turn), strength * std::sin(tilt) * std::sin(turn),
            -strength * std::cos(tilt)};
}

/// Step sizes for a ball of 6 mm, scaled to this one.
double drawDt(Sketch &s) {
    constexpr double kSteps[] = {1e-9, 1e-6, 1e-4, 5e-4, 1e-3, 1e-3, 4e-3, 1e-2, 1e-2, 1.0 / 60, 0.1, 1};
    return s.dice.oneOf(kSteps) * std::sqrt(s.r / 0.006);
}

void drawLegs(Sketch &s) {
    const int legs = 1 + s.dice.below(4);
    for (int i = 0; i < legs; ++i) {
        phys_vec3 gravity = drawGravity(s.dice);
        if (i > 0 && s.dice.chance(0.2)) {
            const phys_vec3 &before = s.scene.legs.back().gravity;
            gravity = {-before.x, -before.y, s.dice.chance(0.8) ? before.z : -before.z};
        }
        const double dt = drawDt(s);
        const int most = dt > 0.05 * std::sqrt(s.r / 0.006) ? 2 : 12;
        s.scene.legs.push_back({gravity, dt, static_cast<uint32_t>(1 + s.dice.below(most))});
    }
}

Sketch sketch(size_t kind, uint64_t seed, uint32_t model) {
    Dice dice(seed * 1000003 + kind * 2 + model);
    dice.bits();
    Sketch s{dice, emptyCase(), 0.006};
    s.scene.name = std::string(kKinds[kind].name) + '-' + std::to_string(seed);
    s.scene.params.model = model;
    return s;
}

/// Rotated by quarter turns, so that no axis is special.
void turn(Sketch &s) {
    const auto quarter = [](const phys_vec3 &v) { return phys_vec3{-v.y, v.x, v.z}; };
    for (int turns = s.dice.below(4); turns > 0; --turns) {
        for (phys_box &box : s.scene.boxes)
            box = {{-box.max.y, box.min.x, box.min.z}, {-box.min.y, box.max.x, box.max.z}};
        s.scene.start.position = quarter(s.scene.start.position);
        s.scene.start.velocity = quarter(s.scene.start.velocity);
        s.scene.start.spin = quarter(s.scene.start.spin);
        for (Leg &leg : s.scene.legs) leg.gravity = quarter(leg.gravity);
    }
}

} // namespace

const std::vector<std::string> &kinds() {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const Kind &kind : kKinds) names.push_back(kind.name);
        return names;
    }();
    return kNames;
}

Case drawCase(size_t kind, uint64_t seed, uint32_t model) {
    Sketch s = sketch(kind, seed, model);
    drawRadius(s);
    drawCoefficients(s);
    kKinds[kind].draw(s);
    drawSpin(s);
    turn(s);
    if (s.scene.legs.empty()) drawLegs(s);
    return s.scene;
}

Case drawSmoothCase(size_t kind, uint64_t seed, uint32_t model) {
    Sketch s = sketch(kind, seed ^ 0x5eed5eed, model);
    s.scene.name = std::string(kKinds[kind].name) + "-smooth-" + std::to_string(seed);
    kKinds[kind].draw(s);
    if (kKinds[kind].isShifted) {
        s.scene.start.position.x += s.dice.between(0.01, 0.1) * s.r;
        s.scene.start.position.y += s.dice.between(0.01, 0.1) * s.r;
    }
    const double fastest = 4 * std::sqrt(kGravity * s.r);
    const double speed = static_cast<double>(length(vectorOf(s.scene.start.velocity)));
    if (speed > fastest) s.scene.start.velocity = rounded((fastest / speed) * vectorOf(s.scene.start.velocity));
    phys_params &params = s.scene.params;
    params.restitution_wall = s.dice.chance(0.4) ? 0 : s.dice.between(0, 0.9);
    params.restitution_floor = s.dice.chance(0.4) ? 0 : s.dice.between(0, 0.9);
    params.sliding_friction = s.dice.between(0.05, 0.6);
    params.wall_friction = s.dice.chance(0.3) ? 0 : s.dice.between(0, 0.6);
    params.rolling_friction = s.dice.chance(0.5) ? 0 : s.dice.between(0, 0.04);
    s.scene.radius = s.r;
    drawSpin(s);
    turn(s);
    const double tilt = s.dice.magnitude(0.02, 0.8);
    const double turned = s.dice.between(-3.15, 3.15);
    s.scene.legs.assign(1, {{kGravity * std::sin(tilt) * std::cos(turned), kGravity * std::sin(tilt) * std::sin(turned),
                             -kGravity * std::cos(tilt)},
                            0.1,
                            1});
    return s.scene;
}

} // namespace witness
