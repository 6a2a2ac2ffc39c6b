// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/simulation.h"

#include "core/engine/rate_meter.h"

#include <algorithm>
#include <cmath>
#include <future>
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
// Of a step: 30 steps of 0.01 s are 0.3 s.
constexpr double kRounding = 1e-6;

// Steps before the place sought in a replay that plots and trails get to see.
constexpr uint64_t kStepsBefore = 10000; // the 10 s of a plot at 1 ms
// Steps of an earlier run that plots and trails get to see: a moment's work.
constexpr uint64_t kStepsOfARun = 100000;
// A replay is checked ahead in pieces, between which there is time for steps and commands.
constexpr std::chrono::milliseconds kCheckSlice{1};
constexpr std::chrono::milliseconds kShowSlice{20};
constexpr int kStepsPerLook = 32; // at the clock

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
    uint64_t published = 0;
    uint64_t obeyed = 0; // number of the inputs that count
    uint64_t impacts = 0;
    double stepTime = 0.0; // of the last live one, us
    std::optional<Recorder> recorder{};
    std::optional<Companion> companion{};
    uint64_t companionNumber = 0;
    double leftAt = std::numeric_limits<double>::infinity();  // when the ball left the maze, s
    double pauseAt = std::numeric_limits<double>::infinity(); // s
    // A replay is shown in place of the engine's ball.
    struct Seek {
        uint64_t position, number;
    };
    std::optional<Player> player{};
    uint64_t replay = 0;          // its number
    std::optional<Seek> sought{}; // to be shown as soon as all before it is checked
    uint64_t seeks = 0;           // number of the last one done
    bool areSamplesHeld = false;  // a place sought is being shown
    double pacedDt = 0.0;         // s
    // What was played, kept; a replay may show that in place of a recording.
    History history{};
    std::optional<Past> past{};
    uint64_t liveRun = 0;  // where the live run began, in the history
    uint64_t shownRun = 0; // the one that samples and events are of

    const Engine &shown() const { return player ? player->engine() : engine; }
    bool isChecking() const { return player && !player->isChecked(); }
    void setOrigin(const Origin &origin);
    void obey(const GivenInputs &given);
    void startPacing();
    void setRunning(bool isRunning);
    void beginRun();
    void step(Clock::time_point due);
    void noteStep();
    void replayStep(Clock::time_point due);
    std::optional<uint64_t> differenceAt() const;
    void checkAhead();
    void goToSought();
    bool showUpTo(uint64_t position);
    void holdSamples();
    void releaseSamples();
    ReplayPlace replayPlace() const;
    void goOnLive(uint64_t number);
    uint64_t pastPlace() const { return past->begin + player->position(); }
    void pastStep(Clock::time_point due);
    void showPastRun();
    void refillSamples(uint64_t first);
    void leavePast();
    std::optional<Ghost> pastGhost() const;
    HistoryPlace historyPlace() const;
    void record(const QString &failure);
    void dropBadRecorder();
    void endRecording();
    void leadCompanion();
    void noteEvents();
    void noteLeaving();
    void publish(Clock::time_point due);
};

void Simulation::Worker::setOrigin(const Origin &origin) {
    stepper = stepperOf(origin);
    history.setOrigin(origin);
    if (recorder) recorder->setOrigin(origin);
}

void Simulation::Worker::obey(const GivenInputs &given) {
    if (given.number < obeyed) return;
    obeyed = given.number;
    engine.setInputs(given.inputs);
}

// Rates and deadlines count from now; what was lost in this run stays counted.
void Simulation::Worker::startPacing() {
    const Clock::time_point now = Clock::now();
    pacedDt = shown().dt();
    pacer.start(now, pacedDt, speed);
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
    leftAt = std::numeric_limits<double>::infinity();
    if (shown().state().flags & PHYS_OUT) leftAt = shown().state().time;
    if (companion && companion->scene() != shown().scene()) companion.reset(); // its stepper is of the other
    if (companion) companion->meet(shown());
    if (!player) liveRun = shownRun = history.end();
    pacer.forgetLostTime();
    startPacing();
    owner.m_samples.clear();
    owner.m_events.clear();
    emit owner.runBegan();
}

void Simulation::Worker::step(Clock::time_point due) {
    if (past) return pastStep(due);
    if (player) return replayStep(due);
    QString line;
    const Clock::time_point begin = Clock::now();
    const bool hasStepped = engine.step(&line);
    stepTime = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    if (hasStepped) history.note(engine);
    record(line);
    if (!hasStepped) {
        setRunning(false);
        publish(due);
        emit owner.failed(line);
        return;
    }
    noteStep();
    noteLeaving();
    if (engine.state().time >= pauseAt - kRounding * engine.dt()) setRunning(false);
    publish(due);
}

