// SPDX-License-Identifier: MIT
#include "contact/modes.h"

#include "contact/dense.h"
#include "contact/mirror.h"

#include <algorithm>
#include <cmath>

namespace phys {

namespace {

constexpr int kMostPasses = 1000;        // of the direction in which a slip starts
constexpr double kFits = 1e-11;          // relative: a condition that holds within this holds
constexpr double kRoughly = 1e6 * kFits; // then directions that settle too slowly do: friction still only takes energy
constexpr double kInertia = 2.5;         // m R^2 / I of a solid ball
constexpr double kSlipPerFriction = 3.5; // what friction at one contact changes its slip by: 1 + 5/2
constexpr double kNoSlip = 64.0 * 0x1p-52; // relative
constexpr uint32_t kMostPressing = 4;      // of contacts with different normals, model.md 14.1

double squared(const Vec3 &v) { return glm::dot(v, v); }

/// Also of vectors whose squares underflow.
Vec3 hat(Vec3 v) {
    const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (most == 0.0) return Vec3(0.0);
    if (most < 1e-100) v /= most;
    return v / glm::length(v);
}

Vec3 tangential(const Vec3 &v, const Vec3 &normal) { return v - glm::dot(v, normal) * normal; }

bool isFace(const Held &held) { return held.across.x + held.across.y + held.across.z == 1.0; }
bool isTopFace(const Held &held) { return isFace(held) && held.normal.z == 1.0; }

/// What the curvature of a feature adds to the normal acceleration: |P v|^2 / R.
double curvature(const Moment &moment, const Held &held) {
    return isFace(held) ? 0.0 : squared(held.across * moment.velocity) / moment.radius;
}

/// Part of the spin that rolling resistance acts against.
Vec3 rollingSpin(const Moment &moment, const Held &held) { return tangential(moment.spin, held.normal); }

double resistancePerPressure(const Moment &moment, const Held &held) {
    return kInertia * held.resistance / moment.radius;
}

// ------------------------------------------------------------------------------------------------ smooth contacts

/// A floor that needs no share in what the others do, and smooth contacts whose normals it doesn't know: the reactions
/// of those solve a linear complementarity problem whose solution is unique.
struct Smooth {
    const Moment &moment;
    std::span<const Held> held;
    double inertia; ///< mass that a push at the centre moves: 7/5 where the ball must roll
    double zero;    ///< acceleration that is none but for rounding

    double approach(uint32_t i, const Vec3 &a) const {
        return glm::dot(held[i].normal, a) + curvature(moment, held[i]);
    }
};

/// Whether all contacts but those of a set let the ball accelerate by a.
bool allows(const Smooth &smooth, const Vec3 &a, uint32_t among, uint32_t but) {
    for (uint32_t i = 0; i < smooth.held.size(); ++i) {
        if ((among >> i & 1U) && !(but >> i & 1U) && smooth.approach(i, a) < -smooth.zero) return false;
    }
    return true;
}

/// Pushes of two contacts that keep both; false if they are parallel or one would have to pull.
bool pushOfTwo(const Smooth &smooth, const Vec3 &a, uint32_t i, uint32_t j, double &first, double &second) {
    const Vec3 line = glm::cross(smooth.held[i].normal, smooth.held[j].normal);
    const double c = glm::dot(smooth.held[i].normal, smooth.held[j].normal), determinant = glm::dot(line, line);
    if (determinant == 0.0) return false;
    const double x = -smooth.approach(i, a), y = -smooth.approach(j, a);
    first = (x - c * y) / determinant;
    second = (y - c * x) / determinant;
    return first >= 0.0 && second >= 0.0;
}

/// Adds the pushes of the contacts among a set to a; false if more than two have to push.
bool pushSmooth(const Smooth &smooth, uint32_t among, Vec3 &a, std::array<double, kMostHeld> &push) {
    const uint32_t count = static_cast<uint32_t>(smooth.held.size());
    if (allows(smooth, a, among, 0)) return true;
    for (uint32_t i = 0; i < count; ++i) {
        if (!(among >> i & 1U)) continue;
        const double size = -smooth.approach(i, a);
        const Vec3 pushed = a + size * smooth.held[i].normal;
        if (size <= 0.0 || !allows(smooth, pushed, among, 1U << i)) continue;
        push[i] = size;
        a = pushed;
        return true;
    }
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t j = i + 1; j < count; ++j) {
            double first = 0.0, second = 0.0;
            if (!(among >> i & 1U) || !(among >> j & 1U) || !pushOfTwo(smooth, a, i, j, first, second)) continue;
            const Vec3 pushed = a + (first * smooth.held[i].normal + second * smooth.held[j].normal);
            if (!allows(smooth, pushed, among, 1U << i | 1U << j)) continue;
            push[i] = first;
            push[j] = second;
            a = pushed;
            return true;
        }
    }
    return false;
}

