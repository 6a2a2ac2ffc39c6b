// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/engine/sample.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace inspector {

const std::array<ChannelInfo, kChannelCount> &channelInfos() {
    static constexpr std::array<ChannelInfo, kChannelCount> infos{{
        {"position_x", "Position x", "m", "Position"},
        {"position_y", "Position y", "m", "Position"},
        {"position_z", "Position z", "m", "Position"},
        {"velocity_x", "Velocity x", "m/s", "Velocity"},
        {"velocity_y", "Velocity y", "m/s", "Velocity"},
        {"velocity_z", "Velocity z", "m/s", "Velocity"},
        {"speed", "Speed", "m/s", "Velocity"},
        {"spin_x", "Spin x", "rad/s", "Spin"},
        {"spin_y", "Spin y", "rad/s", "Spin"},
        {"spin_z", "Spin z", "rad/s", "Spin"},
        {"energy", "Energy per mass", "J/kg", "Energy"},
        {"tilt_x", "Tilt x", "deg", "Board"},
        {"tilt_y", "Tilt y", "deg", "Board"},
        {"substeps", "Substeps", "", "Stepper"},
        {"penetration", "Penetration", "m", "Stepper"},
        {"flags", "Flags", "", "Stepper"},
        {"ghost_x", "Ghost x", "m", "Ghost", Channel::PositionX},
        {"ghost_y", "Ghost y", "m", "Ghost", Channel::PositionY},
        {"ghost_z", "Ghost z", "m", "Ghost", Channel::PositionZ},
        {"distance", "Distance", "m", "Ghost"},
        {"speed_difference", "Speed difference", "m/s", "Ghost"},
        {"energy_difference", "Energy difference per mass", "J/kg", "Ghost"},
        {"acceleration", "Acceleration", "m/s^2", "Velocity"},
        {"kinetic", "Kinetic energy", "J/kg", "Energy"},
        {"potential", "Potential energy", "J/kg", "Energy"},
        {"lost_impact", "Lost to impacts", "J/kg", "Energy"},
        {"lost_rolling", "Lost to rolling", "J/kg", "Energy"},
        {"lost_slip", "Lost to slip", "J/kg", "Energy"},
        {"scheme", "Made by the stepper", "J/kg", "Energy"},
        {"step_time", "Time a step takes", "us", "Stepper"},
        {"ghost_speed", "Ghost speed", "m/s", "Ghost", Channel::Speed},
        {"ghost_energy", "Ghost energy", "J/kg", "Ghost", Channel::Energy},
        {"wall_gap", "Gap to the nearest wall", "m", "Position"},
        {"track_x", "Measured x", "m", "Measured ball", Channel::PositionX},
        {"track_y", "Measured y", "m", "Measured ball", Channel::PositionY},
        {"track_speed", "Measured speed", "m/s", "Measured ball", Channel::Speed},
        {"track_distance", "Distance to the measured ball", "m", "Measured ball"},
    }};
    return infos;
}

Sample makeSample(const phys_state &state, const Inputs &inputs, const phys_report &report) {
    const phys_vec3 &p = state.position;
    const phys_vec3 &v = state.velocity;
    const phys_vec3 &w = state.spin;
    Sample sample;
    sample.time = state.time;
    sample.step = state.step;
    sample.values.fill(std::numeric_limits<double>::quiet_NaN());
    const auto put = [&sample](Channel first, std::initializer_list<double> values) {
        std::copy(values.begin(), values.end(), sample.values.begin() + size_t(first));
    };
    put(Channel::PositionX, {p.x, p.y, p.z, v.x, v.y, v.z, std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z)});
    put(Channel::SpinX, {w.x, w.y, w.z, report.energy_after, degrees(inputs.tilt.x), degrees(inputs.tilt.y)});
    put(Channel::Substeps, {double(report.substeps), report.penetration, double(state.flags)});
    const phys_vec3 &g = inputs.params.gravity;
    const double potential = -(g.x * p.x + g.y * p.y + g.z * p.z);
    put(Channel::Kinetic, {report.energy_after - potential, potential});
    return sample;
}

Sample sampleBeforeAStep(const phys_scene *scene, const phys_state &state, const Inputs &inputs) {
    phys_report report{};
    if (phys_energy(scene, &inputs.params, &state, &report.energy_after) != PHYS_OK)
        report.energy_after = std::numeric_limits<double>::quiet_NaN();
    Sample sample = makeSample(state, inputs, report);
    for (const Channel channel : {Channel::Substeps, Channel::Penetration})
        sample[channel] = std::numeric_limits<double>::quiet_NaN();
    return sample;
}

} // namespace inspector
