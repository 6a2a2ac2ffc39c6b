// SPDX-License-Identifier: GPL-3.0-or-later
// What a person doesn't know exactly about a board, and boards as they may really be.
#pragma once

#include "core/setup/inputs.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace inspector {

// The true value lies anywhere within `amount` on either side of the one that is set.
struct Unknown {
    // "tilt" (both axes alike), "start" (x and y), or a row's: tilt_x, gravity, rolling_friction, ...
    QString id;
    double amount = 0.0;  // > 0; in the row's unit, "tilt" in degrees, "start" in m
    bool isShare = false; // `amount` is a share of the value instead
    bool operator==(const Unknown &) const = default;
};
using Unknowns = std::vector<Unknown>;

// Of a board built by hand: tilt=0.1deg,rolling_friction=50%,restitution_wall=0.04,start=0.1mm
const QString &usualUnknowns();

// Such words, or "none". Nothing and one line in `error` if they can't be read.
std::optional<Unknowns> parseUnknowns(const QString &words, QString *error);
QString unknownsText(const Unknowns &unknowns); // as parseUnknowns() reads them

// A board as it may really be.
struct SampledBoard {
    phys_params params; // without their gravity
    double gravity;     // m/s^2
    Tilt tiltOffset;    // rad, added to every tilt
    phys_vec3 startOffset;
};

// Independent of each other, even between their bounds; values beyond a row's range are moved to its end. The same for
// the same seed, everywhere.
std::vector<SampledBoard> sampleBoards(const Unknowns &unknowns, const Inputs &inputs, int count, uint64_t seed);

} // namespace inspector
