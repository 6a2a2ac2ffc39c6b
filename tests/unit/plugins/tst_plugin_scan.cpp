// SPDX-License-Identifier: MIT
// The files that a scan finds, their order, and what it reports about each.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <physics/physics.h>

#include <stdexcept>

namespace {

const QString kGood = QStringLiteral(FIXTURES "/good/good.so");
const QString kOther = QStringLiteral(FIXTURES "/good/other.so");
const QString kRefused = QStringLiteral(FIXTURES "/refused/abi_version.so");

/// One line of a scan: "name: status: text".
void note(void *context, const char *path, phys_status status, const char *text) {
    const QByteArray name = QFileInfo(QString::fromUtf8(path)).fileName().toUtf8();
    static_cast<QByteArrayList *>(context)->append(name + ": " + phys_status_name(status) + ": " + text);
}

QByteArrayList scan(phys_registry *registry, const char *folder) {
    QByteArrayList lines;
    phys_error error{};
    const phys_status status = phys_registry_scan(registry, folder, note, &lines, &error);
    if (status) lines.append(error.text);
    return lines;
}

} // namespace

class PluginScan : public QObject {
    Q_OBJECT

private slots:
    void init() {
        qunsetenv("PHYS_PLUGIN_PATH");
        QCOMPARE(phys_registry_create(&m_registry, nullptr), PHYS_OK);
    }
    void cleanup() { phys_registry_destroy(m_registry); }

    void aFolderIsReadInOrderOfNames();
    void aRefusedFileDoesNotEndTheScan();
    void symbolicLinksCountAsFiles();
    void aLinkToNowhereIsTold();
    void otherFilesAreLeftAlone();
    void aFolderThatIsNotThereIsAnError();
    void theSearchPathIsWalkedInItsOrder();
    void aMissingFolderOfTheSearchPathIsToldAndPassed();
    void pluginsBesideTheLibraryAreFound();
    void anExceptionOfTheListenerStaysInside();
    void aScanNeedsNoListener();
    void aScanWithoutARegistryOnlyListsTheFiles();
    void aTableLongerThanOursLoads();
    void pluginsStayWhenTheirRegistryGoes();
    void aFileThatTookAnotherOnesNameIsRefused();
    void rowsOfAPluginReachTheParameters();

private:
    phys_registry *m_registry = nullptr;
    const uint32_t m_builtIn = phys_registry_count(nullptr);
};

void PluginScan::aFolderIsReadInOrderOfNames() {
    QCOMPARE(scan(m_registry, FIXTURES "/good"),
             (QByteArrayList{"good.so: PHYS_OK: loaded good", "other.so: PHYS_OK: loaded other"}));
    phys_stepper_info info;
    QCOMPARE(phys_registry_info(m_registry, m_builtIn, &info), PHYS_OK);
    QCOMPARE(info.id, "good");
    QCOMPARE(phys_registry_info(m_registry, m_builtIn + 1, &info), PHYS_OK);
    QCOMPARE(info.id, "other");
}

void PluginScan::aRefusedFileDoesNotEndTheScan() {
    const QTemporaryDir folder;
    QVERIFY(QFile::link(kRefused, folder.filePath(QStringLiteral("a.so"))));
    QVERIFY(QFile::link(kGood, folder.filePath(QStringLiteral("b.so"))));
    const QByteArrayList lines = scan(m_registry, folder.path().toUtf8().constData());
    QCOMPARE(lines.size(), 2);
    QVERIFY2(lines[0].startsWith("a.so: PHYS_ERROR_PLUGIN_REFUSED: "), lines[0].constData());
    QVERIFY2(lines[0].endsWith("a.so: abi_version is 2; expected 1"), lines[0].constData());
    QCOMPARE(lines[1], "b.so: PHYS_OK: loaded good");
    QCOMPARE(phys_registry_count(m_registry), m_builtIn + 1);
}

void PluginScan::symbolicLinksCountAsFiles() {
    const QTemporaryDir folder;
    const QByteArray link = folder.filePath(QStringLiteral("link.so")).toUtf8();
    QVERIFY(QFile::link(kGood, QString::fromUtf8(link)));
    QCOMPARE(scan(m_registry, folder.path().toUtf8().constData()), QByteArrayList{"link.so: PHYS_OK: loaded good"});
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(m_registry, "good", &info, nullptr), PHYS_OK);
    QCOMPARE(info.file, link.constData());
}

