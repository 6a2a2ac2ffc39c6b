// SPDX-License-Identifier: MIT
#include "survey.h"

#include "draw.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace witness {

namespace {

/// Runs with a step that takes longer (s of CPU time) are listed.
constexpr double kSlow = 0.1;

std::string nameOf(uint32_t model) { return model == PHYS_MODEL_RIGID ? "rigid" : "rolling"; }

/// Gravity that doesn't pull down while the floor carries the ball, or a start without room: model.md 11.
bool hasNoAnswer(const Verdict &verdict) {
    return verdict.status == PHYS_ERROR_RANGE || (verdict.status == PHYS_ERROR_STUCK && verdict.step == 0);
}

class Surveyor {
public:
    explicit Surveyor(const Plan &plan)
        : m_plan(plan) {
        if (plan.listFile.empty()) return;
        m_list.open(plan.listFile);
        if (!m_list) throw std::runtime_error(plan.listFile + ": can't be written");
    }

    Survey run() {
        const auto begin = std::chrono::steady_clock::now();
        for (uint64_t seed = m_plan.firstSeed; m_survey.runs < m_plan.runs; ++seed) {
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
            if (taken.count() > m_plan.seconds) break;
            for (const size_t kind : m_plan.kinds) {
                for (const uint32_t model : m_plan.models) runScene(kind, seed, model);
            }
        }
        return m_survey;
    }

private:
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
        if (!truth) ++m_survey.withoutAnswer;
        if (!truth) return;
        for (const std::string &stepper : m_plan.steppers) {
            ++m_survey.rows[stepper + ' ' + nameOf(model)].compared;
            note(kind, tame, stepper, judgeLaw(m_plan.registry, stepper, tame, *truth));
        }
    }

    void note(size_t kind, const Case &scene, const std::string &stepper, const Verdict &verdict) {
        const std::string model = nameOf(scene.params.model);
        Row &row = m_survey.rows[stepper + ' ' + model];
        ++row.runs;
        ++m_survey.runs;
        row.steps += verdict.steps;
        row.slowest = std::max(row.slowest, verdict.seconds);
        if (verdict.seconds > kSlow) list(stepper, model, scene, "slow", std::to_string(verdict.seconds) + " s");
        Findings &findings = m_survey.kinds[kinds()[kind]];
        if (verdict.status) {
            if (!hasNoAnswer(verdict)) ++findings.refused[stepper];
            list(stepper, model, scene, phys_status_name(verdict.status), verdict.statusText);
            // A start without room isn't the result of a run.
            const std::string when = verdict.step == 0 ? " at the start" : "";
            const std::string status = phys_status_name(verdict.status) + when;
            ++row.byStatus[status];
            ++(hasNoAnswer(verdict) ? row.withoutAnswer : row.refused);
            m_survey.refusals.try_emplace(status + ' ' + kinds()[kind], stepper + ": " + verdict.statusText);
        }
        if (verdict.check.empty()) return;
        ++findings.wrong[stepper];
        list(stepper, model, scene, verdict.check, verdict.what);
        if (m_plan.known.contain(stepper, model, kinds()[kind], verdict.check)) {
            ++row.known;
            return;
        }
        ++row.wrong;
        ++m_survey.wrong;
        ++row.byCheck[verdict.check];
        const std::string id = stepper + ' ' + model + ' ' + kinds()[kind] + ' ' + verdict.check;
        if (!m_seen.insert(id).second) return;
        std::printf("FAIL %s: %s\n", id.c_str(), verdict.what.c_str());
        std::printf(
            "     %s, model %s: witness 1 --seed %s --kind %s --model %s --stepper %s --cases FOLDER shrinks it\n",
            scene.name.c_str(), model.c_str(), scene.name.substr(scene.name.rfind('-') + 1).c_str(),
            kinds()[kind].c_str(), model.c_str(), stepper.c_str());
        std::fflush(stdout);
        if (m_plan.caseFolder.empty()) return;
        Case smallest = shrink(m_plan.registry, stepper, scene, verdict);
        smallest.name = stepper + '-' + model + '-' + scene.name + '-' + verdict.check;
        std::ofstream(m_plan.caseFolder + '/' + smallest.name + ".case") << textOf(smallest);
    }

    void list(const std::string &stepper, const std::string &model, const Case &scene, const std::string &check,
              const std::string &what) {
        if (m_list.is_open())
            m_list << stepper << ' ' << model << ' ' << scene.name << ' ' << check << ' ' << what << std::endl;
    }

    const Plan &m_plan;
    std::ofstream m_list;
    Survey m_survey;
    std::set<std::string> m_seen;
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

} // namespace

void print(std::FILE *file, const Survey &survey) {
    std::fprintf(file, "%-26s %8s %9s %8s %6s %6s %9s %7s  %s\n", "stepper model", "runs", "steps", "compared", "wrong",
                 "known", "no answer", "refused", "wrong by check; statuses; slowest step");
    for (const auto &[name, row] : survey.rows) {
        std::fprintf(file, "%-26s %8llu %9llu %8llu %6llu %6llu %9llu %7llu ", name.c_str(),
                     static_cast<unsigned long long>(row.runs), static_cast<unsigned long long>(row.steps),
                     static_cast<unsigned long long>(row.compared), static_cast<unsigned long long>(row.wrong),
                     static_cast<unsigned long long>(row.known), static_cast<unsigned long long>(row.withoutAnswer),
                     static_cast<unsigned long long>(row.refused));
        for (const auto &[check, count] : row.byCheck) {
            std::fprintf(file, " %s %llu", check.c_str(), static_cast<unsigned long long>(count));
        }
        std::fprintf(file, ";");
        for (const auto &[status, count] : row.byStatus) {
            std::fprintf(file, " %s %llu", status.c_str() + 11, static_cast<unsigned long long>(count)); // PHYS_ERROR_
        }
        std::fprintf(file, "; %.3g s\n", row.slowest);
    }
    printKinds(file, survey);
    for (const auto &[what, words] : survey.refusals) std::fprintf(file, "%s: %s\n", what.c_str() + 11, words.c_str());
    std::fprintf(file, "%s: %llu runs, %llu wrong, %llu scenes without an answer of the brute force\n",
                 survey.wrong ? "FAIL" : "PASS", static_cast<unsigned long long>(survey.runs),
                 static_cast<unsigned long long>(survey.wrong), static_cast<unsigned long long>(survey.withoutAnswer));
}

std::vector<std::string> stepperIds(const phys_registry *registry, uint32_t first) {
    std::vector<std::string> ids;
    phys_stepper_info info;
    for (uint32_t i = first; phys_registry_info(registry, i, &info) == PHYS_OK; ++i) ids.push_back(info.id);
    return ids;
}

} // namespace witness
