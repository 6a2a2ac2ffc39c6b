// SPDX-License-Identifier: MIT
#include "contact/modes.h"

#include "contact/closed_modes.h"
#include "contact/combination.h"
#include "contact/mirror.h"

namespace phys {

namespace {

constexpr double kNoSlip = 64.0 * 0x1p-52; // relative

uint32_t closedContacts(std::span<const Reaction> reactions) {
    uint32_t closed = 0;
    for (const Reaction &reaction : reactions) closed += reaction.mode == Mode::open ? 0U : 1U;
    return closed;
}

/// The modes that a contact may have. The first one is open.
std::span<const Mode> modesOf(const Held &held, const Reaction &reaction) {
    static constexpr Mode smooth[] = {Mode::open, Mode::smooth}, sliding[] = {Mode::open, Mode::slipping};
    static constexpr Mode glued[] = {Mode::open, Mode::sticking};
    static constexpr Mode still[] = {Mode::open, Mode::sticking, Mode::starting};
    if (held.isGlued) return glued;
    if (held.friction == 0.0) return smooth;
    if (reaction.slip != Vec3(0.0)) return sliding;
    return still;
}

/// All combinations of modes in which at most so many contacts press, one after the other.
class ModeCounter {
public:
    ModeCounter(std::span<const Held> held, const Response &known, uint32_t mostPressing)
        : m_mostPressing(mostPressing) {
        for (const Held &contact : held) m_modes[m_count] = modesOf(contact, known.reactions[m_count]), ++m_count;
    }

    Mode operator[](uint32_t i) const { return m_modes[i][m_numbers[i]]; }

    /// Advances to the next combination; false after the last one.
    bool next() {
        for (uint32_t i = 0; i < m_count; ++i) {
            const bool presses = m_numbers[i] > 0;
            if ((presses || m_pressing < m_mostPressing) && m_numbers[i] + 1 < m_modes[i].size()) {
                m_pressing += presses ? 0 : 1;
                ++m_numbers[i];
                return true;
            }
            m_pressing -= presses ? 1 : 0;
            m_numbers[i] = 0;
        }
        return false;
    }

private:
    std::array<std::span<const Mode>, kMostHeld> m_modes;
    std::array<size_t, kMostHeld> m_numbers{};
    uint32_t m_count = 0, m_pressing = 0, m_mostPressing;
};

/// How well a combination fits, best first: within rounding; within the accuracy of directions with few digits, such as
/// that of a slip that has just begun; the same with shifted forces of sticking contacts; within the accuracy of
/// directions that haven't converged, also with shifted forces.
struct Fit {
    double tolerance;
    bool shares;
};
constexpr Fit kFit[] = {{kFits, false},      {1e3 * kFits, false}, {kFits, true},
                        {1e3 * kFits, true}, {kRoughly, false},    {kRoughly, true}};
constexpr size_t kNoFit = std::size(kFit);
constexpr size_t kFirstRough = 4; ///< all that a combination can reach whose directions haven't converged
static_assert(kFit[kFirstRough].tolerance == kRoughly && kFit[kFirstRough - 1].tolerance < kRoughly);
constexpr size_t kUnranked = 2 * kNoFit;

/// Size of the accelerations that a slip's direction is part of. That of the spin may be far larger.
double sizeOfForces(const Combination &c) {
    double size = glm::length(c.moment.gravity);
    for (uint32_t i = 0; i < c.count(); ++i) {
        size += glm::length(c.reactions[i].force) + curvature(c.moment, c.held[i]);
    }
    return size;
}

/// Index in kFit; kNoFit if it is beyond `most`. Only a combination that hasn't converged may fit roughly.
size_t fitOf(Combination &c, bool isSettled, size_t most, double scale) {
    constexpr double kRoundings = 16.0 * 0x1p-52; // of the sum of forces, which a wedge increases without limit
    const double size = sizeOfForces(c), rough = std::min(scale, size);
    if (kRoundings * size > scale) return kNoFit; // what is left of such forces is rounding
    for (size_t i = 0; i <= most && i < kNoFit; ++i) {
        const double zero = kFit[i].tolerance * (kFit[i].tolerance > kFits ? rough : scale) + kRoundings * size;
        if (isSettled == (kFit[i].tolerance == kRoughly)) continue;
        if (kFit[i].shares) share(c, zero);
        if (fits(c, zero)) return i;
    }
    return kNoFit;
}

/// Sets the modes of this combination; directions: of the slips. False if they aren't allowed together.
bool setModes(Combination &c, const ModeCounter &modes, std::span<const Vec3> directions, const Excluded &excluded) {
    for (uint32_t i = 0; i < c.count(); ++i) {
        c.reactions[i].direction = directions[i];
        c.reactions[i].mode = modes[i];
        if ((excluded.closed >> i & 1U) && !c.isOpen(i)) return false;
        if ((excluded.sticking >> i & 1U) && c.sticks(i)) return false;
    }
    return true;
}

Response enumerate(const Moment &moment, std::span<const Held> held, Work &work, const Excluded &excluded,
                   const Response &known);

/// Whether the ball, an instant after this combination has let it leave contacts, doesn't return to them under the
/// combination that is chosen for the others then: model.md 14.1.
bool lasts(const Combination &c, const Excluded &excluded, const Response &known) {
    const double zero = kFits * accelerationScale(c.moment);
    const auto apart = [&](uint32_t i, const Vec3 &acceleration) {
        return glm::dot(c.held[i].normal, acceleration) + curvature(c.moment, c.held[i]);
    };
    std::array<Held, kMostHeld> others;
    Response othersKnown = known;
    Excluded othersExcluded;
    uint32_t count = 0, left = 0;
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.isOpen(i) && apart(i, c.acceleration) > zero) {
            left |= 1U << i;
            continue;
        }
        othersExcluded.closed |= (excluded.closed >> i & 1U) << count;
        othersExcluded.sticking |= (excluded.sticking >> i & 1U) << count;
        othersKnown.reactions[count] = known.reactions[i];
        others[count++] = c.held[i];
    }
    if (left == 0 || count < 2) return true; // one contact has one solution
    othersKnown.count = count;
    const Response chosen = enumerate(c.moment, {others.data(), count}, c.work, othersExcluded, othersKnown);
    for (uint32_t i = 0; i < c.count(); ++i) {
        if ((left >> i & 1U) && apart(i, chosen.acceleration) < -zero) return false;
    }
    return true;
}

