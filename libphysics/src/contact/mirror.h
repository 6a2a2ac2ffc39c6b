// SPDX-License-Identifier: MIT
// A frame for a moment that is the same for all reflections and quarter turns of it: results computed in this frame are
// reflected and rotated to the bit. model.md 14.3.
#pragma once

#include "contact/modes.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace phys {

class Mirror {
public:
    Mirror(const Moment &moment, std::span<const Held> held);

    Vec3 seen(Vec3 v) const {
        if (m_flipX) v.x = -v.x;
        if (m_flipY) v.y = -v.y;
        if (m_swaps) std::swap(v.x, v.y);
        return v;
    }
    Vec3 back(Vec3 v) const {
        if (m_swaps) std::swap(v.x, v.y);
        if (m_flipX) v.x = -v.x;
        if (m_flipY) v.y = -v.y;
        return v;
    }

    /// For axial vectors: spins and torques.
    Vec3 seenSpin(const Vec3 &om) const { return handedness() * seen(om); }
    Vec3 backSpin(const Vec3 &om) const { return handedness() * back(om); }

    Moment seen(const Moment &moment) const {
        Moment image = moment;
        image.velocity = seen(moment.velocity);
        image.spin = seenSpin(moment.spin);
        image.gravity = seen(moment.gravity);
        return image;
    }
    Held seen(Held contact) const {
        contact.normal = seen(contact.normal);
        if (m_swaps) std::swap(contact.across.x, contact.across.y);
        return contact;
    }

private:
    bool m_flipX = false, m_flipY = false, m_swaps = false;

    double handedness() const { return (m_flipX != m_flipY) != m_swaps ? -1.0 : 1.0; }
    void decideByContacts(bool isOpenX, bool isOpenY, bool isOpenSwap, const Vec3 &spin, std::span<const Held> held);

    static bool isNegative(std::initializer_list<double> signs) {
        for (const double sign : signs) {
            if (sign != 0.0) return sign < 0.0;
        }
        return false;
    }

    static bool isUndecided(std::initializer_list<double> signs) {
        return std::all_of(signs.begin(), signs.end(), [](double sign) { return sign == 0.0; });
    }
};

/// Contacts in an order that is independent of reflections and of the boxes' order: by their normals in this frame.
struct Sorted {
    std::array<Held, kMostHeld> held{};
    std::array<uint32_t, kMostHeld> index{}; ///< index of each in the given list
    uint32_t count = 0;

    Sorted(const Mirror &mirror, std::span<const Held> given) {
        for (uint32_t i = 0; i < given.size(); ++i) {
            held[i] = mirror.seen(given[i]);
            index[i] = i;
        }
        count = static_cast<uint32_t>(given.size());
        const auto before = [](const Vec3 &a, const Vec3 &b) {
            return std::tie(a.z, a.x, a.y) < std::tie(b.z, b.x, b.y);
        };
        for (uint32_t i = 1; i < count; ++i) { // insertion sort, as there are only a few
            for (uint32_t j = i; j > 0 && before(held[j].normal, held[j - 1].normal); --j) {
                std::swap(held[j], held[j - 1]);
                std::swap(index[j], index[j - 1]);
            }
        }
    }
    std::span<const Held> list() const { return {held.data(), count}; }
};

/// Below 0 if a comes before b. Where both frames show the same, the order of the contacts decides that was given.
inline int compare(const Sorted &a, const Sorted &b) {
    const auto order = [](const auto &first, const auto &second) { return (first > second) - (first < second); };
    const auto shown = [](const Held &held) {
        const Vec3 &n = held.normal, &across = held.across;
        return std::tuple(n.z, n.x, n.y, across.x, across.y, across.z, held.friction, held.resistance, held.isGlued,
                          held.isStill);
    };
    for (uint32_t i = 0; i < a.count; ++i) {
        if (const int byHeld = order(shown(a.held[i]), shown(b.held[i])); byHeld != 0) return byHeld;
    }
    for (uint32_t i = 0; i < a.count; ++i) {
        if (const int byIndex = order(a.index[i], b.index[i]); byIndex != 0) return byIndex;
    }
    return 0;
}

inline Mirror::Mirror(const Moment &moment, std::span<const Held> held) {
    const Vec3 &v = moment.velocity, &g = moment.gravity, &om = moment.spin;
    Vec3 most(0.0), least(0.0);
    for (const Held &contact : held) {
        most = glm::max(most, contact.normal);
        least = glm::min(least, contact.normal);
    }
    const Vec3 lean = most + least, reach = glm::max(most, -least);
    const std::initializer_list<double> alongX = {v.x, g.x, om.y, lean.x}, alongY = {v.y, g.y, -om.x, lean.y};
    const std::initializer_list<double> apart = {std::abs(v.x) - std::abs(v.y), std::abs(g.x) - std::abs(g.y),
                                                 std::abs(om.y) - std::abs(om.x), reach.x - reach.y};
    m_flipX = isNegative(alongX);
    m_flipY = isNegative(alongY);
    m_swaps = isNegative(apart);
    const bool isOpenX = isUndecided(alongX), isOpenY = isUndecided(alongY), isOpenSwap = isUndecided(apart);
    if (isOpenX || isOpenY || isOpenSwap) decideByContacts(isOpenX, isOpenY, isOpenSwap, om, held);
}

/// Of the frames that the motion leaves, takes one in which the ball turns counterclockwise, if it turns at all, and
/// the contacts come first.
inline void Mirror::decideByContacts(bool isOpenX, bool isOpenY, bool isOpenSwap, const Vec3 &spin,
                                     std::span<const Held> held) {
    const Mirror given = *this;
    Sorted first(given, held);
    bool isFirst = true;
    for (uint32_t bits = 0; bits < 8; ++bits) {
        const bool flipsX = bits & 1U, flipsY = bits & 2U, swaps = bits & 4U;
        if ((flipsX && !isOpenX) || (flipsY && !isOpenY) || (swaps && !isOpenSwap)) continue;
        Mirror other = given;
        other.m_flipX = other.m_flipX != flipsX;
        other.m_flipY = other.m_flipY != flipsY;
        other.m_swaps = other.m_swaps != swaps;
        if (other.seenSpin(spin).z < 0.0) continue;
        const Sorted sorted(other, held);
        if (!isFirst && compare(sorted, first) >= 0) continue;
        isFirst = false;
        first = sorted;
        *this = other;
    }
}

} // namespace phys