/// Contacts that neither push nor let go: kept, so that the next moment finds them.
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

/// Only smooth contacts: they push as on a point.
bool respondSmooth(const Moment &moment, std::span<const Held> held, uint32_t among, double zero, Response &response) {
    const Smooth smooth{moment, held, 1.0, zero};
    std::array<double, kMostHeld> push{};
    Vec3 a = moment.gravity;
    if (!pushSmooth(smooth, among, a, push)) return false;
    response.acceleration = a;
    fillSmooth(smooth, among, a, push, response);
    return true;
}

/// A ball on a floor whose other contacts are upright and smooth: the floor carries it, the others push in the plane.
/// False if the floor's friction has to be found together with them.
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
    const double B = rolls ? 5.0 / 7.0 * ground.resistance * N : 0.0;

    Smooth smooth{moment, held, rolls ? 1.4 : 1.0, zero};
    std::array<double, kMostHeld> push{};
    Vec3 a = rolls ? 5.0 / 7.0 * level : level;
    Vec3 heading(0.0); // of the way that resistance acts against
    if (slips) {
        reaction.direction = hat(reaction.slip);
        a -= ground.friction * N * reaction.direction;
    } else if (B > 0.0) {
        heading = hat(glm::cross(rollingSpin(moment, ground), up));
        a -= B * heading;
    }
    if (!pushSmooth(smooth, among, a, push)) return false;
    if (std::count_if(push.begin(), push.end(), [](double size) { return size > 0.0; }) > 1) a = Vec3(0.0);
    if (B > 0.0 && heading == Vec3(0.0)) {
        // At rest: resistance balances what it can of what the others leave, model.md 2.1 R4.
        const double size = glm::length(a);
        heading = hat(a);
        a = size > B ? a - B * heading : Vec3(0.0);
        if (size <= B) heading = Vec3(0.0);
    }
    Vec3 others(0.0);
    for (uint32_t i = 0; i < held.size(); ++i) others += smooth.inertia * push[i] * held[i].normal;
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
    fillSmooth(smooth, among, a, push, response);
    return true;
}

// ------------------------------------------------------------------------------------------- contacts with friction

/// One combination of modes and its equations, model.md 14.1.
struct Combination {
    const Moment &moment;
    std::span<const Held> held;
    std::array<Reaction, kMostHeld> reactions{};
    Vec3 rolling{0.0}; ///< against which resistance acts; shorter than 1 where less than all of it holds the ball
    Vec3 acceleration{0.0}, spinAcceleration{0.0};
    std::array<uint32_t, kMostHeld> column{}; ///< first unknown of each contact
    uint32_t unknowns = 0;

    uint32_t count() const { return static_cast<uint32_t>(held.size()); }
    bool sticks(uint32_t i) const { return reactions[i].mode == Mode::sticking; }
    bool isOpen(uint32_t i) const { return reactions[i].mode == Mode::open; }
    bool isHeld() const { return squared(rolling) < 1.0 - 1e-12; }

    /// What a ball that contact i holds keeps: at most a change of its spin about the normal.
    void rest(uint32_t i, double zero) {
        const Vec3 pivoting = spinAcceleration - tangential(spinAcceleration, held[i].normal);
        acceleration = Vec3(0.0);
        spinAcceleration = glm::length(pivoting) * moment.radius > zero ? pivoting : Vec3(0.0);
    }

    /// r of contact i per unit of its unknown `part`.
    Vec3 basis(uint32_t i, uint32_t part) const {
        if (!sticks(i)) return held[i].normal - held[i].friction * reactions[i].direction;
        return {part == 0 ? 1.0 : 0.0, part == 1 ? 1.0 : 0.0, part == 2 ? 1.0 : 0.0};
    }
    uint32_t width(uint32_t i) const { return isOpen(i) ? 0 : sticks(i) ? 3 : 1; }

