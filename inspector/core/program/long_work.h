// SPDX-License-Identifier: GPL-3.0-or-later
// Work that takes a while, on the command line: how far it is, and what ends it.
#pragma once

#include <QString>
#include <QTextStream>

#include <stop_token>

namespace inspector {

class LongWork {
public:
    // terminal: nullptr shows nothing.
    explicit LongWork(QTextStream *terminal);
    // Erases what it showed.
    ~LongWork();

    // Shows a share of 0..1 and what is at work, in one line; asks for the end after a signal.
    void progressed(double share, const QString &what);
    std::stop_token stop() const { return m_stop.get_token(); }

private:
    QTextStream *m_terminal;
    std::stop_source m_stop;
};

} // namespace inspector
