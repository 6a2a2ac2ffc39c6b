// SPDX-License-Identifier: GPL-3.0-or-later
// What is recorded of every step for plots and tables: a fixed set of channels, described by one table.
#pragma once

#include "core/setup/inputs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

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
    /// The comparison with a ghost: NaN in steps without one.
    GhostX,
    GhostY,
    GhostZ,
    Distance,
    SpeedDifference,
    EnergyDifference,
    /// Only for plots; not part of every table.
    Acceleration,
    Kinetic,
    Potential,
    LostImpact,
    LostRolling,
    LostSlip,
    Scheme,
    StepTime, ///< NaN where it wasn't timed
    GhostSpeed,
    GhostEnergy,
    WallGap, ///< NaN where no wall is near
    /// The measured ball: NaN without one.
    TrackX,
    TrackY,
    TrackSpeed,
    TrackDistance,
};

inline constexpr size_t kBallChannelCount = size_t(Channel::Flags) + 1;             ///< channels of every step
inline constexpr size_t kTableChannelCount = size_t(Channel::EnergyDifference) + 1; ///< including a ghost's
inline constexpr size_t kChannelCount = size_t(Channel::TrackDistance) + 1;

struct ChannelInfo {
    const char *id;                       ///< for columns and settings: velocity_x
    const char *label;                    ///< for display: Velocity x
    const char *unit;                     ///< "" if it has none
    const char *group;                    ///< in menus
    std::optional<Channel> counterpart{}; ///< the ball's, if this is a ghost's or the measured ball's: dashed in plots
};

/// In the order of the enumeration.
const std::array<ChannelInfo, kChannelCount> &channelInfos();

struct Sample {
    double time = 0.0; ///< s since the start
    uint64_t step = 0;
    uint64_t ghost = 0; ///< number of the ghost beside it, as in Simulation::compareWith(); 0: none
    std::array<double, kChannelCount> values{};

    double operator[](Channel channel) const { return values[size_t(channel)]; }
    double &operator[](Channel channel) { return values[size_t(channel)]; }
};

/// Without the comparison, and without channels that a single state doesn't determine.
Sample makeSample(const phys_state &state, const Inputs &inputs, const phys_report &report);
/// The same for a state that no step led to.
Sample sampleBeforeAStep(const phys_scene *scene, const phys_state &state, const Inputs &inputs);

} // namespace inspector
