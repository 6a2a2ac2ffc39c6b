// SPDX-License-Identifier: MIT
#include "plan.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace sweep {

const char *const usage = "usage: sweep --levels FILE,... --steppers ID,... --out FILE.csv [--frictions NUMBER,...]\n"
                          "             [--restitutions NUMBER,...] [--dts SECONDS,...] [--seconds SECONDS]\n"
                          "             [--plugins FILE.so,...]\n";

namespace {

constexpr double kMostSteps = 1e12; // days of work: a slip of a digit

std::vector<std::string> split(const std::string &option, const std::string &list) {
    std::vector<std::string> parts;
    std::stringstream stream(list + ',');
    for (std::string part; std::getline(stream, part, ',');) {
        if (part.empty()) throw std::invalid_argument(option + " has an empty value in '" + list + "'");
        parts.push_back(part);
    }
    return parts;
}

double number(const std::string &option, const std::string &text) {
    char *end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool isNumber = end != text.c_str() && *end == '\0' && std::isfinite(value);
    if (!isNumber) throw std::invalid_argument(option + " has '" + text + "'; expected a number");
    return value;
}

std::vector<double> numbers(const std::string &option, const std::string &list) {
    std::vector<double> values;
    for (const std::string &text : split(option, list)) values.push_back(number(option, text));
    return values;
}

double positive(const std::string &option, double value) {
    if (!(value > 0.0)) throw std::invalid_argument(option + " must be above 0 s");
    return value;
}

void set(Plan &plan, const std::string &option, const std::string &value) {
    if (option == "--levels")
        plan.levels = split(option, value);
    else if (option == "--steppers")
        plan.steppers = split(option, value);
    else if (option == "--plugins")
        plan.plugins = split(option, value);
    else if (option == "--frictions")
        plan.frictions = numbers(option, value);
    else if (option == "--restitutions")
        plan.restitutions = numbers(option, value);
    else if (option == "--dts")
        plan.dts = numbers(option, value);
    else if (option == "--seconds")
        plan.seconds = positive(option, number(option, value));
    else if (option == "--out")
        plan.file = value;
    else
        throw std::invalid_argument("unknown option " + option);
}

/// The CSV would replace what it is made from.
void expectNoInput(const std::string &file, const std::string &option, const std::vector<std::string> &inputs) {
    for (const std::string &input : inputs) {
        std::error_code isMissing; // then it's another file
        if (!std::filesystem::equivalent(file, input, isMissing)) continue;
        throw std::invalid_argument("--out is " + file + ", which " + option + " reads; expected another file");
    }
}

} // namespace

uint64_t Plan::jobCount() const {
    return levels.size() * steppers.size() * frictions.size() * restitutions.size() * dts.size();
}

Job Plan::job(uint64_t number) const {
    const auto take = [&number](const auto &list) {
        const auto &item = list[number % list.size()];
        number /= list.size();
        return item;
    };
    Job job;
    job.dt = take(dts);
    job.restitution = take(restitutions);
    job.friction = take(frictions);
    job.stepper = take(steppers);
    job.level = take(levels);
    return job;
}

Plan readPlan(int argc, char **argv) {
    Plan plan;
    std::set<std::string> given;
    for (int i = 1; i < argc; i += 2) {
        if (!given.insert(argv[i]).second) throw std::invalid_argument(std::string(argv[i]) + " is given twice");
        if (i + 1 == argc) throw std::invalid_argument(std::string(argv[i]) + " has no value");
        set(plan, argv[i], argv[i + 1]);
    }
    if (plan.levels.empty()) throw std::invalid_argument("--levels is missing");
    if (plan.steppers.empty()) throw std::invalid_argument("--steppers is missing");
    if (plan.file.empty()) throw std::invalid_argument("--out is missing");
    expectNoInput(plan.file, "--levels", plan.levels);
    expectNoInput(plan.file, "--plugins", plan.plugins);
    for (const double dt : plan.dts) {
        positive("--dts", dt);
        if (plan.seconds / dt > kMostSteps) throw std::invalid_argument("--seconds is more than 1e12 steps of --dts");
    }
    return plan;
}

} // namespace sweep
