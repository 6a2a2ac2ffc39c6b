// SPDX-License-Identifier: MIT
#include "contact/coulomb_newton.h"

#include "contact/dense.h"
#include "contact/held.h"

#include <cmath>

namespace phys {

namespace {

constexpr int kMostSteps = 12;

/// For a pair of sticking contacts whose gap is still to be closed, slip along the line through both points can't end:
/// the equation along this line has the smallest weight.
constexpr double kGivesWay = 0x1p-20;

constexpr uint32_t kMostContactsOfNewton = 4;
static_assert(5 * kMostContactsOfNewton <= dense::kMostUnknowns);

/// The effect of a unit impulse.
Motion pushOf(const Vec3 &impulse) { return {impulse, Vec3(0.0)}; }
Motion rubOf(const Lasting &contact, const Vec3 &impulse, double radius) {
    return {impulse, -kInertia / radius * glm::cross(contact.lever, impulse)};
}
Motion turnOf(const Vec3 &spin) { return {Vec3(0.0), spin}; }
/// Spins are represented as speeds, so that all equations are in m/s.
Motion turnBy(const Vec3 &speed, double radius) { return turnOf(speed / radius); }

void add(const Motion &change, Motion &motion) {
    motion.velocity += change.velocity;
    motion.spin += change.spin;
}

/// The regime of a quantity that is limited by the pressure: friction opposing slip, or resistance opposing spin.
enum class Answer {
    None,    ///< there is no such quantity
    Holds,   ///< as large as needed to end the slip
    Limited, ///< as large as the pressure allows
};

/// Two directions across a contact's lever, and the equations along them. Symmetric scenes give symmetric equations.
struct Disc {
    Answer answer = Answer::None;
    Vec3 along{0.0}, sideways{0.0};
    double turning = 0.0; ///< most/|target|: a sideways change of the target changes the answer by this factor

    const Vec3 &operator[](uint32_t i) const { return i == 0 ? along : sideways; }

    void face(const Vec3 &direction, const Vec3 &lever) {
        along = glm::normalize(direction);
        sideways = glm::cross(lever, along);
    }
};

/// The equations of one step, and the data from which they were made.
class Newton {
public:
    Newton(const CoulombProblem &problem, Motion &motion)
        : m_problem(problem)
        , m_motion(motion) {}

    void step() {
        for (uint32_t i = 0; i < count(); ++i) classify(i);
        for (uint32_t i = 0; i < count(); ++i) orient(i);
        number();
        dense::Equations equations(m_unknowns);
        for (uint32_t i = 0; i < count(); ++i) addRows(i, equations);
        apply(equations.solve());
    }

    /// Whether the law holds, under the regimes of the last step.
    bool isSolved() const {
        for (uint32_t i = 0; i < count(); ++i) {
            if (!holds(i)) return false;
        }
        return true;
    }

private:
    struct Mode {
        bool presses = false;
        bool resists = false;
        bool givesWay = false; ///< it and another contact stick while its gap is still to be closed
        Disc rubbing, resisting;
        uint32_t first = 0; ///< number of its first unknown; reaction, friction, resistance
    };

    uint32_t count() const { return static_cast<uint32_t>(m_problem.contacts.size()); }
    Lasting &contact(uint32_t i) const { return m_problem.contacts[i]; }
    double radius() const { return m_problem.radius; }
    double mostResistance(const Lasting &of) const { return of.mostResisting(m_problem.rollingFriction, radius()); }
    Vec3 slip(const Lasting &of) const { return slipAt(m_motion, of.limit, radius()); }
    Vec3 holding(const Lasting &of) const { return tangential(of.rubbing - kEndsSlip * slip(of), of.lever); }
    Vec3 limited(const Lasting &of) const {
        return tangential(of.rubbing - kEndsSlip * (of.slipBefore + slip(of)), of.lever);
    }
    Vec3 holdingSpin(const Lasting &of) const { return tangential(of.resisting - m_motion.spin, of.lever); }
    Vec3 limitedSpin(const Lasting &of) const {
        return tangential(of.resisting - of.spinBefore - m_motion.spin, of.lever);
    }

    void classify(uint32_t i) {
        const Lasting &c = contact(i);
        Mode &mode = m_modes[i];
        mode = {};
        const double missing = c.slow - glm::dot(c.limit, m_motion.velocity);
        const double reaction = c.reaction + missing / glm::dot(c.limit, c.lever);
        // A glued face holds without pressure, too, model.md 13.1.
        mode.presses = reaction > 0.0 || (c.isGlued && !c.isIdle && reaction >= -m_problem.negligible);
        if (!mode.presses) return;
        const double most = c.friction * c.reaction;
        if (c.hasNoLimit() || glm::length(holding(c)) <= most)
            mode.rubbing.answer = c.hasNoLimit() || c.friction > 0.0 ? Answer::Holds : Answer::None;
        else
            mode.rubbing.answer = c.friction > 0.0 ? Answer::Limited : Answer::None;
        mode.resists = c.rolls && m_problem.rollingFriction > 0.0;
        if (!mode.resists) return;
        const bool stops = glm::length(holdingSpin(c)) <= mostResistance(c);
        mode.resisting.answer = stops ? Answer::Holds : Answer::Limited;
    }

