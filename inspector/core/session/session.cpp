// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/session.h"

#include "core/pilot/autopilot.h"
#include "core/recording/recording.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <algorithm>

namespace inspector {

namespace {

const QString kModel = QStringLiteral("model"); // the row's id

// What a maze is, is its file's bytes: another one of the same number has another best time.
QStringList mazesOf(const std::vector<Level> &levels) {
    QStringList mazes;
    for (const Level &level : levels)
        mazes +=
            QString::fromLatin1(hashText(hashOf(readFile(level.path, kLargestMaze, nullptr).value_or(QByteArray()))));
    return mazes.isEmpty() ? QStringList{QStringLiteral("none")} : mazes;
}

} // namespace

std::unique_ptr<Session> Session::open(const Options &options, QSettings &settings, QString *error) {
    const Scene scene = loadScene(options.level.path, error);
    if (!scene) return nullptr;
    const Stepper stepper = makeStepper(options.registry, options.stepper, scene, error);
    if (!stepper) return nullptr;

    std::unique_ptr<Session> session(new Session(options, settings, scene, stepper));
    phys_stepper_info info;
    if (phys_registry_find(options.registry.get(), options.stepper.constData(), &info, nullptr) == PHYS_OK)
        session->m_parameters.setStepper(info);
    if (!session->m_parameters.set(options.settings, error)) return nullptr;
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
    return session;
}

Session::Session(const Options &options, QSettings &settings, const Scene &scene, const Stepper &stepper)
    : m_settings(settings)
    , m_registry(options.registry)
    , m_levels(options.levels)
    , m_level(options.level)
    , m_scene(scene)
    , m_stepperId(options.stepper)
    , m_dt(options.dt)
    , m_speed(options.speed)
    , m_game(mazesOf(options.levels), settings)
    , m_simulation(std::make_unique<Simulation>(scene, stepper, origin()))
    , m_comparison(std::make_unique<Comparison>(*this)) {
    connect(&m_parameters, &Parameters::changed, this, &Session::sendInputs);
    connect(m_simulation.get(), &Simulation::failed, this, &Session::failed);
    connect(m_simulation.get(), &Simulation::recordingFailed, this, [this](const QString &line) {
        showRecording(false);
        emit recordingFailed(line);
    });
    connect(m_simulation.get(), &Simulation::leftMaze, this,
            [this](double time) { m_game.leaveMaze(time, m_hasAutopilot || m_isTakenOver || levelIndex() < 0); });
    connect(m_simulation.get(), &Simulation::differenceFound, this, &Session::noteDifference);
    connect(m_simulation.get(), &Simulation::differenceReached, this, [this](uint64_t replay) {
        if (m_replay && m_replay->number == replay) emit replayDiffers(m_replay->difference);
    });
    connect(&m_game, &Game::started, this, [this] {
        m_isTakenOver = false;
        m_simulation->restart();
        m_simulation->run();
    });
    connect(&m_game, &Game::levelWanted, this, [this](int level) {
        if (size_t(level) < m_levels.size()) openLevel(m_levels[size_t(level)]);
    });
}

int Session::levelIndex() const {
    const auto isOpen = [this](const Level &level) { return level.path == m_level.path; };
    const auto found = std::find_if(m_levels.begin(), m_levels.end(), isOpen);
    return found == m_levels.end() ? -1 : int(found - m_levels.begin());
}

// A file that isn't in the list keeps the game's place in the list.
void Session::showPrompt() {
    const int index = levelIndex();
    m_game.prompt(index < 0 ? m_game.level() : index);
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
    const Stepper stepper = makeStepper(m_registry, id, scene, &error);
    if (!stepper) return report(error);
    if (m_replay) leaveReplay();
    m_isTakenOver = false;
    m_scene = scene;
    m_level = level;
    m_simulation->setScene(scene, stepper, origin());
    levelBoard();
    if (m_hasAutopilot && !fly(&error)) {
        m_hasAutopilot = false;
        emit autopilotChanged(false);
        report(error);
    }
    emit levelOpened();
    showPrompt();
    return true;
}

bool Session::setStepper(const QByteArray &id) {
    if (m_replay) return refuseInReplay();
    QString error;
    phys_stepper_info info;
    phys_error failure;
    if (phys_registry_find(m_registry.get(), id.constData(), &info, &failure) != PHYS_OK)
        return report(QString::fromUtf8(failure.text));
    const Stepper stepper = makeStepper(m_registry, id, m_scene, &error);
    if (!stepper) return report(error);
    m_stepperId = id;
    m_parameters.setStepper(info);
    m_simulation->setStepper(stepper, m_parameters.inputs(), origin());
    emit stepperChanged();
    return true;
}

bool Session::setDt(double dt) {
    if (m_replay) return refuseInReplay();
    if (!(dt >= Engine::kSmallestDt && dt <= Engine::kLargestDt))
        return report(tr("dt: expected %1 to %2 s, found %3").arg(Engine::kSmallestDt).arg(Engine::kLargestDt).arg(dt));
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
    if (stepping == before) return true;
    if ((stepping.stepper == m_stepperId || setStepper(stepping.stepper)) && setDt(stepping.dt)) {
        std::vector<Setting> settings = m_parameters.initialOfStepper();
        settings.insert(settings.end(), stepping.settings.begin(), stepping.settings.end()); // the last counts
        QString error;
        if (m_parameters.set(settings, &error)) return true;
        report(error);
    }
    setStepping(before); // which was possible
    return false;
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
    const std::shared_ptr<const Autopilot> pilot = Autopilot::create(m_scene.get(), error);
    if (!pilot) return false;
    m_hasAutopilot = true;
    m_simulation->setPilot(pilot);
    return true;
}

bool Session::setAutopilot(bool isOn) {
    if (m_replay) return refuseInReplay();
    if (isOn == m_hasAutopilot) return true;
    QString error;
    if (isOn && !fly(&error)) return report(error);
    if (!isOn) {
        m_hasAutopilot = false;
        m_simulation->setPilot(nullptr);
        levelBoard();
    }
    emit autopilotChanged(isOn);
    return true;
}

// Also forgets keys that are still held: a new level starts level.
void Session::levelBoard() {
    m_tiltControl = {};
    m_keysTilt = false;
    setTilt({});
}

void Session::setTilt(Tilt tilt) {
    m_parameters.set({{QStringLiteral("tilt_x"), degrees(tilt.x)}, {QStringLiteral("tilt_y"), degrees(tilt.y)}});
}

void Session::advanceKeys(double seconds) {
    if (m_hasAutopilot || m_replay) return;
    if (!m_keysTilt) {
        if (!m_tiltControl.keys().any()) return;
        m_keysTilt = true;
        m_tiltControl.setTilt(m_parameters.inputs().tilt); // from where sliders left the board
    }
    setTilt(m_tiltControl.advance(seconds));
    m_keysTilt = !m_tiltControl.isAtRest();
}

void Session::startRecording(const QString &file) {
    const bool isRead = isSameFile(file, m_level.path) || (m_replay && isSameFile(file, recording().recording().file));
    if (isRead) {
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

Origin Session::origin() const { return originOf(m_registry, m_stepperId, m_level.path); }

// What a replay shows isn't the live ball's.
void Session::sendInputs() {
    if (!m_replay) m_simulation->setInputs(m_parameters.inputs());
}

} // namespace inspector
