// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation.h"

#include "rate_meter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace inspector {

namespace {

// How long the ball goes on falling after it left the maze, s of simulated time.
constexpr double kFallTime = 0.4;

uint32_t stepperOf(const Origin &origin) { return stepperIndex(origin.registry, origin.stepper.id); }

// Linux delays timers by up to 50 us to save energy; a lot for steps of 1 ms.
void askForExactTimers() {
#ifdef __linux__
    prctl(PR_SET_TIMERSLACK, 1000UL); // ns, this thread
#endif
}

} // namespace

struct Simulation::Worker {
    Simulation &owner;
    Engine engine;
    uint32_t stepper; // index in the registry
    Pacer pacer{};
    RateMeter meter{};
    double speed = 1.0;
    bool running = false;
    uint64_t run = 0;
    uint64_t obeyed = 0; // number of the inputs that count
    uint64_t impacts = 0;
    phys_event lastImpact{};
    std::optional<Recorder> recorder{};
    std::optional<Companion> companion{};
    double leftAt = std::numeric_limits<double>::infinity(); // when the ball left the maze, s

    void obey(const GivenInputs &given);
    void startPacing();
    void setRunning(bool isRunning);
    void beginRun();
    void step(Clock::time_point due);
    void record(const QString &failure);
    void dropBadRecorder();
    void endRecording();
    void leadCompanion();
    void noteEvents();
    void noteLeaving();
    void publish(Clock::time_point due);
};

void Simulation::Worker::obey(const GivenInputs &given) {
    if (given.number < obeyed) return;
    obeyed = given.number;
    engine.setInputs(given.inputs);
}

// Rates and deadlines count from now; what was lost in this run stays counted.
void Simulation::Worker::startPacing() {
    const Clock::time_point now = Clock::now();
    pacer.start(now, engine.dt(), speed);
    meter.start(now);
}

void Simulation::Worker::setRunning(bool isRunning) {
    if (running == isRunning) return;
    running = isRunning;
    startPacing();
    emit owner.runningChanged(running);
}

// The state was set from outside: a new history begins.
void Simulation::Worker::beginRun() {
    ++run;
    impacts = 0;
    lastImpact = {};
    leftAt = std::numeric_limits<double>::infinity();
    if (engine.state().flags & PHYS_OUT) leftAt = engine.state().time;
    if (companion) companion->meet(engine);
    pacer.forgetLostTime();
    startPacing();
    owner.m_samples.clear();
    owner.m_events.clear();
}

void Simulation::Worker::step(Clock::time_point due) {
    QString line;
    const bool hasStepped = engine.step(&line);
    record(line);
    if (!hasStepped) {
        setRunning(false);
        publish(due);
        emit owner.failed(line);
        return;
    }
    meter.count(Clock::now(), engine.dt());
    leadCompanion();
    Sample sample = engine.sample();
    if (companion) companion->addTo(sample);
    owner.m_samples.append(sample);
    noteEvents();
    noteLeaving();
    publish(due);
}

// failure: the library's line if the step failed, else empty.
void Simulation::Worker::record(const QString &failure) {
    if (!recorder) return;
    if (failure.isEmpty())
        recorder->note(engine);
    else
        recorder->noteFailure(engine, failure);
    dropBadRecorder();
}

void Simulation::Worker::dropBadRecorder() {
    if (!recorder || recorder->isGood()) return;
    emit owner.recordingFailed(recorder->error());
    recorder.reset();
}

void Simulation::Worker::endRecording() {
    if (!recorder) return;
    recorder->close();
    dropBadRecorder();
    recorder.reset();
}

// Last of all that a step does to the state: nothing of the ball depends on it.
void Simulation::Worker::leadCompanion() {
    QString line;
    if (companion && !companion->follow(engine, &line)) emit owner.comparisonRefused(line);
}

void Simulation::Worker::noteEvents() {
    owner.m_events.note(engine, stepper);
    for (const phys_event &event : engine.events()) {
        if (event.kind != PHYS_EVENT_IMPACT) continue;
        ++impacts;
        lastImpact = event;
    }
}

void Simulation::Worker::noteLeaving() {
    const phys_state &state = engine.state();
    if (!(state.flags & PHYS_OUT)) return;
    if (std::isinf(leftAt)) {
        leftAt = state.time;
        emit owner.leftMaze(leftAt);
    }
    if (state.time >= leftAt + kFallTime) setRunning(false);
}

