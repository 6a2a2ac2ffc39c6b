// SPDX-License-Identifier: MIT
// The report card of a plugin's steppers.
// Each part runs in a process of its own, so that a crash or an endless loop becomes one line of the card.
#include "card.h"
#include "contract.h"
#include "isolation.h"
#include "trial.h"

#include "support/handles.h"
#include "witness/survey.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

using namespace plugin_check;

phys_status load(const char *file, support::RegistryPtr &registry, phys_error &error) {
    phys_registry *created = nullptr;
    phys_status status = phys_registry_create(&created, &error);
    registry.reset(created);
    if (!status) status = phys_registry_load_file(created, file, &error);
    return status;
}

constexpr char kHelp[] = "usage: physics-check FILE.so [--stepper ID]\n"
                         "The report card of each stepper of a plugin, or of one of them: a line for each question, up "
                         "to a minute for each\n"
                         "stepper.\n"
                         "  ok    as it should be\n"
                         "  FAIL  it isn't\n"
                         "  open  not answered, because the stepper or the machine is too slow\n"
                         "Ends with 0 if all is ok, 1 if something fails, 3 if nothing fails but something is open, 2 "
                         "if the command is wrong\n"
                         "or the plugin can't be loaded.\n";

/// From good to bad: of several results the last one counts.
enum class Mark { Ok, Open, Fail };

Mark say(const char *name, const Measure &measure) {
    std::puts(lineOf(name, measure).c_str());
    std::fflush(stdout);
    return measure.isWrong ? Mark::Fail : measure.isOpen ? Mark::Open : Mark::Ok;
}

Measure contract(const std::string &file, const std::string &stepper) {
    Measure measure{false, "keeps to plugin.h"};
    for (const std::string &breach : breaches(file, stepper)) {
        measure.text = (measure.isWrong ? measure.text + "; " : "") + breach;
        measure.isWrong = true;
    }
    return measure;
}

/// A part that a slow stepper couldn't finish isn't begun.
Measure judge(const Isolation &isolation, const Part &part, const Subject &subject, double stepSeconds) {
    if (part.steps * stepSeconds > part.seconds)
        return {false, format("not begun: some %g steps of %.2g s each", part.steps, stepSeconds), true};
    return isolation.run([&] { return part.measure(subject); }, part.seconds);
}

Mark card(const std::string &file, const Subject &subject) {
    std::printf("stepper %s\n", subject.id.c_str());
    const Isolation isolation;
    const Mark kept = say("contract", isolation.run([&] { return contract(file, subject.id); }, 5));
    const Measure price = isolation.run([&] { return cost(subject); }, 10);
    Mark all = std::max(kept, say("cost", price));
    if (price.isWrong) return all; // it makes no step at all
    const double stepSeconds = 1e-9 * std::atof(price.text.c_str());
    for (const Part &part : parts()) all = std::max(all, say(part.name, judge(isolation, part, subject, stepSeconds)));
    return all;
}

} // namespace

int main(int argc, char **argv) {
    if (argc == 2 && std::strcmp(argv[1], "--help") == 0) return std::fputs(kHelp, stdout) < 0 ? 2 : 0;
    const bool hasStepper = argc == 4 && std::strcmp(argv[2], "--stepper") == 0;
    if (argc != 2 && !hasStepper) {
        std::fputs("usage: physics-check FILE.so [--stepper ID]; --help says more\n", stderr);
        return 2;
    }
    support::RegistryPtr registry;
    phys_error error{};
    // A damaged file ends the process that loads it.
    const Measure trial = Isolation().run([&] {
        load(argv[1], registry, error);
        return Measure{};
    });
    if (trial.isWrong) {
        std::fprintf(stderr, "physics-check: %s: %s\n", argv[1], trial.text.c_str());
        return 2;
    }
    if (load(argv[1], registry, error)) {
        std::fprintf(stderr, "physics-check: %s\n", error.text);
        return 2;
    }
    std::vector<std::string> ids = witness::stepperIds(registry.get(), phys_registry_count(nullptr));
    if (hasStepper) std::erase_if(ids, [&](const std::string &id) { return id != argv[3]; });
    if (ids.empty()) {
        std::fprintf(stderr, "physics-check: %s: no stepper %s\n", argv[1], hasStepper ? argv[3] : "");
        return 2;
    }
    Mark all = Mark::Ok;
    for (const std::string &id : ids) all = std::max(all, card(argv[1], {registry.get(), id}));
    return all == Mark::Fail ? 1 : all == Mark::Open ? 3 : 0;
}
