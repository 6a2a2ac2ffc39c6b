// SPDX-License-Identifier: MIT
#include "contact/contact.h"

#include "contact/mirror.h"
#include "contact/near.h"
#include "scene/nearest.h"

#include <cmath>
#include <tuple>

namespace phys {

namespace {

bool isSameNormal(const Vec3 &a, const Vec3 &b, double most) {
    return std::abs(a.x - b.x) <= most && std::abs(a.y - b.y) <= most && std::abs(a.z - b.z) <= most;
}

/// A frame in which these contacts look the same for all symmetric images of the ball and them.
Mirror mirrorOf(std::span<const Contact> contacts, const Motion &motion, const Vec3 &gravity, double radius) {
    std::array<Held, kMostHeld> held{};
    const size_t count = std::min<size_t>(contacts.size(), kMostHeld);
    for (size_t i = 0; i < count; ++i) {
        const Contact &contact = contacts[i];
        held[i].normal = contact.normal;
        held[i].across = contact.across(Vec3(1.0));
        held[i].friction = contact.friction;
        held[i].isGlued = contact.isGlued;
    }
    return Mirror({motion.velocity, motion.spin, gravity, radius}, {held.data(), count});
}

bool isLess(const Vec3 &a, const Vec3 &b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// On which side of a box a centre is along one axis. On a border (within the tolerance) it belongs to the side towards
/// which it moves, or to the box if it doesn't move.
int sideOf(double centre, double low, double high, double speed, double tolerance, double negligible) {
    if (centre < low - tolerance) return -1;
    if (centre > high + tolerance) return 1;
    if (centre <= low + tolerance && speed < -negligible) return -1;
    if (centre >= high - tolerance && speed > negligible) return 1;
    return 0;
}

/// From the box's nearest point to the centre along one axis; a centre on a border counts as beside the box.
double offset(double centre, double low, double high, double tolerance) {
    if (centre < low - tolerance) return centre - low;
    if (centre > high + tolerance) return centre - high;
    return 0.0;
}

/// The coefficients depend on the feature alone, model.md 13.1.
void setCoefficients(const Setting &setting, Contact &contact) {
    const phys_params &params = setting.params;
    contact.isTop = contact.sides == std::array{0, 0, 1};
    contact.isGlued = contact.isTop && !setting.isRigid();
    contact.restitution = contact.isTop ? params.restitution_floor : params.restitution_wall;
    contact.friction = !setting.isRigid() ? 0.0 : contact.isTop ? params.sliding_friction : params.wall_friction;
}

/// Whether two contacts are on opposite sides of a crack of negligible width, with the ball right above it.
bool areAcrossACrack(const Contact &a, const Contact &b) {
    bool any = false;
    for (int axis = 0; axis < 3; ++axis) {
        if (a.sides[axis] == b.sides[axis]) continue;
        if (a.sides[axis] != -b.sides[axis]) return false;
        any = true;
    }
    return any;
}

/// One of two such contacts, moved to the middle, where both are the same. It stays an edge, off which the ball rolls.
Contact joined(Contact contact, const Contact &other) {
    for (int axis = 0; axis < 3; ++axis) {
        if (contact.sides[axis] == other.sides[axis]) continue;
        contact.normal[axis] = 0.0;
        contact.point[axis] = 0.5 * (contact.point[axis] + other.point[axis]);
    }
    contact.normal = glm::normalize(contact.normal);
    return contact;
}

/// Collects contacts, keeping one for each normal. Which one is kept depends on positions, never on the order.
class Gathering {
public:
    Gathering(const Setting &setting, const Vec3 &position, const Motion &motion, Contacts &contacts)
        : m_setting(setting)
        , m_position(position)
        , m_motion(motion)
        , m_contacts(contacts) {
        contacts.clear();
    }

    /// Of two contacts with the same normal the closer one is kept; within the tolerance the one with the fewest axes,
    /// and of equals the one along which the ball moves for longer. If there are too many contacts, the closest are
    /// kept.
    void add(const Contact &contact) {
        for (Contact &other : m_contacts) {
            if (!isSameNormal(contact.normal, other.normal, m_setting.sameNormal)) continue;
            // A stepper that looks ahead passes over the crack; another one goes from edge to edge.
            const bool looksAhead = m_setting.sameNormal == kSameNormal;
            if (looksAhead && contact.gap == other.gap && areAcrossACrack(contact, other)) {
                other = liesAhead(contact, other) ? joined(contact, other) : joined(other, contact);
            } else if (isPreferred(contact, other)) {
                other = contact;
            }
            return;
        }
        if (!m_contacts.isFull()) return m_contacts.add(contact);
        Contact &farthest = *std::max_element(m_contacts.begin(), m_contacts.end(),
                                              [](const Contact &a, const Contact &b) { return a.gap < b.gap; });
        if (contact.gap < farthest.gap) farthest = contact;
    }

private:
    bool isPreferred(const Contact &a, const Contact &b) const {
        const bool isFlush = std::abs(a.gap - b.gap) <= m_setting.tolerance;
        if (isFlush && a.axes() != b.axes()) return a.axes() < b.axes();
        return a.gap == b.gap ? liesAhead(a, b) : a.gap < b.gap;
    }

    /// Two contacts differ only by the ends of their boxes: whether the ball leaves the second one's box first.
    bool liesAhead(const Contact &a, const Contact &b) const {
        const auto outlook = [&](const Contact &contact) {
            const Vec3 driven = glm::cross(m_motion.spin, contact.normal); // direction of friction's drive
            return std::tuple(endAlong(contact, m_motion.velocity), endAlong(contact, m_setting.gravity()),
                              endAlong(contact, driven), nearestEnd(contact));
        };
        return outlook(b) < outlook(a);
    }

    /// Distance to the box's end along a direction, in units of its length.
    double endAlong(const Contact &contact, const Vec3 &direction) const {
        const phys_box &box = m_setting.scene.boxes[contact.box];
        double nearest = INFINITY;
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(contact.normal[axis]) > kSameNormal || direction[axis] == 0.0) continue;
            const double end = direction[axis] > 0.0 ? (&box.max.x)[axis] : (&box.min.x)[axis];
            nearest = std::min(nearest, (end - m_position[axis]) / direction[axis]);
        }
        return nearest;
    }

