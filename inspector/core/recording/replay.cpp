// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/replay.h"

#include "core/setup/tables.h"

namespace inspector {

namespace {

QString text(uint64_t hash) { return QString::fromLatin1(hashText(hash)); }

/// Lists the versions that differ from the recording's; each begins with a separator.
QString otherVersions(const PlayableRecording &playable) {
    const Recording &recording = playable.recording();
    const Registry &registry = playable.registry();
    QStringList others;
    const QString library = QString::fromUtf8(phys_version());
    if (recording.library != library)
        others += QStringLiteral("libphysics was %1, is %2").arg(recording.library, library);
    for (const Segment &segment : recording.segments) {
        const StepperSource &stepper = segment.conditions.stepper;
        phys_stepper_info info;
        if (phys_registry_find(registry.get(), stepper.id.constData(), &info, nullptr) != PHYS_OK) continue;
        const QString version = QString::fromUtf8(info.version);
        const QString was = QString::fromUtf8(stepper.version);
        if (was != version)
            others +=
                QStringLiteral("stepper %1 was version %2, is %3").arg(QString::fromUtf8(stepper.id), was, version);
    }
    others.removeDuplicates();
    return others.isEmpty() ? QString() : QStringLiteral("; ") + others.join(QStringLiteral("; "));
}

} // namespace

Replay::Replay(std::shared_ptr<const PlayableRecording> recording)
    : m_recording(std::move(recording)) {
    if (!m_recording->recording().segments.empty()) enter(0);
}

void Replay::moveTo(const Keyframe &place) {
    m_segment = place.segment;
    m_position = place.position;
    m_isStuck = false;
    takeConditions(m_segment);
    m_engine->setState(place.state, place.sums);
}

bool Replay::step() {
    if (m_isStuck || !prepare()) return false;
    const uint64_t expected = m_recording->segment(m_segment).hashes[m_position - m_recording->begin(m_segment)];
    const phys_state before = m_engine->state();
    QString failure;
    if (!m_engine->step(&failure)) {
        compare(before, text(expected), failure);
        m_isStuck = true;
        return false;
    }
    const uint64_t found = phys_state_hash(&m_engine->state());
    if (found != expected) compare(before, text(expected), text(found));
    ++m_position;
    if (m_position == m_recording->end(m_segment)) failAsRecorded();
    return true;
}

bool Replay::prepare() {
    const size_t count = m_recording->recording().segments.size();
    if (count == 0) return false;
    while (m_position == m_recording->end(m_segment)) {
        if (m_segment + 1 == count) return false;
        enter(m_segment + 1);
    }
    return true;
}

void Replay::enter(size_t segment) {
    const Segment &now = m_recording->segment(segment);
    m_segment = segment;
    takeConditions(segment);
    if (now.from) m_engine->setState(*now.from);
    if (now.hashes.empty()) failAsRecorded();
}

void Replay::takeConditions(size_t segment) {
    const Conditions &now = m_recording->segment(segment).conditions;
    const Scene &scene = m_recording->scene(segment);
    const Stepper &stepper = m_recording->stepper(segment);
    if (!m_engine)
        m_engine = std::make_unique<Engine>(scene, stepper);
    else if (m_engine->scene() != scene)
        m_engine->setScene(scene, stepper);
    else
        m_engine->setStepper(stepper);
    m_engine->setDt(now.dt);
    m_engine->setInputs(now.inputs);
}

/// A step that failed in the recording left the state unchanged, and the run continued from there.
void Replay::failAsRecorded() {
    const QString &expected = m_recording->segment(m_segment).failure;
    if (expected.isEmpty()) return;
    QString failure;
    const phys_state before = m_engine->state();
    const EnergySums sums = m_engine->sums();
    const bool hasStepped = m_engine->step(&failure);
    compare(before, expected, hasStepped ? text(phys_state_hash(&m_engine->state())) : failure);
    if (hasStepped) m_engine->setState(before, sums);
}

void Replay::compare(const phys_state &before, const QString &expected, const QString &found) {
    if (m_difference || expected == found) return;
    m_difference = {m_position + 1, before.step + 1, before.time, expected, found};
}

ReplayOutcome replay(const std::shared_ptr<const PlayableRecording> &recording,
                     const std::function<bool(const Engine &)> &visit) {
    Replay replay(recording);
    while (replay.step() && visit(replay.engine())) {
    }
    return {replay.position(), replay.difference()};
}

std::vector<Setting> settingsOf(const Conditions &conditions, const Registry &registry) {
    const Inputs &inputs = conditions.inputs;
    std::vector<Setting> settings{{QStringLiteral("tilt_x"), degrees(inputs.tilt.x)},
                                  {QStringLiteral("tilt_y"), degrees(inputs.tilt.y)},
                                  {QStringLiteral("gravity"), inputs.gravity}};
    phys_stepper_info info;
    if (phys_registry_find(registry.get(), conditions.stepper.id.constData(), &info, nullptr) != PHYS_OK)
        return settings;
    for (const phys_param_row *row : recordedRows(info))
        settings.push_back({QString::fromUtf8(row->id), phys_param_get(&inputs.params, row)});
    return settings;
}

QString verdict(const PlayableRecording &recording, const ReplayOutcome &outcome) {
    const QString cut =
        recording.recording().isWhole ? QString() : QStringLiteral(" (the recording is cut off after them)");
    if (!outcome.difference) return QStringLiteral("same: %1 steps").arg(outcome.steps) + cut;
    const Difference &difference = *outcome.difference;
    return QStringLiteral("differs: step %1 of the recording, step %2 since the start, from %3 s on: expected %4, "
                          "found %5")
               .arg(difference.number)
               .arg(difference.step)
               .arg(QString::fromUtf8(exactText(difference.time)), difference.expected, difference.found) +
           otherVersions(recording);
}

} // namespace inspector
