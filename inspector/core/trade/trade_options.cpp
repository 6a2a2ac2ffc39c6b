// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_options.h"

#include "core/engine/engine.h"
#include "core/schedule/busy_schedule.h"
#include "core/schedule/recording_schedule.h"
#include "core/setup/lines.h"

#include <QStringList>

#include <algorithm>
#include <limits>

namespace inspector {

namespace {

/// If a setting fails on none of this many schedules, it fails on at most 3 in 200 others with 95 % confidence (the
/// rule of three). That is less than the 1 in 20 which a reader of "good enough" may accept, also after several
/// settings were tried in turn.
constexpr int kValidations = 200;

TiltSchedule makeSchedule(const QString &words, const TradePlan &plan, double duration, QString *error) {
    const QString random = QStringLiteral("random:");
    if (words == QLatin1String("autopilot"))
        return autopilotSchedule(plan.registry, plan.scene, plan.inputs, duration, error);
    if (words == QLatin1String("busy"))
        return busySchedule(plan.registry, plan.scene, plan.inputs, duration, plan.horizon, error);
    if (isRecordingFile(words)) return recordedSchedule(words, plan.registry, duration, error);
    if (!words.startsWith(random)) return readSchedule(words, duration, error);
    bool isNumber = false;
    const uint64_t seed = words.mid(random.size()).toULongLong(&isNumber);
    if (isNumber) return randomSchedule(seed, duration);
    *error = QStringLiteral("expected random: and a whole number, found %1").arg(foundText(words));
    return {};
}

} // namespace

std::optional<Length> parseLength(const QString &text) {
    const bool isInRadii = text.endsWith(QLatin1Char('R'));
    if (text.isEmpty() || !text.back().isLetter()) return std::nullopt; // the unit is required: m or R?
    const NumberRange range{0.0, std::numeric_limits<double>::max(), isInRadii ? QString() : QStringLiteral("m")};
    const std::optional<double> value = readNumber(isInRadii ? text.chopped(1) : text, range).value;
    return value && *value > 0.0 ? std::optional(Length{*value, isInRadii}) : std::nullopt;
}

std::vector<double> parseStepSizes(const QString &text) {
    const bool adds = text.startsWith(QLatin1Char('+'));
    std::vector<double> sizes = adds ? usualStepSizes() : std::vector<double>();
    for (const QString &word : text.mid(adds ? 1 : 0).split(QLatin1Char(','))) {
        const NumberReading size = readDuration(word, Engine::kSmallestDt, Engine::kLargestDt);
        if (!size.value) return {};
        sizes.push_back(*size.value);
    }
    return sizes;
}

bool makeSchedules(const QString &words, double duration, TradePlan &plan, QString *error) {
    const bool isBoth = words == QLatin1String("both");
    plan.schedules.clear();
    for (const QString &word : isBoth ? QStringList{"autopilot", "busy"} : QStringList{words}) {
        TiltSchedule schedule = makeSchedule(word, plan, duration, error);
        const bool isSpare = isBoth && word == QLatin1String("autopilot"); // many boards have no path out
        if (schedule.switches.empty() && isSpare) continue;
        if (schedule.switches.empty()) return false;
        if (isBoth && plan.schedules.empty() && !isSpare)
            schedule.name += QStringLiteral(" (the autopilot finds no way out)");
        plan.schedules.push_back(std::move(schedule));
    }
    double longest = 0.0;
    for (const TiltSchedule &schedule : plan.schedules) longest = std::max(longest, schedule.duration);
    plan.askedHorizon = plan.horizon;
    plan.horizon = std::min(plan.horizon, longest); // beyond it nothing is measured
    // A user's own schedule is used as it is; random kinds are validated on further ones.
    const bool isFile = !isBoth && words != QLatin1String("autopilot") && words != QLatin1String("busy") &&
                        !words.startsWith(QLatin1String("random:"));
    plan.validations = plan.unknowns.empty() || isFile ? 0 : kValidations;
    return true;
}

} // namespace inspector
