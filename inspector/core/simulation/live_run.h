// SPDX-License-Identifier: GPL-3.0-or-later
// The ball that the user plays with: stepped live, kept in the history, and recorded into a file on request.
#pragma once

#include "core/recording/history.h"
#include "core/recording/recorder.h"
#include "core/simulation/presentation.h"

#include <limits>
#include <optional>

namespace inspector {

class LiveRun : public Run {
public:
    LiveRun(Presentation &presentation, const Scene &scene, const Stepper &stepper);

    const Engine &engine() const override { return m_engine; }
    uint32_t stepperPlace() const override { return m_stepperPlace; }
    void addTo(Snapshot &snapshot) const override;
    void step(Clock::time_point due) override;
    void stepOnce() override { step(Clock::now()); }
    void restart() override;

    // ---- inputs of the next steps ----

    void obey(const GivenInputs &given);
    void setScene(const Scene &scene, const Stepper &stepper, const Origin &origin);
    void setStepper(const Stepper &stepper, const Origin &origin);
    void setState(const phys_state &state);
    void setStart(const std::optional<phys_state> &start) { m_engine.setStart(start); }
    void setDt(double dt) { m_engine.setDt(dt); }
    void setPilot(std::shared_ptr<const Pilot> pilot) { m_engine.setPilot(std::move(pilot)); }
    void setOrigin(const Origin &origin);
    void pauseAt(double time) { m_pauseAt = time; } ///< s

    /// Called when it is shown again in place of another run.
    void begin();
    /// Continues from the last step of another run with its complete state, so that the next step is the one that the
    /// other run would have made. Inputs given after `number` are kept, even if they arrived earlier. Reports a ball
    /// that has left.
    void goOnFrom(const Engine &from, const Stepper &stepper, uint64_t number);
    /// Continues the last run of the history, which began at this place, from its end.
    void resume(const Engine &end, uint64_t begin);

    // ---- recording ----

    void startRecording(const QString &file, const Origin &origin);
    void endRecording();
    void flushRecording(); ///< the run may stay paused for long

    // ---- history ----

    const History &history() const { return m_history; }
    /// The place where it began, which the history may have dropped.
    uint64_t beginPlace() const { return m_history.beginOfLastRun(); }

private:
    void record(const QString &failure);
    void dropBadRecorder();
    void noteLeaving();

    Presentation &m_presentation;
    Engine m_engine;
    uint32_t m_stepperPlace = kNoStepper;                       ///< in the registry
    uint64_t m_obeyed = 0;                                      ///< number of the inputs in use
    double m_leftAt = std::numeric_limits<double>::infinity();  ///< when the ball left the maze, s
    double m_pauseAt = std::numeric_limits<double>::infinity(); ///< s
    std::optional<Recorder> m_recorder{};
    History m_history{};
};

} // namespace inspector
