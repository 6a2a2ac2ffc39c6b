// SPDX-License-Identifier: GPL-3.0-or-later
// Logged events as text: table columns, and a description of one event.
#pragma once

#include "core/events/bounce_law.h"
#include "core/setup/handles.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace inspector {

struct EventColumn {
    const char *id;    ///< in CSV, with the unit: speed_before [m/s]
    const char *label; ///< for display
    const char *unit;  ///< for display; "" without
    const char *help;
    int digits;   ///< for display, after the point; < 0: a whole number
    bool isShown; ///< in the window; all are in CSV
    /// The value in the column's unit; nothing if the event has no such figure.
    std::optional<double> (*value)(const LoggedEvent &event);
};

/// Kind, stepper and model are text columns that precede these.
const std::vector<EventColumn> &eventColumns();

/// Impact, Landing, Take-off, ...; "Event 42" for a kind that is not known.
QString eventKindName(uint32_t kind);
/// A short description: Impact; Leaning: 0.83 s, 83 impacts.
QString eventText(const LoggedEvent &event);
/// The text of a figure; "" if the event has none.
QString figureText(const EventColumn &column, const LoggedEvent &event);

/// Everything known about one event: time, step, place, speeds, and for a bounce the laws.
std::vector<LawLine> eventLines(const LoggedEvent &event, const phys_scene *scene, const Registry &registry);

/// A header and one row per event: the shortest numbers that read back exactly. separator: ',' or '\t'.
QByteArray eventCsv(const std::vector<LoggedEvent> &events, const Registry &registry, char separator);

} // namespace inspector
