// SPDX-License-Identifier: GPL-3.0-or-later
// Logged events as text: columns of a table, lines for one of them.
#pragma once

#include "core/events/bounce_law.h"
#include "core/setup/handles.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace inspector {

struct EventColumn {
    const char *id;    // in CSV, with the unit: speed_before [m/s]
    const char *label; // for people
    const char *unit;  // for people; "" without
    const char *help;
    int digits;   // for people, after the point; < 0: a whole number
    bool isShown; // in the window; all are in CSV
    // In the column's unit; nothing where the event has no such figure.
    std::optional<double> (*value)(const LoggedEvent &event);
};

// Kind, stepper and model come as words before these.
const std::vector<EventColumn> &eventColumns();

// Impact, Landing, Take-off, ...; "Event 42" for a kind that is not known.
QString eventKindName(uint32_t kind);
// What happened in a few words: Impact; Leaning: 0.83 s, 83 impacts.
QString eventText(const LoggedEvent &event);
// A figure of a column; "" without one.
QString figureText(const EventColumn &column, const LoggedEvent &event);

// All there is to say about one event: when, what in force, where, how fast, and for a bounce the laws.
std::vector<LawLine> eventLines(const LoggedEvent &event, const phys_scene *scene, const Registry &registry);

// Header and a row an event: the shortest numbers that read back exactly. separator: ',' or '\t'.
QByteArray eventCsv(const std::vector<LoggedEvent> &events, const Registry &registry, char separator);

} // namespace inspector
