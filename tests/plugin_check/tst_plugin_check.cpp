// SPDX-License-Identifier: MIT
// Whether the report card detects what a plugin does wrong.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTest>

#include "card.h"
#include "contract.h"
#include "isolation.h"
#include "measures.h"

#include "support/handles.h"
#include "witness/survey.h"

#include <cstdlib>
#include <set>
#include <unistd.h>

class PluginCheck : public QObject {
    Q_OBJECT

private slots:
    void aBreachOfTheContractIsNamed_data();
    void aBreachOfTheContractIsNamed();
    void aMotionThatIsWrongIsNamed_data();
    void aMotionThatIsWrongIsNamed();
    void whatIsUntrueIsNamed_data();
    void whatIsUntrueIsNamed();
    void aSoundPluginKeepsTheContract();
    void whatLacksTimeIsOpen();
    void aSlowSteppersPartsAreOpen();
    void aStepperThatMakesNoStepHasAShortCard();
    void commandLine_data();
    void commandLine();
    void soundSteppersSayWhatHappens_data();
    void soundSteppersSayWhatHappens();
    void theLawIsFollowedAcrossImpacts_data();
    void theLawIsFollowedAcrossImpacts();
    void theExamplesPageShowsItsCard_data();
    void theExamplesPageShowsItsCard();

private:
    support::RegistryPtr registryWith(const QByteArray &file);
};

namespace {

using plugin_check::Measure;
using plugin_check::Subject;

#ifdef SANITIZED
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

using MeasureFunction = Measure(const Subject &);

Measure contract(const Subject &subject) {
    Measure measure;
    for (const std::string &breach : plugin_check::breaches(UNTRUE, subject.id)) measure.text += breach + "; ";
    measure.isWrong = !measure.text.empty();
    return measure;
}

} // namespace

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
    row("writes-params", "step writes to the parameters it is given");
    row("writes-beyond-out", "step writes beyond the state `out`");
    row("one-event-too-far", "step writes beyond the report's buffer of events");
    row("writes-beyond-report", "step writes beyond the report");
    row("writes-beyond-error", "step writes beyond the error");
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
    QVERIFY2(std::set(found.begin(), found.end()).size() == found.size(), all); // none twice
}

/// The witness's planted faults that a short check must detect, and a stepper that jumps through everything.
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
    const support::RegistryPtr registry = registryWith(file);
    const Measure measure = plugin_check::invariants({registry.get(), QTest::currentDataTag()});
    QVERIFY(measure.isWrong);
    QVERIFY2(measure.text.find(word.toStdString()) != std::string::npos, measure.text.c_str());
}

support::RegistryPtr PluginCheck::registryWith(const QByteArray &file) {
    phys_registry *created = nullptr;
    phys_error error{};
    if (phys_registry_create(&created, &error) || phys_registry_load_file(created, file, &error))
        qFatal("%s", error.text);
    return support::RegistryPtr(created);
}