void PluginScan::aLinkToNowhereIsTold() {
    const QTemporaryDir folder;
    QVERIFY(QFile::link(QStringLiteral("/nowhere/at-all.so"), folder.filePath(QStringLiteral("link.so"))));
    const QByteArrayList lines = scan(m_registry, folder.path().toUtf8().constData());
    QCOMPARE(lines.size(), 1);
    QVERIFY2(lines[0].startsWith("link.so: PHYS_ERROR_FILE: ") && lines[0].endsWith("link.so: no such file"),
             lines[0].constData());
}

void PluginScan::otherFilesAreLeftAlone() {
    const QTemporaryDir folder;
    QVERIFY(QFile::copy(kGood, folder.filePath(QStringLiteral("good.so.1"))));
    QVERIFY(QFile::copy(kGood, folder.filePath(QStringLiteral("good"))));
    QCOMPARE(scan(m_registry, folder.path().toUtf8().constData()), QByteArrayList{});
}

void PluginScan::aFolderThatIsNotThereIsAnError() {
    phys_error error{};
    QCOMPARE(phys_registry_scan(m_registry, "/nowhere/at/all", nullptr, nullptr, &error), PHYS_ERROR_FILE);
    QCOMPARE(error.text, "/nowhere/at/all: expected a folder that can be read");
    QCOMPARE(phys_registry_scan(m_registry, "", nullptr, nullptr, &error), PHYS_ERROR_FILE);
    QCOMPARE(error.text, "folder is empty; expected a folder's name");
}

void PluginScan::theSearchPathIsWalkedInItsOrder() {
    const QTemporaryDir first;
    const QTemporaryDir second;
    QVERIFY(QFile::link(kOther, first.filePath(QStringLiteral("z.so"))));
    QVERIFY(QFile::link(kGood, second.filePath(QStringLiteral("a.so"))));
    qputenv("PHYS_PLUGIN_PATH", (first.path() + QLatin1Char(':') + second.path()).toUtf8());
    QCOMPARE(scan(m_registry, nullptr).mid(0, 2),
             (QByteArrayList{"z.so: PHYS_OK: loaded other", "a.so: PHYS_OK: loaded good"}));
}

void PluginScan::aMissingFolderOfTheSearchPathIsToldAndPassed() {
    qputenv("PHYS_PLUGIN_PATH", ":/nowhere/at/all::" FIXTURES "/good:");
    QCOMPARE(scan(m_registry, nullptr).mid(0, 3),
             (QByteArrayList{"all: PHYS_ERROR_FILE: /nowhere/at/all: a folder of PHYS_PLUGIN_PATH that can't be read",
                             "good.so: PHYS_OK: loaded good", "other.so: PHYS_OK: loaded other"}));
}

void PluginScan::pluginsBesideTheLibraryAreFound() {
    const QDir beside(QStringLiteral(PHYSICS_FOLDER));
    QVERIFY(beside.mkpath(QStringLiteral("physics-1")));
    const QString link = beside.filePath(QStringLiteral("physics-1/tst_plugin_scan.so"));
    QFile::remove(link);
    QVERIFY(QFile::link(kGood, link));
    const QByteArrayList lines = scan(m_registry, nullptr);
    QVERIFY(QFile::remove(link));
    QVERIFY2(lines.contains("tst_plugin_scan.so: PHYS_OK: loaded good"), lines.join('\n').constData());
}

void PluginScan::anExceptionOfTheListenerStaysInside() {
    const auto complain = [](void *, const char *, phys_status, const char *) { throw std::runtime_error("enough"); };
    phys_error error{};
    QCOMPARE(phys_registry_scan(m_registry, FIXTURES "/good", complain, nullptr, &error), PHYS_ERROR_INTERNAL);
    QCOMPARE(error.text, "an exception while plugins were scanned");
}

void PluginScan::aScanNeedsNoListener() {
    QCOMPARE(phys_registry_scan(m_registry, FIXTURES "/good", nullptr, nullptr, nullptr), PHYS_OK);
    QCOMPARE(phys_registry_count(m_registry), m_builtIn + 2);
}

