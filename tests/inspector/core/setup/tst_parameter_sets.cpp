// SPDX-License-Identifier: MIT
// Named sets of parameters: the built-in ones, which every model accepts, and their text format.
#include "core/setup/parameter_sets.h"
#include "support/compare.h"

#include <QTest>

using namespace inspector;

class TestParameterSets : public QObject {
    Q_OBJECT

private slots:
    void knownSetsAreAllowedInBothModels_data();
    void knownSetsAreAllowedInBothModels();
    void textReadsBackBitByBit();
    void presentSetHasNoTilt();
    void valuesOfAnotherSteppersRowsAreLeftOut();
    void textIsAsPeopleWriteIt();
    void damagedTextGivesOneLine_data();
    void damagedTextGivesOneLine();
};

void TestParameterSets::knownSetsAreAllowedInBothModels_data() {
    QTest::addColumn<int>("index");
    for (size_t i = 0; i < knownSets().size(); ++i) QTest::addRow("%s", qPrintable(knownSets()[i].name)) << int(i);
}

void TestParameterSets::knownSetsAreAllowedInBothModels() {
    QFETCH(int, index);
    const ParameterSet &set = knownSets()[size_t(index)];
    QVERIFY(!set.about.isEmpty());
    for (const double model : {double(PHYS_MODEL_ROLLING), double(PHYS_MODEL_RIGID)}) {
        Parameters parameters;
        QString error;
        QVERIFY(parameters.set({{"model", model}}));
        QVERIFY2(parameters.set(set.values, &error), qPrintable(error));
    }
}

void TestParameterSets::textReadsBackBitByBit() {
    const ParameterSet set{"A & B / ü", {}, {{"rolling_friction", 0.1 + 0.2}, {"gravity", 1e-300}}};
    const std::optional<ParameterSet> read = readSet(setText(set), "file", nullptr);
    QVERIFY(read);
    QCOMPARE(read->name, set.name);
    QCOMPARE(read->values, set.values);
}

void TestParameterSets::presentSetHasNoTilt() {
    Parameters parameters;
    QVERIFY(parameters.set({{"tilt_x", 3.0}, {"gravity", 1.62}}));
    const ParameterSet set = presentSet("moon", parameters);
    QCOMPARE(set.values.size(), size_t(parameters.count()) - 2);
    QCOMPARE(set.values.front(), (Setting{"gravity", 1.62}));
}

void TestParameterSets::valuesOfAnotherSteppersRowsAreLeftOut() {
    const ParameterSet set{"", {}, {{"gravity", 3.0}, {"nobody_has_this", 1.0}}};
    QCOMPARE(valuesFor(Parameters(), set), (std::vector<Setting>{{"gravity", 3.0}}));
}

void TestParameterSets::textIsAsPeopleWriteIt() {
    const QByteArray text = "physics-parameters 1\r\n\r\n# mine\r\nname  my  ball \r\n  set gravity 9,81\r\n";
    const std::optional<ParameterSet> read = readSet(text, "file", nullptr);
    QVERIFY(read);
    QCOMPARE(read->name, QString("my ball"));
    QCOMPARE(read->values, (std::vector<Setting>{{"gravity", 9.81}}));
}

void TestParameterSets::damagedTextGivesOneLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("line");
    QTest::newRow("another kind of file")
        << QByteArray("box 0 0 0 1 1 1\n") << "p.txt:1: expected 'physics-parameters 1', found 'box 0 0 0 1 1 1'";
    QTest::newRow("no number") << QByteArray("physics-parameters 1\nset gravity strong\n")
                               << "p.txt:2: expected a number, found 'strong'";
    QTest::newRow("a byte order mark")
        << QByteArray("\xef\xbb\xbfphysics-parameters 1\nset gravity 3\n")
        << "p.txt:1: expected 'physics-parameters 1', found a byte order mark (BOM) before "
           "it; save the file without";
    QTest::newRow("twice") << QByteArray("physics-parameters 1\nset gravity 3\nset gravity 4\n")
                           << "p.txt:3: expected each parameter once, found 'set gravity 4'";
    QTest::newRow("no word") << QByteArray("physics-parameters 1\nname x\ngravity 3\n")
                             << "p.txt:3: expected 'set PARAMETER NUMBER', found 'gravity 3'";
}

void TestParameterSets::damagedTextGivesOneLine() {
    QFETCH(QByteArray, text);
    QFETCH(QString, line);
    QString error;
    QVERIFY(!readSet(text, "p.txt", &error));
    QCOMPARE(error, line);
}

QTEST_GUILESS_MAIN(TestParameterSets)
#include "tst_parameter_sets.moc"
