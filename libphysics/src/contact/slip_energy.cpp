// SPDX-License-Identifier: MIT
#include "contact/slip_energy.h"

#include "contact/dense.h"

#include <array>
#include <cmath>

namespace phys {

namespace {

/// Sweeps converge like a geometric series, quickly unless rough contacts are nearly parallel or opposite.
constexpr int kSweepsBetween = 50;
constexpr int kMostNewtonSteps = 40;
/// Newton's steps are made for at most this many discs, whose system is kept on the stack; for more, sweeps must do.
constexpr size_t kMostInNewtonStep = dense::kMostUnknowns / 2;

/// A unit impulse changes the slip of its own contact by 7/2.
constexpr double kSlipShare = 2.0 / 7.0;

void apply(const Vec3 &normal, const Vec3 &impulse, double radius, Motion &motion) {
    motion.velocity += impulse;
    motion.spin -= 2.5 / radius * glm::cross(normal, impulse);
}

/// The optimal impulse of a disc while all others are fixed.
Vec3 best(const FrictionDisc &disc, double radius, const Motion &motion) {
    return clipped(disc.impulse - kSlipShare * slipAt(motion, disc.normal, radius), disc.most);
}

/// Gauss-Seidel; each contact's minimum has a closed form because its slip responds equally in all directions. True
/// once nothing changes by more than `negligible`.
bool sweep(std::span<FrictionDisc> discs, double radius, double negligible, Motion &motion, Work &work) {
    for (int i = 0; i < kSweepsBetween && !work.isTooMuch(); ++i) {
        double largest = 0.0;
        work.add(Work::kDisc * discs.size());
        for (FrictionDisc &disc : discs) {
            const Vec3 impulse = best(disc, radius, motion);
            const Vec3 change = impulse - disc.impulse;
            apply(disc.normal, change, radius, motion);
            disc.impulse = impulse;
            largest = std::max(largest, glm::length(change));
        }
        if (largest <= negligible) return true;
    }
    return false;
}

double residual(std::span<const FrictionDisc> discs, double radius, const Motion &motion) {
    double sum = 0.0;
    for (const FrictionDisc &disc : discs) {
        const Vec3 wrong = disc.impulse - best(disc, radius, motion);
        sum += glm::dot(wrong, wrong);
    }
    return sum;
}

/// Two directions across a disc's normal: that of its target, and the one perpendicular to both. Reflections and
/// quarter turns preserve them, so that computations in them are independent of the axes.
struct Frame {
    Vec3 target, along, across;

    Vec3 operator[](size_t i) const { return i == 0 ? along : across; }

    /// Derivative of `clipped` at the target, along it and across it.
    std::array<double, 2> clippingSlope(double most) const {
        const double size = glm::length(target);
        if (size <= most) return {1.0, 1.0};
        return {0.0, most / size};
    }
};

Frame frameOf(const FrictionDisc &disc, double radius, const Motion &motion) {
    const Vec3 target = disc.impulse - kSlipShare * slipAt(motion, disc.normal, radius);
    Vec3 along = target != Vec3(0.0) ? target : Vec3(-disc.normal.y, disc.normal.x, 0.0);
    along = along != Vec3(0.0) ? along / glm::length(along) : Vec3(1.0, 0.0, 0.0);
    return {target, along, glm::cross(disc.normal, along)};
}

/// Change of the slip at one contact, in one direction, by a unit impulse at another contact in another direction.
double slipSlope(const Vec3 &slipping, const Vec3 &along, const Vec3 &pushed, const Vec3 &pushing) {
    return (1.0 + 2.5 * glm::dot(slipping, pushed)) * glm::dot(along, pushing) -
           2.5 * glm::dot(along, pushed) * glm::dot(slipping, pushing);
}

/// A semismooth Newton step on `impulse = best(impulse)`; accepted only if it reduces the residual.
void newtonStep(std::span<FrictionDisc> discs, double radius, Motion &motion, Work &work) {
    const size_t count = discs.size();
    if (count > kMostInNewtonStep) return;
    work.add(Work::kDisc * count * count * (4 + count));
    std::array<Frame, kMostInNewtonStep> frames;
    for (size_t i = 0; i < count; ++i) frames[i] = frameOf(discs[i], radius, motion);
    dense::Equations equations(static_cast<uint32_t>(2 * count));
    for (size_t i = 0; i < count; ++i) {
        const std::array<double, 2> slope = frames[i].clippingSlope(discs[i].most);
        const Vec3 wrong = discs[i].impulse - clipped(frames[i].target, discs[i].most);
        for (size_t row = 0; row < 2; ++row) {
            dense::Values &factors = equations.add(-glm::dot(wrong, frames[i][row]));
            for (size_t j = 0; j < count; ++j) {
                for (size_t column = 0; column < 2; ++column) {
                    const double change =
                        slipSlope(discs[i].normal, frames[i][row], discs[j].normal, frames[j][column]);
                    factors[2 * j + column] = kSlipShare * slope[row] * change;
                }
            }
            factors[2 * i + row] += 1.0 - slope[row];
        }
    }
    const dense::Values steps = equations.solve();
    std::array<FrictionDisc, kMostInNewtonStep> next;
    Motion moved = motion;
    for (size_t i = 0; i < count; ++i) {
        next[i] = discs[i];
        const Vec3 step = steps[2 * i] * frames[i].along + steps[2 * i + 1] * frames[i].across;
        next[i].impulse = clipped(discs[i].impulse + step, discs[i].most);
        apply(next[i].normal, next[i].impulse - discs[i].impulse, radius, moved);
    }
    const std::span<FrictionDisc> candidates(next.data(), count);
    if (!(residual(candidates, radius, moved) < residual(discs, radius, motion))) return;
    std::copy(candidates.begin(), candidates.end(), discs.begin());
    motion = moved;
}

} // namespace

void minimiseSlipEnergy(std::span<FrictionDisc> discs, double radius, Motion &motion, Work &work) {
    const double negligible = kRounding * (glm::length(motion.velocity) + radius * glm::length(motion.spin));
    if (discs.size() == 1) {
        apply(discs[0].normal, discs[0].impulse = best(discs[0], radius, motion), radius, motion);
        return;
    }
    for (int i = 0; i < kMostNewtonSteps && !sweep(discs, radius, negligible, motion, work); ++i) {
        newtonStep(discs, radius, motion, work);
    }
}

} // namespace phys
