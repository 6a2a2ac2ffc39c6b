// SPDX-License-Identifier: MIT
// Does the report card name what a plugin does wrong.
#include <QTest>

#include "contract.h"
#include "measures.h"

#include "support/handles.h"
#include "witness/survey.h"

class PluginCheck : public QObject {
    Q_OBJECT

private slots:
    void aBreachOfTheContractIsNamed_data();
    void aBreachOfTheContractIsNamed();
    void aMotionThatIsWrongIsNamed_data();
    void aMotionThatIsWrongIsNamed();
    void aSoundPluginKeepsTheContract();
};

void PluginCheck::aBreachOfTheContractIsNamed_data() {
    QTest::addColumn<QByteArray>("breach");
    const auto row = [](const char *id, const char *breach) { QTest::newRow(id) << QByteArray(breach); };
    row("nan", "step writes a number that isn't finite");
    row("infinity", "step writes a number that isn't finite");
    row("time-not-advanced", "step changes the time that the host has set");
    row("step-counted-twice", "step changes the step number that the host has set");
    row("unknown-flags", "step sets unknown flags");
    row("orientation-not-unit", "step writes an orientation that is no unit quaternion");
    row("writes-input", "step writes to the state it is given");
    row("too-many-events", "step reports more events than there is room for");
    row("own-buffer", "step changes the report's size or its event buffer");
    row("nan-in-report", "step reports a number that isn't finite");
    row("throws", "step throws an exception: no reason to go on");
    row("throws-number", "step throws an exception");
    row("positive-status", "step returns the unknown status 42");
    row("unknown-status", "step returns the unknown status -4711");
    row("fails-silently", "step fails without a reason");
    row("fails-with-reason", "step refuses a ball that rolls on a floor: PHYS_ERROR_UNSUPPORTED");
    row("fails-endlessly", "step's reason has no end");
    row("throws-at-creation", "create throws an exception: std::bad_alloc");
    row("garbage-at-creation", "create returns the unknown status 1");
    row("throws-at-destruction", "destroy throws an exception");
    row("throws-requirements", "requirements throws an exception: I require nothing");
    row("endless-requirements", "requirements writes a reason without an end");
}

void PluginCheck::aBreachOfTheContractIsNamed() {
    QFETCH(QByteArray, breach);
    const std::vector<std::string> found = plugin_check::breaches(MISBEHAVING, QTest::currentDataTag());
    QByteArray all;
    for (const std::string &line : found) all += QByteArray(line.c_str()) + "; ";
    QVERIFY2(std::find(found.begin(), found.end(), breach.toStdString()) != found.end(), all);
}

/// Those of the witness's planted faults that a short look must see, and one that leaps through everything.
void PluginCheck::aMotionThatIsWrongIsNamed_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("word");
    QTest::newRow("behaves") << QByteArray(MISBEHAVING) << QByteArray("too_far:");
    const auto fault = [](const char *id, const char *word) {
        QTest::newRow(id) << QByteArray(FAULTS) << QByteArray(word);
    };
    fault("ends-inside", "inside:");
    fault("prefers-right", "mirrored:");
    fault("prefers-x", "turned:");
    fault("prefers-first-box", "shuffled:");
    fault("remembers", "all_stages:");
    fault("obeys-report", "fresh:");
    fault("claims-loss", "report:");
    fault("claims-rest", "rest:");
    fault("energy-up-1e-6", "energy:");
    fault("thin-wall-forgotten", "inside:");
}

void PluginCheck::aMotionThatIsWrongIsNamed() {
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, word);
    phys_registry *created = nullptr;
    phys_error error{};
    QCOMPARE(phys_registry_create(&created, &error), PHYS_OK);
    const support::RegistryPtr registry(created);
    QVERIFY2(phys_registry_load_file(created, file, &error) == PHYS_OK, error.text);
    const plugin_check::Measure measure = plugin_check::invariants({created, QTest::currentDataTag()});
    QVERIFY(measure.isWrong);
    QVERIFY2(measure.text.find(word.toStdString()) != std::string::npos, measure.text.c_str());
}

void PluginCheck::aSoundPluginKeepsTheContract() {
    const std::vector<std::string> found = plugin_check::breaches(EXAMPLE, "adaptive-drag");
    QVERIFY2(found.empty(), found.empty() ? "" : found[0].c_str());
}

QTEST_GUILESS_MAIN(PluginCheck)
#include "tst_plugin_check.moc"
