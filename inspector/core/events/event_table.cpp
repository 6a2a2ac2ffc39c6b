// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/events/event_table.h"

#include "core/events/event_figures.h"
#include "core/setup/tables.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace inspector {

namespace {

using Figure = std::optional<double>;
using E = const LoggedEvent &;

bool hasBox(E event) { return event.event.box != PHYS_NO_BOX; }
Figure ifBounce(E event, double value) { return event.isBounce() ? Figure(value) : std::nullopt; }
Figure ifBox(E event, double value) { return hasBox(event) ? Figure(value) : std::nullopt; }

Figure ratioOf(E event) {
    if (!event.isBounce() || event.event.speed_before == 0.0) return std::nullopt;
    return -event.event.speed_after / event.event.speed_before;
}

QString change(double before, double after) {
    return QStringLiteral("%1 → %2").arg(speedText(before), speedText(after));
}

QString vector(const phys_vec3 &v, const char *unit) {
    return QStringLiteral("(%1, %2, %3)%4").arg(figureText(v.x), figureText(v.y), figureText(v.z), QLatin1String(unit));
}

QString whenText(E event, const Registry &registry) {
    const StepFacts &step = event.step;
    const QString name = stepperName(registry, stepperId(registry, step.stepper));
    QString text = QStringLiteral("%1 s, in step %2 of %3")
                       .arg(event.event.time, 0, 'f', 6)
                       .arg(step.after.step)
                       .arg(stepSizeText(step.dt));
    if (!name.isEmpty()) text += QStringLiteral(" by %1").arg(name);
    return text + QStringLiteral(", %1 model").arg(modelName(step.params.model));
}

QString boxText(E event, const phys_scene *scene) {
    const uint32_t number = event.event.box;
    if (number >= phys_scene_box_count(scene)) return QString::number(number); // of a scene that is no longer loaded
    const phys_box &box = phys_scene_boxes(scene)[number];
    return QStringLiteral("%1: from %2 to %3").arg(number).arg(vector(box.min, ""), vector(box.max, " m"));
}

QString placeText(E event, double radius) {
    const std::optional<BouncePlace> place = bouncePlace(event, radius);
    if (!place) return QStringLiteral("after something else in the same step");
    if (place->isAtFace(radius)) return QStringLiteral("at the face");
    const QString text = place->gap > 0.0 ? QStringLiteral("%1 mm in front of the face, so %2 ms early")
                                          : QStringLiteral("%1 mm behind the face, so %2 ms late");
    return text.arg(figureText(1e3 * std::abs(place->gap)), figureText(1e3 * std::abs(place->lateness)));
}

/// The law comes first, as it is the line that users look for.
void addBounceLines(E event, double radius, std::vector<LawLine> &lines) {
    const Motion before = motionOf(event.step.before, event.event.normal);
    const Motion after = motionOf(event.step.after, event.event.normal);
    const std::vector<LawLine> laws = lawLines(event, radius);
    lines.insert(lines.end(), laws.begin(), laws.end());
    lines.push_back({QStringLiteral("Found"), placeText(event, radius)});
    lines.push_back({QStringLiteral("Normal speed"), change(event.event.speed_before, event.event.speed_after)});
    lines.push_back({QStringLiteral("Speed along"),
                     QStringLiteral("%1 in this step").arg(change(before.tangentialSpeed, after.tangentialSpeed))});
    lines.push_back(
        {QStringLiteral("Spin"),
         QStringLiteral("%1 → %2 in this step").arg(vector(before.spin, ""), vector(after.spin, " rad/s"))});
}

QByteArray shortest(double value) { return QByteArray::number(value, 'g', QLocale::FloatingPointShortest); }

QByteArray csvRow(E event, const Registry &registry, char separator) {
    QByteArray row = eventKindName(event.event.kind).toUtf8() + separator + stepperId(registry, event.step.stepper) +
                     separator + modelName(event.step.params.model).toUtf8();
    for (const EventColumn &column : eventColumns()) {
        const Figure value = column.value(event);
        row += separator + (value ? shortest(*value) : QByteArray());
    }
    return row + '\n';
}

} // namespace