    Vec3 spinPerForce(uint32_t i, const Vec3 &force) const {
        Vec3 spin = -kInertia / moment.radius * glm::cross(held[i].normal, force);
        if (sticks(i) && held[i].resistance > 0.0) {
            spin -= resistancePerPressure(moment, held[i]) * glm::dot(force, held[i].normal) * rolling;
        }
        return spin;
    }
};

/// What contact i asks of all forces: of the slip's rate where it sticks, of the normal acceleration elsewhere.
void addRows(const Combination &c, uint32_t i, dense::Equations &equations, const Vec3 &slipRate, double apart) {
    const Held &contact = c.held[i];
    const Moment &moment = c.moment;
    const bool sticks = c.sticks(i);
    for (uint32_t row = 0; row < (sticks ? 3U : 1U); ++row) {
        Vec3 axis = contact.normal;
        if (sticks) axis = {row == 0 ? 1.0 : 0.0, row == 1 ? 1.0 : 0.0, row == 2 ? 1.0 : 0.0};
        dense::Row &equation = equations.add();
        for (uint32_t j = 0; j < c.count(); ++j) {
            for (uint32_t part = 0; part < c.width(j); ++part) {
                const Vec3 force = c.basis(j, part);
                Vec3 change = force;
                if (sticks) change -= moment.radius * glm::cross(c.spinPerForce(j, force), contact.normal);
                equation.factors[c.column[j] + part] = glm::dot(axis, change);
            }
        }
        equation.value = sticks ? glm::dot(axis, slipRate) : apart;
    }
}

/// Two sticking contacts leave a force along the line through both open, which moves nothing: the member of this family
/// with the least friction, model.md 14.1.
void addGauge(const Combination &c, uint32_t i, uint32_t j, dense::Equations &equations) {
    const Vec3 line = hat(c.held[i].normal - c.held[j].normal);
    const Vec3 at[] = {tangential(line, c.held[i].normal), -tangential(line, c.held[j].normal)};
    dense::Row &equation = equations.add();
    for (uint32_t part = 0; part < 3; ++part) {
        equation.factors[c.column[i] + part] = at[0][static_cast<int>(part)];
        equation.factors[c.column[j] + part] = at[1][static_cast<int>(part)];
    }
    equation.value = 0.0;
}

/// Accelerations and slips' rates that follow from the reactions.
void accelerate(Combination &c) {
    c.acceleration = c.moment.gravity;
    c.spinAcceleration = Vec3(0.0);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.isOpen(i)) continue;
        c.acceleration += c.reactions[i].force;
        c.spinAcceleration += c.spinPerForce(i, c.reactions[i].force);
    }
}

Vec3 slipRate(const Combination &c, uint32_t i) {
    const Held &contact = c.held[i];
    return c.acceleration - c.moment.radius * glm::cross(c.spinAcceleration, contact.normal) -
           glm::cross(c.moment.spin, contact.across * c.moment.velocity);
}

/// Solves a combination's equations for its reactions.
void solve(Combination &c) {
    c.unknowns = 0;
    for (uint32_t i = 0; i < c.count(); ++i) {
        c.column[i] = c.unknowns;
        c.unknowns += c.width(i);
    }
    dense::Equations equations(c.unknowns);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (!c.isOpen(i)) {
            const Vec3 turning = glm::cross(c.moment.spin, c.held[i].across * c.moment.velocity);
            addRows(c, i, equations, turning - c.moment.gravity,
                    -(glm::dot(c.held[i].normal, c.moment.gravity) + curvature(c.moment, c.held[i])));
        }
        for (uint32_t j = 0; j < i; ++j) {
            if (c.sticks(i) && c.sticks(j)) addGauge(c, i, j, equations);
        }
    }
    const dense::Values x = equations.solve();
    for (uint32_t i = 0; i < c.count(); ++i) {
        Reaction &reaction = c.reactions[i];
        reaction.force = Vec3(0.0);
        for (uint32_t part = 0; part < c.width(i); ++part) reaction.force += x[c.column[i] + part] * c.basis(i, part);
        reaction.pressure = c.isOpen(i) ? 0.0 : glm::dot(reaction.force, c.held[i].normal);
    }
    accelerate(c);
}

