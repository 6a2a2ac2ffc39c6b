// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/engine/companion.h"

#include <QObject>

namespace inspector {

class Session;

// Whether the session's ball is compared, and with what. Makes the opponent's stepper for each level and lets the
// simulation lead it.
class Comparison : public QObject {
    Q_OBJECT

public:
    // session: owns the comparison.
    explicit Comparison(Session &session);

    bool isOn() const { return m_isOn; }
    const Opponent &opponent() const { return m_opponent; }
    // While it is on, one line that says why there is no ghost; empty if there was no refusal since the last meeting.
    QString refusal() const { return m_refusal; }

    void start(const Opponent &opponent); // switches it on; both balls meet
    void setOn(bool isOn);
    void setOpponent(const Opponent &opponent); // both meet if it is on
    void meetAgain();                           // also tries again after a refusal

signals:
    void changed(); // on, opponent or refusal
    void refused(const QString &line);

private:
    void begin();
    void refuse(const QString &line);

    Session &m_session;
    Opponent m_opponent;
    bool m_isOn = false;
    QString m_refusal;
};

} // namespace inspector
