// SPDX-License-Identifier: MIT
// Draws scenes and checks steppers in them until the given number of runs (scenes x steppers x models) is done.
// Usage: witness RUNS [--seed N] [--stepper ID]... [--model rolling|rigid] [--kind KIND] [--plugin FILE] [--known FILE]
//                     [--cases FOLDER] [--list FILE] [--seconds S] [--only invariants|law] [--threads N]
//        witness --replay FILE [--stepper ID] [--plugin FILE]      judges the cases of a file
// SIGINT and SIGTERM end it after the seeds that are begun, with the table of all that are done.
// Exits with 1 if anything was wrong that isn't in the list of known faults.
#include "draw.h"
#include "survey.h"

#include "support/handles.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace {

using namespace witness;

std::atomic<bool> isInterrupted = false;

struct Arguments {
    double runs = 0;
    std::string replay, plugin, known, cases, list, model, kind, only;
    std::vector<std::string> steppers;
    uint64_t seed = 1;
    double seconds = 1e9;
    unsigned threads = 1;
};

Arguments parse(int argc, char **argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word.rfind("--", 0) != 0) {
            arguments.runs = std::strtod(word.c_str(), nullptr);
            continue;
        }
        if (i + 1 == argc) throw std::runtime_error(word + ": expected a value");
        const std::string value = argv[++i];
        if (word == "--replay")
            arguments.replay = value;
        else if (word == "--plugin")
            arguments.plugin = value;
        else if (word == "--known")
            arguments.known = value;
        else if (word == "--cases")
            arguments.cases = value;
        else if (word == "--list")
            arguments.list = value;
        else if (word == "--stepper")
            arguments.steppers.push_back(value);
        else if (word == "--model")
            arguments.model = value;
        else if (word == "--kind")
            arguments.kind = value;
        else if (word == "--only")
            arguments.only = value;
        else if (word == "--seed")
            arguments.seed = std::strtoull(value.c_str(), nullptr, 10);
        else if (word == "--seconds")
            arguments.seconds = std::strtod(value.c_str(), nullptr);
        else if (word == "--threads")
            arguments.threads = static_cast<unsigned>(std::strtoul(value.c_str(), nullptr, 10));
        else
            throw std::runtime_error(word + ": unknown option");
    }
    if (!(arguments.runs >= 1) && arguments.replay.empty()) throw std::runtime_error("expected RUNS or --replay FILE");
    return arguments;
}

support::RegistryPtr registryWith(const std::string &plugin) {
    phys_registry *created = nullptr;
    phys_error error{};
    phys_status status = phys_registry_create(&created, &error);
    support::RegistryPtr registry(created);
    if (!status && !plugin.empty()) status = phys_registry_load_file(created, plugin.c_str(), &error);
    if (status) throw std::runtime_error(error.text);
    return registry;
}

int replay(const Arguments &arguments, const phys_registry *registry, const std::vector<std::string> &steppers) {
    int wrong = 0;
    for (const Case &scene : readCases(arguments.replay)) {
        for (const std::string &stepper : steppers) {
            const Verdict verdict = judge(registry, stepper, scene);
            wrong += !verdict.check.empty();
            std::printf("%s %s: %s %s%s\n", scene.name.c_str(), stepper.c_str(),
                        verdict.check.empty() ? phys_status_name(verdict.status) : verdict.check.c_str(),
                        verdict.what.c_str(), verdict.statusText.c_str());
        }
    }
    return wrong ? 1 : 0;
}

int run(int argc, char **argv) {
    const Arguments arguments = parse(argc, argv);
    const support::RegistryPtr registry = registryWith(arguments.plugin);
    Plan plan;
    plan.registry = registry.get();
    plan.steppers = stepperIds(registry.get(), arguments.plugin.empty() ? 0 : phys_registry_count(nullptr));
    if (!arguments.steppers.empty()) plan.steppers = arguments.steppers;
    if (!arguments.replay.empty()) return replay(arguments, registry.get(), plan.steppers);
    if (!arguments.model.empty()) plan.models = {arguments.model == "rigid" ? 1U : 0U};
    for (size_t i = 0; i < kinds().size(); ++i) {
        if (arguments.kind.empty() || arguments.kind == kinds()[i]) plan.kinds.push_back(i);
    }
    if (plan.kinds.empty()) throw std::runtime_error(arguments.kind + ": unknown kind");
    plan.firstSeed = arguments.seed;
    plan.runs = static_cast<uint64_t>(arguments.runs);
    plan.seconds = arguments.seconds;
    plan.stops = &isInterrupted;
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { isInterrupted = true; });
    plan.threads = arguments.threads;
    plan.withInvariants = arguments.only != "law";
    plan.withLaw = arguments.only != "invariants";
    plan.caseFolder = arguments.cases;
    plan.listFile = arguments.list;
    if (!arguments.known.empty()) plan.known = KnownFaults(arguments.known);
    const Survey result = survey(plan);
    print(stdout, result);
    return result.wrong ? 1 : 0;
}

} // namespace

int main(int argc, char **argv) {
    try {
        return run(argc, argv);
    } catch (const std::runtime_error &error) {
        std::fprintf(stderr, "witness: %s\n", error.what());
        return 2;
    }
}
