// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line asks for.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace inspector {

struct Options {
    enum class Action { Run, ListSteppers, ListParameters, PlayAllLevels };

    struct Setting {
        QString id; // of a parameter row
        double value;
    };

    Action action = Action::Run;
    QString level = QStringLiteral("1"); // a number of the list, or a file
    QByteArray stepper;
    double dt = 0.01;   // s
    double speed = 1.0; // simulated seconds per second
    std::vector<Setting> settings;
    QStringList plugins;
    bool headless = false;
    bool autopilot = false;
    std::optional<double> duration; // s of simulated time
    QString csv;                    // file; empty: standard output
    uint64_t csvEvery = 1;          // steps from one row to the next
    QString grab;                   // file; empty: none
};

} // namespace inspector
