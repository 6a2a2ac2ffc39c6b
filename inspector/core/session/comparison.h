// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/engine/ghost_engine.h"
#include "core/setup/parameters.h"

#include <QObject>

namespace inspector {

class Session;

// Whether the session's ball is compared, and with what: another stepper, a finer step, other parameters. Makes the
// ghost's stepper for each level and lets the simulation lead it.
class Comparison : public QObject {
    Q_OBJECT

public:
    // session: owns the comparison.
    explicit Comparison(Session &session);

    bool isOn() const { return m_isOn; }
    const GhostChoice &ghostChoice() const { return m_ghostChoice; }
    // While it is on, one line that says why there is no ghost; empty if there was no refusal since the last meeting.
    QString refusal() const { return m_refusal; }

    void start(const GhostChoice &ghostChoice); // switches it on; both balls meet
    void setOn(bool isOn);
    void setGhostChoice(const GhostChoice &ghostChoice); // both meet if it is on
    void meetAgain();                                    // also tries again after a refusal

    // The second ball's own parameters, with the rows of its stepper; but the tilt is the ball's. They count while it
    // has own ones, are the ball's when it gets them first, and are kept meanwhile.
    Parameters &parameters() { return m_parameters; }
    bool hasOwnParameters() const { return m_hasOwn; }
    void setOwnParameters(bool isOn); // on: switches the comparison on, too

signals:
    void changed(); // on, choice, own parameters or refusal
    void refused(const QString &line);

private:
    void begin();
    void refuse(const QString &line);
    void takeRows();
    std::optional<Inputs> ownInputs() const;
    void forgetRefusal();

    Session &m_session;
    GhostChoice m_ghostChoice;
    bool m_isOn = false;
    QString m_refusal;
    Parameters m_parameters;
    QByteArray m_rowsOf; // id of the stepper
    bool m_hasOwn = false;
    bool m_hasValues = false; // was given the ball's
    uint64_t m_ghost = 0;     // its number; 0: none could be made
};

} // namespace inspector
