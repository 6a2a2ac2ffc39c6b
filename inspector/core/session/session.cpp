// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include "core/pilot/autopilot.h"
#include "core/recording/recording.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <algorithm>
#include <utility>

namespace inspector {

namespace {

const QString kModel = QStringLiteral("model"); ///< the row's id

} // namespace

std::unique_ptr<Session> Session::open(const Options &options, QSettings &settings, QString *error) {
    const Scene scene = loadScene(options.level.path, error);
    if (!scene) return nullptr;
    const Stepper stepper = makeStepper(options.registry, options.stepper, scene, error);
    if (!stepper) return nullptr;

    std::unique_ptr<Session> session(new Session(options, settings, scene, stepper));
    if (!setParameters(options, session->m_parameters, error)) return nullptr;
    if (options.autopilot && !session->fly(error)) return nullptr;
    session->m_simulation->setDt(options.dt);
    session->m_simulation->setSpeed(options.speed);
    session->sendInputs();
    if (!options.record.isEmpty()) session->startRecording(options.record);
    if (options.comparison) session->comparison().start(*options.comparison);
    session->showPrompt();
    if (!options.replay.isEmpty() && !session->startReplay(options.replay, error)) {
        if (error) error->prepend(QStringLiteral("--replay: "));
        return nullptr;
    }
    if (options.comparisonSettings.empty()) return session;
    session->comparison().setOwnParameters(true); // the other values are the ball's, also of a recorded ball
    if (!session->comparison().parameters().set(options.comparisonSettings, error)) return nullptr;
    return session;
}

Session::Session(const Options &options, QSettings &settings, const Scene &scene, const Stepper &stepper)
    : m_settings(settings)
    , m_registry(options.registry, options.pluginLoader)
    , m_levels(options.levels, options.level, scene)
    , m_stepperId(options.stepper)
    , m_dt(options.dt)
    , m_speed(options.speed)
    , m_tilt(m_parameters)
    , m_game(m_levels.mazes(), settings)
    , m_simulation(std::make_unique<Simulation>(scene, stepper, origin()))
    , m_comparison(std::make_unique<Comparison>(*this))
    , m_lookAhead(options.registry)
    , m_liveUncertainty(options.registry) {
    connect(&m_parameters, &Parameters::changed, this, &Session::sendInputs);
    connect(this, &Session::levelOpened, this, &Session::layTrackOver);
    connect(m_simulation.get(), &Simulation::recordingFailed, this, [this](const QString &line) {
        showRecording(false);
        emit recordingFailed(line);
    });
    connect(m_simulation.get(), &Simulation::leftMaze, this, &Session::endGame);
    connect(&m_parameters, &Parameters::changed, this, &Session::watchPhysics);
    connect(this, &Session::stepperChanged, this, &Session::watchPhysics);
    connect(this, &Session::paceChanged, this, &Session::watchPhysics);
    connect(m_simulation.get(), &Simulation::differenceFound, this, &Session::noteDifference);
    connect(m_simulation.get(), &Simulation::differenceReached, this, [this](uint64_t replay) {
        if (m_replay && m_replay->playback.number() == replay) emit replayDiffers(m_replay->playback.difference());
    });
    connect(&m_game, &Game::started, this, &Session::startGame);
    connect(&m_game, &Game::againWanted, this, &Session::restart);
    connect(&m_game, &Game::levelWanted, this, [this](int level) {
        if (size_t(level) < levels().listed().size()) openLevel(levels().listed()[size_t(level)]);
    });
}

void Session::startGame() {
    if (m_levels.isMazeOlder() && openLevel(Level(level()))) return m_game.confirm();
    const bool isBallPut = this->isBallPut();
    phys_state begin = m_simulation->latest().current;
    begin.time = 0.0;
    begin.step = 0;
    returnToPresent();
    m_hasUsualPhysics = true;
    watchPhysics();
    isBallPut ? m_start.leave() : m_start.begin();
    endTakenTilt();
    isBallPut ? m_simulation->setState(begin) : m_simulation->restart();
    m_simulation->run();
}

void Session::restart() {
    returnToPresent();
    if (m_levels.isMazeOlder() && openLevel(Level(level()))) return;
    const bool isOver = m_game.phase() == Game::Phase::Won || m_game.phase() == Game::Phase::Lost;
    const bool goesOn = !isOver && m_simulation->latest().running;
    if (isOver) m_simulation->pause(); // the ball may still be falling
    endTakenTilt();
    m_simulation->restart();
    if (!goesOn) m_game.again();
}

void Session::endGame(const Departure &departure) {
    const bool hasBegunOutside = !m_start.isFromElsewhere() && !m_start.fault(scene()).isEmpty();
    if (departure.side == BoardSide::Below || hasBegunOutside) return m_game.lose(departure.time);
    m_game.leaveMaze(departure.time, !whyNoBestTime().isEmpty());
}

void Session::showPrompt() { m_game.prompt(m_levels.index(), m_levels.otherMaze()); }

/// A change of the physics on the way disqualifies a win, even if it is undone later.
void Session::watchPhysics() {
    bool isUsual = m_stepperId == PHYS_STEPPER_DEFAULT && m_dt == Engine::kDefaultDt && m_speed == 1.0;
    for (int i = 0; i < m_parameters.count(); ++i) {
        isUsual = isUsual && (isTilt(m_parameters.row(i)) || m_parameters.isInitial(i));
    }
    m_hasUsualPhysics = m_hasUsualPhysics && isUsual;
}

QString Session::whyNoBestTime() {
    if (m_hasAutopilot) return tr("the autopilot played");
    if (m_start.isFromElsewhere() || m_start.isOwn()) return tr("not from the start");
    if (!m_hasUsualPhysics) return tr("speed or physics changed");
    if (m_levels.exits() && m_levels.exits()->empty()) return tr("this maze has no way out");
    return {};
}

std::optional<Departure> Session::departure(const Snapshot &now) const {
    return inspector::departure(m_simulation->samples(), scene().get(), now.current.time);
}

std::optional<Departure> Session::departure() const {
    const SampleRing &samples = m_simulation->samples();
    Sample last;
    const bool hasAny = samples.last() > samples.first() && samples.read(samples.last() - 1, last);
    return hasAny ? inspector::departure(samples, scene().get(), last.time) : std::nullopt;
}

bool Session::hasEnded(const Snapshot &now) const {
    const std::optional<Departure> left = m_replay || m_past ? std::nullopt : departure(now);
    return left && now.current.time >= left->time + kFallTime;
}

double Session::stopwatch(const Snapshot &now) const {
    const std::optional<Departure> left = departure(now);
    return left ? left->time : now.current.time;
}

bool Session::report(const QString &line) {
    emit failed(line);
    return false;
}

bool Session::refuseInReplay() {
    return report(tr("a recording is shown as it was; Go on from here makes it yours to change"));
}

bool Session::openLevel(const Level &level) {
    QString error;
    const Scene scene = loadScene(level.path, &error);
    if (!scene) return report(error);
    const QByteArray id = m_replay ? m_replay->before.stepper : m_stepperId;
    const Stepper stepper = makeStepper(registry(), id, scene, &error);
    if (!stepper) return report(error);
    if (m_replay) leaveReplay();
    returnToPresent();
    m_start.openLevel();
    m_levels.open(level, scene);
    m_simulation->setScene(scene, stepper, origin());
    m_followsTrack = false; // setScene() ended it
    m_tilt.level();
    const bool isFlown = !m_hasAutopilot || fly(&error);
    if (!isFlown) {
        m_hasAutopilot = false;
        emit autopilotChanged(false);
    }
    emit levelOpened();
    showPrompt();
    if (!isFlown) report(error);
    return true;
}

bool Session::useStepper(const QByteArray &id, QString *error) {
    phys_stepper_info info;
    phys_error failure;
    if (phys_registry_find(registry().get(), id.constData(), &info, &failure) != PHYS_OK) {
        tell(error, failure);
        return false;
    }
    const Stepper stepper = makeStepper(registry(), id, scene(), error);
    if (!stepper) return false;
    m_stepperId = id;
    m_parameters.setStepper(info);
    m_simulation->setStepper(stepper, m_parameters.inputs(), origin());
    emit stepperChanged();
    return true;
}

bool Session::loadPlugin(const QString &file) {
    QString error;
    if (!m_registry.load(file, &error)) return report(error);
    emit steppersAdded();
    return true;
}

bool Session::useDt(double dt, QString *error) {
    if (!(dt >= Engine::kSmallestDt && dt <= Engine::kLargestDt)) {
        *error = tr("dt: expected %1 to %2 s, found %3").arg(Engine::kSmallestDt).arg(Engine::kLargestDt).arg(dt);
        return false;
    }
    m_dt = dt;
    m_simulation->setDt(dt);
    emit paceChanged();
    return true;
}

Stepping Session::stepping() const {
    Stepping now{m_stepperId, m_dt, {}};
    for (int i = 0; i < m_parameters.count(); ++i) {
        const QString id = QString::fromUtf8(m_parameters.row(i).id);
        if (m_parameters.isOfStepper(i) || id == kModel) now.settings.push_back({id, m_parameters.value(i)});
    }
    return now;
}

bool Session::setStepping(const Stepping &stepping) {
    if (m_replay) return refuseInReplay();
    const Stepping before = this->stepping();
    QString error;
    if (stepping != before) takeOver();
    if (stepping == before || useStepping(stepping, &error)) return true;
    useStepping(before, nullptr); // can't fail: it was in use before
    return report(error);
}

bool Session::useStepping(const Stepping &stepping, QString *error) {
    if (stepping.stepper != m_stepperId && !useStepper(stepping.stepper, error)) return false;
    if (!useDt(stepping.dt, error)) return false;
    std::vector<Setting> settings = m_parameters.initialOfStepper();
    settings.insert(settings.end(), stepping.settings.begin(), stepping.settings.end()); // later entries win
    return m_parameters.set(settings, error);
}

bool Session::setSpeed(double speed) {
    if (!(speed >= Simulation::kSlowest && speed <= Simulation::kFastest))
        return report(
            tr("speed: expected %1 to %2, found %3").arg(Simulation::kSlowest).arg(Simulation::kFastest).arg(speed));
    m_speed = speed;
    m_simulation->setSpeed(speed);
    emit paceChanged();
    return true;
}

bool Session::fly(QString *error) {
    const std::shared_ptr<const Autopilot> pilot = Autopilot::create(scene().get(), error);
    if (!pilot) return false;
    m_hasAutopilot = true;
    m_simulation->setPilot(pilot);
    return true;
}

bool Session::setAutopilot(bool isOn) {
    if (m_replay) return refuseInReplay();
    if (isOn == m_hasAutopilot) return true;
    takeOver();
    followTrack(false);
    QString error;
    if (isOn && !fly(&error)) return report(error);
    if (!isOn) {
        m_hasAutopilot = false;
        m_simulation->setPilot(nullptr);
        m_tilt.level();
    }
    emit autopilotChanged(isOn);
    return true;
}

void Session::noticeOlderMaze(const PlayableRecording &recording, size_t segment) {
    m_levels.goOnIn(recording.segment(segment).conditions.maze.hash);
    if (m_levels.isMazeOlder()) emit olderMazeOpened(level().path);
}

/// Levels the board unless its tilt was changed since.
void Session::endTakenTilt() {
    if (m_tilt.endTaken() && !m_replay) m_tilt.set({});
}

void Session::advanceKeys(double seconds) {
    if (m_replay || (m_hasAutopilot && !m_past)) return;
    const TiltKeys keys = m_tilt.keys();
    if (m_past && keys.any()) {
        takeOver();
        setAutopilot(false);
        m_tilt.setKeys(keys);
        m_simulation->run();
    }
    if (m_past) return;
    if (keys.any()) followTrack(false);
    m_tilt.advance(seconds);
}

void Session::placeBall(const phys_state &state) {
    if (m_replay) return;
    const bool isFromPresent = !m_past;
    const Snapshot now = m_simulation->latest();
    watchRuns(now);
    takeOver();
    m_start.place();
    m_simulation->pause(); // first, so that the ball stays there
    phys_state placed = state;
    placed.flags = 0; // of the step before
    m_simulation->setState(placed);
    if (isFromPresent && now.history.end > now.history.run) emit runLeft();
}

void Session::putBallBack(const Snapshot &before) {
    if (m_replay) return;
    takeOver();
    m_simulation->pause();
    const bool isOfLiveRun = before.replay.number == 0;
    isOfLiveRun ? m_simulation->resume(before.history, before.current) : m_simulation->setState(before.current);
    emit ballPutBack();
}

bool Session::isBallPut() const { return !m_replay && !m_past && m_start.isBallPut(m_simulation->latest(), scene()); }

void Session::setStart(const std::optional<phys_state> &start) {
    m_start.set(start);
    m_simulation->setStart(start);
}

void Session::showTrack(std::shared_ptr<const ShownTrack> track) {
    followTrack(false);
    m_track = std::move(track);
    m_trackMaze = level().path;
    layTrackOver();
}

std::shared_ptr<const ShownTrack> Session::track() const { return level().path == m_trackMaze ? m_track : nullptr; }

void Session::layTrackOver() {
    passTrack();
    emit trackChanged();
}

/// Passes the track on with all scenes of its maze in which a step may be made before this object learns of it.
void Session::passTrack() {
    std::vector<Scene> scenes;
    const auto add = [&](const Level &level, const Scene &scene) {
        if (level.path == m_trackMaze && std::ranges::count(scenes, scene) == 0) scenes.push_back(scene);
    };
    const auto addAll = [&](const PlayableRecording &recording) {
        for (size_t i = 0; i < recording.recording().segments.size(); ++i) add(recording.level(i), recording.scene(i));
    };
    add(level(), scene());
    if (m_past) add(m_past->level, m_past->scene);
    if (m_past) addAll(*m_past->past.recording);
    if (m_replay) addAll(m_replay->playback.recording());
    m_simulation->setTrack(m_track, std::move(scenes));
}

bool Session::followTrack(bool isOn) {
    if (isOn == m_followsTrack) return true;
    if (isOn && (m_replay || !track() || !m_track->hasTilts())) return false;
    returnToPresent();
    if (isOn) setAutopilot(false);
    m_followsTrack = isOn;
    setStart(isOn ? std::optional(m_track->start(scene().get())) : std::nullopt);
    m_simulation->setPilot(isOn ? std::make_shared<TrackPilot>(m_track) : nullptr);
    if (isOn) {
        m_start.leave(); // disables the best time
        m_simulation->restart();
        m_simulation->run();
    } else {
        m_tilt.level();
    }
    emit trackChanged();
    return true;
}

QStringList Session::openFiles() const {
    QStringList files{level().path, level().mesh};
    if (!m_replay) return files;
    const PlayableRecording &recording = m_replay->playback.recording();
    files += {recording.recording().file, m_replay->levelBefore.path, m_replay->levelBefore.mesh};
    for (size_t i = 0; i < recording.recording().segments.size(); ++i)
        files += {recording.level(i).path, recording.level(i).mesh};
    files.removeDuplicates();
    return files;
}

void Session::startRecording(const QString &file) {
    const QStringList open = openFiles();
    if (std::any_of(open.begin(), open.end(), [&file](const QString &each) { return isSameFile(file, each); })) {
        emit recordingFailed(tr("can't record into %1: it is open here").arg(quoted(file)));
        return;
    }
    m_simulation->startRecording(file, origin());
    showRecording(true);
}

void Session::stopRecording() {
    m_simulation->stopRecording();
    showRecording(false);
}

void Session::showRecording(bool isOn) {
    m_isRecording = isOn;
    emit recordingChanged(isOn);
}

Origin Session::origin() const {
    Origin origin = originOf(registry(), m_stepperId, level().path);
    origin.maze = m_levels.maze(); // the file may have changed since
    return origin;
}

/// Doesn't send the values of a replay, which aren't the live ball's.
void Session::sendInputs() {
    if (m_replay || (m_past && m_isFollowing)) return;
    takeOver(); // the user changed something
    m_simulation->setInputs(m_parameters.inputs());
}

} // namespace inspector
