// SPDX-License-Identifier: MIT
// Checks the fit on tracks with known parameters: how often the true values lie in the 95 % intervals, whether a wrong
// model is recognised, and what a fit costs. Prints Markdown tables.
#include "core/setup/tables.h"
#include "core/track/track_fit.h"
#include "inspector/track/made_track.h"

#include <QCoreApplication>
#include <QStringList>
#include <QTextStream>

#include <algorithm>
#include <ctime>
#include <map>

using namespace inspector;

namespace {

constexpr double kWantedTruths = 0.90;
constexpr double kWantedVerdicts = 0.95;
constexpr double kWantedSeconds = 2.0;

double cpuTime() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Count {
    int held = 0;
    int determined = 0;
    std::vector<double> errors; // in people's units
    QString unit;
};

struct Series {
    int fits = 0;
    int rightModel = 0;
    int whole = 0;
    int refused = 0;
    std::vector<double> seconds;
    std::map<QString, Count> counts;
};

FitPlan planOf(const Registry &registry, const Scene &scene, Track track) {
    QString error;
    FitPlan plan{registry, scene, std::move(track), {initialInputs().params, 9.81, {}, 0.0, {}}, {}, {}};
    plan.quantities =
        *parseFitQuantities(QStringLiteral("rolling_friction,restitution_wall,sliding_friction,tilt,delay"), &error);
    return plan;
}

void judge(Series &series, const ModelFit &fit, BoardParameters truth) {
    for (const FittedValue &value : fit.values) {
        Count &count = series.counts[value.quantity.id];
        count.unit = value.quantity.unit;
        if (!value.isDetermined()) continue;
        const double error = std::abs(value.value - value.quantity.of(truth));
        ++count.determined;
        count.held += error <= value.halfInterval();
        count.errors.push_back(error / value.quantity.perUnit);
    }
}

Series run(const QStringList &mazes, uint32_t made, int first, int last, bool isVerbose) {
    Series series;
    const Registry registry = makeRegistry(nullptr);
    for (int seed = first; seed <= last; ++seed) {
        QString error;
        const Scene scene = loadScene(mazes[seed % mazes.size()], &error);
        if (!scene) qFatal("%s", qPrintable(error));
        const BoardParameters truth = support::drawTruth(made, uint64_t(seed));
        const FitPlan plan =
            planOf(registry, scene, support::makeTrack(registry, scene, truth, {.seed = uint64_t(seed)}));
        const double begin = cpuTime();
        const std::optional<TrackFit> fit = fitTrack(plan, {}, {}, &error);
        if (!fit) {
            ++series.refused;
            continue;
        }
        const FitVerdict right = made == PHYS_MODEL_ROLLING ? FitVerdict::RollingSuffices : FitVerdict::RigidNeeded;
        series.seconds.push_back(cpuTime() - begin);
        ++series.fits;
        series.rightModel += fit->verdict == right;
        series.whole += fit->best().segments.size() == 1;
        if (fit->best().model == made) judge(series, fit->best(), truth);
        if (isVerbose) {
            QTextStream(stderr) << "seed " << seed << ": points " << plan.track.points.size() << ", noise "
                                << fit->noise * 1e3 << " mm, ";
            for (const ModelFit &one : fit->fits)
                QTextStream(stderr) << (one.model ? "rigid" : "rolling") << " rms " << one.rms * 1e3 << " mm, breaks "
                                    << one.breaks << ", bounces " << one.bounces.size() << "; ";
            QTextStream(stderr) << series.seconds.back() << " s\n";
            for (const FittedValue &value : fit->best().values) {
                BoardParameters board = truth;
                QTextStream(stderr) << "   " << value.quantity.id << " " << value.value / value.quantity.perUnit
                                    << " +- " << value.halfInterval() / value.quantity.perUnit << ", truth "
                                    << value.quantity.of(board) / value.quantity.perUnit << " " << value.reason << "\n";
            }
        }
    }
    return series;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

bool print(QTextStream &out, const QString &name, const Series &series) {
    const double right = double(series.rightModel) / series.fits;
    const double most = *std::max_element(series.seconds.begin(), series.seconds.end());
    out << "\nMade by the " << name << " model: " << series.fits << " tracks, right model named in "
        << series.rightModel << ", the whole track fitted at once in " << series.whole << "; CPU time "
        << QString::number(median(series.seconds), 'f', 2) << " s (median), " << QString::number(most, 'f', 2)
        << " s (most)\n\n| number | determined in | truth within its interval | median error |\n|---|---|---|---|\n";
    bool isMet = right >= kWantedVerdicts && most < kWantedSeconds;
    for (const auto &[id, count] : series.counts) {
        out << "| " << id << " | " << count.determined << " | " << count.held << " | "
            << QString::number(median(count.errors), 'g', 2) << ' ' << count.unit << " |\n";
        isMet &= count.held >= kWantedTruths * count.determined;
    }
    out.flush();
    return isMet;
}

} // namespace

// Usage: bench_proof [--verbose] MODEL FIRST LAST MAZE.txt...: tracks made by the rolling or the rigid model with seeds
// FIRST to LAST. Exits with 1 if one of the requirements isn't met.
int main(int argc, char **argv) {
    const QCoreApplication application(argc, argv);
    QStringList words = QCoreApplication::arguments().mid(1);
    const bool isVerbose = words.removeAll(QStringLiteral("--verbose")) > 0;
    if (words.size() < 4) {
        QTextStream(stderr) << "usage: bench_proof [--verbose] rolling|rigid FIRST LAST MAZE.txt...\n";
        return 2;
    }
    const QString model = words[0];
    const uint32_t made = model == QLatin1String("rigid") ? PHYS_MODEL_RIGID : PHYS_MODEL_ROLLING;
    QTextStream out(stdout);
    return print(out, modelName(made), run(words.mid(3), made, words[1].toInt(), words[2].toInt(), isVerbose)) ? 0 : 1;
}
