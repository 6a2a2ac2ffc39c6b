// SPDX-License-Identifier: GPL-3.0-or-later
#include "unattended_run.h"

#include "csv_writer.h"

#include <QFile>

namespace inspector {

namespace {
constexpr int kLookInterval = 20; // ms
} // namespace

UnattendedRun::UnattendedRun(Session &session, const Options &options, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_options(options) {
    connect(&session, &Session::failed, this, &UnattendedRun::finish);
    connect(&session.simulation(), &Simulation::leftMaze, this, [this] { finish({}); });
    connect(&m_timer, &QTimer::timeout, this, &UnattendedRun::look);
}

bool UnattendedRun::isWanted(const Options &options) {
    return options.duration.has_value() || !options.csv.isEmpty() || !options.grab.isEmpty();
}

void UnattendedRun::start() {
    m_session.game().confirm();
    if (m_options.duration) m_timer.start(kLookInterval);
}

void UnattendedRun::look() {
    if (m_session.simulation().latest().current.time >= *m_options.duration) finish({});
}

void UnattendedRun::finish(QString error) {
    if (m_isFinished) return;
    m_isFinished = true;
    m_timer.stop();
    m_session.simulation().pause();
    if (error.isEmpty() && !m_options.csv.isEmpty()) error = writeTable();
    emit finished(error);
}

QString UnattendedRun::writeTable() const {
    QFile file(m_options.csv);
    if (file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        CsvWriter writer(file, m_options);
        const SampleRing &samples = m_session.simulation().samples();
        Sample sample;
        for (uint64_t number = samples.first(); number < samples.last(); ++number)
            if (samples.read(number, sample)) writer.write(sample);
        if (writer.isGood() && file.flush()) return {};
    }
    return tr("--csv: can't write '%1': %2").arg(m_options.csv, file.errorString());
}

} // namespace inspector