    bool sticks(uint32_t i) const { return m_modes[i].presses && m_modes[i].rubbing.answer == Answer::Holds; }

    /// Chooses directions that transform with the scene under reflections and quarter turns.
    void orient(uint32_t i) {
        const Lasting &c = contact(i);
        Mode &mode = m_modes[i];
        if (!mode.presses) return;
        const Vec3 target = limited(c);
        Vec3 direction = target;
        if (sticks(i) && c.slow < 0.0) {
            for (uint32_t j = 0; j < count(); ++j) {
                if (j == i || !sticks(j)) continue;
                mode.givesWay = true;
                direction = tangential(contact(j).lever - c.lever, c.lever);
                break;
            }
        }
        if (direction == Vec3(0.0)) direction = tangential(m_motion.velocity, c.lever);
        for (uint32_t j = 0; j < count() && direction == Vec3(0.0); ++j)
            direction = tangential(contact(j).lever, c.lever);
        if (direction == Vec3(0.0)) direction = Vec3(-c.lever.y, c.lever.x, 0.0);
        if (direction == Vec3(0.0)) direction = Vec3(1.0, 0.0, 0.0);
        mode.rubbing.face(direction, c.lever);
        const double size = glm::length(target);
        mode.rubbing.turning = size > 0.0 ? std::min(1.0, c.friction * c.reaction / size) : 0.0;
        if (!mode.resists) return;
        const Vec3 spinTarget = limitedSpin(c);
        mode.resisting.face(spinTarget == Vec3(0.0) ? mode.rubbing.along : spinTarget, c.lever);
        const double spinSize = glm::length(spinTarget);
        mode.resisting.turning = spinSize > 0.0 ? std::min(1.0, mostResistance(c) / spinSize) : 0.0;
    }

    void number() {
        m_unknowns = 0;
        for (uint32_t i = 0; i < count(); ++i) {
            Mode &mode = m_modes[i];
            mode.first = m_unknowns;
            if (!mode.presses) release(i);
            if (mode.presses) m_unknowns += 1 + countOf(mode.rubbing) + countOf(mode.resisting);
        }
    }
    static uint32_t countOf(const Disc &disc) { return disc.answer == Answer::None ? 0 : 2; }

    /// Removes all impulses of a contact that doesn't press.
    void release(uint32_t i) {
        Lasting &c = contact(i);
        add(pushOf(-c.reaction * c.lever), m_motion);
        add(rubOf(c, -c.rubbing, radius()), m_motion);
        add(turnOf(-c.resisting), m_motion);
        c.reaction = 0.0;
        c.rubbing = c.resisting = Vec3(0.0);
        c.isSpent = false;
    }

    /// Calls visit(unknown, motion) with the effect of one unit of each unknown.
    template<class Visit>
    void visitUnknowns(Visit visit) const {
        for (uint32_t j = 0; j < count(); ++j) {
            const Mode &mode = m_modes[j];
            if (!mode.presses) continue;
            const Lasting &c = contact(j);
            uint32_t unknown = mode.first;
            visit(unknown++, pushOf(c.lever));
            for (uint32_t k = 0; k < countOf(mode.rubbing); ++k) visit(unknown++, rubOf(c, mode.rubbing[k], radius()));
            for (uint32_t k = 0; k < countOf(mode.resisting); ++k)
                visit(unknown++, turnBy(mode.resisting[k], radius()));
        }
    }

    void addRows(uint32_t i, dense::Equations &equations) const {
        const Mode &mode = m_modes[i];
        if (!mode.presses) return;
        const Lasting &c = contact(i);
        dense::Values &normal = equations.add(c.slow - glm::dot(c.limit, m_motion.velocity));
        visitUnknowns([&](uint32_t unknown, const Motion &by) { normal[unknown] = glm::dot(c.limit, by.velocity); });
        const double weight = mode.givesWay ? kGivesWay : 1.0;
        const auto slipOf = [&](const Motion &by) { return slipAt(by, c.limit, radius()); };
        addDisc(mode.rubbing, mode.first + 1, mode.first, c.friction, c.rubbing, c.friction * c.reaction, slip(c),
                kEndsSlip, weight, slipOf, equations);
        const auto spinOf = [&](const Motion &by) { return radius() * by.spin; };
        const double perPressure = c.load < 0.0 ? kInertia * m_problem.rollingFriction : 0.0;
        addDisc(mode.resisting, mode.first + 1 + countOf(mode.rubbing), mode.first, perPressure, radius() * c.resisting,
                radius() * mostResistance(c), radius() * m_motion.spin, 1.0, 1.0, spinOf, equations);
    }

