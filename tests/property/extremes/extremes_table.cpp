// SPDX-License-Identifier: MIT
// Prints the outcome of each extreme case as a Markdown table: extremes_table > table.md, or of the cases whose names
// contain some words: extremes_table WORDS
#include "catalogue.h"

#include "support/stepper_rows.h"

#include <cstdio>

using namespace extremes;

namespace {

/// The outcomes of the two models, stated once if they are the same: all that are allowed, or the forbidden one that
/// occurred.
QByteArray cell(const Extreme &extreme, const QByteArray &stepper) {
    const auto run = [&](uint32_t model) {
        const Outcome outcome = overDraws(extreme, stepper, model);
        if (!outcome.problem.isEmpty()) return "**" + outcome.problem + "**";
        const QByteArray expected = extreme.expected(stepper, model);
        return isExpected(outcome.text, expected) ? expected : "**" + outcome.text + "**";
    };
    const QByteArray rolling = run(PHYS_MODEL_ROLLING);
    const QByteArray rigid = run(PHYS_MODEL_RIGID);
    return rolling == rigid ? rolling : "rolling: " + rolling + "; rigid: " + rigid;
}

void printRow(const QByteArrayList &cells) { std::printf("| %s |\n", cells.join(" | ").constData()); }

} // namespace

int main(int argc, char **argv) {
    const QByteArrayList steppers = support::stepperIds();
    printRow(QByteArrayList{"case"} + steppers);
    printRow(QByteArrayList(steppers.size() + 1, "---"));
    for (const Extreme &extreme : allExtremes()) {
        if (argc > 1 && !extreme.name.contains(argv[1])) continue;
        QByteArrayList cells{extreme.name};
        for (const QByteArray &stepper : steppers) cells.append(cell(extreme, stepper));
        printRow(cells);
    }
    return 0;
}
