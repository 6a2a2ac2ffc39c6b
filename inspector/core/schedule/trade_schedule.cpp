// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/trade_schedule.h"

#include "core/pilot/autopilot.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace inspector {

namespace {

constexpr double kRandomHold = 0.5; ///< s

struct Row {
    double time;
    Tilt tilt;
};

void append(std::vector<TiltSwitch> &switches, double time, Tilt tilt) {
    if (switches.empty() || !(switches.back().tilt == tilt)) switches.push_back({time, tilt});
}

/// Parses the lines of a schedule's file, one by one.
class ScheduleReader {
public:
    /// False if the line is invalid; `error` then gets the expected and the found text.
    bool read(const QString &line, QString *error) {
        const QString text = line.section(QLatin1Char('#'), 0, 0).trimmed();
        if (text.isEmpty()) return true;
        if (m_rows.empty() && text.startsWith(QLatin1String("time [s]"))) return readHeader(text, error);
        static const QRegularExpression separators(QStringLiteral("[\\s,;]+"));
        const QStringList fields = m_isTable ? text.split(QLatin1Char(',')) : text.split(separators);
        const std::optional<Row> row = rowOf(fields);
        if (!row || !isNext(*row)) {
            *error =
                QStringLiteral("expected %1, found %2")
                    .arg(m_rows.empty() && !m_isTable ? QStringLiteral("0 s and two tilts within 89 degrees")
                                                      : QStringLiteral("a later time and two tilts within 89 degrees"),
                         foundText(text.left(60)));
            return false;
        }
        m_rows.push_back(*row);
        return true;
    }

    bool isEmpty() const { return m_rows.empty(); }

    TiltSchedule schedule(double duration) const {
        TiltSchedule result;
        result.duration = m_isTable ? std::min(duration, m_rows.back().time) : duration;
        double begin = 0.0; // a table's row has the tilt of the step that ended at its time
        for (const Row &row : m_rows) {
            const double time = m_isTable ? begin : row.time;
            if (time < result.duration) append(result.switches, time, row.tilt);
            begin = row.time;
        }
        return result;
    }

private:
    bool readHeader(const QString &text, QString *error) {
        const QStringList names = text.split(QLatin1Char(','));
        m_columns = {names.indexOf(QStringLiteral("time [s]")), names.indexOf(QStringLiteral("tilt_x [deg]")),
                     names.indexOf(QStringLiteral("tilt_y [deg]"))};
        m_isTable = true;
        if (m_columns[1] >= 0 && m_columns[2] >= 0) return true;
        *error = QStringLiteral("expected the columns 'tilt_x [deg]' and 'tilt_y [deg]'");
        return false;
    }

    std::optional<Row> rowOf(const QStringList &fields) const {
        if (!m_isTable && fields.size() != 3) return std::nullopt;
        double numbers[3];
        for (size_t i = 0; i < 3; ++i) {
            bool isNumber = false;
            numbers[i] = QLocale::c().toDouble(fields.value(m_columns[i]).trimmed(), &isNumber);
            if (!isNumber || !std::isfinite(numbers[i])) return std::nullopt;
        }
        if (std::abs(numbers[1]) > 89.0 || std::abs(numbers[2]) > 89.0) return std::nullopt;
        return Row{numbers[0], {radians(numbers[1]), radians(numbers[2])}};
    }

    bool isNext(const Row &row) const {
        if (!m_rows.empty()) return row.time > m_rows.back().time;
        return m_isTable ? row.time > 0.0 : row.time == 0.0;
    }

    bool m_isTable = false;
    std::array<qsizetype, 3> m_columns{0, 1, 2};
    std::vector<Row> m_rows;
};

} // namespace

TiltSchedule autopilotSchedule(const Registry &registry, const Scene &scene, const Inputs &inputs, double duration,
                               QString *error) {
    const std::shared_ptr<const Autopilot> pilot = Autopilot::create(scene.get(), error);
    const Stepper stepper = makeStepper(registry, "exact", scene, error);
    phys_state state;
    if (!pilot || !stepper || phys_scene_start(scene.get(), &state) != PHYS_OK) return {};

    TiltSchedule result{QStringLiteral("autopilot"), {}, duration};
    Inputs now = inputs;
    for (int i = 0; i * kScheduleHold < duration; ++i) {
        const double time = i * kScheduleHold;
        const Tilt tilt = pilot->tilt(state, kScheduleHold);
        tiltBoard(now, tilt);
        phys_error failure;
        if (phys_step(stepper.get(), &now.params, kScheduleHold, &state, &state, nullptr, &failure) != PHYS_OK) {
            tell(error, failure);
            return {};
        }
        result.duration = time;
        if (state.flags & PHYS_OUT) return result;
        append(result.switches, time, tilt);
    }
    result.duration = duration;
    return result;
}

TiltSchedule randomSchedule(uint64_t seed, double duration) {
    TiltSchedule result{QStringLiteral("random:%1").arg(seed), {}, duration};
    std::mt19937_64 numbers(seed);
    // Uniform in -1 .. 1 from the upper 53 bits; the standard's distributions differ between libraries.
    const auto next = [&] { return double(numbers() >> 11) * 0x1p-52 - 1.0; };
    for (int i = 0; i * kRandomHold < duration; ++i) {
        const double x = next();
        const double y = next();
        result.switches.push_back({i * kRandomHold, {radians(kPlayTilt) * x, radians(kPlayTilt) * y}});
    }
    return result;
}

TiltSchedule readSchedule(const QString &path, double duration, QString *error) {
    constexpr qint64 kLargest = 500 * kMegabyte; // a table of an hour at 1 ms
    const std::optional<QByteArray> text = readFile(path, kLargest, error);
    if (!text) return {};
    ScheduleReader reader;
    int number = 0;
    for (const QByteArray &line : text->split('\n')) {
        QString reason;
        ++number;
        if (reader.read(QString::fromUtf8(line), &reason)) continue;
        *error = QStringLiteral("%1:%2: %3").arg(oneLine(path)).arg(number).arg(oneLine(reason));
        return {};
    }
    if (reader.isEmpty()) {
        *error = QStringLiteral("%1: expected rows of 'time tilt_x tilt_y', found none").arg(oneLine(path));
        return {};
    }
    TiltSchedule result = reader.schedule(duration);
    result.name = path;
    return result;
}

} // namespace inspector