    /// Holds: the velocity that it opposes ends. Limited: the answer is `most` along its target, which turns with that
    /// velocity and with the answer itself; perPressure: how `most` grows with the reaction.
    template<class Meet>
    void addDisc(const Disc &disc, uint32_t own, uint32_t reaction, double perPressure, const Vec3 &answer, double most,
                 const Vec3 &met, double share, double weight, Meet meetOf, dense::Equations &equations) const {
        if (disc.answer == Answer::None) return;
        for (uint32_t k = 0; k < 2; ++k) {
            if (disc.answer == Answer::Holds) {
                const Vec3 direction = k == 0 ? weight * disc.along : disc.sideways;
                dense::Values &row = equations.add(-glm::dot(met, direction));
                visitUnknowns(
                    [&](uint32_t unknown, const Motion &by) { row[unknown] = glm::dot(meetOf(by), direction); });
            } else if (k == 0) {
                dense::Values &row = equations.add(most - glm::dot(answer, disc.along));
                row[own] = 1.0;
                row[reaction] = -perPressure;
            } else {
                dense::Values &row = equations.add(-glm::dot(answer, disc.sideways));
                visitUnknowns([&](uint32_t unknown, const Motion &by) {
                    row[unknown] = disc.turning * share * glm::dot(meetOf(by), disc.sideways);
                });
                row[own + 1] += 1.0 - disc.turning;
            }
        }
    }

    void apply(const dense::Values &change) {
        for (uint32_t i = 0; i < count(); ++i) {
            const Mode &mode = m_modes[i];
            if (!mode.presses) continue;
            Lasting &c = contact(i);
            uint32_t unknown = mode.first;
            const double reaction = std::max(0.0, c.reaction + change[unknown++]);
            add(pushOf((reaction - c.reaction) * c.lever), m_motion);
            c.reaction = reaction;
            c.isSpent = mode.rubbing.answer == Answer::Limited;
            if (mode.rubbing.answer != Answer::None) {
                Vec3 rubbing = c.rubbing + change[unknown] * mode.rubbing.along;
                rubbing += change[unknown + 1] * mode.rubbing.sideways;
                unknown += 2;
                if (!c.hasNoLimit()) rubbing = clipped(rubbing, c.friction * reaction);
                if (reaction == 0.0 && !c.isGlued) rubbing = Vec3(0.0);
                add(rubOf(c, rubbing - c.rubbing, radius()), m_motion);
                c.rubbing = rubbing;
            }
            if (mode.resisting.answer != Answer::None) {
                Vec3 more = change[unknown] * mode.resisting.along;
                more += change[unknown + 1] * mode.resisting.sideways;
                const Vec3 resisting = clipped(c.resisting + more / radius(), mostResistance(c));
                add(turnOf(resisting - c.resisting), m_motion);
                c.resisting = resisting;
            }
        }
    }

    double tolerance() const {
        double pressures = 0.0;
        for (const Lasting &c : m_problem.contacts) pressures += c.reaction;
        return 8.0 * (m_problem.negligible + kRounding * pressures);
    }

    bool holds(uint32_t i) const {
        const Lasting &c = contact(i);
        const Mode &mode = m_modes[i];
        const double most = tolerance();
        const double speed = glm::dot(c.limit, m_motion.velocity) - c.slow;
        if (!mode.presses) return speed >= -most;
        if (std::abs(speed) > most) return c.reaction == 0.0 && speed > 0.0;
        if (mode.rubbing.answer == Answer::Holds) {
            const Vec3 left = mode.givesWay ? glm::dot(slip(c), mode.rubbing.sideways) * mode.rubbing.sideways
                                            : tangential(slip(c), c.lever);
            if (glm::length(left) > most) return false;
        }
        if (mode.rubbing.answer == Answer::Limited) {
            const double allowed = c.friction * c.reaction;
            const Vec3 holds = holding(c);
            const Vec3 wanted = glm::length(holds) <= allowed ? holds : clipped(limited(c), allowed);
            if (glm::length(c.rubbing - wanted) > most) return false;
        }
        if (mode.resisting.answer == Answer::Holds)
            return radius() * glm::length(tangential(m_motion.spin, c.lever)) <= most;
        if (mode.resisting.answer == Answer::Limited) {
            const Vec3 wanted = clipped(limitedSpin(c), mostResistance(c));
            return radius() * glm::length(c.resisting - wanted) <= most;
        }
        return true;
    }

    const CoulombProblem &m_problem;
    Motion &m_motion;
    std::array<Mode, kMostContactsOfNewton> m_modes;
    uint32_t m_unknowns = 0;
};

} // namespace

bool solveCoulomb(const CoulombProblem &problem, Motion &motion) {
    const size_t count = problem.contacts.size();
    if (count > kMostContactsOfNewton) return false;
    std::array<Lasting, kMostContactsOfNewton> before;
    std::copy(problem.contacts.begin(), problem.contacts.end(), before.begin());
    const Motion motionBefore = motion;
    Newton newton(problem, motion);
    for (int i = 0; i < kMostSteps; ++i) {
        problem.work.add(Work::kNewton * count);
        newton.step();
        if (newton.isSolved()) return true;
    }
    std::copy(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(count), problem.contacts.begin());
    motion = motionBefore;
    return false;
}

} // namespace phys
