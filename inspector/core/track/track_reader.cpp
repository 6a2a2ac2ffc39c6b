// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/track/track_reader.h"

#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "core/setup/numbers.h"

#include <QBuffer>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace inspector {

namespace {

constexpr size_t kFewestRows = 10;
constexpr int kToldRows = 5;          ///< unusable rows that are listed
constexpr double kGap = 3.5;          ///< times the median period
constexpr double kLargestTilt = 89.0; ///< degrees

struct UnitScale {
    const char *name;
    double scale;
};

constexpr std::array<UnitScale, 4> kTimes{{{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60.0}}};
constexpr std::array<UnitScale, 5> kLengths{{{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"in", 0.0254}}};
constexpr std::array<UnitScale, 3> kAngles{{{"rad", 1.0}, {"deg", 0.017453292519943295}, {"mrad", 1e-3}}};
constexpr std::array<UnitScale, 2> kAccelerations{{{"m/s^2", 1.0}, {"g", 9.80665}}};

template<size_t n>
std::optional<double> scaleOf(const std::array<UnitScale, n> &units, const QString &name) {
    for (const UnitScale &unit : units)
        if (name == QLatin1String(unit.name)) return unit.scale;
    return std::nullopt;
}

std::optional<double> numberOf(QString text, bool readsComma) {
    text = text.trimmed();
    if (text.size() >= 2 && text.startsWith(QLatin1Char('"')) && text.endsWith(QLatin1Char('"')))
        text = text.mid(1, text.size() - 2).trimmed();
    if (readsComma) text.replace(QLatin1Char(','), QLatin1Char('.'));
    bool isNumber = false;
    const double number = QLocale::c().toDouble(text, &isNumber);
    return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

enum class Quantity { Time, Frame, X, Y, TiltX, TiltY, GravityX, GravityY, GravityZ };

const std::map<QString, Quantity> &names() {
    static const std::map<QString, Quantity> all{{"t", Quantity::Time},
                                                 {"time", Quantity::Time},
                                                 {"timestamp", Quantity::Time},
                                                 {"frame", Quantity::Frame},
                                                 {"x", Quantity::X},
                                                 {"position_x", Quantity::X},
                                                 {"pos_x", Quantity::X},
                                                 {"y", Quantity::Y},
                                                 {"position_y", Quantity::Y},
                                                 {"pos_y", Quantity::Y},
                                                 {"tilt_x", Quantity::TiltX},
                                                 {"tilt_y", Quantity::TiltY},
                                                 {"gravity_x", Quantity::GravityX},
                                                 {"gravity_y", Quantity::GravityY},
                                                 {"gravity_z", Quantity::GravityZ},
                                                 {"gx", Quantity::GravityX},
                                                 {"gy", Quantity::GravityY},
                                                 {"gz", Quantity::GravityZ}};
    return all;
}

struct QuantityColumn {
    qsizetype place;
    double scale;
};

/// The columns named by a header.
class Header {
public:
    Header(const QString &line, const TrackUnits &units)
        : m_units(units)
        , m_separator(line.contains(QLatin1Char('\t'))  ? QLatin1Char('\t')
                      : line.contains(QLatin1Char(';')) ? QLatin1Char(';')
                                                        : QLatin1Char(',')) {
        const QStringList fields = split(line);
        for (qsizetype i = 0; i < fields.size(); ++i) add(fields[i], i);
        m_isOwnTable = fields.contains(QStringLiteral("step")) && has(Quantity::TiltX);
    }

    QStringList split(const QString &line) const {
        QStringList fields = line.split(m_separator);
        for (QString &field : fields) field = field.trimmed().remove(QLatin1Char('"'));
        return fields;
    }
    bool has(Quantity quantity) const { return m_columns.count(quantity) > 0; }
    bool hasTilt() const { return has(Quantity::TiltX) && has(Quantity::TiltY); }
    bool hasGravity() const { return has(Quantity::GravityX) && has(Quantity::GravityY) && has(Quantity::GravityZ); }
    /// A table written by this program: the tilt in a row is that of the step that ended at its time.
    bool isOwnTable() const { return m_isOwnTable; }

    QString problem() const {
        if (!m_problem.isEmpty()) return m_problem;
        if (!has(Quantity::Time) && !has(Quantity::Frame)) return QStringLiteral("a column t, time or frame");
        if (!has(Quantity::X)) return QStringLiteral("a column x");
        if (!has(Quantity::Y)) return QStringLiteral("a column y");
        if (!has(Quantity::Time) && m_units.frame <= 0.0)
            return QStringLiteral("a column t, or with column frame the pictures per second (fps=60)");
        return {};
    }

    /// In SI; nothing if the field isn't a number.
    std::optional<double> value(const QStringList &fields, Quantity quantity) const {
        const QuantityColumn &column = m_columns.at(quantity);
        if (column.place >= fields.size()) return std::nullopt;
        const std::optional<double> number = numberOf(fields[column.place], m_separator != QLatin1Char(','));
        return number ? std::optional(*number * column.scale) : std::nullopt;
    }
    QString text(const QStringList &fields, Quantity quantity) const {
        return fields.value(m_columns.at(quantity).place); // empty: the row is too short
    }
    bool isEmpty(const QStringList &fields, Quantity quantity) const {
        const QString text = this->text(fields, quantity).toLower();
        return text.isEmpty() || text == QLatin1String("nan") || text == QLatin1String("na");
    }

private:
    /// x [mm], x (mm), x_mm or x.
    void add(const QString &field, qsizetype place) {
        static const QRegularExpression form(QStringLiteral("^\\s*([A-Za-z_]+?)\\s*(?:[\\[(]([^\\])]*)[\\])])?\\s*$"));
        const QRegularExpressionMatch match = form.match(field);
        if (!match.hasMatch()) return;
        QString name = match.captured(1).toLower();
        QString unit = match.captured(2).trimmed();
        if (!names().count(name) && unit.isEmpty()) {
            unit = name.section(QLatin1Char('_'), -1);
            name = name.section(QLatin1Char('_'), 0, -2);
        }
        const auto found = names().find(name);
        if (found == names().end() || has(found->second)) return;
        const std::optional<double> scale = unit.isEmpty() ? usualScale(found->second) : unitScale(found->second, unit);
        if (scale)
            m_columns[found->second] = {place, *scale};
        else if (m_problem.isEmpty())
            m_problem =
                QStringLiteral("a unit of column %1 that is known%2, not '%3'")
                    .arg(name, unit == QLatin1String("px") ? QStringLiteral(" (px=0.25mm tells pixels)") : QString(),
                         unit.left(20));
    }

    std::optional<double> usualScale(Quantity quantity) const {
        switch (quantity) {
        case Quantity::Time:
            return m_units.time;
        case Quantity::Frame:
            return m_units.frame;
        case Quantity::X:
        case Quantity::Y:
            return m_units.position;
        case Quantity::TiltX:
        case Quantity::TiltY:
            return m_units.tilt;
        default:
            return 1.0;
        }
    }

    std::optional<double> unitScale(Quantity quantity, const QString &unit) const {
        switch (quantity) {
        case Quantity::Time:
            return scaleOf(kTimes, unit);
        case Quantity::Frame:
            return std::nullopt;
        case Quantity::X:
        case Quantity::Y:
            if (unit == QLatin1String("px")) return m_units.pixel > 0.0 ? std::optional(m_units.pixel) : std::nullopt;
            return scaleOf(kLengths, unit);
        case Quantity::TiltX:
        case Quantity::TiltY:
            return scaleOf(kAngles, unit);
        default:
            return scaleOf(kAccelerations, unit);
        }
    }

    TrackUnits m_units;
    QChar m_separator;
    std::map<Quantity, QuantityColumn> m_columns;
    bool m_isOwnTable = false;
    QString m_problem;
};

/// Builds a track from rows, one by one.
class Builder {
public:
    Builder(const Header &header, const TrackUnits &units, const QString &name)
        : m_header(header)
        , m_units(units) {
        m_track.name = name;
    }

    void add(int number, const QString &line) {
        const QStringList fields = m_header.split(line);
        QString problem;
        const std::optional<double> time = timeOf(fields, &problem);
        if (!time) return leaveOut(number, problem);
        if (m_isBegun && *time <= m_time)
            return leaveOut(number, QStringLiteral("expected a time after %1 s, found %2 s").arg(m_time).arg(*time));
        if (!addTilt(fields, *time, &problem)) return leaveOut(number, problem);
        m_isBegun = true;
        m_time = *time;
        addPosition(number, fields, *time);
    }

    std::optional<Track> finish(QString *error) {
        if (m_track.points.size() < kFewestRows) {
            *error =
                QStringLiteral("%1: expected at least %2 rows with time and position, found %3%4")
                    .arg(m_track.name)
                    .arg(kFewestRows)
                    .arg(m_track.points.size())
                    .arg(m_track.remarks.isEmpty() ? QString() : QStringLiteral("; ") + m_track.remarks.constFirst());
            return std::nullopt;
        }
        if (m_bad > kToldRows) m_track.remarks += QStringLiteral("%1 more rows left out").arg(m_bad - kToldRows);
        if (m_lost > 0) m_track.remarks += QStringLiteral("%1 rows without a position").arg(m_lost);
        tellGaps();
        return std::move(m_track);
    }

private:
    void leaveOut(int number, const QString &why) {
        if (m_bad++ < kToldRows)
            m_track.remarks += QStringLiteral("%1:%2: %3; left out").arg(m_track.name).arg(number).arg(why);
    }

    std::optional<double> required(const QStringList &fields, Quantity quantity, const char *column,
                                   QString *problem) const {
        const std::optional<double> value = m_header.value(fields, quantity);
        if (value) return value;
        const QString text = m_header.text(fields, quantity);
        const QString why = readNumber(text, {}).problem; // it reads more forms
        *problem = QStringLiteral("column %1: %2")
                       .arg(QLatin1String(column), why.isEmpty() ? "expected a number, found " + foundText(text) : why);
        return value;
    }

    std::optional<double> timeOf(const QStringList &fields, QString *problem) const {
        return m_header.has(Quantity::Time) ? required(fields, Quantity::Time, "t", problem)
                                            : required(fields, Quantity::Frame, "frame", problem);
    }

    void addPosition(int number, const QStringList &fields, double time) {
        if (m_header.isEmpty(fields, Quantity::X) && m_header.isEmpty(fields, Quantity::Y)) {
            ++m_lost;
            return;
        }
        QString problem;
        const std::optional<double> x = required(fields, Quantity::X, "x", &problem);
        const std::optional<double> y = required(fields, Quantity::Y, "y", &problem);
        if (!x || !y) return leaveOut(number, problem);
        m_track.points.push_back({time, m_units.mirrorsX ? -*x : *x, m_units.mirrorsY ? -*y : *y});
    }

    bool addTilt(const QStringList &fields, double time, QString *problem) {
        std::optional<Tilt> tilt;
        if (m_header.hasTilt()) tilt = tiltOf(fields, problem);
        if (m_header.hasGravity() && !m_header.hasTilt()) tilt = tiltOfGravity(fields, problem);
        if (!m_header.hasTilt() && !m_header.hasGravity()) return true;
        if (!tilt) return false;
        if (std::abs(degrees(tilt->x)) > kLargestTilt || std::abs(degrees(tilt->y)) > kLargestTilt) {
            *problem = QStringLiteral("expected tilts within 89 degrees, found %1 and %2")
                           .arg(degrees(tilt->x))
                           .arg(degrees(tilt->y));
            return false;
        }
        const double since = m_header.isOwnTable() && m_isBegun ? m_time : time;
        if (m_track.tilts.empty() || !(m_track.tilts.back().tilt == *tilt)) m_track.tilts.push_back({since, *tilt});
        return true;
    }

    std::optional<Tilt> tiltOf(const QStringList &fields, QString *problem) const {
        const std::optional<double> x = required(fields, Quantity::TiltX, "tilt_x", problem);
        const std::optional<double> y = required(fields, Quantity::TiltY, "tilt_y", problem);
        return x && y ? std::optional(Tilt{*x, *y}) : std::nullopt;
    }

    /// An accelerometer's vector: only its direction counts.
    std::optional<Tilt> tiltOfGravity(const QStringList &fields, QString *problem) const {
        const std::optional<double> x = required(fields, Quantity::GravityX, "gravity_x", problem);
        const std::optional<double> y = required(fields, Quantity::GravityY, "gravity_y", problem);
        const std::optional<double> z = required(fields, Quantity::GravityZ, "gravity_z", problem);
        if (!x || !y || !z) return std::nullopt;
        if (*z == 0.0) {
            *problem = QStringLiteral("expected a gravity that points into the board, found 0 across it");
            return std::nullopt;
        }
        return Tilt{std::atan(*x / std::abs(*z)), std::atan(*y / std::abs(*z))};
    }

    void tellGaps() {
        const double usual = m_track.period();
        for (size_t i = 1; i < m_track.points.size(); ++i) {
            const double from = m_track.points[i - 1].time;
            const double length = m_track.points[i].time - from;
            if (length > kGap * usual)
                m_track.remarks +=
                    QStringLiteral("a gap of %1 s after %2 s").arg(length, 0, 'g', 3).arg(from, 0, 'g', 5);
        }
    }

    const Header &m_header;
    TrackUnits m_units;
    Track m_track;
    bool m_isBegun = false;
    double m_time = 0.0; ///< s, of the last row
    int m_bad = 0;
    int m_lost = 0;
};

// ---- the words of --track-units; each function returns false, and changes nothing, if the text is no value ----

template<size_t n>
bool readScale(const std::array<UnitScale, n> &units, const QString &text, double &scale) {
    const std::optional<double> read = scaleOf(units, text);
    if (read) scale = *read;
    return read.has_value();
}

bool readFrameRate(const QString &text, TrackUnits &units) {
    const std::optional<double> rate = numberOf(text, false);
    if (!rate || *rate <= 0.0) return false;
    units.frame = 1.0 / *rate;
    return true;
}

/// 0.25mm
bool readPixel(const QString &text, TrackUnits &units) {
    static const QRegularExpression form(QStringLiteral("^(.*?)([a-z]+)$"));
    const QRegularExpressionMatch match = form.match(text);
    const std::optional<double> number = numberOf(match.captured(1), false);
    const std::optional<double> unit = scaleOf(kLengths, match.captured(2));
    if (!number || !unit || *number <= 0.0) return false;
    units.pixel = *number * *unit;
    return true;
}

bool readMirror(const QString &text, TrackUnits &units) {
    if (text != QLatin1String("x") && text != QLatin1String("y")) return false;
    (text == QLatin1String("x") ? units.mirrorsX : units.mirrorsY) = true;
    return true;
}

bool readUnit(const QString &name, const QString &text, TrackUnits &units) {
    if (name == QLatin1String("t")) return readScale(kTimes, text, units.time);
    if (name == QLatin1String("x")) return readScale(kLengths, text, units.position);
    if (name == QLatin1String("tilt")) return readScale(kAngles, text, units.tilt);
    if (name == QLatin1String("fps")) return readFrameRate(text, units);
    if (name == QLatin1String("px")) return readPixel(text, units);
    return name == QLatin1String("mirror") && readMirror(text, units);
}

} // namespace

std::optional<TrackUnits> parseTrackUnits(const QString &words, QString *error) {
    TrackUnits units;
    QStringList named;
    for (const QString &word : words.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QString name = word.section(QLatin1Char('='), 0, 0).trimmed();
        named += name == QLatin1String("mirror") ? word.trimmed() : name; // both axes may be mirrored
        if (named.removeDuplicates() > 0) {
            *error = QStringLiteral("'%1' is named twice").arg(name.left(60));
            return std::nullopt;
        }
        if (readUnit(name, word.section(QLatin1Char('='), 1).trimmed(), units)) continue;
        *error = QStringLiteral("expected t=ms, x=mm, tilt=rad, px=0.25mm, fps=60 or mirror=y, found %1")
                     .arg(foundText(word.trimmed().left(60)));
        return std::nullopt;
    }
    return units;
}

std::optional<Track> readTrack(QIODevice &device, const QString &name, const TrackUnits &units, QString *error) {
    std::optional<Header> header;
    std::optional<Builder> builder;
    for (int number = 1; !device.atEnd(); ++number) {
        const QString line = QString::fromUtf8(device.readLine()).trimmed(); // without a byte order mark
        if (line.isEmpty() || line.startsWith(QLatin1Char('#'))) continue;
        if (builder) {
            builder->add(number, line);
            continue;
        }
        header.emplace(line, units);
        if (const QString problem = header->problem(); !problem.isEmpty()) {
            *error = QStringLiteral("%1:%2: expected %3 in the header, found %4")
                         .arg(name)
                         .arg(number)
                         .arg(problem, foundText(line.left(80)));
            return std::nullopt;
        }
        builder.emplace(*header, units, name);
    }
    if (builder) return builder->finish(error);
    *error = QStringLiteral("%1: expected a header line, found nothing").arg(name);
    return std::nullopt;
}

bool isTrackFile(const QString &path) {
    for (const char *ending : {".csv", ".tsv"})
        if (path.endsWith(QLatin1String(ending), Qt::CaseInsensitive)) return true;
    constexpr qint64 kLongestHeader = 4096;
    const QString beginning = QString::fromUtf8(beginningOf(path, kLongestHeader));
    for (const QString &line : beginning.split(QLatin1Char('\n'))) {
        if (line.trimmed().isEmpty() || line.startsWith(QLatin1Char('#'))) continue;
        const Header header(line.trimmed(), {});
        return header.has(Quantity::X) && header.has(Quantity::Y);
    }
    return false;
}

std::optional<Track> readTrackFile(const QString &path, const TrackUnits &units, QString *error) {
    constexpr qint64 kLargest = 200 * kMegabyte; // hours of video
    std::optional<QByteArray> bytes = readFile(path, kLargest, error);
    if (!bytes) return std::nullopt;
    QBuffer buffer(&*bytes);
    buffer.open(QIODevice::ReadOnly);
    return readTrack(buffer, path, units, error);
}

} // namespace inspector
