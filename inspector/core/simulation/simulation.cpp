// SPDX-License-Identifier: GPL-3.0-or-later
// Commands, and the thread that executes them between two steps.
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

/// Linux delays timers by up to 50 us to save energy, which is too much for steps of 1 ms.
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
    , m_worker(new Worker(*this, scene, stepper)) {
    m_worker->live.setOrigin(origin);
    m_worker->presentation.publish(Clock::now());
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
        worker.shown().prepareToGoOn();
        worker.presentation.setRunning(true);
    });
}

void Simulation::pause() {
    post([](Worker &worker) { worker.presentation.setRunning(false); });
}

void Simulation::pauseAt(double time) {
    post([time](Worker &worker) { worker.live.pauseAt(time); });
}

void Simulation::stepOnce() {
    post([](Worker &worker) {
        worker.presentation.setRunning(false);
        worker.shown().stepOnce();
    });
}

void Simulation::restart() {
    post([](Worker &worker) { worker.shown().restart(); });
}

void Simulation::setScene(const Scene &scene, const Stepper &stepper, const Origin &origin) {
    post([scene, stepper, origin](Worker &worker) {
        worker.presentation.setRunning(false);
        worker.leavePast();
        worker.presentation.endComparison(); // its stepper is of the other scene
        worker.live.setScene(scene, stepper, origin);
    });
}

void Simulation::setStepper(const Stepper &stepper, const Inputs &inputs, const Origin &origin) {
    post([stepper, origin, given = GivenInputs{inputs, ++m_givenCount}](Worker &worker) {
        worker.live.setStepper(stepper, origin);
        if (GhostEngine *ghost = worker.presentation.ghost()) ghost->setLeaderStepper(origin.stepper.id);
        worker.live.obey(given);
    });
}

void Simulation::setTrack(std::shared_ptr<const ShownTrack> track, std::vector<Scene> scenes) {
    post([track = std::move(track), scenes = std::move(scenes)](Worker &worker) {
        worker.presentation.setTrack(track, scenes);
    });
}

void Simulation::setState(const phys_state &state) {
    post([state](Worker &worker) { worker.live.setState(state); });
}

void Simulation::resume(const HistoryPlace &run, const phys_state &state) {
    post([run, state](Worker &worker) {
        if (!worker.resume(run)) worker.live.setState(state);
    });
}

void Simulation::setStart(const std::optional<phys_state> &start) {
    post([start](Worker &worker) {
        std::optional<phys_state> first = start;
        if (first) {
            first->time = 0.0;
            first->step = 0;
        }
        worker.live.setStart(first);
    });
}

void Simulation::setDt(double dt) {
    post([dt](Worker &worker) {
        worker.live.setDt(dt);
        worker.presentation.startPacing();
    });
}

void Simulation::setSpeed(double speed) {
    post([speed = std::clamp(speed, kSlowest, kFastest)](Worker &worker) { worker.presentation.setSpeed(speed); });
}

void Simulation::setPilot(std::shared_ptr<const Pilot> pilot) {
    post([pilot = std::move(pilot)](Worker &worker) { worker.live.setPilot(pilot); });
}

/// The stepping thread also opens and closes files, in the order of the commands.
void Simulation::startRecording(const QString &file, const Origin &origin) {
    post([file, origin](Worker &worker) { worker.live.startRecording(file, origin); });
}

void Simulation::stopRecording() {
    post([](Worker &worker) { worker.live.endRecording(); });
}

uint64_t Simulation::compareWith(const GhostSetup &setup, const QByteArray &leaderId) {
    post([setup, leaderId, number = ++m_ghostCount](Worker &worker) {
        worker.presentation.compare(number, setup, leaderId);
    });
    return m_ghostCount;
}

uint64_t Simulation::setGhostInputs(const std::optional<Inputs> &own) {
    post([own, number = ++m_ghostCount](Worker &worker) { worker.presentation.setGhostInputs(number, own); });
    return m_ghostCount;
}

