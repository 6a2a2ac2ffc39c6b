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

/// Options of a measured ball.
struct FitOptions {
    QString track;     ///< file; empty: none. For Action::Fit, or shown in the window
    QString unitWords; ///< in the form that parseTrackUnits() reads
    TrackUnits units;
    TrackFrame frame;                    ///< the tracker's frame on the board, or its initial value in a fit
    std::vector<FitQuantity> quantities; ///< to be fitted
};

struct Options {
    enum class Action { Run, PlayAllLevels, Trade, Fit, Replay };

    Action action = Action::Run;
    Registry registry;   ///< including loaded plugins
    QStringList plugins; ///< files of --plugin
    PluginLoader pluginLoader = loadPlugin;
    std::vector<Level> levels; ///< the list
    Level level;
    QByteArray stepper = PHYS_STEPPER_DEFAULT;
    double dt = Engine::kDefaultDt; ///< s
    double speed = 1.0;             ///< simulated seconds per second
    QString parameters;             ///< file with some of the settings; empty: none
    std::vector<Setting> settings;
    bool headless = false;
    bool autopilot = false;
    std::optional<double> duration; ///< s of simulated time
    QString csv;                    ///< file; "-": standard output; empty: that if headless, else nowhere
    uint64_t csvEvery = 1;          ///< steps from one row to the next
    QString record;                 ///< file to write a recording to; empty: none
    QString replay;                 ///< recording, for Action::Replay; played in the window unless headless
    bool check = false;             ///< report whether the replay is the same, instead of writing its table
    std::optional<GhostChoice> comparison;
    std::vector<Setting> comparisonSettings; ///< the second ball's own parameters; empty: the first's
    TradeOptions trade;                      ///< for Action::Trade
    FitOptions fit;
    QString grab;       ///< file; empty: none
    bool force = false; ///< outputs may overwrite any file
    enum class View { Auto, Flat, Solid };
    View view = View::Auto; ///< of the board: OpenGL if there is any, always, never
    QString shaders;        ///< folder of files that replace the embedded ones; empty: none
};

/// Sets the rows of the options' stepper, and then the options' values. Returns false, with one line in `error` (may be
/// nullptr), if those are invalid.
bool setParameters(const Options &options, Parameters &parameters, QString *error);

/// The second ball's inputs from comparisonSettings, except for the tilt. Returns nothing, with one line in `error`, if
/// they are invalid.
std::optional<Inputs> ghostsInputs(const Options &options, QString *error);

} // namespace inspector
