// SPDX-License-Identifier: MIT
#include "exact/search.h"

namespace phys {

bool Outlook::isBehind(const Contact &face, const phys_box &other) const {
    const int axis = axisOf(face), sign = face.sides[axis];
    return sign * (planeOf(other, axis, sign) - planeOf(box(face.box), axis, sign)) <= scene.tolerance;
}

bool Outlook::isBehindTouchedFace(const phys_box &other) const {
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const Contact &contact) { return contact.isFace() && isBehind(contact, other); });
}

bool Outlook::isTouched(const Vec3 &normal) const {
    const double most = 4.0 * sameNormal(scene);
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const Contact &contact) { return glm::length(contact.normal - normal) <= most; });
}

bool Outlook::isBarred(int axis) const {
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        if ((lasting >> i & 1U) && contacts[i].isFace() && contacts[i].sides[axis] != 0) return true;
    }
    return false;
}

bool Outlook::isKept(uint32_t number, const phys_box &other) const {
    for (uint32_t i = 0; i < contacts.count(); ++i) {
        const Contact &contact = contacts[i];
        if (contact.box == number && contact.isFace() && isBarred(axisOf(contact))) return true;
        const bool isAtIt = contact.box == number || (contact.isFace() && isBehind(contact, other));
        if ((lasting >> i & 1U) && isAtIt) return true;
    }
    return false;
}

Target::Target(const Outlook &around, const phys_box &from)
    : box{fromVec(toVec(from.min) - around.position), fromVec(toVec(from.max) - around.position)} {
    const double R = around.scene.radius;
    tolerance = around.scene.tolerance;
    slight = 2.0 * std::sqrt(tolerance / R);
    const Nearest close = nearest(box, Vec3(0.0));
    if (close.distance - R > 2.0 * around.scene.tolerance) return; // not touched, beyond rounding
    isBehindFace = around.isBehindTouchedFace(from);
    rate = glm::dot(close.normal, around.motion.velocity);
    isTouched = isBehindFace || around.isTouched(close.normal);
    if (!isTouched) return;
    normal = close.normal;
    for (int axis = 0; axis < 3; ++axis) {
        const double n = close.normal[axis];
        double &low = (&box.min.x)[axis], &high = (&box.max.x)[axis];
        if (n > 0.0) high = -R * n;
        if (n < 0.0) low = -R * n;
        if (low > high) (n > 0.0 ? low : high) = -R * n; // a box without width keeps none
    }
}

double Target::gap(const Vec3 &way, double radius, Vec3 &n) const {
    Vec3 away(0.0);
    bool isSame = isTouched;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = way[axis];
        away[axis] = x - limited(x, (&box.min.x)[axis], (&box.max.x)[axis]);
        isSame = isSame && away[axis] * normal[axis] >= 0.0 && (away[axis] == 0.0) == (normal[axis] == 0.0);
    }
    const int outside = (away.x != 0.0) + (away.y != 0.0) + (away.z != 0.0);
    if (outside == 0) {
        const Nearest close = nearest(box, way);
        n = close.normal;
        return close.distance - radius;
    }
    const double distance = outside == 1 ? std::abs(away.x + away.y + away.z) : glm::length(away);
    n = away / distance;
    if (!isSame) return distance - radius;
    if (outside == 1) return glm::dot(normal, way);
    const Vec3 across{normal.x != 0.0 ? way.x : 0.0, normal.y != 0.0 ? way.y : 0.0, normal.z != 0.0 ? way.z : 0.0};
    return (2.0 * radius * glm::dot(normal, way) + glm::dot(across, across)) / (distance + radius);
}

bool Stretch::passes(const phys_box &box) const {
    double first = 0.0, last = 1.0; // shares of the line
    for (int axis = 0; axis < 3; ++axis) {
        const double low = planeOf(box, axis, -1) - off - start[axis], high = planeOf(box, axis, 1) + off - start[axis];
        const double way = end[axis] - start[axis];
        if (way == 0.0) {
            if (low > 0.0 || high < 0.0) return true;
            continue;
        }
        first = std::max(first, std::min(low / way, high / way));
        last = std::min(last, std::max(low / way, high / way));
    }
    return first > last;
}

bool carriesOn(const Outlook &around, const Contact &face, const Vec3 &p, const Border &at, phys_box &box) {
    const double tolerance = around.scene.tolerance;
    const phys_box own = box;
    double furthest = tolerance;
    visitNear(around.scene, p, around.scene.radius + 2.0 * tolerance, [&](const phys_box &other, uint32_t) {
        for (int axis = 0; axis < 3; ++axis) {
            const int sign = face.sides[axis];
            if (sign != 0 && std::abs(planeOf(other, axis, sign) - planeOf(own, axis, sign)) > tolerance) return;
            if (sign == 0 &&
                (p[axis] < planeOf(other, axis, -1) - tolerance || p[axis] > planeOf(other, axis, 1) + tolerance))
                return;
        }
        const double beyond =
            at.inward < 0.0 ? planeOf(other, at.axis, 1) - at.coordinate : at.coordinate - planeOf(other, at.axis, -1);
        if (beyond <= furthest) return;
        furthest = beyond;
        box = other;
    });
    return furthest > tolerance;
}

double distanceFromAbove(const phys_box &box, const Vec3 &point, Vec3 &away) {
    Vec3 out(0.0), toward(0.0); // beyond the nearer side along each axis, and its direction
    for (int axis = 0; axis < 2; ++axis) {
        const double low = planeOf(box, axis, -1) - point[axis], high = point[axis] - planeOf(box, axis, 1);
        out[axis] = std::max(low, high);
        toward[axis] = low > high ? -1.0 : 1.0;
    }
    if (out.x > 0.0 && out.y > 0.0) {
        const double distance = glm::length(out);
        away = out / distance * toward;
        return distance;
    }
    const int axis = out.x >= out.y ? 0 : 1;
    away = Vec3(0.0);
    away[axis] = toward[axis];
    return out[axis];
}

} // namespace phys