/// Turns the directions of slips that start, and of a ball that starts to roll against resistance, until they agree
/// with the accelerations. False if they don't settle.
bool settleDirections(Combination &c) {
    bool starts = false;
    for (uint32_t i = 0; i < c.count(); ++i) starts = starts || c.reactions[i].mode == Mode::starting;
    if (!starts) {
        solve(c);
        return true;
    }
    for (int pass = 0; pass < kMostPasses; ++pass) {
        solve(c);
        double change = 0.0;
        for (uint32_t i = 0; i < c.count(); ++i) {
            Reaction &reaction = c.reactions[i];
            if (reaction.mode != Mode::starting) continue;
            const Vec3 rate = tangential(slipRate(c, i), c.held[i].normal);
            const Vec3 next =
                hat(c.held[i].friction * reaction.pressure * reaction.direction + rate / kSlipPerFriction);
            change = std::max(change, glm::length(next - reaction.direction));
            reaction.direction = next;
        }
        if (change <= 1e-14) {
            solve(c);
            return true;
        }
    }
    return false;
}

/// Whether what the modes ask for holds.
bool fits(const Combination &c, double zero) {
    for (uint32_t i = 0; i < c.count(); ++i) {
        const Reaction &reaction = c.reactions[i];
        const double apart = glm::dot(c.held[i].normal, c.acceleration) + curvature(c.moment, c.held[i]);
        switch (reaction.mode) {
        case Mode::open:
            if (apart < -zero) return false;
            break;
        case Mode::starting:
            if (std::abs(apart) > zero || reaction.pressure < -zero) return false;
            if (glm::dot(slipRate(c, i), reaction.direction) <= zero) return false;
            break;
        case Mode::sticking:
            if (std::abs(apart) > zero || reaction.pressure < -zero) return false;
            if (c.held[i].isGlued) break;
            if (glm::length(slipRate(c, i)) > zero) return false;
            if (reserve(c.held[i], reaction, c.rolling) <
                -2.0 * zero * c.held[i].friction * reaction.pressure - zero * zero)
                return false;
            break;
        default:
            if (std::abs(apart) > zero || reaction.pressure < -zero) return false;
        }
    }
    return true;
}

double sumOfPressures(const Combination &c) {
    double sum = 0.0;
    for (uint32_t i = 0; i < c.count(); ++i) sum += c.reactions[i].pressure;
    return sum;
}

uint32_t closedContacts(const Combination &c) {
    uint32_t closed = 0;
    for (uint32_t i = 0; i < c.count(); ++i) closed += c.isOpen(i) ? 0U : 1U;
    return closed;
}

/// Modes that a contact may be in; `index` counts them. False beyond the last.
bool modeOf(const Held &held, const Reaction &reaction, uint32_t index, Mode &mode) {
    const bool slips = reaction.slip != Vec3(0.0);
    const Mode smooth[] = {Mode::open, Mode::smooth}, sliding[] = {Mode::open, Mode::slipping};
    const Mode glued[] = {Mode::open, Mode::sticking}, still[] = {Mode::open, Mode::sticking, Mode::starting};
    if (held.isGlued) return index < 2 && (mode = glued[index], true);
    if (held.friction == 0.0) return index < 2 && (mode = smooth[index], true);
    if (slips) return index < 2 && (mode = sliding[index], true);
    return index < 3 && (mode = still[index], true);
}

/// The contact at which rolling resistance acts; count() if none does.
uint32_t resisted(const Combination &c) {
    uint32_t i = 0;
    while (i < c.count() && !(c.sticks(i) && c.held[i].resistance > 0.0)) ++i;
    return i;
}

/// Resistance of a ball that starts to roll: against the way that it then takes, or the share of the most possible that
/// holds it, model.md 14.1. False if directions don't settle.
bool startRolling(Combination &c, uint32_t i, double scale) {
    const Vec3 free = tangential(c.spinAcceleration, c.held[i].normal);
    if (glm::length(free) * c.moment.radius <= kFits * scale) return true;
    bool isSettled = true;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        const double most = resistancePerPressure(c.moment, c.held[i]) * c.reactions[i].pressure;
        const Vec3 rate = tangential(c.spinAcceleration, c.held[i].normal);
        // A torque changes the rate by 2/7 of itself at one contact, and by less at several.
        const Vec3 torque = most * c.rolling + kSlipPerFriction * rate;
        const Vec3 next = most > 0.0 ? torque / std::max(most, glm::length(torque)) : Vec3(0.0);
        const double change = glm::length(next - c.rolling);
        c.rolling = next;
        isSettled = settleDirections(c);
        if (change <= 4.0 * 0x1p-52 || !isSettled) break;
    }
    if (c.isHeld()) c.rest(i, kFits * scale);
    return isSettled;
}

