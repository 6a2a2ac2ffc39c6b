// SPDX-License-Identifier: GPL-3.0-or-later
// Commands, and the thread that takes them between two steps.
#include "core/simulation/simulation.h"

#include "core/simulation/simulation_worker.h"

#include <algorithm>
#include <future>
#include <optional>
#include <utility>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace inspector {

namespace {

// Linux delays timers by up to 50 us to save energy; a lot for steps of 1 ms.
void askForExactTimers() {
#ifdef __linux__
    prctl(PR_SET_TIMERSLACK, 1000UL); // ns, this thread
#endif
}

} // namespace

Simulation::Simulation(const Scene &scene, const Stepper &stepper, const Origin &origin, QObject *parent)
    : QObject(parent)
    , m_inputs(GivenInputs{initialInputs()})
    , m_snapshots(Snapshot{})
    , m_worker(new Worker{*this, Engine(scene, stepper)}) {
    m_worker->setOrigin(origin);
    m_worker->publish(Clock::now());
    m_thread = std::jthread([this](const std::stop_token &stop) { work(stop); });
}

Simulation::~Simulation() {
    m_thread.request_stop();
    m_thread.join();
}

void Simulation::post(Command command) {
    {
        const std::lock_guard lock(m_mutex);
        m_commands.push_back(std::move(command));
    }
    m_wake.notify_one();
}

void Simulation::run() {
    post([](Worker &worker) {
        // At its end a replay begins again.
        if (worker.player && !worker.past && !worker.sought && worker.player->position() == worker.player->end())
            worker.sought = {0, worker.seeks};
        worker.setRunning(true);
    });
}

void Simulation::pause() {
    post([](Worker &worker) { worker.setRunning(false); });
}

void Simulation::pauseAt(double time) {
    post([time](Worker &worker) { worker.pauseAt = time; });
}

void Simulation::stepOnce() {
    post([](Worker &worker) {
        worker.setRunning(false);
        if (worker.sought)
            ++worker.sought->position;
        else
            worker.step(Clock::now());
    });
}

void Simulation::restart() {
    post([](Worker &worker) {
        if (worker.player) {
            worker.sought = {0, worker.seeks};
            return;
        }
        worker.engine.restart();
        worker.beginRun();
    });
}

void Simulation::setScene(const Scene &scene, const Stepper &stepper, const Origin &origin) {
    post([scene, stepper, origin](Worker &worker) {
        worker.setRunning(false);
        worker.leavePast();
        worker.companion.reset(); // its stepper is of the other scene
        worker.engine.setScene(scene, stepper);
        worker.setOrigin(origin);
        worker.beginRun();
    });
}

void Simulation::setStepper(const Stepper &stepper, const Inputs &inputs, const Origin &origin) {
    post([stepper, origin, given = GivenInputs{inputs, ++m_givenCount}](Worker &worker) {
        worker.setOrigin(origin);
        worker.engine.setStepper(stepper);
        if (worker.companion) worker.companion->setLeaderStepper(origin.stepper.id);
        worker.obey(given);
    });
}

void Simulation::setState(const phys_state &state) {
    post([state](Worker &worker) {
        worker.engine.setState(state);
        worker.beginRun();
    });
}

void Simulation::setStart(const std::optional<phys_state> &start) {
    post([start](Worker &worker) {
        std::optional<phys_state> first = start;
        if (first) {
            first->time = 0.0;
            first->step = 0;
        }
        worker.engine.setStart(first);
    });
}

void Simulation::setDt(double dt) {
    post([dt](Worker &worker) {
        worker.engine.setDt(dt);
        worker.startPacing();
    });
}

void Simulation::setSpeed(double speed) {
    post([speed = std::clamp(speed, kSlowest, kFastest)](Worker &worker) {
        worker.speed = speed;
        worker.startPacing();
    });
}

void Simulation::setPilot(std::shared_ptr<const Pilot> pilot) {
    post([pilot = std::move(pilot)](Worker &worker) { worker.engine.setPilot(pilot); });
}

// Files are opened and closed by the stepping thread too, one after the other.
void Simulation::startRecording(const QString &file, const Origin &origin) {
    post([file, origin](Worker &worker) {
        worker.endRecording();
        worker.recorder.emplace(file);
        worker.recorder->setOrigin(origin);
        worker.dropBadRecorder();
    });
}

void Simulation::stopRecording() {
    post([](Worker &worker) { worker.endRecording(); });
}

uint64_t Simulation::compareWith(const CompanionMeans &means, const QByteArray &leaderId) {
    post([means, leaderId, number = ++m_companionCount](Worker &worker) {
        worker.companion.reset();
        worker.companionNumber = number;
        // A replay may have gone on to another scene; then this is asked for again.
        if (means.scene == worker.shown().scene()) worker.companion.emplace(worker.shown(), means, leaderId);
    });
    return m_companionCount;
}