void PluginCheck::whatIsUntrueIsNamed_data() {
    QTest::addColumn<MeasureFunction *>("measure");
    QTest::addColumn<QByteArray>("words");
    const auto row = [](const char *id, MeasureFunction *measure, const char *words) {
        QTest::newRow(id) << measure << QByteArray(words);
    };
    using namespace plugin_check;
    row("normals-turned", reports, "an impact's normal doesn't point from the box to the ball");
    row("first-box-named", reports, "an impact with another box than the ball's");
    row("points-at-the-centre", reports, "an impact's point isn't on the box");
    row("slow-events", reports, "an impact's speed before is wrong");
    row("kinds-invented", reports, "reports event 0 with kind 99; expected 1 .. 7");
    row("events-hidden", reports, "a bounce without an event");
    row("events-lost", reports, "events lost where there was room");
    row("substeps-hidden", reports, "a step without substeps");
    row("resistance-not-booked", reports, "energy lost by rolling isn't booked");
    row("impacts-not-booked", reports, "energy lost in an impact isn't booked");
    row("flies-unseen", reports, "not airborne in the air");
    row("rests-unseen", reports, "at rest without its flag");
    row("loses-at-rest", reports, "energy is lost at rest");
    row("speeds-up", invariants, "other bits: velocity.x ");
    row("random", threads, "other bits in a repeat on another thread: position.x ");
    row("fails-always", invariants, "refused with PHYS_ERROR_PLUGIN_RESULT: ");
    row("claims-slip", reports, "slipping in the rolling model");
    row("turns-backwards", reports, "the orientation doesn't follow the spin");
    row("never-turns", reports, "the orientation doesn't follow the spin");
    row("stays-sleeping", reports, "the flags of the state before are read");
    row("claims-exactness", reports, "one step of 0.4 s isn't as good as 400 of 1 ms, which its flags promise");
    row("requires-more", reports, "requirements tell other substeps than the step takes");
    row("requires-the-unknown", reports, "requirements of unknown stages");
    row("swallows-errors", tunnelling, "stands still at");
    row("fails-silently-when-fast", contract, "step refuses 1e12 m/s without a reason");
    row("fails-inside", contract, "step refuses 1e12 m/s with PHYS_ERROR_INTERNAL, which isn't one of phys_step's");
    row("rounds-up", contract, "step leaves another rounding than it found");
    row("traps-exceptions", contract, "step leaves other exceptions trapped than it found");
    row("prints", energyPerBounce, "prints 'step 0'");
    row("closes-output", energyPerBounce, "closes file descriptor 1");
    row("closes-all", energyPerBounce, "closes the pipe");
    row("redirects-errors", energyPerBounce, "redirects file descriptor 2");
    row("opens-files", energyPerBounce, "leaves open file descriptor");
    row("goes-to-root", energyPerBounce, "changes the working directory to /");
    row("sets-locale", energyPerBounce, "changes the locale to C");
    row("takes-interrupt", energyPerBounce, "takes the signal Interrupt");
    row("blocks-hang-up", energyPerBounce, "blocks or unblocks the signal Hangup");
    row("sets-variable", energyPerBounce, "changes environment variables");
    row("masks-files", energyPerBounce, "changes the mask of new files' rights");
    row("ends-alarm", energyPerBounce, "changes the process's alarm");
    if (kIsSanitized) return; // sanitizers allocate by themselves and need more stack
    row("keeps-memory", memory, "bytes a step");
    row("needs-stack", smallStack, "crashes: Segmentation fault");
}

void PluginCheck::whatIsUntrueIsNamed() {
    QFETCH(MeasureFunction *, measure);
    QFETCH(QByteArray, words);
    const support::RegistryPtr registry = registryWith(UNTRUE);
    const Subject subject{registry.get(), QTest::currentDataTag()};
    const Measure found = plugin_check::Isolation().run([&] { return measure(subject); });
    QVERIFY(found.isWrong);
    QVERIFY2(found.text.find(words.toStdString()) != std::string::npos, found.text.c_str());
}

void PluginCheck::soundSteppersSayWhatHappens_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::newRow("sound") << QByteArray(UNTRUE);
    QTest::newRow("adaptive-drag") << QByteArray(EXAMPLE);
    for (const std::string &id : witness::stepperIds(nullptr)) QTest::newRow(id.c_str()) << QByteArray(EXAMPLE);
}

void PluginCheck::soundSteppersSayWhatHappens() {
    QFETCH(QByteArray, file);
    const support::RegistryPtr registry = registryWith(file);
    using namespace plugin_check;
    for (MeasureFunction *const measure : {reports, memory, smallStack}) {
        if (kIsSanitized && measure != reports) continue;
        const Measure found = Isolation().run([&] { return measure({registry.get(), QTest::currentDataTag()}); });
        QVERIFY2(!found.isWrong, found.text.c_str());
    }
}

void PluginCheck::theLawIsFollowedAcrossImpacts_data() {
    QTest::addColumn<bool>("isFollowed");
    for (const std::string &id : witness::stepperIds(nullptr)) QTest::newRow(id.c_str()) << true;
    QTest::newRow("wall-friction-halved") << false;
}

void PluginCheck::theLawIsFollowedAcrossImpacts() {
    QFETCH(bool, isFollowed);
    const support::RegistryPtr registry = registryWith(FAULTS);
    const Measure found = plugin_check::impacts({registry.get(), QTest::currentDataTag()});
    QVERIFY2(found.isWrong != isFollowed, found.text.c_str());
}

/// Without what differs between machines, and without what takes longest.
void PluginCheck::theExamplesPageShowsItsCard_data() {
    QTest::addColumn<size_t>("part");
    const std::span<const plugin_check::Part> parts = plugin_check::parts();
    for (size_t i = 0; i < parts.size(); ++i) {
        const auto measure = parts[i].measure;
        if (measure == plugin_check::cost || measure == plugin_check::law) continue;
        if (kIsSanitized && (measure == plugin_check::memory || measure == plugin_check::smallStack)) continue;
        QTest::newRow(parts[i].name) << i;
    }
}