    double nearestEnd(const Contact &contact) const {
        const phys_box &box = m_setting.scene.boxes[contact.box];
        double nearest = INFINITY;
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(contact.normal[axis]) > kSameNormal) continue;
            nearest = std::min({nearest, std::abs(m_position[axis] - (&box.min.x)[axis]),
                                std::abs(m_position[axis] - (&box.max.x)[axis])});
        }
        return nearest;
    }

    const Setting &m_setting;
    const Vec3 &m_position;
    const Motion &m_motion;
    Contacts &m_contacts;
};

/// Finds the feature of a box that is nearest to the ball. False if the centre is inside the box.
bool findFeature(const Setting &setting, const Vec3 &position, const Motion &motion, double negligible, uint32_t number,
                 Contact &contact) {
    const phys_box &box = setting.scene.boxes[number];
    const double tolerance = setting.tolerance;
    Vec3 d(0.0); // initialised because of a false warning by GCC 12 under ThreadSanitizer
    for (int axis = 0; axis < 3; ++axis) {
        const double low = (&box.min.x)[axis];
        const double high = (&box.max.x)[axis];
        contact.sides[axis] = sideOf(position[axis], low, high, motion.velocity[axis], tolerance, negligible);
        d[axis] = offset(position[axis], low, high, tolerance);
        contact.point[axis] = limited(position[axis], low, high);
    }
    const int outside = (d.x != 0.0) + (d.y != 0.0) + (d.z != 0.0);
    if (outside == 0) return false;
    // A face's distance is exact, without the rounding of a square root.
    const double distance = outside == 1 ? std::abs(d.x + d.y + d.z) : glm::length(d);
    contact.normal = d / distance;
    contact.gap = distance - setting.scene.radius;
    contact.restSpeed = 0.0;
    contact.box = number;
    return true;
}

} // namespace

void Contacts::dropHidden(double tolerance) {
    drop([&](const Contact &contact) {
        return std::any_of(begin(), end(), [&](const Contact &other) {
            return other.axes() < contact.axes() && other.isBefore(contact.point, tolerance);
        });
    });
}

