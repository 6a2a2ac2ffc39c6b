// SPDX-License-Identifier: MIT
// Any bytes as a recording: its content is within the promised ranges and the same when written and read again, or
// there is one line with the reason.
#include "core/engine/engine.h"
#include "core/recording/recording.h"
#include "input.h"

#include <cmath>

namespace {

using namespace inspector;

// What code that replays it relies on.
void check(const Segment &segment) {
    const Conditions &conditions = segment.conditions;
    fuzz::demand(phys_params_check(&conditions.inputs.params, nullptr) == PHYS_OK);
    fuzz::demand(conditions.dt >= Engine::kSmallestDt && conditions.dt <= Engine::kLargestDt);
    fuzz::demand(!conditions.maze.path.isEmpty() && segment.mazeLine > 1 && segment.stepperLine > 1);
    fuzz::demand(!segment.hashes.empty() || !segment.failure.isEmpty());
    if (segment.from) fuzz::demand(std::isfinite(segment.from->time));
}

// As the recorder would have written it.
QByteArray textOf(const Recording &recording, const Registry &registry) {
    QByteArray text = recordingHead();
    const Conditions *before = nullptr;
    for (const Segment &segment : recording.segments) {
        phys_stepper_info info;
        const QByteArray &id = segment.conditions.stepper.id;
        fuzz::demand(phys_registry_find(registry.get(), id.constData(), &info, nullptr) == PHYS_OK);
        text += conditionsText(before, segment.conditions, info);
        if (segment.from) text += stateText(*segment.from);
        for (const uint64_t hash : segment.hashes)
            text += QByteArray::number(qulonglong(hash), 16).rightJustified(16, '0') + '\n';
        if (!segment.failure.isEmpty()) text += failureText(segment.failure);
        before = &segment.conditions;
    }
    return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const Registry registry = makeRegistry(nullptr);
    const QByteArray bytes(reinterpret_cast<const char *>(data), qsizetype(size));
    QString error;
    const std::optional<Recording> recording = parseRecording(bytes, registry, &error);
    if (!recording) {
        fuzz::demand(!error.isEmpty() && !error.contains('\n') && error.contains(": "));
        return 0;
    }
    for (const Segment &segment : recording->segments) check(segment);
    const QByteArray text = textOf(*recording, registry);
    const std::optional<Recording> again = parseRecording(text, registry, &error);
    fuzz::demand(again && textOf(*again, registry) == text);
    return 0;
}
