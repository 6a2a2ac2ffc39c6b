// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/program/long_work.h"

#include "core/program/ending.h"
#include "core/setup/lines.h"

#include <cmath>

namespace inspector {

namespace {

constexpr char kClearLine[] = "\r\x1b[K"; ///< return and erase the line (ECMA-48)

/// Fits into 80 columns: a wrapped line couldn't be overwritten.
QString progressLine(double share, const QString &what) {
    constexpr int kBar = 30;
    constexpr int kText = 38;
    const int full = int(std::lround(share * kBar));
    const QString bar = QString(full, QLatin1Char('#')) + QString(kBar - full, QLatin1Char('.'));
    const QString percent = QString::number(int(share * 100.0)).rightJustified(3);
    return QStringLiteral("[%1] %2 %  %3").arg(bar, percent, oneLine(what).left(kText));
}

} // namespace

LongWork::LongWork(QTextStream *terminal, const QString &what)
    : m_terminal(terminal) {
    progressed(0.0, what);
}

LongWork::~LongWork() {
    if (m_terminal) *m_terminal << kClearLine << Qt::flush;
}

void LongWork::progressed(double share, const QString &what) {
    if (endingSignal()) m_stop.request_stop();
    if (m_terminal) *m_terminal << kClearLine << progressLine(share, what) << Qt::flush;
}

} // namespace inspector
