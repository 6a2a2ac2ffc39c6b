// SPDX-License-Identifier: MIT
// Lasting contacts over a short time: their joint effect on a velocity, model.md 13.5.
#pragma once

#include "contact/contact.h"
#include "contact/work.h"

#include <optional>

namespace phys {

/// A contact that may last, with its impulses. In a list they are in the order of Contacts::sort.
struct Lasting {
    Vec3 lever;  ///< normal along which the reaction pushes and across which friction acts
    Vec3 limit;  ///< normal along which the ball must not approach at the end; order 1: the same
    double slow; ///< smallest speed along `limit` at the end, m/s: 0, or negative for a gap to be closed
    double friction;
    bool isTop;
    bool isGlued;
    // Order 2: what contributes to the directions of friction and resistance. Order 1: 0.
    Vec3 slipBefore; ///< slip at the start, m/s
    Vec3 spinBefore; ///< spin at the start if the ball rolled then, rad/s

    double reaction; ///< impulses per mass, m/s
    Vec3 rubbing;
    Vec3 resisting; ///< rolling resistance: change of the spin, rad/s
    bool isSpent;   ///< friction is at its limit
    bool rolls;     ///< a top face without slip, so that rolling resistance works there
    bool isIdle;    ///< opens without pressure, as two others with normals in one plane press instead
    bool closes;    ///< sticks by prestress, or but for the slip with which a pair of sticking contacts closes a gap
    double load;    ///< reaction on which resistance depends, m/s; below 0: the present one

    /// Whether friction has a reserve. Its magnitude doesn't tell, as friction at its limit is rounded.
    bool sticks() const {
        return !isSpent && reaction > 0.0 && glm::dot(rubbing, rubbing) < friction * friction * reaction * reaction;
    }
    /// The largest resistance, rad/s; rollingFriction: the coefficient.
    double mostResisting(double rollingFriction, double radius) const {
        return 2.5 * rollingFriction * (load >= 0.0 && reaction > 0.0 ? load : reaction) / radius;
    }
    /// Friction of a contact that rolls or closes was judged without the resistance, model.md 13.5.
    bool hasNoLimit() const { return isGlued || rolls || closes; }
    /// Whether it pulls along what it touches: a face that glues does so until it opens, even without pressure.
    bool holds(const Vec3 &velocity) const {
        return reaction > 0.0 || (isGlued && !isIdle && glm::dot(limit, velocity) <= slow);
    }
};

/// The friction that ends a slip. A unit impulse changes the slip of its own contact by 7/2.
inline constexpr double kEndsSlip = 2.0 / 7.0;

class LastingContacts : public ShortList<Lasting> {
public:
    /// work: counts the cost of `solve`.
    LastingContacts(double radius, Work &work)
        : m_radius(radius)
        , m_work(&work) {}

    /// Coulomb's law of all contacts together, with rolling resistance where a top face rolls: changes the motion under
    /// gravity alone. Starts from the impulses that the contacts have: zero, or those of a similar problem.
    void solve(double rollingFriction, Motion &motion);

    /// The impulses are those of the solution to be taken if there are several: see `choose`.
    void setChosen() { m_isChosen = true; }
    /// The same where two of them stick only as they press each other: they do, and resistance depends on that
    /// pressure.
    void setPrestressed();
    bool isPrestressed() const { return m_isPrestressed; }
    bool isChosen() const { return m_isChosen; }
    /// Begins with the chosen solution of a similar problem with the same contacts.
    void keep(const LastingContacts &chosen);

private:
    /// Resistance depends on how contacts share their load, which a solution doesn't determine: at most so many
    /// solutions until it is found.
    static constexpr int kMostShares = 20;

    void solveBySweeps(double rollingFriction, double negligible, const Motion &driven, Motion &motion);
    bool keepChoice(double rollingFriction, double negligible, Motion &motion);
    bool updateRolling();
    void closeBySticking();
    bool settle(double rollingFriction, double negligible, bool releases, Motion &motion);
    bool settleTogether(double rollingFriction, double negligible, int most, Motion &motion);
    bool solveByNewton(double rollingFriction, double negligible, bool isLast, Motion &motion);
    bool solvePressed(double rollingFriction, double negligible, Motion &motion);
    void settleWithoutResistance(double negligible, const Motion &driven, Motion &motion);
    bool takesPart(const Lasting &contact) const;
    void unload();
    bool shareLoads() const;
    double pressTogether(double negligible, Motion &motion);
    bool isIdle(const Lasting &contact) const;
    bool releaseOpposite(double negligible);
    /// A pressure between two sticking contacts that moves nothing.
    struct Strain {
        double relieved; ///< m/s
        bool remains;    ///< somewhere: without it a contact would slip
    };
    Strain relieve(double negligible, const Motion &motion);
    std::optional<double> relieveTogether(double negligible, const Motion &motion);
    bool isStill(const Lasting &contact, double negligible, const Motion &motion) const;
    uint32_t countStill(double negligible, const Motion &motion) const;
    bool slips(const Lasting &contact, double negligible, const Motion &motion) const;
    bool keepLoads(double negligible);
    void stickWhileClosing(double negligible, Motion &motion);
    bool sticksWhileClosing(Lasting &a, Lasting &b, double negligible, Motion &motion);
    void settleFromBelow(double negligible, const Motion &driven, Motion &motion);
    double pressure() const;
    double sweep(double rollingFriction, bool arePressed, Motion &motion);

    double m_radius;
    Work *m_work;
    bool m_isChosen = false;
    bool m_isPrestressed = false;
    double m_mostPressure = 2.0; ///< share of the chosen pressure that the solution near it may have
    bool m_needsNewton = false;  ///< sweeps converged too slowly the last time
};

} // namespace phys
