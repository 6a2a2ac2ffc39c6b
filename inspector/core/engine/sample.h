// SPDX-License-Identifier: GPL-3.0-or-later
// What every step leaves for plots and tables: a fixed set of channels, described by one table.
#pragma once

#include "core/setup/inputs.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace inspector {

enum class Channel {
    PositionX,
    PositionY,
    PositionZ,
    VelocityX,
    VelocityY,
    VelocityZ,
    Speed,
    SpinX,
    SpinY,
    SpinZ,
    Energy,
    TiltX,
    TiltY,
    Substeps,
    Penetration,
    Flags,
    // Of the comparison with a second ball: NaN in steps without one.
    GhostX,
    GhostY,
    GhostZ,
    Distance,
    SpeedDifference,
    EnergyDifference,
    // For plots; not in every table.
    Acceleration,
    Kinetic,
    Potential,
    LostImpact,
    LostRolling,
    LostSlip,
    Scheme,
    StepTime, // NaN where nobody looked at the clock
    GhostSpeed,
    GhostEnergy,
    WallGap, // NaN where no wall is near
    // Of a measured ball: NaN without one.
    TrackX,
    TrackY,
    TrackSpeed,
    TrackDistance,
};

inline constexpr size_t kBallChannelCount = size_t(Channel::Flags) + 1;             // that every step has
inline constexpr size_t kTableChannelCount = size_t(Channel::EnergyDifference) + 1; // with a ghost's
inline constexpr size_t kChannelCount = size_t(Channel::TrackDistance) + 1;

struct ChannelInfo {
    const char *id;       // for columns and settings: velocity_x
    const char *label;    // for people: Velocity x
    const char *unit;     // "" if it has none
    const char *group;    // in menus
    bool isGhost = false; // of another ball: dashed in plots
};

// In the order of the enumeration.
const std::array<ChannelInfo, kChannelCount> &channelInfos();

struct Sample {
    double time = 0.0; // s since the start
    uint64_t step = 0;
    std::array<double, kChannelCount> values{};

    double operator[](Channel channel) const { return values[size_t(channel)]; }
    double &operator[](Channel channel) { return values[size_t(channel)]; }
};

// Without a comparison, and without what one state alone doesn't tell.
Sample makeSample(const phys_state &state, const Inputs &inputs, const phys_report &report);

} // namespace inspector