/// Directions in which slips begin: against the friction that would be needed to stop them.
bool aimStarts(Combination &c) {
    Combination stuck = c;
    bool starts = false;
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode != Mode::starting) continue;
        stuck.reactions[i].mode = Mode::sticking;
        starts = true;
    }
    if (!starts) return true;
    solve(stuck);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.reactions[i].mode != Mode::starting) continue;
        c.reactions[i].direction = -hat(tangential(stuck.reactions[i].force, c.held[i].normal));
        if (c.reactions[i].direction == Vec3(0.0)) return false;
    }
    return true;
}

/// Finds the reactions of a combination, and all directions that they depend on. False if those don't settle.
bool settle(Combination &c, double scale) {
    const uint32_t i = resisted(c);
    const Vec3 spin = i < c.count() ? rollingSpin(c.moment, c.held[i]) : Vec3(0.0);
    const bool rolls = !isNoSlip(c.moment, c.moment.radius * spin);
    if (rolls) c.rolling = hat(spin);
    if (!aimStarts(c)) return false;
    const bool isSettled = settleDirections(c);
    if (i == c.count() || rolls) return isSettled;
    return startRolling(c, i, scale) && isSettled;
}

/// One contact alone has a closed form.
Response respondAlone(const Moment &moment, const Held &contact, double zero, Response response) {
    Reaction &reaction = response.reactions[0];
    const Vec3 &n = contact.normal;
    const double N = -(glm::dot(moment.gravity, n) + curvature(moment, contact));
    if (N < -zero) return response;
    const Vec3 free = tangential(moment.gravity - glm::cross(moment.spin, contact.across * moment.velocity), n);
    const bool slips = reaction.slip != Vec3(0.0);
    Vec3 friction = -2.0 / 7.0 * free;
    const bool holds = !slips && glm::length(friction) <= contact.friction * N + kFits * accelerationScale(moment);
    reaction.mode = slips ? Mode::slipping : holds ? Mode::sticking : Mode::starting;
    if (contact.friction == 0.0) reaction.mode = Mode::smooth;
    reaction.direction = slips ? hat(reaction.slip) : holds ? Vec3(0.0) : hat(free);
    if (contact.friction == 0.0) reaction.direction = Vec3(0.0);
    if (!holds || contact.friction == 0.0) friction = -contact.friction * N * reaction.direction;
    reaction.pressure = N;
    reaction.force = N * n + friction;
    response.acceleration = moment.gravity + reaction.force;
    response.spinAcceleration = -kInertia / moment.radius * glm::cross(n, friction);
    return response;
}

/// Moves the forces of sticking contacts along the lines through pairs of them, which changes no motion, as far as it
/// takes to bring both into their cones: model.md 14.1.
void share(Combination &c, double zero) {
    for (uint32_t i = 0; i < c.count(); ++i) {
        for (uint32_t j = 0; j < i; ++j) {
            if (!c.sticks(i) || !c.sticks(j)) continue;
            const Vec3 line = hat(c.held[i].normal - c.held[j].normal);
            std::array<double, 16> moves{};
            uint32_t count = 1;
            const auto addRoots = [&](uint32_t k, const Vec3 &along) {
                // |r + s along|^2 = (1 + mu^2) (n.(r + s along))^2
                const double most = 1.0 + c.held[k].friction * c.held[k].friction;
                const Vec3 &r = c.reactions[k].force, &n = c.held[k].normal;
                const double rn = glm::dot(r, n), ln = glm::dot(along, n);
                const double q2 = squared(along) - most * ln * ln;
                const double q1 = glm::dot(r, along) - most * rn * ln, q0 = squared(r) - most * rn * rn;
                const double discriminant = q1 * q1 - q2 * q0;
                if (c.held[k].isGlued || discriminant < 0.0 || q2 == 0.0) return;
                moves[count++] = (-q1 + std::sqrt(discriminant)) / q2;
                moves[count++] = (-q1 - std::sqrt(discriminant)) / q2;
            };
            addRoots(i, line);
            addRoots(j, -line);
            std::sort(moves.begin(), moves.begin() + count,
                      [](double a, double b) { return std::abs(a) < std::abs(b); });
            const Reaction before[] = {c.reactions[i], c.reactions[j]};
            for (uint32_t move = 0; move < count; ++move) {
                c.reactions[i].force = before[0].force + moves[move] * line;
                c.reactions[j].force = before[1].force - moves[move] * line;
                for (const uint32_t k : {i, j}) {
                    c.reactions[k].pressure = glm::dot(c.reactions[k].force, c.held[k].normal);
                }
                if (fits(c, zero)) return;
            }
            c.reactions[i] = before[0];
            c.reactions[j] = before[1];
        }
    }
}

