// SPDX-License-Identifier: MIT
// Rolls balls through random mazes under random tilts with every stepper and both models until the given number of
// steps is done, and checks the invariants of each step. Usage: soak STEPS [FIRST_SEED [PLUGIN_FILE]]      for
// instance: soak 1e6
// With a plugin: its steppers instead of the built-in ones.
// Prints a line for each stepper and model; exits with 1 if an invariant failed, or if a stepper refused steps too
// often.
#include "trial.h"

#include "support/handles.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr uint64_t kStepsATrial = 20000;

/// Share of the trials that may end with a step that the stepper refuses.
constexpr double kMostDeclined = 0.05;

struct Sum {
    soak::Plan plan;
    uint64_t trials = 0;
    uint64_t failed = 0;
    uint64_t declined = 0;
    soak::Outcome all{};
};

/// One for each stepper and each model that it supports. firstStepper: in the registry.
std::vector<Sum> combinations(const phys_registry *registry, uint32_t firstStepper) {
    std::vector<Sum> sums;
    phys_stepper_info info;
    for (uint32_t i = firstStepper; phys_registry_info(registry, i, &info) == PHYS_OK; ++i) {
        for (const uint32_t model : {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID}) {
            sums.push_back({{registry, 0, info.id, model, kStepsATrial}});
        }
    }
    return sums;
}

/// NULL, with a line on stderr, if the plugin is refused.
support::RegistryPtr registryWith(const char *plugin) {
    phys_registry *created = nullptr;
    phys_error error{};
    phys_status status = phys_registry_create(&created, &error);
    support::RegistryPtr registry(created);
    if (!status && plugin) status = phys_registry_load_file(created, plugin, &error);
    if (!status) return registry;
    std::fprintf(stderr, "soak: %s\n", error.text);
    return nullptr;
}

void add(Sum &sum, const soak::Outcome &outcome) {
    ++sum.trials;
    sum.all.steps += outcome.steps;
    sum.all.impacts += outcome.impacts;
    sum.all.hash = sum.all.hash * 31 + outcome.hash;
    sum.all.deepest = std::max(sum.all.deepest, outcome.deepest);
    sum.all.mostGained = std::max(sum.all.mostGained, outcome.mostGained);
    if (!outcome.declined.empty()) {
        ++sum.declined;
        sum.all.declined = outcome.declined;
    }
    sum.all.fastest = std::max(sum.all.fastest, outcome.fastest);
    if (outcome.problem.empty()) return;
    ++sum.failed;
    std::printf("FAIL %s: %s\n", soak::describe(sum.plan).c_str(), outcome.problem.c_str());
}

void print(const Sum &sum) {
    const auto number = [](uint64_t value) { return static_cast<unsigned long long>(value); };
    std::printf("%-8s %-17s trials %6llu (%llu declined)  steps %11llu  events %9llu  fastest %5.2f m/s  "
                "deepest %7.2g m  gain %7.2g J/kg  hash %016llx\n",
                sum.plan.model == PHYS_MODEL_RIGID ? "rigid" : "rolling", sum.plan.stepper.c_str(), number(sum.trials),
                number(sum.declined), number(sum.all.steps), number(sum.all.impacts), sum.all.fastest, sum.all.deepest,
                sum.all.mostGained, number(sum.all.hash));
}

bool declinesTooOften(const Sum &sum) {
    if (static_cast<double>(sum.declined) <= kMostDeclined * static_cast<double>(sum.trials)) return false;
    std::printf("FAIL %s: declined %llu of %llu trials, the last with: %s\n", soak::describe(sum.plan).c_str(),
                static_cast<unsigned long long>(sum.declined), static_cast<unsigned long long>(sum.trials),
                sum.all.declined.c_str());
    return true;
}

} // namespace

int main(int argc, char **argv) {
    const double wanted = argc > 1 ? std::strtod(argv[1], nullptr) : 0.0;
    if (argc > 4 || !(wanted >= 1.0)) {
        std::fprintf(stderr, "usage: %s STEPS [FIRST_SEED [PLUGIN_FILE]]\n", argv[0]);
        return 2;
    }
    uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    const char *plugin = argc > 3 ? argv[3] : nullptr;
    const support::RegistryPtr registry = registryWith(plugin);
    if (!registry) return 2;
    std::vector<Sum> sums = combinations(registry.get(), plugin ? phys_registry_count(nullptr) : 0);
    double done = 0.0;
    for (; done < wanted; ++seed) {
        for (Sum &sum : sums) {
            sum.plan.seed = seed;
            const soak::Outcome outcome = soak::run(sum.plan);
            done += static_cast<double>(std::max<uint64_t>(outcome.steps, 1));
            add(sum, outcome);
        }
    }
    uint64_t failed = 0;
    for (const Sum &sum : sums) {
        print(sum);
        failed += sum.failed;
    }
    bool isPassed = failed == 0;
    for (const Sum &sum : sums) isPassed = !declinesTooOften(sum) && isPassed;
    std::printf("%s: %.0f steps, %llu trials failed\n", isPassed ? "PASS" : "FAIL", done,
                static_cast<unsigned long long>(failed));
    return isPassed ? 0 : 1;
}
