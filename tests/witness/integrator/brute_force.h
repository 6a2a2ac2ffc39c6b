// SPDX-License-Identifier: MIT
// The motion under the law of contact by brute force: implicit Euler on the velocity level, with Coulomb's law solved
// anew in every step, extrapolated from four step sizes. Steps shrink until the error estimate is small enough, so that
// no change of mode has to be known in advance; new contacts are bracketed by bisection of the step.
#pragma once

#include "law.h"

#include <span>
#include <vector>

namespace witness {

class BruteForce {
public:
    /// tolerance: error of a step relative to the radius and to the speeds at hand.
    BruteForce(std::span<const phys_box> boxes, Real radius, Real tolerance = 1e-13L);

    /// Moves the ball for `duration` seconds. False if the caps are reached: no result.
    bool run(const Law &law, Real duration, Motion &motion);

    uint64_t steps() const { return m_steps; }
    uint64_t impacts() const { return m_impacts; }
    /// Impacts, changes of feature, ends of slipping and rolling.
    uint64_t events() const { return m_events + m_impacts; }
    /// The centre after each step so far.
    const std::vector<Vector> &way() const { return m_way; }
    bool isAtRest(const Law &law, const Motion &motion) const;

private:
    struct Contact { // NOLINT(clang-analyzer-optin.performance.Padding)
        size_t box;
        Touch touch;
        Real pressure; ///< normal impulse
        Vector friction;
        Vector resistance;
        bool isMerged;
        bool isRolling;
    };
    struct Trial {
        Motion end;
        Real error;
        std::vector<Contact> contacts;
    };

    std::vector<Touch> touching(const Motion &motion) const;
    std::vector<Contact> lasting(const Law &law, const Motion &motion) const;
    Trial attempt(const Law &law, const Motion &start, Real h, const std::vector<Contact> &contacts) const;
    bool releaseOpposite(std::vector<Contact> &contacts) const;
    bool areDependent(const std::vector<Contact> &contacts, const std::vector<size_t> &some) const;
    void release(Contact &c, Motion &end) const;
    void relax(const Law &law, Real scale, const Motion &end, std::vector<Contact> &contacts) const;
    Motion implicitEuler(const Law &law, const Motion &start, Real h, std::vector<Contact> &contacts) const;
    void lookWhereTheyEnd(const Law &law, const Vector &place, std::vector<Contact> &contacts) const;
    Vector rub(const Law &law, Contact &c, Motion &end) const;
    Vector rollOn(const Law &law, Contact &c, Motion &end) const;
    void sweep(const Law &law, Real scale, bool withResistance, std::vector<Contact> &contacts, Motion &end) const;
    void press(const Law &law, Real scale, bool withResistance, std::vector<Contact> &contacts, Motion &end) const;
    Real firstOverlap(const Motion &start, const Motion &end, Real h, const std::vector<Contact> &contacts) const;
    bool changesFeature(const Motion &start, const Motion &end, const std::vector<Contact> &contacts) const;
    bool reverses(const Law &law, const Motion &start, const Trial &trial) const;
    Real endingSlip(const Law &law, const Motion &start, const Trial &trial) const;
    bool endsEarly(const Law &law, const Motion &start, const Trial &trial, Real h) const;
    Real bracket(const Law &law, const Motion &start, Real h, const std::vector<Contact> &contacts, Trial &trial) const;
    void settle(Motion &motion) const;
    void project(const std::vector<Contact> &contacts, Motion &motion) const;
    void pushOut(Motion &motion) const;
    void slaveSpin(const Law &law, const Motion &before, const std::vector<Contact> &contacts, Motion &motion) const;
    Real longestStep(const Law &law, const Motion &motion) const;

    std::span<const phys_box> m_boxes;
    Real m_radius;
    Real m_tolerance;
    Real m_givenTolerance; ///< gaps below this count as zero in given positions
    Real m_touchTolerance; ///< and in computed ones
    uint64_t m_steps = 0;
    uint64_t m_impacts = 0;
    uint64_t m_events = 0;
    std::vector<Vector> m_way;
    mutable uint64_t m_updates = 0; ///< of contacts so far: the cost of a run
    Real m_suggested = 1e-5L;
};

} // namespace witness
