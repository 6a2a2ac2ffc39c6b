// SPDX-License-Identifier: MIT
// Would the witness notice: each planted fault is found within a few scenes, and named.
#include <QTest>

#include "draw.h"
#include "judge.h"

#include "support/handles.h"

#include <map>
#include <optional>

namespace {

constexpr uint64_t kMostSeeds = 12;

} // namespace

class WitnessNotices : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void aPlantedFaultIsFoundAndNamed_data();
    void aPlantedFaultIsFoundAndNamed();

private:
    /// The first check that the faulty stepper fails in a scene that the sound one passes; empty if there is none.
    QByteArray firstFinding(const std::string &stepper, const QByteArrayList &kindNames);
    witness::Verdict verdictOf(const std::string &stepper, const witness::Case &scene);

    support::RegistryPtr m_registry;
    std::map<std::string, std::optional<witness::Truth>> m_truths; // of the scenes of the law, which rows share
};

void WitnessNotices::initTestCase() {
    phys_registry *registry = nullptr;
    phys_error error{};
    QCOMPARE(phys_registry_create(&registry, &error), PHYS_OK);
    m_registry.reset(registry);
    QVERIFY2(phys_registry_load_file(registry, WITNESS_FAULTS, &error) == PHYS_OK, error.text);
}

witness::Verdict WitnessNotices::verdictOf(const std::string &stepper, const witness::Case &scene) {
    if (scene.check != "law") return witness::judge(m_registry.get(), stepper, scene);
    const auto [place, isNew] = m_truths.try_emplace(witness::textOf(scene));
    std::optional<witness::Truth> &truth = place->second;
    if (isNew) truth = witness::Truth::of(scene);
    return truth ? witness::judgeLaw(m_registry.get(), stepper, scene, *truth) : witness::Verdict{};
}

QByteArray WitnessNotices::firstFinding(const std::string &stepper, const QByteArrayList &kindNames) {
    for (uint64_t seed = 1; seed <= kMostSeeds; ++seed) {
        for (size_t kind = 0; kind < witness::kinds().size(); ++kind) {
            if (!kindNames.contains(witness::kinds()[kind].c_str())) continue;
            for (const uint32_t model : {PHYS_MODEL_RIGID, PHYS_MODEL_ROLLING}) {
                for (const bool isLaw : {false, true}) {
                    witness::Case scene =
                        isLaw ? witness::drawSmoothCase(kind, seed, model) : witness::drawCase(kind, seed, model);
                    if (isLaw) scene.check = "law";
                    const witness::Verdict verdict = verdictOf(stepper, scene);
                    if (verdict.check.empty() || !verdictOf("sound", scene).check.empty()) continue;
                    qInfo("%s: %s: %s", scene.name.c_str(), verdict.check.c_str(), verdict.what.c_str());
                    return verdict.check.c_str();
                }
            }
        }
    }
    return {};
}

void WitnessNotices::aPlantedFaultIsFoundAndNamed_data() {
    QTest::addColumn<QByteArrayList>("kinds");
    QTest::addColumn<QByteArrayList>("checks");

    const auto row = [](const char *id, const QByteArrayList &kinds, const QByteArrayList &checks) {
        QTest::newRow(id) << kinds << checks;
    };
    row("wall-friction-halved", {"boxes", "pressed", "gap"}, {"law", "report"});
    row("floor-friction-doubled", {"thin", "roof"}, {"law"});
    row("restitution-of-the-other-feature", {"boxes", "roof", "thin"}, {"law"});
    row("resistance-forgotten", {"boxes", "thin"}, {"law"});
    row("inertia-forgotten", {"boxes", "thin"}, {"law", "energy", "too_far"});
    row("normal-turned-1e-3", {"boxes", "thin", "thick"}, {"law", "mirrored"});
    row("roof-forgotten", {"roof"}, {"inside", "law", "through"});
    row("thin-wall-forgotten", {"thin"}, {"inside", "through", "law"});
    row("energy-up-1e-6", {"boxes"}, {"energy"});
    row("ends-inside", {"boxes"}, {"inside"});
    row("prefers-right", {"boxes"}, {"mirrored", "turned"});
    row("prefers-x", {"boxes"}, {"turned", "swapped"});
    row("prefers-first-box", {"boxes"}, {"shuffled"});
    row("counts-boxes", {"boxes"}, {"doubled"});
    row("stops-by-threshold", {"boxes"}, {"scaled", "law"});
    row("remembers", {"boxes"}, {"fresh", "all_stages"});
    row("obeys-report", {"boxes"}, {"fresh"});
    row("claims-loss", {"boxes"}, {"report"});
    row("claims-rest", {"boxes"}, {"rest", "scaled", "law"});
    row("jumps", {"room"}, {"through", "energy"});
}

void WitnessNotices::aPlantedFaultIsFoundAndNamed() {
    QFETCH(QByteArrayList, kinds);
    QFETCH(QByteArrayList, checks);
    const QByteArray found = firstFinding(QTest::currentDataTag(), kinds);
    QVERIFY2(checks.contains(found), "found: '" + found + "'");
}

QTEST_GUILESS_MAIN(WitnessNotices)
#include "tst_witness_notices.moc"
