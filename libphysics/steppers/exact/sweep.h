// SPDX-License-Identifier: MIT
// When a moving ball first touches a solid or leaves its floor: conservative advancement, model.md 5.2.
#pragma once

#include "board.h"
#include "motion.h"

namespace phys {

/// Searches along a motion. Owns its buffers, so that nothing is allocated while stepping.
class Sweep {
public:
    explicit Sweep(const Board &board);

    /// Searches for a touch in one step may take so many looks at a solid in all: some 20 for each of a million events.
    static constexpr uint32_t kMostLooks = 20'000'000;

    /// Before the first search of a step.
    void begin() { m_looks = 0; }

    /// A search was given up for too many looks: what it returned isn't true.
    bool isGivenUp() const { return m_looks > kMostLooks; }

    /// First time in [0, until] at which the ball touches a solid and moves towards it; kNever if it doesn't.
    /// plane: the one the ball slides on, whose solids it can't hit; nullptr if there is none.
    double firstTouch(const Motion &motion, double until, const Plane *plane);

    /// First time in [0, until] at which the centre leaves the floors; kNever if it doesn't. Crossing from one to the
    /// next is nothing. floor: the one at the start; then the one that it leaves.
    double firstExit(const Motion &motion, double until, uint32_t &floor) const;

private:
    /// A solid's own clock: it can't be hit before `safe`.
    struct Candidate {
        double safe;
        uint32_t solid;
        bool polished; ///< it was within the tolerance already and got one more step of the advancement
    };

    const Board &m_board;
    std::vector<Candidate> m_candidates;
    uint32_t m_looks = 0; // in the present step

    void collect(const Motion &motion, const Motion::Point &now, double from, double until, const Plane *plane);
    std::span<const uint32_t> withinReach(const Motion &motion, const Motion::Point &now, double until, double duration,
                                          double way) const;
    double firstHit(const Motion &motion, double windowEnd, double until);
    double startInFront(const Motion &motion, const Nearest &close, double reach, double t, double until) const;
    double settled(const Motion &motion, const Nearest &close, double reach, const Vec3 &velocity, double t,
                   double until) const;
    double settledExit(const phys_box &floor, const Motion &motion, const Motion::Point &out, double t,
                       double until) const;
};

/// First time in [from, until] at which the centre leaves the floor's rectangle; kNever if it doesn't.
double firstExit(const phys_box &floor, const Motion &motion, double from, double until, double tolerance);

/// Puts a centre that leaves the floor exactly on the border that it crosses.
void snapToBorder(const phys_box &floor, double tolerance, const Vec3 &velocity, Vec3 &p);

/// The part of a velocity that leads round what is touched: none on a face, and on an edge what goes across it.
Vec3 velocityRound(const Vec3 &normal, uint32_t feature, const Vec3 &v);

/// Whether the ball moves towards what it touches: v.n < 0 by more than the rounding of the normal.
bool approaches(const Board &board, const Vec3 &normal, uint32_t feature, const Vec3 &v);

} // namespace phys
