// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStatusBar>

#include <vector>

class QLabel;

namespace inspector {
struct Snapshot;
}

namespace inspector::ui {

// What the simulation says of itself, in fields made from a table.
class StatusLine : public QStatusBar {
    Q_OBJECT

public:
    explicit StatusLine(QWidget *parent = nullptr);

    void showSnapshot(const Snapshot &snapshot);
    // Until the next snapshot: what differs from run to run isn't shown.
    void leaveOutClock();

private:
    std::vector<QLabel *> m_fields; // in the order of the table
};

} // namespace inspector::ui
