// SPDX-License-Identifier: MIT
#include "law.h"

#include <algorithm>
#include <bit>

namespace witness {

namespace {

constexpr int kMostRounds = 64;
constexpr int kMostSweeps = 20000;
constexpr Real kUlp = 2e-19L;

/// Solves the system of at most three equations by elimination with full pivoting. False if it is singular.
bool solve(Real matrix[3][4], int size, Real *out) {
    int columns[3] = {0, 1, 2};
    for (int k = 0; k < size; ++k) {
        int row = k;
        int column = k;
        for (int i = k; i < size; ++i) {
            for (int j = k; j < size; ++j) {
                if (std::abs(matrix[i][j]) > std::abs(matrix[row][column])) row = i, column = j;
            }
        }
        if (std::abs(matrix[row][column]) < 1e-13L) return false;
        for (int j = 0; j <= size; ++j) std::swap(matrix[k][j], matrix[row][j]);
        for (int i = 0; i < size; ++i) std::swap(matrix[i][k], matrix[i][column]);
        std::swap(columns[k], columns[column]);
        for (int i = k + 1; i < size; ++i) {
            const Real factor = matrix[i][k] / matrix[k][k];
            for (int j = k; j <= size; ++j) matrix[i][j] -= factor * matrix[k][j];
        }
    }
    Real x[3];
    for (int k = size - 1; k >= 0; --k) {
        Real sum = matrix[k][size];
        for (int j = k + 1; j < size; ++j) sum -= matrix[k][j] * x[j];
        x[k] = sum / matrix[k][k];
    }
    for (int k = 0; k < size; ++k) out[columns[k]] = x[k];
    return true;
}

struct Approach {
    Touch touch;
    Real wanted; ///< least speed along the normal afterwards
    Real impulse;
    Vector friction;
};

bool fits(const std::vector<Approach> &all, unsigned subset, const Vector &velocity, Real tolerance,
          std::vector<Real> &impulses) {
    int chosen[3];
    int size = 0;
    for (unsigned i = 0; i < all.size(); ++i) {
        if (subset >> i & 1U) chosen[size++] = static_cast<int>(i);
    }
    Real matrix[3][4];
    for (int i = 0; i < size; ++i) {
        const Approach &a = all[chosen[i]];
        for (int j = 0; j < size; ++j) matrix[i][j] = dot(a.touch.normal, all[chosen[j]].touch.normal);
        matrix[i][size] = a.wanted - dot(a.touch.normal, velocity);
    }
    Real x[3];
    if (!solve(matrix, size, x)) return false;
    std::fill(impulses.begin(), impulses.end(), 0);
    Vector after = velocity;
    for (int i = 0; i < size; ++i) {
        if (x[i] < -tolerance) return false;
        impulses[chosen[i]] = std::max<Real>(x[i], 0);
        after += impulses[chosen[i]] * all[chosen[i]].touch.normal;
    }
    return std::all_of(all.begin(), all.end(),
                       [&](const Approach &a) { return dot(a.touch.normal, after) >= a.wanted - tolerance; });
}

/// Normal impulses of a round, complementary to the speeds with which the contacts separate.
void pushApart(std::vector<Approach> &all, Motion &motion, Real tolerance) {
    std::vector<Real> impulses(all.size());
    const unsigned subsets = 1U << std::min<size_t>(all.size(), 12);
    for (int size = 1; size <= 3; ++size) {
        for (unsigned subset = 1; subset < subsets; ++subset) {
            if (std::popcount(subset) != size || !fits(all, subset, motion.velocity, tolerance, impulses)) continue;
            for (size_t i = 0; i < all.size(); ++i) {
                all[i].impulse = impulses[i];
                motion.velocity += impulses[i] * all[i].touch.normal;
            }
            return;
        }
    }
    // Where normals are almost parallel, no subset fits to rounding: sweeps come close.
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        Real change = 0;
        for (Approach &a : all) {
            const Real impulse = std::max<Real>(0, a.impulse + a.wanted - dot(a.touch.normal, motion.velocity));
            motion.velocity += (impulse - a.impulse) * a.touch.normal;
            change = std::max(change, std::abs(impulse - a.impulse));
            a.impulse = impulse;
        }
        if (change <= kUlp * length(motion.velocity)) return;
    }
}

/// Friction of a round: it removes as much energy as the cones allow.
void rub(const Law &law, std::vector<Approach> &all, Motion &motion) {
    for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
        Real change = 0;
        for (Approach &a : all) {
            const Vector &n = a.touch.normal;
            const Vector friction =
                clipped(a.friction - (2.0L / 7) * slipAt(motion, n, law.radius), law.friction(a.touch) * a.impulse);
            const Vector more = friction - a.friction;
            motion.velocity += more;
            motion.spin -= (5 / (2 * law.radius)) * cross(n, more);
            a.friction = friction;
            change = std::max(change, length(more));
        }
        if (change <= kUlp * (length(motion.velocity) + law.radius * length(motion.spin))) return;
    }
}

} // namespace

Real Law::noSpeed(const Motion &motion) const {
    return 64 * 2.2e-16L * (length(motion.velocity) + radius * length(motion.spin));
}

Law lawOf(const phys_params &params, Real radius) {
    return {params.model == PHYS_MODEL_RIGID,
            radius,
            vectorOf(params.gravity),
            params.restitution_floor,
            params.restitution_wall,
            params.sliding_friction,
            params.wall_friction,
            params.rolling_friction};
}

Vector slipAt(const Motion &motion, const Vector &normal, Real radius) {
    return across(motion.velocity - radius * cross(motion.spin, normal), normal);
}

Real closingSpeed(const Law &law, const Touch &touch, Real lengthTolerance) {
    return std::sqrt(2 * lengthTolerance * std::max<Real>(0, -dot(touch.normal, law.gravity)));
}

bool collide(const Law &law, const std::vector<Touch> &touches, Real lengthTolerance, Motion &motion) {
    const auto restitution = [&](const Touch &touch, Real speed) {
        const Real limit = closingSpeed(law, touch, lengthTolerance);
        return speed >= -limit ? 0 : law.restitution(touch);
    };
    for (int round = 0; round <= kMostRounds; ++round) {
        const bool isLast = round == kMostRounds; // nearly opposite normals: the remaining speed into them is removed
        const Real noSpeed = law.noSpeed(motion);
        std::vector<Approach> approaching;
        for (const Touch &touch : touches) {
            const Real speed = dot(touch.normal, motion.velocity);
            if (isLast) approaching.push_back({touch, 0, 0, {}});
            if (!isLast && speed < -noSpeed) approaching.push_back({touch, -restitution(touch, speed) * speed, 0, {}});
        }
        if (approaching.empty()) return round > 0;
        pushApart(approaching, motion, noSpeed);
        if (law.isRigid && !isLast) rub(law, approaching, motion);
    }
    return true;
}

} // namespace witness
