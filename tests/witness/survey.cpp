// SPDX-License-Identifier: MIT
#include "survey.h"

#include "draw.h"

#include "support/orders.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace witness {

namespace {

/// Runs with a step that takes longer (s of CPU time) are listed.
constexpr double kSlow = 0.1;

unsigned long long number(uint64_t count) { return count; } // as printf wants it

std::string nameOf(uint32_t model) { return model == PHYS_MODEL_RIGID ? "rigid" : "rolling"; }

/// Gravity that doesn't pull down while the floor carries the ball, or a start without room: model.md 11.
bool hasNoAnswer(const Verdict &verdict) {
    return verdict.status == PHYS_ERROR_RANGE || (verdict.status == PHYS_ERROR_STUCK && verdict.step == 0);
}

/// So many make as many runs as planned, if every scene has an answer.
uint64_t seedsOf(const Plan &plan) {
    const uint64_t parts = (plan.withInvariants ? 1 : 0) + (plan.withLaw ? 1 : 0);
    const uint64_t all = parts * plan.kinds.size() * plan.models.size() * plan.steppers.size();
    const uint64_t perSeed = std::max<uint64_t>(1, all);
    return (plan.runs + perSeed - 1) / perSeed;
}

class Surveyor {
public:
    explicit Surveyor(const Plan &plan)
        : m_plan(plan)
        , m_nextSeed(plan.firstSeed)
        , m_endSeed(plan.firstSeed + seedsOf(plan)) {
        if (plan.listFile.empty()) return;
        m_list.open(plan.listFile);
        if (!m_list) throw std::runtime_error(plan.listFile + ": can't be written");
    }

    Survey run() {
        {
            std::vector<std::jthread> threads;
            for (unsigned i = 0; i < std::max(1U, m_plan.threads); ++i) threads.emplace_back([this] { runSeeds(); });
        }
        m_survey.nextSeed = m_nextSeed;
        m_survey.seconds = seconds();
        return m_survey;
    }

private:
    void runSeeds() {
        while (const std::optional<uint64_t> seed = beginSeed()) {
            for (const size_t kind : m_plan.kinds) {
                for (const uint32_t model : m_plan.models) runScene(kind, *seed, model);
            }
            const std::scoped_lock lock(m_mutex);
            m_begun.erase(*seed);
        }
    }

    std::optional<uint64_t> beginSeed() {
        const std::scoped_lock lock(m_mutex);
        if (m_nextSeed == m_endSeed || seconds() > m_plan.seconds || (m_plan.stops && *m_plan.stops)) return {};
        return *m_begun.insert(m_nextSeed++).first;
    }

    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count(); }

    void tellProgress() {
        constexpr double kEach = 60.0;
        if (seconds() < m_told + kEach) return;
        m_told = seconds();
        const double rate = static_cast<double>(m_survey.runs) / m_told;
        const double left = static_cast<double>(m_plan.runs) - static_cast<double>(m_survey.runs);
        std::fprintf(stderr,
                     "%llu of %llu runs, %.0f a second, %.0f min left; %llu wrong, %llu refused; "
                     "seeds below %llu are done\n",
                     number(m_survey.runs), number(m_plan.runs), rate, std::max(0.0, left) / rate / 60.0,
                     number(m_survey.wrong), number(m_survey.refused), number(*m_begun.begin()));
    }

    void runScene(size_t kind, uint64_t seed, uint32_t model) {
        if (m_plan.withInvariants) examineInvariants(kind, seed, model);
        if (m_plan.withLaw) compareWithLaw(kind, seed, model);
    }

    void examineInvariants(size_t kind, uint64_t seed, uint32_t model) {
        const Case wild = drawCase(kind, seed, model);
        for (const std::string &stepper : m_plan.steppers)
            note(kind, wild, stepper, examine(m_plan.registry, stepper, wild));
    }

    void compareWithLaw(size_t kind, uint64_t seed, uint32_t model) {
        const Case tame = drawSmoothCase(kind, seed, model);
        const std::optional<Truth> truth = Truth::of(tame);
        if (!truth) {
            const std::scoped_lock lock(m_mutex);
            ++m_survey.withoutAnswer;
            return;
        }
        for (const std::string &stepper : m_plan.steppers) {
            note(kind, tame, stepper, judgeLaw(m_plan.registry, stepper, tame, *truth));
            const std::scoped_lock lock(m_mutex);
            ++m_survey.rows[stepper + ' ' + nameOf(model)].compared;
        }
    }