void Simulation::setCompanionInputs(const std::optional<Inputs> &own) {
    post([own](Worker &worker) {
        if (worker.companion) worker.companion->setOwnInputs(own);
    });
}

void Simulation::endComparison() {
    post([](Worker &worker) { worker.companion.reset(); });
}

uint64_t Simulation::startReplay(std::shared_ptr<const PlayableRecording> recording) {
    post([recording = std::move(recording), number = ++m_replayCount](Worker &worker) {
        worker.setRunning(false);
        worker.player.emplace(recording);
        worker.replay = number;
        worker.sought.reset();
        worker.beginRun();
    });
    return m_replayCount;
}

uint64_t Simulation::seek(uint64_t position) {
    post([position, number = ++m_seekCount](Worker &worker) {
        if (worker.player) worker.sought = {position, number};
    });
    return m_seekCount;
}

void Simulation::stepBack() {
    post([](Worker &worker) {
        if (!worker.player) return;
        worker.setRunning(false);
        const Worker::Seek now = worker.sought.value_or(Worker::Seek{worker.player->position(), worker.seeks});
        worker.sought = {now.position - std::min<uint64_t>(now.position, 1), now.number};
    });
}

void Simulation::endReplay() {
    post([](Worker &worker) {
        worker.setRunning(false);
        worker.player.reset();
        worker.sought.reset();
        worker.beginRun();
    });
}

void Simulation::goOnFrom(uint64_t position, const Origin &origin) {
    post([position, origin, number = ++m_givenCount](Worker &worker) {
        if (!worker.player) return;
        if (worker.past) {
            worker.player->seek(position);
            worker.showPastRun();
        } else if (worker.player->position() != position) {
            worker.companion.reset(); // what it would have to do is long
            while (!worker.showUpTo(position)) {
            }
        }
        worker.goOnLive(number);
        worker.setOrigin(origin);
    });
}

std::optional<Past> Simulation::past(QString *error, uint64_t from, uint64_t to) {
    std::promise<std::optional<Past>> promise;
    post([&](Worker &worker) { promise.set_value(worker.history.past(from, to, error)); });
    return promise.get_future().get();
}

uint64_t Simulation::lookBack(const Past &past) {
    post([past, number = ++m_replayCount](Worker &worker) {
        worker.setRunning(false);
        worker.player.emplace(past.recording, past.keyframes);
        worker.past = past;
        worker.replay = number;
        worker.sought.reset();
        worker.player->seek(past.recording->length());
    });
    return m_replayCount;
}

void Simulation::returnToPresent() {
    post([](Worker &worker) { worker.leavePast(); });
}

void Simulation::setInputs(const Inputs &inputs) {
    m_inputs.publish({inputs, ++m_givenCount});
    // Passing through the lock makes sure that a worker about to wait has seen the inputs or hears the call.
    { const std::lock_guard lock(m_mutex); }
    m_wake.notify_one();
}

Snapshot Simulation::latest() {
    m_snapshots.take();
    return m_snapshots.value();
}

// Waits for work: a command, new inputs, or the next step's deadline. The lock is never held while working. Inputs are
// taken before the commands: whatever was posted before them is then there as well, so that no step is made with the
// old stepper and the values of the new one.
Simulation::Work Simulation::nextWork(const std::stop_token &stop) {
    const bool isDue = m_worker->running && m_worker->pacer.isDue(Clock::now());
    const bool canWait = !isDue && !m_worker->isChecking() && !m_worker->sought;
    const auto hasWork = [this] { return !m_commands.empty() || m_inputs.isFresh(); };
    std::unique_lock lock(m_mutex);
    if (canWait && !m_worker->running)
        m_wake.wait(lock, stop, hasWork);
    else if (canWait)
        m_wake.wait_until(lock, stop, m_worker->pacer.deadline(), hasWork);
    const bool hasInputs = m_inputs.take();
    return {hasInputs, std::exchange(m_commands, {})};
}

void Simulation::work(const std::stop_token &stop) {
    askForExactTimers();
    Worker &worker = *m_worker;
    while (!stop.stop_requested()) {
        const auto [hasInputs, commands] = nextWork(stop);
        if (hasInputs) worker.obey(m_inputs.value());
        for (const Command &command : commands) command(worker);
        if (!worker.sought) worker.releaseSamples(); // it was given up
        if (worker.sought) {
            worker.goToSought();
        } else if (worker.running && worker.pacer.isDue(Clock::now())) {
            const Clock::time_point due = worker.pacer.deadline();
            worker.pacer.advance();
            worker.step(due);
        } else if (hasInputs || !commands.empty()) {
            worker.publish(Clock::now());
        } else if (worker.isChecking()) {
            worker.checkAhead();
        }
        if (!worker.running && worker.recorder) {
            worker.recorder->flush(); // it may stay paused for long
            worker.dropBadRecorder();
        }
    }
}

} // namespace inspector
