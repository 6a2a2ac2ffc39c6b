// SPDX-License-Identifier: MIT
// One combination of modes of lasting contacts, and the equations that it makes: model.md 14.1.
#pragma once

#include "contact/dense.h"
#include "contact/held.h"

namespace phys {

inline constexpr double kSettled = 4e-15; ///< change of a direction that is rounding

/// One combination of modes and its equations, model.md 14.1.
struct Combination {
    const Moment &moment;
    std::span<const Held> held;
    Work &work;
    std::array<Reaction, kMostHeld> reactions{};
    Vec3 rolling{0.0}; ///< against which resistance acts; shorter than 1 where less than all of it holds the ball
    Vec3 acceleration{0.0}, spinAcceleration{0.0};
    std::array<uint32_t, kMostHeld> column{}; ///< first unknown of each contact
    uint32_t unknowns = 0;
    uint32_t spent = 0; ///< bits of contacts whose friction is spent: they may start without an acceleration

    uint32_t count() const { return static_cast<uint32_t>(held.size()); }
    std::span<const Reaction> list() const { return {reactions.data(), held.size()}; }
    bool sticks(uint32_t i) const { return reactions[i].mode == Mode::sticking; }
    /// The one contact that sticks; count() if none does, or several.
    uint32_t onlySticking() const {
        uint32_t only = count();
        for (uint32_t i = 0; i < count(); ++i) {
            if (!sticks(i)) continue;
            if (only < count()) return count();
            only = i;
        }
        return only;
    }
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
void addRows(const Combination &c, uint32_t i, dense::Equations &equations, const Vec3 &slipRate, double apart);

/// Two sticking contacts leave a force along the line through both open, which moves nothing: the member of this family
/// with the least friction, model.md 14.1.
void addGauge(const Combination &c, uint32_t i, uint32_t j, dense::Equations &equations);

Vec3 slipRate(const Combination &c, uint32_t i);

/// Solves a combination's equations for its reactions and accelerations.
void solve(Combination &c);

/// Finds the reactions, and all directions that they depend on: of slips that start, and of resistance where a ball
/// starts to roll. False if the iteration doesn't converge.
bool settle(Combination &c);

/// Whether what the modes ask for holds, but for accelerations of `zero`.
bool fits(const Combination &c, double zero);

/// Moves the forces of sticking contacts along the lines through pairs of them, which changes no motion, as far as it
/// takes to bring both into their cones: model.md 14.1.
void share(Combination &c, double zero);

} // namespace phys