void Simulation::Worker::publish(Clock::time_point due) {
    Snapshot snapshot;
    snapshot.previous = engine.previous();
    snapshot.current = engine.state();
    snapshot.due = due;
    snapshot.interval = running ? pacer.interval() : Clock::duration::zero();
    snapshot.inputs = engine.inputs();
    snapshot.report = engine.report();
    snapshot.report.events = nullptr;
    snapshot.report.event_capacity = 0;
    snapshot.lastImpact = lastImpact;
    snapshot.dt = engine.dt();
    snapshot.run = run;
    snapshot.running = running;
    if (companion && companion->isThere())
        snapshot.ghost = {companion->previous(), companion->state(), companion->metAt(), companion->deviation()};
    snapshot.statistics = {meter.stepsPerSecond(), speed, meter.speed(), pacer.lostTime(), impacts};
    owner.m_snapshots.publish(snapshot);
}

Simulation::Simulation(const Scene &scene, const Stepper &stepper, const Origin &origin, QObject *parent)
    : QObject(parent)
    , m_inputs(GivenInputs{initialInputs()})
    , m_snapshots(Snapshot{})
    , m_worker(new Worker{*this, Engine(scene, stepper), stepperOf(origin)}) {
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
    post([](Worker &worker) { worker.setRunning(true); });
}

void Simulation::pause() {
    post([](Worker &worker) { worker.setRunning(false); });
}

void Simulation::stepOnce() {
    post([](Worker &worker) {
        worker.setRunning(false);
        worker.step(Clock::now());
    });
}

void Simulation::restart() {
    post([](Worker &worker) {
        worker.engine.restart();
        worker.beginRun();
    });
}

void Simulation::setScene(const Scene &scene, const Stepper &stepper, const Origin &origin) {
    post([scene, stepper, origin](Worker &worker) {
        worker.setRunning(false);
        worker.companion.reset(); // its stepper is of the other scene
        worker.engine.setScene(scene, stepper);
        worker.stepper = stepperOf(origin);
        if (worker.recorder) worker.recorder->setOrigin(origin);
        worker.beginRun();
    });
}

void Simulation::setStepper(const Stepper &stepper, const Inputs &inputs, const Origin &origin) {
    post([stepper, origin, given = GivenInputs{inputs, ++m_givenCount}](Worker &worker) {
        if (worker.recorder) worker.recorder->setOrigin(origin);
        worker.engine.setStepper(stepper);
        if (worker.companion) worker.companion->setLeaderStepper(origin.stepper.id);
        worker.stepper = stepperOf(origin);
        worker.obey(given);
    });
}

void Simulation::setState(const phys_state &state) {
    post([state](Worker &worker) {
        worker.engine.setState(state);
        worker.beginRun();
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

void Simulation::compareWith(const CompanionMeans &means, const QByteArray &leaderId) {
    post([means, leaderId](Worker &worker) { worker.companion.emplace(worker.engine, means, leaderId); });
}

void Simulation::endComparison() {
    post([](Worker &worker) { worker.companion.reset(); });
}

void Simulation::setInputs(const Inputs &inputs) {
    m_inputs.publish({inputs, ++m_givenCount});
    // Passing through the lock makes sure that a worker about to wait has seen the inputs or hears the call.
    { const std::lock_guard lock(m_mutex); }
    m_wake.notify_one();
}

const Snapshot &Simulation::latest() {
    m_snapshots.take();
    return m_snapshots.value();
}

// Waits for work: a command, new inputs, or the next step's deadline. The lock is never held while working. Inputs are
// taken before the commands: whatever was posted before them is then there as well, so that no step is made with the
// old stepper and the values of the new one.
Simulation::Work Simulation::nextWork(const std::stop_token &stop) {
    const bool isDue = m_worker->running && m_worker->pacer.isDue(Clock::now());
    const auto hasWork = [this] { return !m_commands.empty() || m_inputs.isFresh(); };
    std::unique_lock lock(m_mutex);
    if (!m_worker->running)
        m_wake.wait(lock, stop, hasWork);
    else if (!isDue)
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
        if (worker.running && worker.pacer.isDue(Clock::now())) {
            const Clock::time_point due = worker.pacer.deadline();
            worker.pacer.advance();
            worker.step(due);
        } else if (hasInputs || !commands.empty()) {
            worker.publish(Clock::now());
        }
        if (!worker.running && worker.recorder) {
            worker.recorder->flush(); // it may stay paused for long
            worker.dropBadRecorder();
        }
    }
}

} // namespace inspector
