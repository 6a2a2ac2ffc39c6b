// SPDX-License-Identifier: MIT
// Scenes that failed once, reduced: every stepper keeps every invariant in each, or the check that the case names.
#include <QDirIterator>
#include <QTest>

#include "judge.h"
#include "survey.h"

class WitnessCases : public QObject {
    Q_OBJECT

private slots:
    void aCaseHolds_data();
    void aCaseHolds();

private:
    void open(const QByteArray &path);

    // The cases of one file: rows of all steppers, one after another, share its brute-force motions.
    QByteArray m_path;
    std::vector<witness::Case> m_cases;
    std::vector<std::optional<witness::Truth>> m_truths; // of the cases of the law
};

void WitnessCases::open(const QByteArray &path) {
    if (path == m_path) return;
    m_truths.clear();
    m_path = path;
    m_cases = witness::readCases(path.toStdString());
    for (const witness::Case &scene : m_cases) {
        m_truths.push_back(scene.check == "law" ? witness::Truth::of(scene) : std::nullopt);
    }
}

void WitnessCases::aCaseHolds_data() {
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("stepper");
    QDirIterator files(WITNESS_FOLDER "/seeds", {"*.case"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QByteArray path = files.next().toUtf8();
        for (const std::string &stepper : witness::stepperIds(nullptr)) {
            const QByteArray tag = files.fileName().toUtf8() + ", " + stepper.c_str();
            QTest::newRow(tag.constData()) << path << QByteArray(stepper.c_str());
        }
    }
}

void WitnessCases::aCaseHolds() {
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, stepper);
    open(path);
    for (size_t i = 0; i < m_cases.size(); ++i) {
        const witness::Case &scene = m_cases[i];
        if (scene.check == "law" && !m_truths[i]) continue; // no answer to compare with
        const bool hasToEnd = scene.check == "ends";
        if (hasToEnd && scene.stepper != stepper.toStdString()) continue;
        const witness::Verdict verdict = m_truths[i]
                                             ? witness::judgeLaw(nullptr, stepper.toStdString(), scene, *m_truths[i])
                                             : witness::judge(nullptr, stepper.toStdString(), scene);
        QVERIFY2(verdict.check.empty(), (scene.name + ": " + verdict.check + ": " + verdict.what).c_str());
        if (hasToEnd) QVERIFY2(verdict.status == PHYS_OK, (scene.name + ": " + verdict.statusText).c_str());
    }
}

QTEST_GUILESS_MAIN(WitnessCases)
#include "tst_witness_cases.moc"
