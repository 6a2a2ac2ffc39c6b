// SPDX-License-Identifier: MIT
// Prints what comes out of each extreme case as a Markdown table: extremes_table > table.md
#include "catalogue.h"

#include "support/stepper_rows.h"

#include <cstdio>

using namespace extremes;

namespace {

/// What the two models do, said once if it is the same.
QByteArray cell(const Extreme &extreme, const QByteArray &stepper) {
    const auto run = [&](uint32_t model) {
        const Outcome outcome = extreme.run(stepper, model);
        return outcome.problem.isEmpty() ? outcome.text : "**" + outcome.problem + "**";
    };
    const QByteArray rolling = run(PHYS_MODEL_ROLLING);
    const QByteArray rigid = run(PHYS_MODEL_RIGID);
    return rolling == rigid ? rolling : "rolling: " + rolling + "; rigid: " + rigid;
}

void printRow(const QByteArrayList &cells) { std::printf("| %s |\n", cells.join(" | ").constData()); }

} // namespace

int main() {
    const QByteArrayList steppers = support::stepperIds();
    printRow(QByteArrayList{"case"} + steppers);
    printRow(QByteArrayList(steppers.size() + 1, "---"));
    for (const Extreme &extreme : allExtremes()) {
        QByteArrayList cells{extreme.name};
        for (const QByteArray &stepper : steppers) cells.append(cell(extreme, stepper));
        printRow(cells);
    }
    return 0;
}
