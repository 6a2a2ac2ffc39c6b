// SPDX-License-Identifier: GPL-3.0-or-later
// Reads tracks as cameras and trackers write them: a table with a header line and one row per picture.
//
// Columns are found by name, in any order, beside any others: t, time or frame; x, y (or position_x, pos_x, ...);
// tilt_x, tilt_y or gravity_x, gravity_y, gravity_z (or gx, ...). A unit follows the name: x [mm], x (mm), x_mm. The
// fields are separated by commas, semicolons or tabs; with the latter two a decimal comma is read, too. Lines that
// begin with # are skipped. A table that this program wrote with --csv is a track, too.
#pragma once

#include "core/track/track.h"

#include <QIODevice>

#include <optional>

namespace inspector {

/// Units of columns whose names don't give one; scales of pixels and frames.
struct TrackUnits {
    double time = 1.0;                  ///< s
    double position = 1.0;              ///< m
    double tilt = 0.017453292519943295; ///< rad: degrees
    double pixel = 0.0;                 ///< m; 0: not known
    double frame = 0.0;                 ///< s; 0: not known
    bool mirrorsX = false;
    bool mirrorsY = false; ///< pixel rows count downwards
};

/// Parses words separated by commas: t=ms, x=mm, tilt=rad, px=0.25mm, fps=60, mirror=y. Returns nothing, with one line
/// in `error`, if one of them is wrong.
std::optional<TrackUnits> parseTrackUnits(const QString &words, QString *error);

/// Unusable rows are skipped and listed in the track's remarks. Returns nothing, with one line in `error`, if columns
/// are missing or fewer than 10 rows remain.
std::optional<Track> readTrack(QIODevice &device, const QString &name, const TrackUnits &units, QString *error);
/// Whether a file looks like a track: by its name (.csv, .tsv), or by a header that names x and y.
bool isTrackFile(const QString &path);
std::optional<Track> readTrackFile(const QString &path, const TrackUnits &units, QString *error);

} // namespace inspector