    void note(size_t kind, const Case &scene, const std::string &stepper, const Verdict &verdict) {
        if (!count(kind, scene, stepper, verdict) || m_plan.caseFolder.empty()) return;
        Case smallest = shrink(m_plan.registry, stepper, scene, verdict);
        smallest.name = stepper + '-' + nameOf(scene.params.model) + '-' + scene.name + '-' + verdict.check;
        std::ofstream(m_plan.caseFolder + '/' + smallest.name + ".case") << textOf(smallest);
    }

    /// Returns whether it is the first of its stepper, model, kind and check that is wrong.
    bool count(size_t kind, const Case &scene, const std::string &stepper, const Verdict &verdict) {
        const std::scoped_lock lock(m_mutex);
        const std::string model = nameOf(scene.params.model);
        Row &row = m_survey.rows[stepper + ' ' + model];
        ++row.runs;
        ++m_survey.runs;
        tellProgress();
        row.steps += verdict.steps;
        row.slowest = std::max(row.slowest, verdict.seconds);
        if (verdict.seconds > kSlow) list(stepper, model, scene, "slow", std::to_string(verdict.seconds) + " s");
        if (verdict.status) {
            list(stepper, model, scene, phys_status_name(verdict.status), verdict.statusText);
            countStatus(kinds()[kind], stepper, row, verdict);
        }
        if (verdict.check.empty()) return false;
        ++m_survey.kinds[kinds()[kind]].wrong[stepper];
        list(stepper, model, scene, verdict.check, verdict.what);
        if (m_plan.known.contain(stepper, model, kinds()[kind], verdict.check)) {
            ++row.known;
            return false;
        }
        ++row.wrong;
        ++m_survey.wrong;
        ++row.byCheck[verdict.check];
        const std::string id = stepper + ' ' + model + ' ' + kinds()[kind] + ' ' + verdict.check;
        if (!m_seen.insert(id).second) return false;
        std::printf("FAIL %s: %s\n", id.c_str(), verdict.what.c_str());
        std::printf(
            "     %s, model %s: witness 1 --seed %s --kind %s --model %s --stepper %s --cases FOLDER shrinks it\n",
            scene.name.c_str(), model.c_str(), scene.name.substr(scene.name.rfind('-') + 1).c_str(),
            kinds()[kind].c_str(), model.c_str(), stepper.c_str());
        std::fflush(stdout);
        return true;
    }

    void countStatus(const std::string &kind, const std::string &stepper, Row &row, const Verdict &verdict) {
        // A start without room isn't the result of a run.
        const std::string when = verdict.step == 0 ? " at the start" : "";
        const std::string status = phys_status_name(verdict.status) + std::strlen("PHYS_ERROR_") + when;
        ++row.byStatus[status];
        if (hasNoAnswer(verdict)) {
            ++row.withoutAnswer;
            return;
        }
        ++row.refused;
        ++m_survey.refused;
        ++m_survey.kinds[kind].refused[stepper];
        Refusals &refusals = m_survey.refusals[kind + ' ' + stepper + ' ' + status];
        if (refusals.count++ == 0) refusals.first = verdict.statusText;
    }

    void list(const std::string &stepper, const std::string &model, const Case &scene, const std::string &check,
              const std::string &what) {
        if (m_list.is_open())
            m_list << stepper << ' ' << model << ' ' << scene.name << ' ' << check << ' ' << what << std::endl;
    }

    const Plan &m_plan;
    const std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
    std::mutex m_mutex; // of all below
    std::ofstream m_list;
    Survey m_survey;
    std::set<std::string> m_seen;
    std::set<uint64_t> m_begun; ///< seeds that aren't done
    uint64_t m_nextSeed;
    uint64_t m_endSeed;
    double m_told = 0.0; ///< s
};

} // namespace

KnownFaults::KnownFaults(const std::string &path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": can't be read");
    int number = 0;
    for (std::string text; std::getline(file, text);) {
        ++number;
        std::istringstream line(text);
        Fault fault;
        std::string reason;
        if (!(line >> fault.stepper) || fault.stepper[0] == '#') continue;
        if (!(line >> fault.model >> fault.kind >> fault.check >> reason)) {
            throw std::runtime_error(path + ':' + std::to_string(number) +
                                     ": expected 'stepper model kind check reason'");
        }
        m_faults.push_back(fault);
    }
}

