// SPDX-License-Identifier: MIT
// Where levels are found.
#include "core/setup/levels.h"
#include "inspector/core/scenes.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace inspector;

class TestLevels : public QObject {
    Q_OBJECT

private slots:
    void allLevelsAreFoundInOrderWithTheirMeshes();
    void environmentVariableNamesTheFolder();
    void emptyFolderNameHasNoLevels();
    void numberFindsALevelOfTheList();
    void numberBeyondTheListIsRefused();
    void anythingElseIsAFile();
    void levelWithoutMeshHasNone();
    void onlyMazesAreLevelsAndTwoComesBeforeTen();
    void levelsThatAreNumbersAreCalledByThem();
    void levelsWithoutNumbersAreCounted();
    void theFirstIsNumberOneOrTheFirstOfTheList();
};

void TestLevels::allLevelsAreFoundInOrderWithTheirMeshes() {
    const std::vector<Level> levels = levelsIn(LEVELS_FOLDER);
    QCOMPARE(levels.size(), size_t(levelCount()));
    for (size_t i = 0; i < levels.size(); ++i) {
        QCOMPARE(levels[i].name, QString("%1").arg(i + 1, 2, 10, QChar('0')));
        QCOMPARE(levels[i].path, QString(LEVELS_FOLDER "/%1.txt").arg(levels[i].name));
        QCOMPARE(levels[i].mesh, QString(LEVELS_FOLDER "/%1.obj").arg(levels[i].name));
    }
}

void TestLevels::environmentVariableNamesTheFolder() {
    const QByteArray before = qgetenv("PHYSICS_LEVELS");
    qputenv("PHYSICS_LEVELS", "/somewhere/else");
    QCOMPARE(levelsFolder(), QString("/somewhere/else"));
    qputenv("PHYSICS_LEVELS", before);
}

void TestLevels::emptyFolderNameHasNoLevels() { QVERIFY(levelsIn({}).empty()); }

void TestLevels::numberFindsALevelOfTheList() {
    const std::vector<Level> levels = levelsIn(LEVELS_FOLDER);
    QCOMPARE(findLevel(levels, "1", nullptr)->name, QString("01"));
    QCOMPARE(findLevel(levels, "10", nullptr)->name, QString("10"));
}

void TestLevels::numberBeyondTheListIsRefused() {
    const std::vector<Level> levels = levelsIn(LEVELS_FOLDER);
    for (const int number : {0, levelCount() + 1, -1}) {
        QString error;
        QVERIFY(!findLevel(levels, QString::number(number), &error));
        QCOMPARE(error, QString("expected 1 to %1, found %2").arg(levelCount()).arg(number));
    }
}

void TestLevels::anythingElseIsAFile() {
    const std::optional<Level> level = findLevel({}, "mine/narrow.v2.txt", nullptr);
    QVERIFY(level);
    QCOMPARE(level->path, QString("mine/narrow.v2.txt"));
    QCOMPARE(level->name, QString("narrow.v2"));
}

void TestLevels::levelWithoutMeshHasNone() {
    const QTemporaryDir folder;
    QFile file(folder.filePath("a.txt"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(levelOfFile(file.fileName()).mesh.isEmpty());
}

namespace {

void put(const QTemporaryDir &folder, const QString &name, const QByteArray &bytes) {
    QFile file(folder.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
}

QStringList namesOf(const std::vector<Level> &levels) {
    QStringList names;
    for (const Level &level : levels) names += level.name;
    return names;
}

} // namespace

void TestLevels::onlyMazesAreLevelsAndTwoComesBeforeTen() {
    const QTemporaryDir folder;
    for (const char *name : {"10.txt", "2.txt", "b10.txt", "b9.txt", "b09.txt", "007.txt"})
        put(folder, name, "# mine\nphysics-maze 1\n");
    put(folder, "README.txt", "Levels of mine.\n");
    put(folder, "1.txt.orig", "physics-maze 1\n");
    QVERIFY(QDir(folder.path()).mkdir("3.txt"));
    QCOMPARE(namesOf(levelsIn(folder.path())), QStringList({"2", "007", "10", "b09", "b9", "b10"}));
}

void TestLevels::levelsThatAreNumbersAreCalledByThem() {
    const QTemporaryDir folder;
    for (const char *name : {"2.txt", "007b.txt", "010.txt"}) put(folder, name, "physics-maze 1\n");
    const std::vector<Level> levels = levelsIn(folder.path());
    const std::optional<Level> tenth = findLevel(levels, "10", nullptr);
    QVERIFY(tenth);
    QCOMPARE(tenth->name, QString("010"));
    QCOMPARE(numberOf(*tenth), 10);
    QVERIFY(!numberOf(levelOfFile("007b.txt")));
    QString error;
    QVERIFY(!findLevel(levels, "1", &error));
    QCOMPARE(error, QString("expected a level of 2 to 10, found 1"));
}

void TestLevels::levelsWithoutNumbersAreCounted() {
    const QTemporaryDir folder;
    for (const char *name : {"narrow.txt", "wide.txt"}) put(folder, name, "physics-maze 1\n");
    const std::vector<Level> levels = levelsIn(folder.path());
    QCOMPARE(findLevel(levels, "2", nullptr)->name, QString("wide"));
    QString error;
    QVERIFY(!findLevel(levels, "3", &error));
    QCOMPARE(error, QString("expected 1 to 2, found 3"));
}

void TestLevels::theFirstIsNumberOneOrTheFirstOfTheList() {
    const auto first = [](std::initializer_list<const char *> names) {
        const QTemporaryDir folder;
        for (const char *name : names) put(folder, name, "physics-maze 1\n");
        return firstLevel(levelsIn(folder.path())).name;
    };
    QCOMPARE(first({"2.txt", "3.txt"}), QString("2"));
    QCOMPARE(first({"0.txt", "001.txt", "2.txt"}), QString("001"));
    QCOMPARE(first({"narrow.txt", "wide.txt"}), QString("narrow"));
}

QTEST_GUILESS_MAIN(TestLevels)
#include "tst_levels.moc"
