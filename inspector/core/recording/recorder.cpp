// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/recorder.h"

#include "core/recording/same_bits.h"

namespace inspector {

namespace {

/// The most that a recording loses in a crash.
constexpr std::chrono::milliseconds kFlushPeriod{100};
constexpr qsizetype kFlushSize = 65536; ///< bytes

} // namespace

Origin originOf(const Registry &registry, const QByteArray &stepper, const QString &maze) {
    Origin origin{{maze, 0}, {}, registry};
    phys_registry_find(registry.get(), stepper.constData(), &origin.stepper, nullptr);
    if (const auto bytes = readFile(maze, kLargestMaze, nullptr)) origin.maze.hash = hashOf(*bytes);
    return origin;
}

Recorder::Recorder(const QString &path) {
    QString reason;
    m_file = OutputFile::open(path, Existing::Replace, {}, &reason);
    if (!m_file) fail(reason);
    put(recordingHead());
    flush();
}

Recorder::~Recorder() { close(); }

void Recorder::note(const Engine &engine) {
    if (!isGood()) return;
    putNews(engine, engine.previous());
    m_state = engine.state();
    put(stepText(*m_state));
    if (isFlushDue()) flush();
}

void Recorder::noteFailure(const Engine &engine, const QString &line) {
    if (!isGood()) return;
    putNews(engine, engine.state());
    put(failureText(line));
    flush();
}

void Recorder::setOrigin(const Origin &origin) {
    m_origin = origin;
    m_originIsNew = true;
}

bool Recorder::hasNewConditions(const Engine &engine) const {
    if (m_originIsNew || !m_conditions || m_conditions->dt != engine.dt()) return true;
    return !isSameBits(m_conditions->inputs, engine.inputs());
}

void Recorder::putConditions(const Engine &engine) {
    const StepperSource stepper{m_origin.stepper.id, m_origin.stepper.version};
    const Conditions now{m_origin.maze, stepper, engine.dt(), engine.inputs()};
    const bool isNewLevel = !m_conditions || !(m_conditions->maze == now.maze);
    put(conditionsText(m_conditions ? &*m_conditions : nullptr, now, m_origin.stepper));
    m_conditions = now;
    m_originIsNew = false;
    if (isNewLevel) m_state.reset();
}

/// Writes what changed with the step that began at this state.
void Recorder::putNews(const Engine &engine, const phys_state &from) {
    if (hasNewConditions(engine)) putConditions(engine);
    if (!m_state || !isSameBits(*m_state, from)) put(stateText(from));
    m_state = from;
}

void Recorder::put(const QByteArray &text) {
    if (isGood()) m_waiting += text;
}

bool Recorder::isFlushDue() const {
    return m_waiting.size() >= kFlushSize || std::chrono::steady_clock::now() - m_flushed >= kFlushPeriod;
}

void Recorder::flush() {
    if (isGood() && (m_file->write(m_waiting) != m_waiting.size() || !m_file->flush())) fail(m_file->problem());
    m_waiting.clear();
    m_flushed = std::chrono::steady_clock::now();
}

void Recorder::close() {
    if (!m_file) return;
    put(recordingEnd());
    flush();
    if (!m_file->finish() && isGood()) fail(m_file->problem());
    m_file.reset();
}

void Recorder::fail(const QString &reason) { m_error = QStringLiteral("can't record into ") + reason; }

} // namespace inspector