void PluginScan::aScanWithoutARegistryOnlyListsTheFiles() {
    QCOMPARE(scan(nullptr, FIXTURES "/good"), (QByteArrayList{"good.so: PHYS_OK: ", "other.so: PHYS_OK: "}));
    QCOMPARE(scan(nullptr, FIXTURES "/refused").size(), QDir(FIXTURES "/refused").entryList({"*.so"}).size());
    qputenv("PHYS_PLUGIN_PATH", "/nowhere/at/all:" FIXTURES "/good");
    QCOMPARE(scan(nullptr, nullptr).mid(0, 2),
             (QByteArrayList{"all: PHYS_ERROR_FILE: /nowhere/at/all: a folder of PHYS_PLUGIN_PATH that can't be read",
                             "good.so: PHYS_OK: "}));
}

void PluginScan::aTableLongerThanOursLoads() {
    QCOMPARE(phys_registry_load_file(m_registry, kOther.toUtf8().constData(), nullptr), PHYS_OK);
}

void PluginScan::pluginsStayWhenTheirRegistryGoes() {
    phys_registry *other = nullptr;
    QCOMPARE(phys_registry_create(&other, nullptr), PHYS_OK);
    QCOMPARE(phys_registry_load_file(other, kGood.toUtf8().constData(), nullptr), PHYS_OK);
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(other, "good", &info, nullptr), PHYS_OK);
    const char *summary = info.summary; // in the plugin's own memory
    phys_registry_destroy(other);
    QCOMPARE(summary, "Leaves the ball where it is.");
}

/// The system's loader would give the old code for it.
void PluginScan::aFileThatTookAnotherOnesNameIsRefused() {
    const QTemporaryDir folder;
    const QString plugin = folder.filePath(QStringLiteral("mine.so"));
    const QByteArray path = plugin.toUtf8();
    QVERIFY(QFile::copy(kGood, plugin));
    QCOMPARE(phys_registry_load_file(m_registry, path, nullptr), PHYS_OK);
    phys_registry_destroy(m_registry);
    QCOMPARE(phys_registry_create(&m_registry, nullptr), PHYS_OK);
    QCOMPARE(phys_registry_load_file(m_registry, path, nullptr), PHYS_OK); // the same file in another registry
    phys_registry_destroy(m_registry);
    QCOMPARE(phys_registry_create(&m_registry, nullptr), PHYS_OK);
    QVERIFY(QFile::remove(plugin) && QFile::copy(QStringLiteral(FIXTURES "/good/other.so"), plugin));
    phys_error error{};
    QCOMPARE(phys_registry_load_file(m_registry, path, &error), PHYS_ERROR_PLUGIN_REFUSED);
    QVERIFY2(QByteArray(error.text).contains("mine.so: this process has loaded an older file of this name"),
             error.text);
    QVERIFY2(QByteArray(error.text).endsWith("in another process"), error.text);
    const QString renamed = folder.filePath(QStringLiteral("new.so"));
    QVERIFY(QFile::rename(plugin, renamed));
    QCOMPARE(phys_registry_load_file(m_registry, renamed.toUtf8(), nullptr), PHYS_OK);
}

void PluginScan::rowsOfAPluginReachTheParameters() {
    QCOMPARE(phys_registry_load_file(m_registry, kGood.toUtf8().constData(), nullptr), PHYS_OK);
    phys_stepper_info info;
    QCOMPARE(phys_registry_find(m_registry, "good", &info, nullptr), PHYS_OK);
    QCOMPARE(info.row_count, 2U);
    phys_params params;
    phys_params_init(&params, sizeof params);
    params.stepper[5] = 7.0;
    QCOMPARE(phys_stepper_info_init_params(&info, &params), PHYS_OK);
    QCOMPARE(params.stepper[0], 0.5);
    QCOMPARE(phys_param_get(&params, info.rows[1]), 1.0);
    QCOMPARE(params.stepper[5], 0.0);
    phys_error error{};
    QCOMPARE(phys_param_set(&params, info.rows[0], 11.0, &error), PHYS_ERROR_RANGE);
    QCOMPARE(error.text, "air_drag is 11 1/m; allowed is 0 .. 10 1/m");
    QCOMPARE(params.stepper[0], 0.5);
}

QTEST_GUILESS_MAIN(PluginScan)
#include "tst_plugin_scan.moc"
