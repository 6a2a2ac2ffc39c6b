// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and cancellation of long work on the command line.
#pragma once

#include <QString>
#include <QTextStream>

#include <stop_token>

namespace inspector {

class LongWork {
public:
    /// Shows at once what is done first. terminal: where progress is shown, or nullptr.
    LongWork(QTextStream *terminal, const QString &what);
    /// Erases the progress line.
    ~LongWork();

    /// Shows the share done (0..1) and what is being done, in one line; requests a stop after a signal.
    void progressed(double share, const QString &what);
    std::stop_token stop() const { return m_stop.get_token(); }

private:
    QTextStream *m_terminal;
    std::stop_source m_stop;
};

} // namespace inspector
