// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/engine/ghost_engine.h"
#include "core/setup/parameters.h"

#include <QObject>

#include <vector>

namespace inspector {

class Session;

/// The session's comparison: whether it is on, and with what (another stepper, finer steps, other parameters). Makes
/// the ghost's stepper for each level and passes it to the simulation.
class Comparison : public QObject {
    Q_OBJECT

public:
    /// session: the owner of this object.
    explicit Comparison(Session &session);

    bool isOn() const { return m_isOn; }
    const GhostChoice &ghostChoice() const { return m_ghostChoice; }
    /// While the comparison is on: why there is no ghost, in one line; empty if the ghost wasn't refused since it last
    /// started.
    QString refusal() const { return m_refusal; }

    void start(const GhostChoice &ghostChoice); ///< switches it on; the ghost starts at the ball
    void setOn(bool isOn);
    void setGhostChoice(const GhostChoice &ghostChoice); ///< restarts the ghost if it is on
    void meetAgain();                                    ///< restarts the ghost, also after a refusal

    /// How a ghost was made.
    struct Made {
        uint64_t number; ///< as in samples and snapshots
        uint64_t met;    ///< number of the ghost that last started at the ball; later ones have other parameters
        GhostChoice ghostChoice;
        std::vector<Setting> own; ///< its own parameters; empty: the ball's
    };
    /// Null if there was no such ghost, or no sample of it is kept any more.
    const Made *made(uint64_t ghost) const;

    /// The ghost's own parameters, including its stepper's rows; the tilt is always the ball's. They are copied from
    /// the ball when first used, have an effect only while own parameters are on, and are kept otherwise.
    Parameters &parameters() { return m_parameters; }
    bool hasOwnParameters() const { return m_hasOwn; }
    void setOwnParameters(bool isOn); ///< switching it on also switches the comparison on

signals:
    void changed(); ///< any of: on, choice, own parameters, refusal
    void refused(const QString &line);

private:
    void begin();
    void beginInScene();
    void beginIfWaiting();
    void refuse(const QString &line);
    void takeRows();
    std::optional<Inputs> ownInputs() const;
    void passOwnInputs();
    void note(uint64_t ghost);
    void forgetUnseen();
    void forgetRefusal();

    static constexpr size_t kFewMade = 256; ///< are kept without a look whether samples name them

    Session &m_session;
    GhostChoice m_ghostChoice;
    bool m_isOn = false;
    QString m_refusal;
    Parameters m_parameters;
    QByteArray m_rowsOf; ///< id of the stepper whose rows are in use
    bool m_hasOwn = false;
    bool m_hasValues = false; ///< was initialised from the ball
    uint64_t m_ghost = 0;     ///< number of the ghost; 0: none could be made
    uint64_t m_met = 0;       ///< as in Made
    bool m_isWaiting = false; ///< for the present, to begin
    Scene m_scene;            ///< that it last began in
    std::vector<Made> m_made; ///< ascending
    size_t m_mostMade = kFewMade;
};

} // namespace inspector