void Simulation::Worker::noteStep() {
    meter.count(Clock::now(), shown().dt());
    if (shown().previous().flags & PHYS_OUT) return; // out of the maze it only falls
    leadCompanion();
    Sample sample = shown().sample();
    if (companion) companion->addTo(sample);
    if (!player) sample[Channel::StepTime] = stepTime;
    owner.m_samples.append(sample);
    noteEvents();
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
    if (!companion) return;
    if (player) companion->setLeaderStepper(player->recording().stretch(player->stretch()).conditions.stepper.id);
    if (!companion->follow(shown(), &line)) emit owner.comparisonRefused(companionNumber, line);
}

void Simulation::Worker::noteEvents() {
    owner.m_events.note(shown(), player ? player->recording().stepperPlace(player->stretch()) : stepper);
    for (const phys_event &event : shown().events())
        if (event.kind == PHYS_EVENT_IMPACT) ++impacts;
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
    const Engine &now = shown();
    Snapshot snapshot;
    snapshot.previous = now.previous();
    snapshot.current = now.state();
    snapshot.due = due;
    snapshot.interval = running ? pacer.interval() : Clock::duration::zero();
    snapshot.inputs = now.inputs();
    snapshot.report = now.report();
    snapshot.report.events = nullptr;
    snapshot.report.event_capacity = 0;
    snapshot.dt = now.dt();
    snapshot.number = ++published;
    snapshot.run = run;
    snapshot.running = running;
    if (past)
        snapshot.ghost = pastGhost();
    else if (companion && companion->isThere())
        snapshot.ghost = {companion->previous(), companion->state(), companion->metAt(), companion->deviation()};
    snapshot.statistics = {meter.stepsPerSecond(), speed, meter.speed(), pacer.lostTime(), impacts};
    if (player) snapshot.replay = replayPlace();
    snapshot.history = historyPlace();
    owner.m_snapshots.publish(snapshot);
}

ReplayPlace Simulation::Worker::replayPlace() const {
    return {replay,         player->position(), player->end(), player->checked(), player->isChecked(),
            differenceAt(), player->stretch(),  seeks};
}

// Where the first difference shows: after that step, or at the end if the step fails.
std::optional<uint64_t> Simulation::Worker::differenceAt() const {
    if (!player->difference()) return std::nullopt;
    return std::min(player->difference()->number, player->end());
}

// A ball that has left the maze goes on as recorded.
void Simulation::Worker::replayStep(Clock::time_point due) {
    if (player->enterRun()) beginRun();
    if (player->next()) {
        if (shown().dt() != pacedDt) startPacing();
        noteStep();
    }
    const bool isDifferent = differenceAt() == player->position();
    if (isDifferent || player->position() == player->end()) setRunning(false);
    publish(due);
    if (isDifferent) emit owner.differenceReached(replay);
}

// While no step is due.
void Simulation::Worker::checkAhead() {
    const bool wasSame = !player->difference();
    Clock::time_point end = Clock::now() + kCheckSlice;
    if (running) end = std::min(end, pacer.deadline());
    do {
        for (int i = 0; i < kStepsPerLook; ++i) player->check();
    } while (!player->isChecked() && Clock::now() < end);
    if (!running) publish(Clock::now());
    if (wasSame && player->difference()) emit owner.differenceFound(replay, *player->difference());
}

// ---- the past of the live ball ----

HistoryPlace Simulation::Worker::historyPlace() const {
    return {history.begin(), liveRun, history.end(), past ? pastPlace() : history.end()};
}

// To the end of the run that is shown.
void Simulation::Worker::pastStep(Clock::time_point due) {
    const uint64_t end = past->endOfRun(pastPlace());
    if (pastPlace() < end && player->next() && shown().dt() != pacedDt) startPacing();
    meter.count(Clock::now(), shown().dt());
    if (pastPlace() == end) setRunning(false);
    publish(due);
}

// Samples and events of the run that is gone to.
void Simulation::Worker::showPastRun() {
    const uint64_t wanted = past->beginOfRun(pastPlace());
    if (wanted != std::max(shownRun, past->begin)) refillSamples(wanted);
}

// Made again from its beginning to its end; the player is where it was afterwards.
void Simulation::Worker::refillSamples(uint64_t first) {
    const uint64_t place = player->position();
    const uint64_t end = std::min(past->endOfRun(first + 1), first + kStepsOfARun) - past->begin;
    owner.m_samples.hold();
    owner.m_events.hold();
    owner.m_samples.clear();
    owner.m_events.clear();
    player->seek(first - past->begin);
    while (player->position() < end && player->next()) {
        if (shown().previous().flags & PHYS_OUT) continue;
        owner.m_samples.append(shown().sample());
        noteEvents();
    }
    player->seek(place);
    owner.m_samples.release();
    owner.m_events.release();
    shownRun = first;
}

