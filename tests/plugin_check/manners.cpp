// SPDX-License-Identifier: MIT
// The resources besides time that a stepper takes from its host: memory and stack.
#include "trial.h"

#include <malloc.h>
#include <pthread.h>

namespace plugin_check {

namespace {

/// Bytes allocated by the process.
size_t allocated() { return mallinfo2().uordblks; }

void live(const Subject &subject, int steps) {
    Run run(subject, board(modelOf(subject)));
    for (int i = 0; i < steps; ++i) run.step(0.001);
}

size_t growthOf(const Subject &subject, int lives, int steps) {
    const size_t before = allocated();
    for (int i = 0; i < lives; ++i) live(subject, steps);
    const size_t after = allocated();
    return after > before ? after - before : 0;
}

} // namespace

Measure memory(const Subject &subject) {
    constexpr int kTimes = 1000;
    live(subject, 1); // for one-time allocations
    const size_t byStepping = growthOf(subject, 1, kTimes);
    if (byStepping > kTimes) return {true, format("keeps %g bytes a step", static_cast<double>(byStepping) / kTimes)};
    const size_t byLiving = growthOf(subject, kTimes, 1);
    if (byLiving > kTimes) return {true, format("keeps %g bytes a stepper", static_cast<double>(byLiving) / kTimes)};
    return {false, "all given back"};
}

/// The stack that physics.h promises to be enough; a stack overflow ends the process.
Measure smallStack(const Subject &subject) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, size_t{128} * 1024);
    pthread_t thread{};
    const auto work = [](void *context) -> void * {
        live(*static_cast<const Subject *>(context), 10);
        return nullptr;
    };
    Subject copy = subject;
    if (pthread_create(&thread, &attributes, work, &copy)) return {true, "no thread"};
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    return {false, "128 kB are enough"};
}

} // namespace plugin_check
