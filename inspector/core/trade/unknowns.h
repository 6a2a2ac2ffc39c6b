// SPDX-License-Identifier: GPL-3.0-or-later
// What is unknown about a board, and random boards within these bounds.
#pragma once

#include "core/setup/inputs.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace inspector {

/// The true value is uniformly distributed within `amount` on either side of the nominal one.
struct Unknown {
    /// "tilt" (both axes), "start" (x and y), or a row's: tilt_x, gravity, rolling_friction, ...
    QString id;
    double amount = 0.0;  ///< > 0; in the row's unit, degrees for "tilt", m for "start"
    bool isShare = false; ///< `amount` is a share of the value
    bool operator==(const Unknown &) const = default;
};
using Unknowns = std::vector<Unknown>;

/// For a hand-built board: tilt=0.1deg,rolling_friction=50%,restitution_wall=0.04,start=0.1mm
const QString &usualUnknowns();

/// Parses such words, or "none". Returns nothing, with one line in `error`, if they can't be read.
std::optional<Unknowns> parseUnknowns(const QString &words, QString *error);
QString unknownsText(const Unknowns &unknowns); ///< in the form that parseUnknowns() reads

/// A possible true board.
struct SampledBoard {
    phys_params params; ///< gravity is not set
    double gravity;     ///< m/s^2
    Tilt tiltOffset;    ///< rad, added to every tilt
    phys_vec3 startOffset;
};

/// Independent uniform samples within the bounds; values outside of a row's range are clamped. The same for the same
/// seed on every system.
std::vector<SampledBoard> sampleBoards(const Unknowns &unknowns, const Inputs &inputs, int count, uint64_t seed);

} // namespace inspector
