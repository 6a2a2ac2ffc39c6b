// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector without its window: what is open, joined together. Whoever shows it holds nothing of it.
#pragma once

#include "comparison.h"
#include "game.h"
#include "handles.h"
#include "levels.h"
#include "options.h"
#include "parameters.h"
#include "simulation.h"
#include "tilt_control.h"

#include <QObject>
#include <QSettings>

#include <memory>
#include <vector>

namespace inspector {

// How steps are made.
struct Stepping {
    QByteArray stepper;             // id
    double dt = Engine::kDefaultDt; // s
    std::vector<Setting> settings;  // the model, which stays if left out; the stepper's own, initial if left out
    bool operator==(const Stepping &) const = default;
};

class Session : public QObject {
    Q_OBJECT

public:
    // Opens what the options ask for. Null and one line in `error` if something isn't there or isn't allowed.
    // settings: best times and the window's; outlives the session.
    static std::unique_ptr<Session> open(const Options &options, QSettings &settings, QString *error);

    Parameters &parameters() { return m_parameters; }
    Simulation &simulation() { return *m_simulation; }
    Game &game() { return m_game; }
    Comparison &comparison() { return *m_comparison; }
    QSettings &settings() { return m_settings; }
    const std::vector<Level> &levels() const { return m_levels; }
    const Level &level() const { return m_level; } // that is open; maybe a file that isn't in the list
    const Scene &scene() const { return m_scene; } // of that level
    const Registry &registry() const { return m_registry; }
    QByteArray stepperId() const { return m_stepperId; }
    double dt() const { return m_dt; }
    Stepping stepping() const; // with all its settings
    double speed() const { return m_speed; }
    bool hasAutopilot() const { return m_hasAutopilot; }

    // Each returns false, changes nothing and sends failed() with one line if it can't be done.
    bool openLevel(const Level &level); // paused at its start; a level of the list also becomes the game's
    bool setStepper(const QByteArray &id);
    bool setDt(double dt); // s, Engine::kSmallestDt .. kLargestDt
    bool setStepping(const Stepping &stepping);
    bool setSpeed(double speed);
    bool setAutopilot(bool isOn); // it flies from the present state on; off: the board goes level

    // Records from the next step on, until it is stopped, can't be written or the session ends.
    void startRecording(const QString &file);
    void stopRecording();
    bool isRecording() const { return m_isRecording; }

    // Keys of the game: arrow keys as held, and the time since the last call (about 60 times a second). While a key is
    // held, and until the board is level again, the tilt parameters follow the keys.
    void setKeys(TiltKeys keys) { m_tiltControl.setKeys(keys); }
    void advanceKeys(double seconds);
    bool isTiltedByKeys() const { return m_keysTilt; }

signals:
    void levelOpened();
    void stepperChanged();
    void paceChanged(); // dt or speed
    void autopilotChanged(bool isOn);
    void failed(const QString &line);          // also the simulation's
    void recordingFailed(const QString &line); // and ended; the simulation goes on
    void recordingChanged(bool isOn);

private:
    Session(const Options &options, QSettings &settings, const Scene &scene, const Stepper &stepper);

    int levelIndex() const; // in the list; -1 for a file that isn't in it
    void showPrompt();
    bool report(const QString &line); // sends it; always false
    bool fly(QString *error);
    void levelBoard();
    void setTilt(Tilt tilt);
    void sendInputs();
    void showRecording(bool isOn);
    Origin origin() const;

    QSettings &m_settings;
    Registry m_registry;
    std::vector<Level> m_levels;
    Level m_level;
    Scene m_scene;
    QByteArray m_stepperId;
    double m_dt = Engine::kDefaultDt;
    double m_speed = 1.0;
    bool m_hasAutopilot = false;
    bool m_isRecording = false;
    TiltControl m_tiltControl;
    bool m_keysTilt = false; // the board's tilt is the keys' just now
    Parameters m_parameters;
    Game m_game;
    std::unique_ptr<Simulation> m_simulation;
    std::unique_ptr<Comparison> m_comparison;
};

} // namespace inspector
