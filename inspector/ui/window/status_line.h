// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <physics/physics.h>

#include <QStatusBar>

#include <vector>

class QLabel;

namespace inspector {
struct Snapshot;
}

namespace inspector::ui {

/// The simulation's status, in fields made from a table.
class StatusLine : public QStatusBar {
    Q_OBJECT

public:
    explicit StatusLine(QWidget *parent = nullptr);

    /// scene: of the moment shown.
    void showSnapshot(Snapshot snapshot, const phys_scene *scene);
    /// Until the next snapshot, hides values that vary from run to run.
    void leaveOutClock();

private:
    std::vector<QLabel *> m_fields; ///< in table order
};

} // namespace inspector::ui