/// Whether a contact is so rough that friction drives the ball though its pressure counts as none.
bool isDrivenByNone(const Combination &c, double none) {
    constexpr double kDriven = 100.0; // times that pressure
    for (uint32_t i = 0; i < c.count(); ++i) {
        if (c.isOpen(i) || c.sticks(i) || c.reactions[i].pressure > none) continue;
        if (c.held[i].friction * c.reactions[i].pressure > kDriven * none) return true;
    }
    return false;
}

/// Whether a combination presses less than the best one so far, or as much with more contacts.
bool isBetter(const Combination &c, const Response &best, double scale) {
    const double same = 1e-9 * scale, more = sumOfPressures(c.list()) - sumOfPressures(best.list());
    if (more < -same) return true;
    return more <= same && closedContacts(c.list()) > closedContacts(best.list()) && !isDrivenByNone(c, same);
}

/// Tries all combinations. Of those that fit best it takes the one with the smallest sum of N, and of equal sums the
/// one with the most contacts; one that doesn't last only if none does.
Response enumerate(const Moment &moment, std::span<const Held> held, Work &work, const Excluded &excluded,
                   const Response &known) {
    const double scale = accelerationScale(moment);
    Response best = known;
    size_t bestRank = kUnranked;
    StuckForces stuckForces;
    Combination c{moment, held, work};
    c.spent = excluded.sticking;
    std::array<Vec3, kMostHeld> directions;
    for (uint32_t i = 0; i < c.count(); ++i) {
        c.reactions[i].slip = known.reactions[i].slip;
        directions[i] = hat(known.reactions[i].slip);
    }
    const auto tryAll = [&] {
        ModeCounter modes(held, known, moment.mostPressing);
        do {
            c.rolling = Vec3(0.0);
            c.prestress = 0.0;
            c.most = bestRank == 0 ? sumOfPressures(best.list()) : INFINITY;
            if (!setModes(c, modes, directions, excluded)) continue;
            const bool isSettled = settle(c, stuckForces);
            if (!isSettled && (bestRank < kFirstRough || c.searches)) continue;
            if (bestRank == 0 && !isBetter(c, best, scale)) continue;
            judge(c);
            const size_t fit = fitOf(c, isSettled, bestRank, scale);
            if (fit == kNoFit || (fit == bestRank && !isBetter(c, best, scale))) continue;
            const size_t rank = lasts(c, excluded, known) ? fit : kNoFit + fit;
            if (rank > bestRank || (rank == bestRank && !isBetter(c, best, scale))) continue;
            bestRank = rank;
            best.reactions = c.reactions;
            best.acceleration = c.acceleration;
            best.spinAcceleration = c.spinAcceleration;
            best.rolling = c.isHeld() ? Vec3(0.0) : c.rolling;
            best.isPrestressed = c.prestress != 0.0;
        } while (modes.next() && !work.isTooMuch());
    };
    tryAll();
    c.searches = bestRank == kUnranked;
    if (c.searches && !work.isTooMuch()) tryAll();
    best.isFound = bestRank != kUnranked;
    // A contact that fits doesn't pull, but by rounding, which the phase would take for the moment of its release.
    for (uint32_t i = 0; i < best.count; ++i) {
        Reaction &reaction = best.reactions[i];
        if (reaction.pressure >= 0.0 || reaction.mode == Mode::sticking) continue;
        reaction.pressure = 0.0;
        reaction.force = Vec3(0.0);
    }
    return best;
}

} // namespace

double accelerationScale(const Moment &moment) {
    return glm::length(moment.gravity) + squared(moment.velocity) / moment.radius +
           moment.radius * squared(moment.spin);
}

double roundingOfLimit(const Moment &moment, double friction) {
    return 16.0 * 0x1p-52 * friction * accelerationScale(moment);
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

Response respond(const Moment &moment, std::span<const Held> held, Work &work, const Excluded &excluded) {
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
        if (slip != Vec3(0.0) && (held[i].isStill || isNoSlip(moment, slip))) slip = Vec3(0.0);
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
    for (uint32_t i = 0; i < held.size(); ++i) { // restores modes that the search has changed
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
    seen = enumerate(mirror.seen(moment), sorted.list(), work, excludedSeen, seen);
    response.isFound = seen.isFound;
    response.isPrestressed = seen.isPrestressed;
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
