// SPDX-License-Identifier: MIT
// The report card of a plugin's steppers. Usage: physics-check FILE.so [--stepper ID]
// Each part runs in a process of its own, so that a crash or an endless loop is one line of the card. Ends with 1 if
// anything is wrong, 2 if the plugin can't be loaded.
#include "contract.h"
#include "measures.h"

#include "support/handles.h"
#include "witness/survey.h"

#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace {

using namespace plugin_check;

constexpr unsigned kMostSeconds = 20; // for a part

struct Part {
    const char *name;
    Measure (*measure)(const Subject &);
};
constexpr Part kParts[] = {
    {"smooth motion", smoothMotion},
    {"across impacts", impacts},
    {"invariants", invariants},
    {"the law", law},
    {"energy at rest", energyAtRest},
    {"energy a bounce", energyPerBounce},
    {"tunnelling", tunnelling},
    {"threads", threads},
    {"extremes", extremes},
    {"misuse", misuse},
    {"cost", cost},
};

/// What a part says, from a process of its own.
template<class Work>
Measure isolated(const Work &work) {
    int ends[2];
    if (pipe(ends)) return {true, "no pipe"};
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        alarm(kMostSeconds);
        const Measure measure = work();
        const std::string text = (measure.isWrong ? "1" : "0") + measure.text;
        size_t written = 0;
        while (written < text.size()) {
            const ssize_t count = write(ends[1], text.data() + written, text.size() - written);
            if (count <= 0) break;
            written += static_cast<size_t>(count);
        }
        _exit(0);
    }
    close(ends[1]);
    std::string text;
    char buffer[4096];
    for (ssize_t count; (count = read(ends[0], buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<size_t>(count));
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return {true, signal == SIGALRM ? "not done after " + std::to_string(kMostSeconds) + " s"
                                        : std::string("crashes: ") + strsignal(signal)};
    }
    if (text.empty()) return {true, "ends without a word"};
    return {text[0] == '1', text.substr(1)};
}

phys_status load(const char *file, support::RegistryPtr &registry, phys_error &error) {
    phys_registry *created = nullptr;
    phys_status status = phys_registry_create(&created, &error);
    registry.reset(created);
    if (!status) status = phys_registry_load_file(created, file, &error);
    return status;
}

bool say(const char *name, const Measure &measure) {
    std::printf("%-5s %-16s %s\n", measure.isWrong ? "FAIL" : "ok", name, measure.text.c_str());
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
    bool isFine = say("contract", isolated([&] { return contract(file, subject.id); }));
    for (const Part &part : kParts) isFine = say(part.name, isolated([&] { return part.measure(subject); })) && isFine;
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
    const Measure trial = isolated([&] {
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
