// SPDX-License-Identifier: MIT
// Lasting contacts over a short time: what all of them together do to a velocity, model.md 13.5.
#pragma once

#include "contact/contact.h"

namespace phys {

/// A contact that may last, and its answer.
struct Lasting {
    Vec3 lever;  ///< normal along which the reaction pushes and across which friction acts
    Vec3 limit;  ///< normal along which the ball must not approach in the end; order 1: the same
    double slow; ///< least speed along `limit` in the end, m/s: 0, or below it for a gap to be closed
    double friction;
    bool isTop;
    bool isGlued;
    Vec3 slipBefore{0.0}; ///< order 2: slip at the start, which shares in friction's direction. Order 1: 0

    double reaction = 0.0; ///< impulses per mass, m/s
    Vec3 rubbing{0.0};
    Vec3 resisting{0.0}; ///< rolling resistance: change of the spin, rad/s
    bool rolls = false;  ///< a top face without slip, so that rolling resistance works there

    /// Whether friction has a reserve.
    bool sticks() const {
        return reaction > 0.0 && glm::dot(rubbing, rubbing) < friction * friction * reaction * reaction;
    }
};

class LastingContacts {
public:
    explicit LastingContacts(double radius)
        : m_radius(radius) {}

    /// contacts: in the order of Contacts::sort.
    void add(const Lasting &contact) { m_contacts[m_count++] = contact; }
    Lasting *begin() { return m_contacts.data(); }
    Lasting *end() { return begin() + m_count; }
    const Lasting *begin() const { return m_contacts.data(); }
    const Lasting *end() const { return begin() + m_count; }

    /// Coulomb's law of all contacts at once, and rolling resistance where a top face rolls: changes the motion that
    /// gravity alone would give. before: the motion at the start, whose spin shares in the direction of the resistance
    /// (order 2), or at order 1 no motion.
    void solve(double rollingFriction, const Motion &before, Motion &motion);

private:
    bool settle(const Motion &before, double rollingFriction, double negligible, Motion &motion);
    double relieve();
    void sweep(const Motion &before, double rollingFriction, Motion &motion);

    double m_radius;
    std::array<Lasting, Contacts::kMost> m_contacts;
    uint32_t m_count = 0;
};

} // namespace phys
