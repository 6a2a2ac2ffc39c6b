// SPDX-License-Identifier: MIT
// The report card of a plugin's steppers. Usage: physics-check FILE.so [--stepper ID]
// Each part runs in a process of its own, so that a crash or an endless loop becomes one line of the card. Exits with 1
// if anything is wrong, with 2 if the plugin can't be loaded.
#include "card.h"
#include "contract.h"
#include "isolation.h"

#include "support/handles.h"
#include "witness/survey.h"

#include <cstdio>
#include <cstring>
#include <string>

namespace {

using namespace plugin_check;

phys_status load(const char *file, support::RegistryPtr &registry, phys_error &error) {
    phys_registry *created = nullptr;
    phys_status status = phys_registry_create(&created, &error);
    registry.reset(created);
    if (!status) status = phys_registry_load_file(created, file, &error);
    return status;
}

bool say(const char *name, const Measure &measure) {
    std::puts(lineOf(name, measure).c_str());
    std::fflush(stdout);
    return !measure.isWrong;
}

Measure contract(const std::string &file, const std::string &stepper) {
    Measure measure{false, "keeps to plugin.h"};
    for (const std::string &breach : breaches(file, stepper)) {
        measure.text = (measure.isWrong ? measure.text + "; " : "") + breach;
        measure.isWrong = true;
    }
    return measure;
}

bool card(const std::string &file, const Subject &subject) {
    std::printf("stepper %s\n", subject.id.c_str());
    const Isolation isolation;
    bool isFine = say("contract", isolation.run([&] { return contract(file, subject.id); }));
    for (const Part &part : parts())
        isFine = say(part.name, isolation.run([&] { return part.measure(subject); })) && isFine;
    return isFine;
}

} // namespace

int main(int argc, char **argv) {
    const bool hasStepper = argc == 4 && std::strcmp(argv[2], "--stepper") == 0;
    if (argc != 2 && !hasStepper) {
        std::fprintf(stderr, "usage: %s FILE.so [--stepper ID]\n", argv[0]);
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
    bool isFine = true;
    for (const std::string &id : witness::stepperIds(registry.get(), phys_registry_count(nullptr))) {
        if (!hasStepper || id == argv[3]) isFine = card(argv[1], {registry.get(), id}) && isFine;
    }
    return isFine ? 0 : 1;
}
