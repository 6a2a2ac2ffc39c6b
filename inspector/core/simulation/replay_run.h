// SPDX-License-Identifier: GPL-3.0-or-later
// A recording that is played in place of the live ball, which waits meanwhile.
#pragma once

#include "core/recording/player.h"
#include "core/simulation/live_run.h"

#include <chrono>
#include <optional>

namespace inspector {

class ReplayRun : public Run {
public:
    /// number: identifies the replay, from 1.
    ReplayRun(Presentation &presentation, const LiveRun &live, Player player, uint64_t number);

    const Engine &engine() const override { return m_player.engine(); }
    uint32_t stepperPlace() const override { return m_player.recording().stepperPlace(m_player.segment()); }
    void addTo(Snapshot &snapshot) const override;
    void prepareToGoOn() override; ///< at its end, starts over
    void step(Clock::time_point due) override;
    void stepOnce() override;
    void restart() override;

    const Stepper &stepper() const { return m_player.recording().stepper(m_player.segment()); } ///< of the last step

    // ---- seeking ----

    /// Requests a seek, done as soon as everything before the position is checked.
    void seek(uint64_t position, uint64_t number);
    void stepBack();
    bool isSeeking() const { return m_sought.has_value(); }
    void goToSought(); ///< does part of the seek, so that commands are handled in between
    /// Seeks synchronously, however long it takes.
    virtual void goTo(uint64_t position);
    /// The live ball takes over here: later steps that are shown become invalid.
    virtual void forgetFuture() {}

    // ---- checking ----

    bool isChecked() const { return m_player.isChecked(); }
    void checkAhead(); ///< checks part of it while no step is due

protected:
    /// A position is shown in slices of this length, between which commands are handled.
    static constexpr std::chrono::milliseconds kShowSlice{20};

    /// Does part of showing this position, before which everything is checked; true when done.
    virtual bool showAt(uint64_t position);
    const QByteArray &leaderId() const {
        return m_player.recording().segment(m_player.segment()).conditions.stepper.id;
    }

    Presentation &m_presentation;
    const LiveRun &m_live;
    Player m_player;

private:
    struct Seek {
        uint64_t position, number;
    };
    std::optional<uint64_t> differenceAt() const;
    void noteStep();
    void tellDifference();

    uint64_t m_number;
    std::optional<Seek> m_sought{};
    uint64_t m_seeks = 0; ///< number of the last one done
    bool m_hasToldDifference = false;
};

} // namespace inspector
