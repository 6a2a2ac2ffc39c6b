// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include <vector>

class QLabel;

namespace inspector::ui {

/// The subject of a message, which disappears when that is settled.
enum class Cause {
    Command,    ///< a command's message, mostly why it failed: until the next command that succeeds
    Step,       ///< a step failed: until another run begins, or the run continues
    Level,      ///< the open level's files
    Maze,       ///< the open maze's file is gone: until it is there again
    View,       ///< shaders
    Comparison, ///< a stepper that refused the ghost
    Recording,  ///< the file that is written
    Replay,     ///< the recording that is watched
    Settings,   ///< they can't be written: until it is dismissed
};

/// A line across the window that shows a problem until it is closed or settled. It doesn't block.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget *parent = nullptr);

    /// A repeated line is counted instead of added again; a new line replaces one with the same cause.
    void showLine(const QString &line, Cause cause);
    /// The problem no longer exists.
    void settle(Cause cause);
    uint64_t count() const { return m_count; }                                               ///< of messages so far
    QString line() const { return m_messages.empty() ? QString() : m_messages.back().line; } ///< empty while hidden
    void dismiss();

signals:
    void changed(const QString &line);

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Message {
        QString line;
        Cause cause;
        int count;
    };
    void showNewest();
    void takeColours();

    QLabel *m_icon;
    QLabel *m_text;
    uint64_t m_count = 0;
    std::vector<Message> m_messages; ///< oldest first; the newest is shown
};

} // namespace inspector::ui
