// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/sample.h"

#include <cmath>
#include <limits>

namespace inspector {

const std::array<ChannelInfo, kChannelCount> &channelInfos() {
    static constexpr std::array<ChannelInfo, kChannelCount> infos{{
        {"position_x", "Position x", "m"},
        {"position_y", "Position y", "m"},
        {"position_z", "Position z", "m"},
        {"velocity_x", "Velocity x", "m/s"},
        {"velocity_y", "Velocity y", "m/s"},
        {"velocity_z", "Velocity z", "m/s"},
        {"speed", "Speed", "m/s"},
        {"spin_x", "Spin x", "rad/s"},
        {"spin_y", "Spin y", "rad/s"},
        {"spin_z", "Spin z", "rad/s"},
        {"energy", "Energy per mass", "J/kg"},
        {"tilt_x", "Tilt x", "deg"},
        {"tilt_y", "Tilt y", "deg"},
        {"substeps", "Substeps", ""},
        {"penetration", "Penetration", "m"},
        {"flags", "Flags", ""},
        {"ghost_x", "Ghost x", "m"},
        {"ghost_y", "Ghost y", "m"},
        {"ghost_z", "Ghost z", "m"},
        {"distance", "Distance", "m"},
        {"speed_difference", "Speed difference", "m/s"},
        {"energy_difference", "Energy difference per mass", "J/kg"},
    }};
    return infos;
}

Sample makeSample(const phys_state &state, const Inputs &inputs, const phys_report &report) {
    const phys_vec3 &p = state.position;
    const phys_vec3 &v = state.velocity;
    const phys_vec3 &w = state.spin;
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Sample sample;
    sample.time = state.time;
    sample.step = state.step;
    sample.values = {p.x,
                     p.y,
                     p.z,
                     v.x,
                     v.y,
                     v.z,
                     std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z),
                     w.x,
                     w.y,
                     w.z,
                     report.energy_after,
                     degrees(inputs.tilt.x),
                     degrees(inputs.tilt.y),
                     double(report.substeps),
                     report.penetration,
                     double(state.flags),
                     kNone,
                     kNone,
                     kNone,
                     kNone,
                     kNone,
                     kNone};
    return sample;
}

} // namespace inspector
