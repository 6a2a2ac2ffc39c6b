// SPDX-License-Identifier: MIT
#include "support/scene.h"

#include "generator/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bench {

namespace {

phys_vec3 gravityAt(double tiltX, double tiltY) {
    phys_vec3 gravity{};
    phys_gravity_from_tilt(tiltX, tiltY, kStrength, &gravity);
    return gravity;
}

double randomTilt(mazes::Random &random) {
    constexpr double kLargest = 5 * std::numbers::pi / 180;
    constexpr std::size_t kNotches = 1'000'000;
    return kLargest * (2 * static_cast<double>(random.below(kNotches + 1)) / kNotches - 1);
}

} // namespace

double distance(const Vec2 &a, const Vec2 &b) { return std::hypot(a.x - b.x, a.y - b.y); }

Wall floorOf(const Scene &scene) {
    constexpr double kMargin = 10;
    Wall floor{scene.start.position.x, scene.start.position.y, scene.start.position.x, scene.start.position.y};
    for (const Wall &wall : scene.walls)
        floor = {std::min(floor.x0, wall.x0), std::min(floor.y0, wall.y0), std::max(floor.x1, wall.x1),
                 std::max(floor.y1, wall.y1)};
    return {floor.x0 - kMargin, floor.y0 - kMargin, floor.x1 + kMargin, floor.y1 + kMargin};
}

std::vector<phys_vec3> steadyTilt(double tiltX, double tiltY) { return {gravityAt(tiltX, tiltY)}; }

std::vector<phys_vec3> randomTilts(unsigned seed, int periods) {
    mazes::Random random(seed);
    std::vector<phys_vec3> tilts;
    for (int period = 0; period < periods; ++period) {
        const double tiltX = randomTilt(random);
        const double tiltY = randomTilt(random);
        tilts.push_back(gravityAt(tiltX, tiltY));
    }
    return tilts;
}

} // namespace bench
