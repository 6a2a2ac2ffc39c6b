// SPDX-License-Identifier: MIT
#include "contact/closed_modes.h"

#include "base/subsets.h"
#include "contact/held.h"

#include <optional>

namespace phys {

namespace {

/// Smooth contacts, possibly on a floor whose plane contains their normals and whose force doesn't depend on theirs:
/// their reactions solve a linear complementarity problem with a unique solution.
struct Smooth {
    const Moment &moment;
    std::span<const Held> held;
    double inertia; ///< effective mass of a push at the centre: 7/5 where the ball must roll
    double zero;    ///< acceleration that counts as zero, as it is rounding

    double approach(uint32_t i, const Vec3 &a) const {
        return glm::dot(held[i].normal, a) + curvature(moment, held[i]);
    }
};

/// Whether all contacts except those of a set allow the acceleration a.
bool allows(const Smooth &smooth, const Vec3 &a, uint32_t among, uint32_t but) {
    for (uint32_t i = 0; i < smooth.held.size(); ++i) {
        if ((among >> i & 1U) && !(but >> i & 1U) && smooth.approach(i, a) < -smooth.zero) return false;
    }
    return true;
}

/// The forces of contacts that keep all of them closed.
template<size_t Size>
struct Closing {
    std::array<double, Size> sizes;
    Vec3 a; ///< the acceleration with them
};

std::optional<Closing<1>> closing(const Smooth &smooth, const Vec3 &a, const std::array<uint32_t, 1> &number) {
    const double size = -smooth.approach(number[0], a);
    if (size <= 0.0) return {};
    return Closing<1>{{size}, a + size * smooth.held[number[0]].normal};
}

/// Nothing if they are parallel or one would have to pull.
std::optional<Closing<2>> closing(const Smooth &smooth, const Vec3 &a, const std::array<uint32_t, 2> &number) {
    const Held &one = smooth.held[number[0]], &other = smooth.held[number[1]];
    const double c = glm::dot(one.normal, other.normal);
    const Vec3 line = glm::cross(one.normal, other.normal);
    const double determinant = glm::dot(line, line);
    if (determinant == 0.0) return {};
    const double x = -smooth.approach(number[0], a), y = -smooth.approach(number[1], a);
    // (x - c y)/(1 - c^2), written without the cancellation that nearly equal normals would cause.
    const double apart =
        glm::dot(other.normal - one.normal, a) + curvature(smooth.moment, other) - curvature(smooth.moment, one);
    const double first = c > 0.5 ? x / (1.0 + c) + c * apart / determinant : (x - c * y) / determinant;
    const double second = c > 0.5 ? y / (1.0 + c) - c * apart / determinant : (y - c * x) / determinant;
    if (!(first >= 0.0 && second >= 0.0)) return {};
    return Closing<2>{{first, second}, a + (first * one.normal + second * other.normal)};
}

/// Nothing if they are dependent or one would have to pull. Three normals that are nearly in one plane push hard:
/// unlike those of two, their equations are of the angle's first power.
std::optional<Closing<3>> closing(const Smooth &smooth, const Vec3 &a, const std::array<uint32_t, 3> &number) {
    const auto normal = [&](size_t i) { return smooth.held[number[i % 3]].normal; };
    const double volume = glm::dot(normal(0), glm::cross(normal(1), normal(2)));
    if (std::abs(volume) <= smooth.moment.rounding) return {};
    Closing<3> closing{{}, Vec3(0.0)};
    for (size_t i = 0; i < 3; ++i) {
        const double bend = curvature(smooth.moment, smooth.held[number[i]]);
        closing.a -= bend / volume * glm::cross(normal(i + 1), normal(i + 2));
    }
    for (size_t i = 0; i < 3; ++i) {
        closing.sizes[i] = glm::dot(closing.a - a, glm::cross(normal(i + 1), normal(i + 2))) / volume;
        if (!(closing.sizes[i] >= 0.0)) return {};
    }
    return closing;
}

/// Whether the forces of so many contacts of a set keep all closed: adds them.
template<size_t Size>
bool pushBy(const Smooth &smooth, uint32_t among, Vec3 &a, std::array<double, kMostHeld> &push) {
    const auto count = static_cast<uint32_t>(smooth.held.size());
    return anySubset<Size>(count, [&](const std::array<uint32_t, Size> &number) {
        uint32_t bits = 0;
        for (const uint32_t i : number) bits |= 1U << i;
        if ((among & bits) != bits) return false;
        const std::optional<Closing<Size>> pushed = closing(smooth, a, number);
        if (!pushed || !allows(smooth, pushed->a, among, bits)) return false;
        for (size_t i = 0; i < Size; ++i) push[number[i]] = pushed->sizes[i];
        a = pushed->a;
        return true;
    });
}

/// Adds the forces of the contacts of a set to a; false if more than three of them have to push. Pairs are tried first:
/// if two contacts share a load, one alone would seem to carry it within rounding.
bool pushSmooth(const Smooth &smooth, uint32_t among, Vec3 &a, std::array<double, kMostHeld> &push) {
    return allows(smooth, a, among, 0) || pushBy<2>(smooth, among, a, push) || pushBy<1>(smooth, among, a, push) ||
           pushBy<3>(smooth, among, a, push);
}

/// Sets the modes. A contact that neither pushes nor opens is kept closed, so that the next moment finds it.
void fillSmooth(const Smooth &smooth, uint32_t among, const Vec3 &a, const std::array<double, kMostHeld> &push,
                Response &response) {
    for (uint32_t i = 0; i < smooth.held.size(); ++i) {
        if (!(among >> i & 1U)) continue;
        Reaction &reaction = response.reactions[i];
        const bool stays = push[i] > 0.0 || std::abs(smooth.approach(i, a)) <= smooth.zero;
        reaction.mode = stays ? Mode::smooth : Mode::open;
        reaction.pressure = smooth.inertia * push[i];
        reaction.force = reaction.pressure * smooth.held[i].normal;
    }
}

} // namespace

bool respondSmooth(const Moment &moment, std::span<const Held> held, uint32_t among, double zero, Response &response) {
    const Smooth smooth{moment, held, 1.0, zero};
    std::array<double, kMostHeld> push{};
    Vec3 a = moment.gravity;
    if (!pushSmooth(smooth, among, a, push)) return false;
    response.acceleration = a;
    fillSmooth(smooth, among, a, push, response);
    return true;
}

bool respondOnFloor(const Moment &moment, std::span<const Held> held, uint32_t floor, uint32_t among, double zero,
                    Response &response) {
    const Held &ground = held[floor];
    Reaction &reaction = response.reactions[floor];
    const Vec3 &up = ground.normal;
    const double R = moment.radius, N = -moment.gravity.z;
    if (N < 0.0) return false;
    const Vec3 level(moment.gravity.x, moment.gravity.y, 0.0);
    const bool slips = reaction.slip != Vec3(0.0) && !ground.isGlued && ground.friction > 0.0;
    const bool rolls = !slips && (ground.isGlued || ground.friction > 0.0);
    const double B = rolls ? 5.0 / 7.0 * (ground.resistance * N) : 0.0;

    Smooth smooth{moment, held, rolls ? 1.4 : 1.0, zero};
    std::array<double, kMostHeld> push{};
    Vec3 a = rolls ? 5.0 / 7.0 * level : level;
    Vec3 heading(0.0); // of the motion that resistance opposes
    if (slips) {
        reaction.direction = hat(reaction.slip);
        a -= ground.friction * N * reaction.direction;
    } else if (B > 0.0) {
        const Vec3 spin = rollingSpin(moment, ground);
        if (!isNoSlip(moment, R * spin)) heading = hat(glm::cross(spin, up)); // a heading of rounding counts as none
        a -= B * heading;
    }
    Vec3 others(0.0);
    if (among != 0) {
        if (!pushSmooth(smooth, among, a, push)) return false;
        if (std::count_if(push.begin(), push.end(), [](double size) { return size > 0.0; }) > 1) a = Vec3(0.0);
        for (uint32_t i = 0; i < held.size(); ++i) others += smooth.inertia * push[i] * held[i].normal;
    }
    if (B > 0.0 && heading == Vec3(0.0)) {
        // At rest: resistance balances as much of the remaining force as it can, model.md 2.1 R4.
        const double size = glm::length(a);
        heading = hat(a);
        a = size > B ? a - B * heading : Vec3(0.0);
        if (size <= B) heading = Vec3(0.0);
    }
    const Vec3 needed = -2.0 / 7.0 * (level + others);
    const bool tooSteep =
        rolls && !ground.isGlued && glm::length(needed) > ground.friction * N + kFits * accelerationScale(moment);
    if (tooSteep) return false;

    const Vec3 friction = slips ? -ground.friction * N * reaction.direction : rolls ? needed - B * heading : Vec3(0.0);
    reaction.mode = slips ? Mode::slipping : rolls ? Mode::sticking : Mode::smooth;
    reaction.pressure = N;
    reaction.force = N * up + friction;
    response.acceleration = a;
    response.rolling = glm::cross(up, heading);
    response.spinAcceleration = rolls ? glm::cross(up, a) / R : -kInertia / R * glm::cross(up, friction);
    if (among != 0) fillSmooth(smooth, among, a, push, response);
    return true;
}

Response respondAlone(const Moment &moment, const Held &contact, double zero, Response response) {
    Reaction &reaction = response.reactions[0];
    const Vec3 &n = contact.normal;
    const double pressure = -(glm::dot(moment.gravity, n) + curvature(moment, contact));
    if (pressure < -zero) return response;
    const double N = std::max(0.0, pressure);
    const Vec3 free = tangential(moment.gravity - glm::cross(moment.spin, contact.across * moment.velocity), n);
    const bool slips = reaction.slip != Vec3(0.0), isSmooth = contact.friction == 0.0;
    Vec3 friction = -2.0 / 7.0 * free;
    const double most = contact.friction * N + kFits * accelerationScale(moment);
    const bool holds = !slips && glm::length(friction) <= most + roundingOfLimit(moment, contact.friction);
    reaction.mode = isSmooth ? Mode::smooth : slips ? Mode::slipping : holds ? Mode::sticking : Mode::starting;
    reaction.direction = isSmooth || holds ? Vec3(0.0) : hat(slips ? reaction.slip : free);
    if (isSmooth || !holds) friction = -contact.friction * N * reaction.direction;
    reaction.pressure = N;
    reaction.force = N * n + friction;
    response.acceleration = moment.gravity + reaction.force;
    response.spinAcceleration = -kInertia / moment.radius * glm::cross(n, friction);
    return response;
}

} // namespace phys