/// Tries all combinations.
Response enumerate(const Moment &moment, std::span<const Held> held, const Excluded &excluded, const Response &known,
                   double tolerance, bool shares) {
    const double scale = accelerationScale(moment), zero = tolerance * scale;
    const uint32_t count = static_cast<uint32_t>(held.size());
    Combination best{moment, held};
    bool isFound = false;
    std::array<uint32_t, kMostHeld> index{};
    for (;;) {
        Combination c{moment, held};
        bool isAllowed = true;
        for (uint32_t i = 0; i < count; ++i) {
            c.reactions[i].slip = known.reactions[i].slip;
            c.reactions[i].direction = hat(c.reactions[i].slip);
            modeOf(held[i], c.reactions[i], index[i], c.reactions[i].mode);
            isAllowed = isAllowed && !((excluded.closed >> i & 1U) && !c.isOpen(i)) &&
                        !((excluded.sticking >> i & 1U) && c.sticks(i));
        }
        if (isAllowed && closedContacts(c) <= kMostPressing && (settle(c, scale) || tolerance >= kRoughly)) {
            if (shares && !fits(c, zero)) share(c, zero);
            if (fits(c, zero)) {
                const double more = isFound ? sumOfPressures(c) - sumOfPressures(best) : 0.0;
                const bool isBetter = !isFound || more < -1e-9 * scale ||
                                      (more <= 1e-9 * scale && closedContacts(c) > closedContacts(best));
                if (isBetter) std::copy(c.reactions.begin(), c.reactions.end(), best.reactions.begin());
                if (isBetter) best.acceleration = c.acceleration, best.spinAcceleration = c.spinAcceleration;
                if (isBetter) best.rolling = c.isHeld() ? Vec3(0.0) : c.rolling;
                isFound = true;
            }
        }
        uint32_t digit = 0;
        for (; digit < count; ++digit) {
            Mode unused;
            if (modeOf(held[digit], known.reactions[digit], ++index[digit], unused)) break;
            index[digit] = 0;
        }
        if (digit == count) break;
    }
    Response response = known;
    response.isFound = isFound;
    if (!isFound) return response;
    response.reactions = best.reactions;
    response.acceleration = best.acceleration;
    response.spinAcceleration = best.spinAcceleration;
    response.rolling = best.rolling;
    return response;
}

} // namespace

void endSlips(Moment &moment, std::span<const Held> held) {
    Moment still = moment;
    still.gravity = Vec3(0.0);
    Combination c{still, held};
    for (uint32_t i = 0; i < c.count(); ++i) {
        c.reactions[i].mode = held[i].friction > 0.0 ? Mode::sticking : Mode::smooth;
        c.column[i] = c.unknowns;
        c.unknowns += c.width(i);
    }
    dense::Equations equations(c.unknowns);
    for (uint32_t i = 0; i < c.count(); ++i) {
        const Vec3 slip = moment.velocity - moment.radius * glm::cross(moment.spin, held[i].normal);
        addRows(c, i, equations, c.sticks(i) ? -slip : Vec3(0.0), -glm::dot(held[i].normal, moment.velocity));
        for (uint32_t j = 0; j < i; ++j) {
            if (c.sticks(i) && c.sticks(j)) addGauge(c, i, j, equations);
        }
    }
    const dense::Values x = equations.solve();
    for (uint32_t i = 0; i < c.count(); ++i) {
        Vec3 impulse(0.0);
        for (uint32_t part = 0; part < c.width(i); ++part) impulse += x[c.column[i] + part] * c.basis(i, part);
        moment.velocity += impulse;
        moment.spin += -kInertia / moment.radius * glm::cross(held[i].normal, impulse);
    }
}

double accelerationScale(const Moment &moment) {
    return glm::length(moment.gravity) + squared(moment.velocity) / moment.radius +
           moment.radius * squared(moment.spin);
}

double speedScale(const Moment &moment) {
    return glm::length(moment.velocity) + moment.radius * glm::length(moment.spin) +
           std::sqrt(moment.radius * glm::length(moment.gravity));
}