void Simulation::Worker::leavePast() {
    if (!past) return;
    setRunning(false);
    const bool isLiveRun = std::max(shownRun, past->begin) == std::max(liveRun, past->begin);
    if (!isLiveRun && liveRun < history.end()) refillSamples(std::max(liveRun, past->begin));
    if (!isLiveRun && liveRun == history.end()) {
        owner.m_samples.clear();
        owner.m_events.clear();
        shownRun = liveRun;
    }
    past.reset();
    player.reset();
    sought.reset();
    startPacing();
}

// As the samples tell it.
std::optional<Ghost> Simulation::Worker::pastGhost() const {
    Sample sample;
    const double time = shown().state().time;
    const uint64_t number = owner.m_samples.find(time);
    if (!owner.m_samples.read(number, sample) || std::isnan(sample[Channel::GhostX])) return std::nullopt;
    Ghost ghost;
    ghost.current = shown().state();
    ghost.current.position = {sample[Channel::GhostX], sample[Channel::GhostY], sample[Channel::GhostZ]};
    ghost.previous = ghost.current;
    ghost.deviation = {sample[Channel::Distance], sample[Channel::SpeedDifference], sample[Channel::EnergyDifference]};
    return ghost;
}

// Once all before it is checked; commands are obeyed between the pieces of that.
void Simulation::Worker::goToSought() {
    if (sought->position > player->checked() && !player->isChecked()) return checkAhead();
    if (past) {
        player->seek(sought->position);
        showPastRun();
        startPacing();
    } else if (!showUpTo(sought->position)) {
        return;
    }
    seeks = std::exchange(sought, std::nullopt)->number;
    publish(Clock::now());
}

// Plots and trails then show what they do when it is played: what was before it in its run is made again, too. A piece
// of that, because a fine ghost makes it long; true if it is done, or needs no more pieces.
bool Simulation::Worker::showUpTo(uint64_t position) {
    const uint64_t end = std::min(position, player->end());
    const uint64_t start = player->recording().beginOfRun(end);
    const uint64_t begin = std::max(start, end - std::min(end, kStepsBefore));
    const bool goesOn = player->position() > start && player->position() >= begin && player->position() <= end;
    holdSamples();
    if (!goesOn) {
        player->seek(begin);
        player->enterRun();
        beginRun();
    }
    const Clock::time_point until = Clock::now() + kShowSlice;
    while (player->position() < end && player->next()) {
        noteStep();
        if (player->position() < end && Clock::now() >= until) return false;
    }
    startPacing();
    releaseSamples();
    return true;
}

// Readers see what they are of before and after, and nothing between.
void Simulation::Worker::holdSamples() {
    owner.m_samples.hold();
    owner.m_events.hold();
    areSamplesHeld = true;
}

void Simulation::Worker::releaseSamples() {
    if (!std::exchange(areSamplesHeld, false)) return;
    owner.m_samples.release();
    owner.m_events.release();
}

// The engine gets all that the replay's last step had: its next one is what that one's would be. Inputs that were given
// after the command, but came before it, stay. number: of what counts as given by the command.
void Simulation::Worker::goOnLive(uint64_t number) {
    const PlayableRecording &recording = player->recording();
    const Engine &from = player->engine();
    engine.setScene(from.scene(), recording.stepper(player->stretch()));
    engine.setDt(from.dt());
    obey({from.inputs(), number});
    engine.setState(from.state(), from.sums());
    if (past) {
        owner.m_samples.truncate(owner.m_samples.find(std::nextafter(engine.state().time, HUGE_VAL)));
        owner.m_events.forgetAfter(engine.state().time);
    }
    past.reset();
    player.reset();
    liveRun = shownRun = history.end();
    if (companion && companion->scene() != engine.scene()) companion.reset();
    if (companion) companion->meet(engine);
    sought.reset();
    leftAt = engine.state().flags & PHYS_OUT ? engine.state().time : std::numeric_limits<double>::infinity();
    startPacing();
    emit owner.runBegan();
}

Simulation::Simulation(const Scene &scene, const Stepper &stepper, const Origin &origin, QObject *parent)
    : QObject(parent)
    , m_inputs(GivenInputs{initialInputs()})
    , m_snapshots(Snapshot{})
    , m_worker(new Worker{*this, Engine(scene, stepper), stepperOf(origin)}) {
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
