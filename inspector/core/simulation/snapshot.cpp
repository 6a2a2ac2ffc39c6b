// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/snapshot.h"

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

phys_vec3 mixed(const phys_vec3 &a, const phys_vec3 &b, double t) {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/// Normalised linear interpolation (nlerp) along the shorter path: between two steps the angle is small.
void mixOrientation(const double a[4], const double b[4], double t, double out[4]) {
    const double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    const double sign = dot < 0.0 ? -1.0 : 1.0;
    double length = 0.0;
    for (int i = 0; i < 4; ++i) {
        out[i] = (1.0 - t) * a[i] + t * sign * b[i];
        length += out[i] * out[i];
    }
    for (int i = 0; i < 4; ++i) out[i] /= std::sqrt(length);
}

/// Fraction of the step to `current` that has passed at `now`.
double shareOf(const Snapshot &snapshot, Clock::time_point now) {
    const std::chrono::duration<double> passed = now - snapshot.due;
    const std::chrono::duration<double> interval = snapshot.interval;
    return std::clamp(passed / interval, 0.0, 1.0);
}

phys_state between(const phys_state &a, const phys_state &b, double t) {
    phys_state result = b;
    result.time = a.time + t * (b.time - a.time);
    result.position = mixed(a.position, b.position, t);
    result.velocity = mixed(a.velocity, b.velocity, t);
    result.spin = mixed(a.spin, b.spin, t);
    mixOrientation(a.orientation, b.orientation, t, result.orientation);
    return result;
}

} // namespace

phys_state interpolated(const Snapshot &snapshot, Clock::time_point now) {
    if (snapshot.interval <= Clock::duration::zero()) return snapshot.current;
    return between(snapshot.previous, snapshot.current, shareOf(snapshot, now));
}

std::optional<phys_state> interpolatedGhost(const Snapshot &snapshot, Clock::time_point now) {
    if (!snapshot.ghost) return std::nullopt;
    if (snapshot.interval <= Clock::duration::zero()) return snapshot.ghost->current;
    return between(snapshot.ghost->previous, snapshot.ghost->current, shareOf(snapshot, now));
}

} // namespace inspector
