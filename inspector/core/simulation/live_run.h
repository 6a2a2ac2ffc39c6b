// SPDX-License-Identifier: GPL-3.0-or-later
// The ball that a person plays with: steps as it is told, kept in memory, and recorded into a file if asked for.
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

    // ---- what its next steps are made with ----

    void obey(const GivenInputs &given);
    void setScene(const Scene &scene, const Stepper &stepper, const Origin &origin);
    void setStepper(const Stepper &stepper, const Origin &origin);
    void setState(const phys_state &state);
    void setStart(const std::optional<phys_state> &start) { m_engine.setStart(start); }
    void setDt(double dt) { m_engine.setDt(dt); }
    void setPilot(std::shared_ptr<const Pilot> pilot) { m_engine.setPilot(std::move(pilot)); }
    void setOrigin(const Origin &origin);
    void pauseAt(double time) { m_pauseAt = time; } // s

    // Shown again, in the place of another run.
    void begin();
    // Goes on from the last step of another run: all that it had, so that the next one is what that one's would be.
    // Inputs that were given after `number`, but came before, stay.
    void goOnFrom(const Engine &from, const Stepper &stepper, uint64_t number);

    // ---- into a file ----

    void startRecording(const QString &file, const Origin &origin);
    void endRecording();
    void flushRecording(); // it may stay paused for long

    // ---- in memory ----

    const History &history() const { return m_history; }
    uint64_t beginPlace() const { return m_beginPlace; } // where it began; may not be kept any more

private:
    void record(const QString &failure);
    void dropBadRecorder();
    void noteLeaving();

    Presentation &m_presentation;
    Engine m_engine;
    uint32_t m_stepperPlace = kNoStepper;                       // in the registry
    uint64_t m_obeyed = 0;                                      // number of the inputs that count
    double m_leftAt = std::numeric_limits<double>::infinity();  // when the ball left the maze, s
    double m_pauseAt = std::numeric_limits<double>::infinity(); // s
    std::optional<Recorder> m_recorder{};
    History m_history{};
    uint64_t m_beginPlace = 0;
};

} // namespace inspector