bool KnownFaults::contain(const std::string &stepper, const std::string &model, const std::string &kind,
                          const std::string &check) const {
    const auto is = [](const std::string &pattern, const std::string &word) {
        return pattern == "*" || pattern == word;
    };
    return std::any_of(m_faults.begin(), m_faults.end(), [&](const Fault &fault) {
        return is(fault.stepper, stepper) && is(fault.model, model) && is(fault.kind, kind) && is(fault.check, check);
    });
}

Survey survey(const Plan &plan) { return Surveyor(plan).run(); }

namespace {

/// "wrong/refused" of each kind of scene and stepper.
void printKinds(std::FILE *file, const Survey &survey) {
    std::set<std::string> steppers;
    for (const auto &[name, row] : survey.rows) steppers.insert(name.substr(0, name.find(' ')));
    std::fprintf(file, "%-16s", "wrong/refused");
    for (const std::string &stepper : steppers) std::fprintf(file, " %16s", stepper.c_str());
    std::fprintf(file, "\n");
    const auto countOf = [](const std::map<std::string, uint64_t> &counts, const std::string &stepper) {
        const auto found = counts.find(stepper);
        return std::to_string(found == counts.end() ? 0 : found->second);
    };
    for (const auto &[kind, findings] : survey.kinds) {
        std::fprintf(file, "%-16s", kind.c_str());
        for (const std::string &stepper : steppers) {
            const std::string text = countOf(findings.wrong, stepper) + '/' + countOf(findings.refused, stepper);
            std::fprintf(file, " %16s", text == "0/0" ? "." : text.c_str());
        }
        std::fprintf(file, "\n");
    }
}

/// Refused runs of each stepper, both models together, beside the goal for those that make steps of their own size.
void printRates(std::FILE *file, const Survey &survey) {
    constexpr double kGoal = 1.0; // of 10,000 runs
    std::map<std::string, Row> rows;
    for (const auto &[name, row] : survey.rows) {
        Row &sum = rows[name.substr(0, name.find(' '))];
        sum.runs += row.runs;
        sum.wrong += row.wrong;
        sum.refused += row.refused;
    }
    for (const auto &[stepper, row] : rows) {
        const double rate = 1e4 * static_cast<double>(row.refused) / static_cast<double>(row.runs);
        const bool isExact = support::ordersOf(stepper).impacts == 0;
        std::fprintf(file, "%-16s %8llu runs, %llu wrong; refused %.2f of 10,000%s\n", stepper.c_str(),
                     number(row.runs), number(row.wrong), rate,
                     isExact        ? ""
                     : rate < kGoal ? ", below 1"
                                    : ", NOT below 1");
    }
}

} // namespace

void print(std::FILE *file, const Survey &survey) {
    std::fprintf(file, "%-26s %8s %9s %8s %6s %6s %9s %7s  %s\n", "stepper model", "runs", "steps", "compared", "wrong",
                 "known", "no answer", "refused", "wrong by check; statuses; slowest step");
    for (const auto &[name, row] : survey.rows) {
        std::fprintf(file, "%-26s %8llu %9llu %8llu %6llu %6llu %9llu %7llu ", name.c_str(), number(row.runs),
                     number(row.steps), number(row.compared), number(row.wrong), number(row.known),
                     number(row.withoutAnswer), number(row.refused));
        for (const auto &[check, count] : row.byCheck) std::fprintf(file, " %s %llu", check.c_str(), number(count));
        std::fprintf(file, ";");
        for (const auto &[status, count] : row.byStatus) std::fprintf(file, " %s %llu", status.c_str(), number(count));
        std::fprintf(file, "; %.3g s\n", row.slowest);
    }
    printKinds(file, survey);
    for (const auto &[what, refusals] : survey.refusals) {
        std::fprintf(file, "refused: %s: %llu, first: %s\n", what.c_str(), number(refusals.count),
                     refusals.first.c_str());
    }
    printRates(file, survey);
    std::fprintf(file, "%.0f s, %.0f runs a second; all seeds below %llu are done\n", survey.seconds,
                 static_cast<double>(survey.runs) / survey.seconds, number(survey.nextSeed));
    std::fprintf(file, "%s: %llu runs, %llu wrong, %llu refused, %llu scenes without an answer of the brute force\n",
                 survey.wrong ? "FAIL" : "PASS", number(survey.runs), number(survey.wrong), number(survey.refused),
                 number(survey.withoutAnswer));
}

std::vector<std::string> stepperIds(const phys_registry *registry, uint32_t first) {
    std::vector<std::string> ids;
    phys_stepper_info info;
    for (uint32_t i = first; phys_registry_info(registry, i, &info) == PHYS_OK; ++i) ids.push_back(info.id);
    return ids;
}

} // namespace witness
