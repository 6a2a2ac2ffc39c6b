// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QFrame>

class QAction;
class QToolButton;

namespace inspector::ui {

class AlarmText;
class ElidedLabel;
class SeekSlider;

/// Below the view: navigation, and the position of the moment shown in its run or in the recording. For a recording it
/// also shows whether the replay is the same so far.
class TimeBar : public QFrame {
    Q_OBJECT

public:
    /// playback: the window's actions, shown first; endings: shown last, while they are enabled. session must outlive
    /// the bar.
    TimeBar(Session &session, const QList<QAction *> &playback, const QList<QAction *> &endings,
            QWidget *parent = nullptr);

    /// Another recording was opened, or none.
    void reset();
    /// Called about 30 times a second.
    void refresh(const Snapshot &now);

private:
    void goTo(int notch);
    void showRun(const Snapshot &now);
    void showTrack(const Snapshot &now);
    void showPlace(const ReplayPlace &place, const Snapshot &now);
    void showVerdict(const ReplayPlace &place, const Snapshot &now);
    void goToDifference();

    Session &m_session;
    SeekSlider *m_slider;
    ElidedLabel *m_place;
    ElidedLabel *m_verdict;
    AlarmText *m_alarm; ///< the verdict's
    ElidedLabel *m_recording;
    QToolButton *m_toDifference;
};

} // namespace inspector::ui
