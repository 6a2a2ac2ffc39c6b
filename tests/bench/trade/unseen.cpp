// SPDX-License-Identifier: MIT
// Checks the settings that the trade calls good enough for what is known of a board: each is chosen on a maze as the
// inspector chooses it, then tested on schedules that weren't used for the choice. Prints a Markdown table.
#include "core/program/command_line.h"
#include "core/setup/tables.h"
#include "core/trade/good_enough.h"
#include "core/trade/trade_options.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTextStream>

using namespace inspector;

namespace {

constexpr int kSchedules = 40;
constexpr uint64_t kFirstUnseen = 1000000;
constexpr int kBalls = 100;
constexpr double kWanted = 0.95; // of the schedules

struct Trial {
    int schedules = 0;
    int kept = 0;         // with an error below the share
    double largest = 0.0; // of the shares
};

TradePlan planOf(const QString &maze, double horizon) {
    QString error;
    TradePlan plan;
    plan.registry = makeRegistry(&error);
    plan.scene = loadScene(maze, &error);
    if (!plan.scene) qFatal("%s", qPrintable(error));
    plan.inputs = initialInputs();
    plan.stepSizes = usualStepSizes();
    plan.repeats = 3;
    plan.unknowns = *parseUnknowns(usualUnknowns(), &error);
    plan.horizon = horizon;
    if (!makeSchedules(QStringLiteral("both"), horizon, plan, &error)) qFatal("%s", qPrintable(error));
    return plan;
}

Trial tryUnseen(const TradePlan &plan, const TradePoint &setting) {
    Trial trial;
    for (uint64_t seed = kFirstUnseen; seed < kFirstUnseen + kSchedules; ++seed) {
        const std::vector<TiltSegment> segments = segmentsOf(randomSchedule(seed, plan.horizon), plan.inputs.gravity);
        const auto reference =
            TradeReference::run(plan.registry, plan.scene, paramsFor(plan, PHYS_MODEL_ROLLING), segments, nullptr);
        if (!reference) continue;
        const BandPlan bandPlan{plan.registry, plan.scene, plan.inputs, plan.unknowns, kBalls, plan.horizon};
        const double band = uncertaintyBand(bandPlan, *reference, {}).middleAt(plan.horizon);
        const std::optional<double> error = errorOfSetting(plan, setting, *reference, plan.horizon, {});
        ++trial.schedules;
        if (!error) continue;
        trial.largest = std::max(trial.largest, *error / band);
        if (*error < plan.share * band) ++trial.kept;
    }
    return trial;
}

// Median over the plan's schedules of the uncertainty, mm.
double unknownOf(const TradePlan &plan, const TradeResult &result) {
    return result.spans.back()[PHYS_MODEL_ROLLING].band.middleAt(plan.horizon) * phys_scene_radius(plan.scene.get()) *
           1e3;
}

double cheapestExact(const TradeResult &result) {
    double cheapest = std::numeric_limits<double>::infinity();
    for (const TradePoint &point : result.valid(PHYS_MODEL_ROLLING))
        if (point.stepper == "exact") cheapest = std::min(cheapest, point.cost.perSecond);
    return cheapest;
}

// Its row of the table. If nothing was tested, no setting was good enough.
Trial tryMaze(QTextStream &out, const QString &maze, double horizon) {
    QString error;
    const TradePlan plan = planOf(maze, horizon);
    const std::optional<TradeResult> result = measureTrade(plan, {}, {}, &error);
    const QString name = QFileInfo(maze).completeBaseName();
    if (!result || !result->goodEnough) {
        out << "| " << name << " | " << horizon << " | none: " << error << " | | | | | |\n";
        return {};
    }
    const TradePoint &setting = result->points[result->goodEnough->point];
    const Trial trial = tryUnseen(plan, setting);
    out << QStringLiteral("| %1 | %2 | %3 | %4 | %5 | %6 | %7 of %8 | %9 |\n")
               .arg(name)
               .arg(horizon)
               .arg(unknownOf(plan, *result), 0, 'g', 3)
               .arg(QStringLiteral("%1, %2").arg(QString::fromUtf8(setting.stepper), stepSizeText(setting.dt)))
               .arg(setting.cost.perSecond * 1e6, 0, 'g', 2)
               .arg(cheapestExact(*result) * 1e6, 0, 'g', 2)
               .arg(trial.kept)
               .arg(trial.schedules)
               .arg(trial.largest, 0, 'g', 2);
    out.flush();
    return trial;
}

} // namespace

// Usage: bench_unseen MAZE.txt... Exits with 1 if a setting stays below the share on fewer than 95 of 100 schedules.
int main(int argc, char **argv) {
    const QCoreApplication application(argc, argv);
    QTextStream out(stdout);
    out << "| maze | horizon [s] | not known, busy [mm] | good enough | µs a second | exact's | below a quarter | "
           "worst "
           "share |\n|---|---|---|---|---|---|---|---|\n";
    bool isKept = true;
    Trial all;
    for (const double horizon : {1.0, 5.0}) {
        for (const QString &maze : QCoreApplication::arguments().mid(1)) {
            const Trial trial = tryMaze(out, maze, horizon);
            isKept &= trial.schedules > 0 && trial.kept >= kWanted * trial.schedules;
            all.schedules += trial.schedules;
            all.kept += trial.kept;
        }
    }
    out << "\nBelow a quarter of what isn't known in " << all.kept << " of " << all.schedules << " trials.\n";
    return isKept ? 0 : 1;
}
