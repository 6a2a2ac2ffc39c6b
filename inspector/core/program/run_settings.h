// SPDX-License-Identifier: GPL-3.0-or-later
// The file beside a table of a run during which settings changed.
#pragma once

#include "core/program/options.h"
#include "core/recording/playable_recording.h"

#include <vector>

namespace inspector {

/// Consecutive rows made under the same conditions; their times, s, in (begin, end].
struct SettingsSpan {
    Conditions conditions;
    Level level;
    double begin;
    double end;
    bool beginsRun; ///< time starts anew
};

/// The spans of the steps [from, to) of a recording.
std::vector<SettingsSpan> spansOf(const PlayableRecording &recording, uint64_t from, uint64_t to);

/// Those of a run that continues another one; what `earlier` has after the run's begin isn't part of it.
std::vector<SettingsSpan> joined(std::vector<SettingsSpan> earlier, const std::vector<SettingsSpan> &run);

bool isSameButForTilt(const Conditions &a, const Conditions &b);

/// What a ghost was stepped with.
struct GhostSettings {
    std::optional<GhostChoice> ghostChoice; ///< empty: there was none
    std::vector<Setting> own;
    uint64_t met = 0; ///< identifies its start at the ball
};

/// Lists the settings of the first row, one per line, then a line for each setting that changes, "from 1.06 s: dt 0.001
/// s", with the time of the first row to which it applies, and one where a ghost starts anew. A tilt that varies isn't
/// listed, as it has a column.
class RunSettings {
public:
    RunSettings(Registry registry, const std::vector<SettingsSpan> &spans);

    /// Notes that the rows from `time` on were made under these conditions, beside this ghost.
    void note(const SettingsSpan &span, const GhostSettings &ghost, double time);

    QByteArray text() const { return m_text; }

private:
    QByteArrayList linesOf(const SettingsSpan &span, const GhostSettings &ghost) const;
    Options optionsOf(const SettingsSpan &span, const GhostSettings &ghost) const;

    Registry m_registry;
    bool m_isTiltVaried = false;
    int m_runs = 0;
    uint64_t m_met = 0;     ///< the last rows' ghost's; 0: there was none
    QByteArrayList m_lines; ///< of the last rows
    QByteArray m_text;
};

/// The same for all steps of a recording, each of its runs with its number.
QByteArray recordingSettings(const PlayableRecording &recording);

} // namespace inspector