void PluginCheck::theExamplesPageShowsItsCard() {
    QFETCH(size_t, part);
    QFile page(EXAMPLE_PAGE);
    QVERIFY(page.open(QIODevice::ReadOnly));
    const support::RegistryPtr registry = registryWith(EXAMPLE);
    const Measure measure = plugin_check::parts()[part].measure({registry.get(), "adaptive-drag"});
    const std::string line = plugin_check::lineOf(QTest::currentDataTag(), measure) + '\n';
    QVERIFY2(page.readAll().contains(line.c_str()), line.c_str());
}

void PluginCheck::aSoundPluginKeepsTheContract() {
    const std::string example(EXAMPLE);
    QVERIFY(QDir::setCurrent(QFileInfo(EXAMPLE).path()));
    for (const std::string &file : {example, example.substr(example.rfind('/') + 1)}) {
        const std::vector<std::string> found = plugin_check::breaches(file, "adaptive-drag");
        QVERIFY2(found.empty(), found.empty() ? "" : found[0].c_str());
    }
}

/// A slow machine or a part that lacks time is no fault of the stepper; a part that never ends is one.
void PluginCheck::whatLacksTimeIsOpen() {
    const plugin_check::Isolation card;
    const Measure endless = card.run([]() -> Measure { pause(), std::abort(); }, 1);
    QVERIFY2(endless.isWrong && endless.text == "not done after 1 s", endless.text.c_str());
    const plugin_check::Isolation over(1);
    const Measure cut = over.run([]() -> Measure { pause(), std::abort(); }, 3);
    QVERIFY2(!cut.isWrong && cut.isOpen, cut.text.c_str());
    QCOMPARE(cut.text, std::string("not done when the card's 1 s were over"));
    const Measure late = over.run([] { return Measure{true, ""}; }, 3);
    QVERIFY2(!late.isWrong && late.isOpen, late.text.c_str());
    QCOMPARE(plugin_check::lineOf("law", late),
             std::string("open  law              not begun when the card's 1 s were over"));
}

namespace {

struct Ended {
    int status;
    QByteArray out, messages;
};

Ended check(const QStringList &arguments) {
    QProcess process;
    process.start(PHYSICS_CHECK, arguments);
    if (!process.waitForFinished(-1)) qFatal("physics-check doesn't run");
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

void PluginCheck::aSlowSteppersPartsAreOpen() {
    if (kIsSanitized) QSKIP("sanitizers need more stack");
    const Ended ended = check({UNTRUE, "--stepper", "slow"});
    QVERIFY2(ended.status == 3 && !ended.out.contains("FAIL"), ended.out);
    QVERIFY2(ended.out.contains("\nok    small stack "), ended.out);
    QVERIFY2(ended.out.contains("\nopen  memory           not begun: some 3000 steps of 0.0"), ended.out);
}

void PluginCheck::aStepperThatMakesNoStepHasAShortCard() {
    const Ended ended = check({UNTRUE, "--stepper", "fails-always"});
    QCOMPARE(ended.status, 1);
    QVERIFY2(ended.out.contains("\nFAIL  contract         step returns the unknown status 3"), ended.out);
    QVERIFY2(ended.out.contains("\nFAIL  cost             nothing else is asked, because "), ended.out);
    QCOMPARE(ended.out.count('\n'), 3);
}

void PluginCheck::commandLine_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("out");
    QTest::addColumn<QByteArray>("messages");
    QTest::newRow("help") << QStringList{"--help"} << 0 << QByteArray("usage: physics-check FILE.so") << QByteArray();
    QTest::newRow("nothing") << QStringList() << 2 << QByteArray() << QByteArray("usage: physics-check FILE.so");
    QTest::newRow("unknown stepper") << QStringList{UNTRUE, "--stepper", "nobody"} << 2 << QByteArray()
                                     << QByteArray("physics-check: " UNTRUE ": no stepper nobody\n");
}

void PluginCheck::commandLine() {
    QFETCH(QStringList, arguments);
    const Ended ended = check(arguments);
    QTEST(ended.status, "status");
    QFETCH(QByteArray, out);
    QFETCH(QByteArray, messages);
    QVERIFY2(ended.out.startsWith(out) && ended.out.isEmpty() == out.isEmpty(), ended.out);
    QVERIFY2(ended.messages.startsWith(messages) && ended.messages.isEmpty() == messages.isEmpty(), ended.messages);
}

QTEST_GUILESS_MAIN(PluginCheck)
#include "tst_plugin_check.moc"
