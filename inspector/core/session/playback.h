// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/replay.h"
#include "core/simulation/simulation.h"

#include <QCoreApplication>

#include <memory>
#include <optional>

namespace inspector {

/// A recording that the simulation shows in place of the live ball: one from a file, or the past.
class Playback {
    Q_DECLARE_TR_FUNCTIONS(Playback)

public:
    /// number: as in snapshots. begin: the position at which it begins.
    Playback(Simulation &simulation, std::shared_ptr<const PlayableRecording> recording, uint64_t number,
             uint64_t begin = 0);

    const PlayableRecording &recording() const { return *m_recording; }
    uint64_t number() const { return m_number; }

    void seek(uint64_t position);
    uint64_t sought() const { return m_sought; } ///< the position last asked for
    /// Whether that is shown by now, or what followed it.
    bool showsSought(const Snapshot &now) const;
    /// The current or requested position; nothing before its first snapshot.
    std::optional<ReplayPlace> place(const Snapshot &now) const;

    /// Of the recording, as last passed to follow(); nothing before the first.
    std::optional<size_t> segment() const { return m_segment; }
    bool follow(size_t segment); ///< returns whether it is another one

    void noteDifference(const Difference &difference);
    QString difference() const { return m_difference; } ///< in one line; empty if none was found yet
    /// "same", "same so far" or the first difference, in one line.
    QString verdict(const Snapshot &now) const;

private:
    Simulation &m_simulation;
    std::shared_ptr<const PlayableRecording> m_recording;
    uint64_t m_number;
    std::optional<size_t> m_segment;
    uint64_t m_sought;
    uint64_t m_seeks = 0; ///< number of the last one
    QString m_difference;
};

} // namespace inspector
