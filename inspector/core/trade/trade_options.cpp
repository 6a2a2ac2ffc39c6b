// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trade/trade_options.h"

#include "core/engine/engine.h"
#include "core/trade/recording_schedule.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace inspector {

namespace {

std::optional<double> parseNumber(const QString &text) {
    bool isNumber = false;
    const double number = QLocale::c().toDouble(text, &isNumber);
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<double> parseStepSize(const QString &text) {
    const auto scaled = [&](qsizetype unit, double scale) -> std::optional<double> {
        const std::optional<double> number = parseNumber(text.chopped(unit));
        return number ? std::optional(*number * scale) : std::nullopt;
    };
    if (text.startsWith(QLatin1String("1/"))) {
        const std::optional<double> rate = parseNumber(text.mid(2));
        return rate ? std::optional(1.0 / *rate) : std::nullopt;
    }
    if (text.endsWith(QLatin1String("ms"))) return scaled(2, 1e-3);
    if (text.endsWith(QLatin1String("us"))) return scaled(2, 1e-6);
    if (text.endsWith(QLatin1Char('s'))) return scaled(1, 1.0);
    return parseNumber(text);
}

} // namespace

std::optional<Length> parseLength(const QString &text) {
    struct Unit {
        const char *name;
        double scale;
        bool isRadii;
    };
    static constexpr std::array<Unit, 4> kUnits{
        {{"mm", 1e-3, false}, {"um", 1e-6, false}, {"m", 1.0, false}, {"R", 1.0, true}}};
    for (const Unit &unit : kUnits) {
        if (!text.endsWith(QLatin1String(unit.name))) continue;
        const std::optional<double> number = parseNumber(text.chopped(qsizetype(qstrlen(unit.name))));
        if (!number || !(*number > 0.0)) return std::nullopt;
        return Length{*number * unit.scale, unit.isRadii};
    }
    return std::nullopt;
}

std::vector<double> parseStepSizes(const QString &text) {
    const bool adds = text.startsWith(QLatin1Char('+'));
    std::vector<double> sizes = adds ? usualStepSizes() : std::vector<double>();
    for (const QString &word : text.mid(adds ? 1 : 0).split(QLatin1Char(','))) {
        const std::optional<double> size = parseStepSize(word.trimmed());
        if (!size || !(*size >= Engine::kSmallestDt && *size <= Engine::kLargestDt)) return {};
        sizes.push_back(*size);
    }
    return sizes;
}

TiltSchedule makeSchedule(const QString &words, const Registry &registry, const Scene &scene, const Inputs &inputs,
                          double duration, QString *error) {
    const QString random = QStringLiteral("random:");
    if (words == QLatin1String("autopilot")) return autopilotSchedule(registry, scene, inputs, duration, error);
    if (isRecordingFile(words)) return recordedSchedule(words, registry, duration, error);
    if (!words.startsWith(random)) return readSchedule(words, duration, error);
    bool isNumber = false;
    const uint64_t seed = words.mid(random.size()).toULongLong(&isNumber);
    if (isNumber) return randomSchedule(seed, duration);
    *error = QStringLiteral("expected random: and a whole number, found '%1'").arg(words);
    return {};
}

} // namespace inspector