Vec3 slipAt(const Moment &moment, const Vec3 &normal) {
    return tangential(moment.velocity - moment.radius * glm::cross(moment.spin, normal), normal);
}

bool isNoSlip(const Moment &moment, const Vec3 &slip) {
    const double size = kNoSlip * speedScale(moment);
    return squared(slip) <= size * size;
}

double reserve(const Held &held, const Reaction &reaction, const Vec3 &rolling) {
    const Vec3 friction = reaction.force - reaction.pressure * held.normal +
                          5.0 / 7.0 * held.resistance * reaction.pressure * glm::cross(rolling, held.normal);
    const double most = held.friction * reaction.pressure;
    return most * most - squared(friction);
}

Response respond(const Moment &moment, std::span<const Held> held, const Excluded &excluded) {
    const uint32_t opened = excluded.closed;
    Response response;
    response.count = static_cast<uint32_t>(held.size());
    response.acceleration = moment.gravity;
    if (held.empty()) return response;
    const double zero = moment.rounding * accelerationScale(moment);
    uint32_t floor = kMostHeld, smooth = 0;
    bool isDecoupled = true;
    for (uint32_t i = 0; i < held.size(); ++i) {
        Vec3 slip(0.0);
        if (!held[i].isGlued && held[i].friction > 0.0) slip = slipAt(moment, held[i].normal);
        if (slip != Vec3(0.0) && isNoSlip(moment, slip)) slip = Vec3(0.0);
        response.reactions[i] = {Mode::open, 0.0, Vec3(0.0), Vec3(0.0), slip};
        if (opened >> i & 1U) continue;
        if (isTopFace(held[i]) && floor == kMostHeld) {
            floor = i;
        } else {
            smooth |= 1U << i;
            isDecoupled = isDecoupled && held[i].friction == 0.0;
        }
    }
    if (isDecoupled && excluded.sticking == 0) {
        bool isLevel = true;
        for (uint32_t i = 0; i < held.size(); ++i)
            isLevel = isLevel && (!(smooth >> i & 1U) || held[i].normal.z == 0.0);
        response.noise = floor == kMostHeld ? zero : 0.0;
        if (floor == kMostHeld && respondSmooth(moment, held, smooth, zero, response)) return response;
        if (floor != kMostHeld && isLevel && respondOnFloor(moment, held, floor, smooth, zero, response))
            return response;
    }
    response.noise = zero;
    for (uint32_t i = 0; i < held.size(); ++i) { // those tried what they are not
        response.reactions[i] = {Mode::open, 0.0, Vec3(0.0), Vec3(0.0), response.reactions[i].slip};
    }
    if (held.size() == 1) {
        if (opened & 1U) return response;
        if (!held[0].isGlued && excluded.sticking == 0) return respondAlone(moment, held[0], zero, response);
    }
    const Mirror mirror(moment, held);
    const Sorted sorted(mirror, held);
    Response seen = response;
    Excluded excludedSeen;
    for (uint32_t i = 0; i < sorted.count; ++i) {
        seen.reactions[i].slip = mirror.seen(response.reactions[sorted.index[i]].slip);
        excludedSeen.closed |= (opened >> sorted.index[i] & 1U) << i;
        excludedSeen.sticking |= (excluded.sticking >> sorted.index[i] & 1U) << i;
    }
    const Response unknown = seen;
    seen.isFound = false;
    // A slip that has just begun has a direction of few digits, so that what depends on it fits only roughly.
    for (const double tolerance : {kFits, 1e3 * kFits, kRoughly}) {
        if (!seen.isFound)
            seen = enumerate(mirror.seen(moment), sorted.list(), excludedSeen, unknown, tolerance, false);
        if (!seen.isFound) seen = enumerate(mirror.seen(moment), sorted.list(), excludedSeen, unknown, tolerance, true);
    }
    response.isFound = seen.isFound;
    response.acceleration = mirror.back(seen.acceleration);
    response.spinAcceleration = mirror.backSpin(seen.spinAcceleration);
    response.rolling = mirror.backSpin(seen.rolling);
    for (uint32_t i = 0; i < sorted.count; ++i) {
        Reaction reaction = seen.reactions[i];
        reaction.force = mirror.back(reaction.force);
        reaction.direction = mirror.back(reaction.direction);
        reaction.slip = response.reactions[sorted.index[i]].slip;
        response.reactions[sorted.index[i]] = reaction;
    }
    return response;
}

} // namespace phys
