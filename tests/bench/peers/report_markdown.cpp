// SPDX-License-Identifier: MIT
#include "peers/front.h"
#include "peers/report.h"
#include "reference/event_driven.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace bench {

namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.2g", value);
    return value >= 100 ? std::to_string(std::lround(value)) : text;
}

std::string processorName() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown processor";
}

bool isMaze(const SceneGroup &group) { return group.name.starts_with("maze"); }

const Trial *trialAt(const std::vector<Trial> &trials, const std::string &group, const std::string &engine, double dt) {
    for (const Trial &trial : trials)
        if (trial.group == group && trial.engine == engine && trial.dt == dt) return &trial;
    return nullptr;
}

std::string errorCell(const Trial *trial) {
    if (!trial) return "";
    if (!trial->skipped.empty()) return trial->skipped;
    if (!trial->answered()) return "refused";
    if (trial->errors.size() == 1) return number(trial->medianLargest());
    return number(trial->medianLargest()) + " (" + number(trial->worstLargest()) + ")";
}

void writeIntroduction(std::ostream &out) {
    out << "# Cost and error, ours and everyone's\n\n"
           "Made by `tests/bench/peers/run`, all engines in turns in one run, on: "
        << processorName()
        << ", one thread; CPU time, medians.\n\n"
           "Errors are distances to an event-driven reference in long double, in ball radii: the largest one at the "
           "ends of all "
           "tilt periods, median over a group's scenes (worst in brackets). Where nothing rolls everything is "
           "frictionless, so "
           "that the acceleration is the tilt's g in two dimensions as in three.\n";
}

void writeGroup(std::ostream &out, const SceneGroup &group, const std::vector<EngineKind> &engines,
                const std::vector<Trial> &trials) {
    out << "\n## " << group.name << "\n\n"
        << group.question << ".\n\n"
        << "| engine | ns per step at 10 ms | error at 10 ms | at 1 ms | at 0.1 ms |\n|---|---|---|---|---|\n";
    for (const EngineKind &kind : engines) {
        const Trial *ten = trialAt(trials, group.name, kind.name, 0.01);
        out << "| " << kind.name << " | " << (ten && ten->answered() ? number(ten->secondsPerStep * 1e9) : "") << " | "
            << errorCell(ten) << " | " << errorCell(trialAt(trials, group.name, kind.name, 0.001)) << " | "
            << errorCell(trialAt(trials, group.name, kind.name, 0.0001)) << " |\n";
    }
}

std::string cheapestCell(const Trial *trial) {
    if (!trial) return "never";
    return number(trial->secondsPerSimulated * 1e6) + " µs: " + trial->engine + ", " + number(trial->dt * 1e3) + " ms";
}

void writeCheapest(std::ostream &out, const SceneGroup &group, const std::vector<Trial> &trials) {
    out << "\nCheapest CPU time per simulated second that keeps the error in all of its scenes:\n\n"
           "| error under | ours | peers |\n|---|---|---|\n";
    for (const double bound : {1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-6, 1e-9})
        out << "| " << number(bound) << " R | " << cheapestCell(cheapestUnder(trials, group.name, bound, Side::Ours))
            << " | " << cheapestCell(cheapestUnder(trials, group.name, bound, Side::Peers)) << " |\n";
    const auto unbeaten = unbeatenPeers(trials, group.name);
    out << (unbeaten.empty() ? "\nFor every point of every peer ours has one that is both cheaper and more accurate.\n"
                             : "\nPoints of peers that none of ours beats in both cost and error:\n\n");
    for (const Trial *trial : unbeaten)
        out << "- " << trial->engine << ", " << number(trial->dt * 1e3)
            << " ms: " << number(trial->secondsPerSimulated * 1e6) << " µs per simulated second, error "
            << number(trial->medianLargest()) << " R\n";
}

