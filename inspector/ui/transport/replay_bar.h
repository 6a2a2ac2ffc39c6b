// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QFrame>

class QAction;
class QLabel;
class QToolButton;

namespace inspector::ui {

class SeekSlider;

// Under the view while a recording is watched: where it is, whether it is the same so far, and ways to go elsewhere.
class ReplayBar : public QFrame {
    Q_OBJECT

public:
    // playback: the window's actions, shown first; endings: shown last. session: outlives the bar.
    ReplayBar(Session &session, const QList<QAction *> &playback, const QList<QAction *> &endings,
              QWidget *parent = nullptr);

    // Another recording.
    void reset();
    // Called about 30 times a second.
    void refresh(const Snapshot &now);

private:
    void showPlace(const ReplayPlace &place, const Snapshot &now);
    void showVerdict(const ReplayPlace &place, const Snapshot &now);
    void goToDifference();

    Session &m_session;
    SeekSlider *m_slider;
    QLabel *m_place;
    QLabel *m_verdict;
    QToolButton *m_toDifference;
};

} // namespace inspector::ui
