// SPDX-License-Identifier: MIT
// Many scenes under many steppers, with counts.
#pragma once

#include "judge.h"

#include <atomic>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace witness {

/// Known faults of steppers, so that a run fails only for new ones: lines "stepper model kind check reason" with '*'
/// for any.
class KnownFaults {
public:
    KnownFaults() = default;
    /// Throws std::runtime_error with file and line.
    explicit KnownFaults(const std::string &path);
    bool contain(const std::string &stepper, const std::string &model, const std::string &kind,
                 const std::string &check) const;

private:
    struct Fault {
        std::string stepper, model, kind, check;
    };
    std::vector<Fault> m_faults;
};

struct Plan {
    const phys_registry *registry = nullptr;
    std::vector<std::string> steppers;
    std::vector<uint32_t> models = {PHYS_MODEL_ROLLING, PHYS_MODEL_RIGID};
    std::vector<size_t> kinds;
    uint64_t firstSeed = 1;
    uint64_t runs = 0; ///< scenes x steppers x models
    bool withInvariants = true;
    bool withLaw = true;  ///< scenes are also compared with the brute force, which takes most of the time
    double seconds = 1e9; ///< after which no new seed is begun
    const std::atomic<bool> *stops = nullptr; ///< if given: true ends it likewise
    unsigned threads = 1;                     ///< which share the seeds
    std::string caseFolder;                   ///< where to write failing cases, shrunk; "": they are named only
    std::string listFile; ///< where to write a line for each run that fails or is refused; "": nowhere
    KnownFaults known;
};

struct Row {
    uint64_t runs = 0;
    uint64_t steps = 0;
    uint64_t compared = 0; ///< with the brute force
    uint64_t wrong = 0;
    uint64_t known = 0;
    std::map<std::string, uint64_t> byCheck;
    std::map<std::string, uint64_t> byStatus;
    uint64_t withoutAnswer = 0; ///< refused because there is no answer
    uint64_t refused = 0;       ///< all others
    double slowest = 0.0;
};

/// Wrong and refused runs of one kind of scene.
struct Findings {
    std::map<std::string, uint64_t> wrong, refused; ///< by stepper; refused although there is an answer
};

/// Runs of one kind of scene under one stepper that were refused for the same reason although there is an answer.
struct Refusals {
    uint64_t count = 0;
    std::string first; ///< message
};

struct Survey {
    std::map<std::string, Row> rows;       ///< by "stepper model"
    std::map<std::string, Findings> kinds; ///< by kind of scene
    uint64_t runs = 0;
    uint64_t wrong = 0;   ///< without known faults
    uint64_t refused = 0; ///< although there is an answer
    uint64_t withoutAnswer = 0;
    std::map<std::string, Refusals> refusals; ///< by "kind stepper status"
    uint64_t nextSeed = 0;                    ///< all before it are done
    double seconds = 0.0;
};

/// Says each minute how far it is.
Survey survey(const Plan &plan);

void print(std::FILE *file, const Survey &survey);

/// Ids of a registry's steppers from index `first` on.
std::vector<std::string> stepperIds(const phys_registry *registry, uint32_t first = 0);

} // namespace witness