// The side of the thin wall on which the fast ball ended.
void writeHolds(std::ostream &out, const SceneGroup &group, const std::vector<Trial> &trials) {
    out << "\nStopped by the wall, of " << group.scenes.size() << ":\n\n| engine | step, ms | held |\n|---|---|---|\n";
    for (const Trial *trial : trialsOf(trials, group.name)) {
        if (trial->dt != 0.01 && trial->dt != 0.001) continue;
        const auto held = std::count_if(trial->errors.begin(), trial->errors.end(), [](const SceneError &error) {
            return error.failure.empty() && error.last.position.x < 0;
        });
        const auto refused = std::count_if(trial->errors.begin(), trial->errors.end(),
                                           [](const SceneError &error) { return !error.failure.empty(); });
        out << "| " << trial->engine << " | " << number(trial->dt * 1e3) << " | " << held;
        if (refused > 0) out << ", refused " << refused << ": " << trial->errors.front().failure;
        out << " |\n";
    }
}

void writeRest(std::ostream &out, const SceneGroup &group, const std::vector<Trial> &trials) {
    out << "\nSpeed after 10 s at rest, step 10 ms:\n\n| engine | speed, m/s |\n|---|---|\n";
    for (const Trial *trial : trialsOf(trials, group.name))
        if (trial->dt == 0.01 && trial->answered())
            out << "| " << trial->engine << " | " << number(distance(trial->errors.front().last.velocity, {}))
                << " |\n";
}

// Limits of the comparison: the trajectory's own sensitivity, and the reference in another precision.
void writeReference(std::ostream &out, const std::vector<SceneGroup> &groups, const std::vector<Trial> &trials) {
    out << "\n## The reference, checked\n\n"
           "Two programs that share no code and no method: the reference (roots of quadratics and quartics, in long "
           "double) and "
           "our stepper `exact`, called once per tilt. Beside them the reference in plain double, and how much a "
           "change of the "
           "start grows until the end: rounding grows as much. The reference is tested against closed forms in "
           "`reference/tst_event_driven.cpp`.\n\n"
           "| scenes | impacts | growth of a change | double against long double, R | exact against the reference, R "
           "|\n"
           "|---|---|---|---|---|\n";
    for (const SceneGroup &group : groups) {
        if (!isMaze(group)) continue;
        const Trial *exact = trialAt(trials, group.name, "exact", group.scenes.front().tiltPeriod);
        for (std::size_t index = 0; index < group.scenes.size(); ++index) {
            const Scene &scene = group.scenes[index];
            const Passage fine = eventDriven<long double>(scene);
            const Passage coarse = eventDriven<double>(scene);
            double difference = 0;
            for (std::size_t period = 0; period < fine.balls.size(); ++period)
                difference = std::max(difference, distance(fine.balls[period].position, coarse.balls[period].position));
            const std::vector<double> growth = sensitivity(scene);
            out << "| " << scene.name << " | " << fine.impacts << " | "
                << number(*std::max_element(growth.begin(), growth.end())) << " | " << number(difference / scene.radius)
                << " | " << (exact && exact->answered() ? number(exact->errors[index].largest) : "") << " |\n";
        }
    }
}

void writeSettings(std::ostream &out, const std::vector<EngineKind> &engines) {
    out << "\n## How each is set, and what it does differently\n\n| engine | settings |\n|---|---|\n";
    for (const EngineKind &kind : engines) out << "| " << kind.name << " | " << kind.settings << " |\n";
}

} // namespace

void writeMarkdown(const std::vector<SceneGroup> &groups, const std::vector<EngineKind> &engines,
                   const std::vector<Trial> &trials, const std::filesystem::path &folder) {
    std::ofstream out(folder / "peers.md");
    writeIntroduction(out);
    for (const SceneGroup &group : groups) {
        writeGroup(out, group, engines, trials);
        if (isMaze(group)) {
            writeCheapest(out, group, trials);
            std::string picture = group.name;
            std::replace(picture.begin(), picture.end(), ' ', '_');
            out << "\n![" << group.name << "](" << picture << ".svg)\n";
        }
        if (group.name == "fast") writeHolds(out, group, trials);
        if (group.name == "rest") writeRest(out, group, trials);
    }
    out << "\n![the other scenes](scenes.svg)\n";
    writeReference(out, groups, trials);
    writeSettings(out, engines);
}

} // namespace bench