void Simulation::endComparison() {
    post([](Worker &worker) { worker.presentation.endComparison(); });
}

uint64_t Simulation::startReplay(std::shared_ptr<const PlayableRecording> recording) {
    post([recording = std::move(recording), number = ++m_replayCount](Worker &worker) {
        worker.startReplay(recording, number);
    });
    return m_replayCount;
}

uint64_t Simulation::seek(uint64_t position) {
    post([position, number = ++m_seekCount](Worker &worker) {
        if (worker.replay) worker.replay->seek(position, number);
    });
    return m_seekCount;
}

void Simulation::stepBack() {
    post([](Worker &worker) {
        if (!worker.replay) return;
        worker.presentation.setRunning(false);
        worker.replay->stepBack();
    });
}

void Simulation::endReplay() {
    post([](Worker &worker) {
        worker.showLive();
        worker.live.begin();
    });
}

void Simulation::goOnFrom(uint64_t position, const Origin &origin) {
    post([position, origin, number = ++m_givenCount](Worker &worker) {
        if (!worker.replay) return;
        worker.replay->goTo(position);
        worker.goOnLive(number);
        worker.live.setOrigin(origin);
    });
}

std::optional<Past> Simulation::past(QString *error, uint64_t from, uint64_t to) {
    std::promise<std::optional<Past>> promise;
    post([&](Worker &worker) { promise.set_value(worker.live.history().past(from, to, error)); });
    return promise.get_future().get();
}

uint64_t Simulation::lookBack(const Past &past) {
    post([past, number = ++m_replayCount](Worker &worker) { worker.lookBack(past, number); });
    return m_replayCount;
}

void Simulation::returnToPresent() {
    post([](Worker &worker) { worker.leavePast(); });
}

void Simulation::setInputs(const Inputs &inputs) {
    m_inputs.publish({inputs, ++m_givenCount});
    // Taking the lock ensures that a worker about to wait either has seen the inputs or will receive the notification.
    { const std::lock_guard lock(m_mutex); }
    m_wake.notify_one();
}

Snapshot Simulation::latest() {
    m_snapshots.take();
    return m_snapshots.value();
}

/// Waits for work: a command, new inputs, or the next step's deadline. The lock is never held while working. Inputs are
/// taken before commands: whatever was posted before the commands is then there as well, so that no step combines the
/// old stepper with the new one's values.
Simulation::Work Simulation::nextWork(const std::stop_token &stop) {
    const bool isRunning = m_worker->presentation.isRunning();
    const bool canWait = !m_worker->presentation.isDue() && !m_worker->isSeeking() && !m_worker->isChecking();
    const auto hasWork = [this] { return !m_commands.empty() || m_inputs.isFresh(); };
    std::unique_lock lock(m_mutex);
    if (canWait && !isRunning)
        m_wake.wait(lock, stop, hasWork);
    else if (canWait)
        m_wake.wait_until(lock, stop, m_worker->presentation.deadline(), hasWork);
    const bool hasInputs = m_inputs.take();
    return {hasInputs, std::exchange(m_commands, {})};
}

void Simulation::work(const std::stop_token &stop) {
    askForExactTimers();
    Worker &worker = *m_worker;
    Presentation &presentation = worker.presentation;
    while (!stop.stop_requested()) {
        const auto [hasInputs, commands] = nextWork(stop);
        if (hasInputs) worker.live.obey(m_inputs.value());
        for (const Command &command : commands) command(worker);
        if (!worker.isSeeking()) presentation.release(); // the seek was abandoned
        if (worker.isSeeking()) {
            worker.replay->goToSought();
        } else if (presentation.isDue()) {
            const Clock::time_point due = presentation.deadline();
            presentation.advance();
            worker.shown().step(due);
        } else if (hasInputs || !commands.empty()) {
            presentation.publish(Clock::now());
        } else if (worker.isChecking()) {
            worker.replay->checkAhead();
        }
        if (!presentation.isRunning()) worker.live.flushRecording();
    }
}

} // namespace inspector
