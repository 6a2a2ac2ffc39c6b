// SPDX-License-Identifier: MIT
// Any bytes as a recording: what it says, within the ranges it promises and the same when written and read again, or
// one line that says why not.
#include "core/engine/engine.h"
#include "core/recording/recording.h"
#include "input.h"

#include <cmath>

namespace {

using namespace inspector;

// What whoever replays it relies on.
void check(const Stretch &stretch) {
    const Conditions &conditions = stretch.conditions;
    fuzz::demand(phys_params_check(&conditions.inputs.params, nullptr) == PHYS_OK);
    fuzz::demand(conditions.dt >= Engine::kSmallestDt && conditions.dt <= Engine::kLargestDt);
    fuzz::demand(!conditions.maze.path.isEmpty() && stretch.mazeLine > 1 && stretch.stepperLine > 1);
    fuzz::demand(!stretch.hashes.empty() || !stretch.failure.isEmpty());
    if (stretch.from) fuzz::demand(std::isfinite(stretch.from->time));
}

// As the recorder would have written it.
QByteArray textOf(const Recording &recording, const Registry &registry) {
    QByteArray text = recordingHead();
    const Conditions *before = nullptr;
    for (const Stretch &stretch : recording.stretches) {
        phys_stepper_info info;
        const QByteArray &id = stretch.conditions.stepper.id;
        fuzz::demand(phys_registry_find(registry.get(), id.constData(), &info, nullptr) == PHYS_OK);
        text += conditionsText(before, stretch.conditions, info);
        if (stretch.from) text += stateText(*stretch.from);
        for (const uint64_t hash : stretch.hashes)
            text += QByteArray::number(qulonglong(hash), 16).rightJustified(16, '0') + '\n';
        if (!stretch.failure.isEmpty()) text += failureText(stretch.failure);
        before = &stretch.conditions;
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
    for (const Stretch &stretch : recording->stretches) check(stretch);
    const QByteArray text = textOf(*recording, registry);
    const std::optional<Recording> again = parseRecording(text, registry, &error);
    fuzz::demand(again && textOf(*again, registry) == text);
    return 0;
}