void Contacts::sort(const Motion &motion, const Vec3 &gravity, double radius) {
    if (count() < 2) return;
    // Below 0 if a comes before b; 0 if they tie. Most differ in the first criteria.
    const auto compare = [&](const Contact &a, const Contact &b) {
        const auto order = [](double first, double second) { return (first > second) - (first < second); };
        const auto squareOfSlip = [&](const Contact &contact) {
            const Vec3 slip = slipAt(motion, contact.normal, radius);
            return glm::dot(slip, slip);
        };
        if (a.gap != b.gap) return order(a.gap, b.gap);
        const double approachA = glm::dot(motion.velocity, a.normal), approachB = glm::dot(motion.velocity, b.normal);
        if (approachA != approachB) return order(approachA, approachB);
        const double pullA = glm::dot(gravity, a.normal), pullB = glm::dot(gravity, b.normal);
        if (pullA != pullB) return order(pullA, pullB);
        const int slips = order(squareOfSlip(a), squareOfSlip(b));
        return slips != 0 ? slips : a.axes() - b.axes();
    };
    const auto insertionSort = [&](auto comesBefore) {
        for (uint32_t i = 1; i < count(); ++i) {
            uint32_t place = i;
            while (place > 0 && comesBefore((*this)[i], (*this)[place - 1])) --place;
            if (place < i) std::rotate(begin() + place, begin() + i, begin() + i + 1);
        }
    };
    // The numbering of boxes has no effect.
    insertionSort([&](const Contact &a, const Contact &b) {
        const int order = compare(a, b);
        return order == 0 ? isLess(a.normal, b.normal) : order < 0;
    });
    m_tiesWithPrevious[0] = false;
    for (uint32_t i = 1; i < count(); ++i) m_tiesWithPrevious[i] = compare((*this)[i], (*this)[i - 1]) == 0;
    if (!hasTies()) return;
    // Nor have reflections and quarter turns, unless the contacts are their own image.
    const Mirror mirror = mirrorOf({begin(), end()}, motion, gravity, radius);
    insertionSort([&](const Contact &a, const Contact &b) {
        const int order = compare(a, b);
        return order == 0 ? isLess(mirror.seen(a.normal), mirror.seen(b.normal)) : order < 0;
    });
}

bool Contacts::reverseTies() {
    bool any = false;
    for (uint32_t first = 0, last = 1; first < count(); first = last++) {
        while (last < count() && m_tiesWithPrevious[last]) ++last;
        any = any || last - first > 1;
        std::reverse(begin() + first, begin() + last);
    }
    return any;
}

bool findContacts(const Setting &setting, const Vec3 &position, const Motion &motion, std::span<const Vec3> ways,
                  Contacts &out) {
    const Scene &scene = setting.scene;
    const double touching = scene.radius + setting.tolerance;
    const double overlapping = scene.radius - setting.tolerance;
    double furthest = 0.0;
    for (const Vec3 &way : ways) furthest = std::max(furthest, glm::length(way));
    const auto isReached = [&](const phys_box &box) {
        return std::any_of(ways.begin(), ways.end(), [&](const Vec3 &way) {
            return squaredDistance(box, position + way) < overlapping * overlapping;
        });
    };
    Gathering gathering(setting, position, motion, out);
    bool isOutside = true;
    double negligible = -1.0; // computed only when something is near
    visitNear(scene, position, touching + furthest, [&](const phys_box &box, uint32_t number) {
        const bool isTouched = squaredDistance(box, position) <= touching * touching;
        if (!isTouched && (furthest == 0.0 || !isReached(box))) return;
        if (negligible < 0.0) negligible = negligibleSpeed(motion, scene.radius);
        Contact contact;
        if (findFeature(setting, position, motion, negligible, number, contact))
            gathering.add(contact);
        else
            isOutside = false;
    });
    for (Contact &contact : out) setCoefficients(setting, contact);
    out.sort(motion, setting.gravity(), scene.radius);
    return isOutside;
}

void findContactsAmong(const Setting &setting, const Vec3 &position, const Motion &motion,
                       std::span<const uint32_t> boxes, Contacts &out) {
    const double touching = setting.scene.radius + setting.tolerance;
    const double negligible = negligibleSpeed(motion, setting.scene.radius);
    Gathering gathering(setting, position, motion, out);
    for (const uint32_t number : boxes) {
        Contact contact;
        const bool isTouched = squaredDistance(setting.scene.boxes[number], position) <= touching * touching;
        if (isTouched && findFeature(setting, position, motion, negligible, number, contact)) gathering.add(contact);
    }
    for (Contact &contact : out) setCoefficients(setting, contact);
    out.sort(motion, setting.gravity(), setting.scene.radius);
}

Contact contactAtFace(const Setting &setting, const Vec3 &position, uint32_t box, int axis, int side) {
    const phys_box &bounds = setting.scene.boxes[box];
    Contact contact{};
    contact.point = position;
    contact.point[axis] = side > 0 ? (&bounds.max.x)[axis] : (&bounds.min.x)[axis];
    contact.sides[static_cast<size_t>(axis)] = side;
    contact.normal[axis] = side;
    contact.box = box;
    setCoefficients(setting, contact);
    return contact;
}

} // namespace phys