const std::vector<EventColumn> &eventColumns() {
    static const std::vector<EventColumn> columns{
        {"time [s]", "Time", "s", "since the start", 4, true, [](E e) { return Figure(e.event.time); }},
        {"box", "Box", "", "number of the box, from 0, as in the maze file", -1, true,
         [](E e) { return ifBox(e, e.event.box); }},
        {"speed_before [m/s]", "Before", "m/s", "of a bounce along the normal, towards the box < 0; else |v|", 4, true,
         [](E e) { return Figure(e.event.speed_before); }},
        {"speed_after [m/s]", "After", "m/s", "of a bounce along the normal; else |v|", 4, true,
         [](E e) { return Figure(e.event.speed_after); }},
        {"ratio", "Ratio", "", "speed after by speed before: the restitution that was found", 3, true, ratioOf},
        {"step", "Step", "", "that it happened in", -1, true, [](E e) { return Figure(double(e.step.after.step)); }},
        {"restitution", "e", "", "the parameter that counts: that of floors on top faces, else that of walls", 3, false,
         [](E e) { return ifBounce(e, restitutionOf(e)); }},
        {"depth [m]", "Depth", "m", "deepest of the step, before it was resolved", 6, false,
         [](E e) { return ifBounce(e, e.step.penetration); }},
        {"point_x [m]", "Point x", "m", "", 5, false, [](E e) { return Figure(e.event.point.x); }},
        {"point_y [m]", "Point y", "m", "", 5, false, [](E e) { return Figure(e.event.point.y); }},
        {"point_z [m]", "Point z", "m", "", 5, false, [](E e) { return Figure(e.event.point.z); }},
        {"normal_x", "Normal x", "", "", 4, false, [](E e) { return ifBox(e, e.event.normal.x); }},
        {"normal_y", "Normal y", "", "", 4, false, [](E e) { return ifBox(e, e.event.normal.y); }},
        {"normal_z", "Normal z", "", "", 4, false, [](E e) { return ifBox(e, e.event.normal.z); }},
        {"count", "Count", "", "events in this row", -1, false, [](E e) { return Figure(double(e.count)); }},
        {"until [s]", "Until", "s", "time of the last of them", 4, false, [](E e) { return Figure(e.until); }},
        {"dt [s]", "Step size", "s", "", 6, false, [](E e) { return Figure(e.step.dt); }},
    };
    return columns;
}

QString eventKindName(uint32_t kind) {
    switch (kind) {
    case PHYS_EVENT_IMPACT:
        return QStringLiteral("Impact");
    case PHYS_EVENT_LANDING:
        return QStringLiteral("Landing");
    case PHYS_EVENT_TAKEOFF:
        return QStringLiteral("Take-off");
    case PHYS_EVENT_STOP:
        return QStringLiteral("Stop");
    case PHYS_EVENT_ROLL:
        return QStringLiteral("Rolls again");
    case PHYS_EVENT_CONTACT:
        return QStringLiteral("Stays in contact");
    case PHYS_EVENT_RELEASE:
        return QStringLiteral("Release");
    case kLeftMazeEvent:
        return QStringLiteral("Out of the maze");
    default:
        return QStringLiteral("Event %1").arg(kind);
    }
}

QString eventText(const LoggedEvent &event) {
    QString name = eventKindName(event.event.kind);
    if (event.count == 1) return name;
    const QString time = QStringLiteral("%1 s").arg(event.until - event.event.time, 0, 'f', 2);
    if (event.event.kind == PHYS_EVENT_IMPACT)
        return QStringLiteral("Leaning: %1, %2 impacts").arg(time).arg(event.count);
    return QStringLiteral("%1: %2, %3 times").arg(name, time).arg(event.count);
}

QString figureText(const EventColumn &column, const LoggedEvent &event) {
    const Figure value = column.value(event);
    if (!value) return {};
    return column.digits < 0 ? QString::number(qint64(*value)) : QString::number(*value, 'f', column.digits);
}

std::vector<LawLine> eventLines(const LoggedEvent &event, const phys_scene *scene, const Registry &registry) {
    std::vector<LawLine> lines{{eventText(event), whenText(event, registry)}};
    if (event.count > 1) {
        lines.push_back(
            {QStringLiteral("Fastest"), QStringLiteral("%1; below is the first").arg(speedText(event.fastest))});
    }
    if (event.isBounce())
        addBounceLines(event, phys_scene_radius(scene), lines);
    else
        lines.push_back({QStringLiteral("Speed"), change(event.event.speed_before, event.event.speed_after)});
    if (hasBox(event)) lines.push_back({QStringLiteral("Box"), boxText(event, scene)});
    lines.push_back({QStringLiteral("Point"), vector(event.event.point, " m")});
    if (hasBox(event)) lines.push_back({QStringLiteral("Normal"), vector(event.event.normal, "")});
    return lines;
}

QByteArray eventCsv(const std::vector<LoggedEvent> &events, const Registry &registry, char separator) {
    QByteArray text = QByteArrayLiteral("kind") + separator + "stepper" + separator + "model";
    for (const EventColumn &column : eventColumns()) text += separator + QByteArray(column.id);
    text += '\n';
    for (const LoggedEvent &event : events) text += csvRow(event, registry, separator);
    return text;
}

} // namespace inspector
