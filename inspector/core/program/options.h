// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line asks for.
#pragma once

#include "core/engine/engine.h"
#include "core/engine/ghost_engine.h"
#include "core/setup/handles.h"
#include "core/setup/levels.h"
#include "core/setup/parameters.h"
#include "core/track/fit_quantity.h"
#include "core/track/track_reader.h"
#include "core/trade/trade_options.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace inspector {

// What is said of a measured ball.
struct FitOptions {
    QString track;     // file; empty: none. Of Action::Fit, or to be laid over the run in the window
    QString unitWords; // as parseTrackUnits() reads them
    TrackUnits units;
    TrackFrame frame;                    // where the tracker's is on the board, or where a fit of it begins
    std::vector<FitQuantity> quantities; // that are looked for
};

struct Options {
    enum class Action { Run, PlayAllLevels, Trade, Fit, Replay };

    Action action = Action::Run;
    Registry registry;   // with the plugins loaded
    QStringList plugins; // files of --plugin
    PluginLoader pluginLoader = loadPlugin;
    std::vector<Level> levels; // the list
    Level level;
    QByteArray stepper = PHYS_STEPPER_DEFAULT;
    double dt = Engine::kDefaultDt; // s
    double speed = 1.0;             // simulated seconds per second
    QString parameters;             // file that some of the settings are from; empty: none
    std::vector<Setting> settings;
    bool headless = false;
    bool autopilot = false;
    std::optional<double> duration; // s of simulated time
    QString csv;                    // file; "-": standard output; empty: that if headless, else nowhere
    uint64_t csvEvery = 1;          // steps from one row to the next
    QString record;                 // file to write a recording to; empty: none
    QString replay;                 // recording, of Action::Replay, in the window unless headless
    bool check = false;             // say whether the replay is the same, instead of writing its table
    std::optional<GhostChoice> comparison;
    std::vector<Setting> comparisonSettings; // the second ball's own parameters; empty: the first's
    TradeOptions trade;                      // of Action::Trade
    FitOptions fit;
    QString grab;       // file; empty: none
    bool force = false; // outputs may take the place of any file
    enum class View { Auto, Flat, Solid };
    View view = View::Auto; // of the board: without OpenGL where that isn't there, never, always
    QString shaders;        // folder of files that replace the embedded ones; empty: none
};

// What the second ball obeys by comparisonSettings, all but the tilt. Nothing and one line in `error` if that isn't
// allowed.
std::optional<Inputs> ghostsInputs(const Options &options, QString *error);

} // namespace inspector
