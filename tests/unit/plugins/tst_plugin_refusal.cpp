// SPDX-License-Identifier: MIT
// Each reason to refuse a plugin: the exact line, and an unchanged registry.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <physics/physics.h>

#include <algorithm>

namespace {

QByteArray fixture(const QByteArray &name) { return QByteArray(FIXTURES "/refused/") + name + ".so"; }

/// A message: of a path that is too long, as that of a build folder may be, the end.
QByteArray lineOf(const QByteArray &path, const QByteArray &reason) {
    QByteArray line = path + ": " + reason;
    const qsizetype most = sizeof(phys_error::text) - 1;
    if (line.size() <= most) return line;
    const qsizetype room = std::max<qsizetype>(64, most - reason.size() - 2);
    return path.size() <= room ? line.left(most) : ("..." + path.right(room - 3) + ": " + reason).left(most);
}

void addFixture(const char *name, const char *reason) { QTest::newRow(name) << fixture(name) << QByteArray(reason); }

} // namespace

class PluginRefusal : public QObject {
    Q_OBJECT

private slots:
    void init() { QCOMPARE(phys_registry_create(&m_registry, nullptr), PHYS_OK); }
    void cleanup() { phys_registry_destroy(m_registry); }

    void givesTheReason_data();
    void givesTheReason();
    void aFileThatIsNotThereIsNamed();
    void aFileThatCannotBeReachedIsNotCalledMissing();
    void aFolderIsNoPlugin();
    void aFileThatTheSystemMakesUpIsNotWaitedFor();
    void aTextFileIsRefusedWithTheLoadersReason();
    void aFileThatIsCutOffIsRefusedWhereverItIsCut();
    void aSecondLoadIsTold();
    void nullArgumentsAreNamed();

private:
    phys_registry *m_registry = nullptr;
};

void PluginRefusal::givesTheReason_data() {
    QTest::addColumn<QByteArray>("path");
    QTest::addColumn<QByteArray>("reason");

    addFixture("missing_symbol", "expected the symbol phys_plugin_entry; found none");
    addFixture("abi_version", "abi_version is 2; expected 1");
    addFixture("plugin_size", "struct_size is 23; expected 24 .. 24");
    addFixture("plugin_longer", "struct_size is 32; expected 24 .. 24");
    addFixture("plugin_reserved", "reserved is 7; expected 0");
    addFixture("no_steppers", "stepper_count is 0; expected 1 .. 256");
    addFixture("many_steppers", "stepper_count is 257; expected 1 .. 256");
    addFixture("null_steppers", "steppers is NULL; expected 1 pointers to tables");
    addFixture("null_stepper", "stepper 0: the pointer is NULL; expected a table");
    addFixture("stepper_size", "stepper 0: struct_size is 95; expected 96 .. 96");
    addFixture("stepper_longer", "stepper 0: struct_size is 104; expected 96 .. 96");
    addFixture("null_id", "stepper 0: id is NULL; expected a text");
    addFixture("empty_id", "stepper 0: id is empty; expected a text");
    addFixture("long_id", "stepper 0: id has over 63 bytes; that is the most");
    addFixture("upper_case_id", "stepper 0: id has the byte 0x47; expected lower case letters, digits and '-'");
    addFixture("built_in_id", "stepper 'rk4': the id is taken by a built-in stepper; expected a unique one");
    addFixture("same_id_twice",
               "stepper 'good': the id is that of stepper 0 of this plugin too; expected a unique one");
    addFixture("null_name", "stepper 'good': name is NULL; expected a text");
    addFixture("long_name", "stepper 'good': name has over 127 bytes; that is the most");
    addFixture("empty_version", "stepper 'good': version is empty; expected a text");
    addFixture("null_summary", "stepper 'good': summary is NULL; expected a text");
    addFixture("summary_of_two_lines", "stepper 'good': summary has the byte 0x0a; expected one line of UTF-8 without "
                                       "control characters");
    addFixture("summary_in_latin_1", "stepper 'good': summary has the byte 0xe9; expected one line of UTF-8 without "
                                     "control characters");
    addFixture("unknown_flags", "stepper 'good': flags has the unknown bits 0x10; known bits are 0x3");
    addFixture("plugin_flag", "stepper 'good': flags has the unknown bits 0x4; known bits are 0x3");
    addFixture("stepper_reserved", "stepper 'good': reserved is 3; expected 0");
    addFixture("null_create", "stepper 'good': create is NULL; expected a function");
    addFixture("null_destroy", "stepper 'good': destroy is NULL; expected a function");
    addFixture("null_step", "stepper 'good': step is NULL; expected a function");
    addFixture("many_rows", "stepper 'good': row_count is 9; expected at most 8");
    addFixture("null_rows", "stepper 'good': rows is NULL; expected 2 pointers");
    addFixture("null_row", "stepper 'good': row 0: the pointer is NULL; expected a row");
    addFixture("row_id", "stepper 'good': row 0: id has the byte 0x2d; expected lower case letters, digits and '_'");
    addFixture("row_of_the_library",
               "stepper 'good': row 'rolling_friction': the library has a row of this id; expected another");
    addFixture("row_reserved", "stepper 'good': row 'help': the id is reserved; expected another");
    addFixture("row_id_twice", "stepper 'good': row 'order': row 0 has this id too; expected another");
    addFixture("row_null_label", "stepper 'good': row 0: label is NULL; expected a text");
    addFixture("row_long_unit", "stepper 'good': row 0: unit has over 15 bytes; that is the most");
    addFixture("row_null_help", "stepper 'good': row 0: help is NULL; expected a text");
    addFixture("row_null_choices", "stepper 'good': row 0: choices is NULL; expected a text");
    addFixture("row_help_with_a_tab", "stepper 'good': row 0: help has the byte 0x09; expected one line of UTF-8 "
                                      "without control characters");
    addFixture("row_needless_choices", "stepper 'good': row 0: choices is 'One' though flags don't say choice; "
                                       "expected \"\"");
    addFixture("row_empty_choice", "stepper 'good': row 0: choices has an empty name; expected names separated by \\n");
    // phys_params: gravity at 8, stepper at 80, 144 bytes in all.
    addFixture("row_offset_before", "stepper 'good': row 'air_drag': offset is 8; expected 80 .. 136 in steps of 8: an "
                                    "element of phys_params.stepper");
    addFixture("row_offset_after", "stepper 'good': row 'air_drag': offset is 144; expected 80 .. 136 in steps of 8: "
                                   "an element of phys_params.stepper");
    addFixture("row_offset_askew", "stepper 'good': row 'air_drag': offset is 84; expected 80 .. 136 in steps of 8: an "
                                   "element of phys_params.stepper");
    addFixture("row_offset_twice", "stepper 'good': row 'order': row 0 has the offset 88 too; expected another");
    addFixture("row_not_finite", "stepper 'good': row 'air_drag': max is nan; expected a finite number");
    addFixture("row_initial_outside", "stepper 'good': row 'air_drag': initial is 2 and high is 1; expected min <= low "
                                      "<= initial <= high <= max");
    addFixture("row_slider_outside", "stepper 'good': row 'air_drag': min is 0 and low is -1; expected min <= low <= "
                                     "initial <= high <= max");
    addFixture("row_empty_slider", "stepper 'good': row 'air_drag': low and high are both 0.5; expected a range");
    addFixture("row_no_step", "stepper 'good': row 'air_drag': step is 0; expected a number above 0");
    addFixture("row_flags", "stepper 'good': row 'air_drag': flags has the bits 0x2; allowed bits are 0xd");
    addFixture("row_two_kinds",
               "stepper 'good': row 'air_drag': flags say both choice and switch; expected one of them");
    addFixture("row_switch", "stepper 'good': row 'air_drag': a switch has min 0, initial 0.5, max 10; expected 0, 0 "
                             "or 1, 1");
    addFixture("row_choice", "stepper 'good': row 'air_drag': a choice of 2 names has min 0, initial 1, max 10; "
                             "expected whole numbers from 0 to one less than names");
}

void PluginRefusal::givesTheReason() {
    QFETCH(QByteArray, path);
    QFETCH(QByteArray, reason);
    phys_error error{};
    const uint32_t before = phys_registry_count(m_registry);
    QCOMPARE(phys_registry_load_file(m_registry, path.constData(), &error), PHYS_ERROR_PLUGIN_REFUSED);
    QCOMPARE(QByteArray(error.text), lineOf(path, reason));
    QCOMPARE(error.status, PHYS_ERROR_PLUGIN_REFUSED);
    QCOMPARE(phys_registry_count(m_registry), before);
}

void PluginRefusal::aFileThatIsNotThereIsNamed() {
    phys_error error{};
    QCOMPARE(phys_registry_load_file(m_registry, "/nowhere/at-all.so", &error), PHYS_ERROR_FILE);
    QCOMPARE(error.text, "/nowhere/at-all.so: no such file");
}

void PluginRefusal::aFileThatCannotBeReachedIsNotCalledMissing() {
    phys_error error{};
    const QByteArray name = QByteArray(300, 'x') + ".so";
    QCOMPARE(phys_registry_load_file(m_registry, name.constData(), &error), PHYS_ERROR_FILE);
    QVERIFY2(QByteArray(error.text).endsWith("x.so: File name too long"), error.text);
    QCOMPARE(phys_registry_load_file(m_registry, "/dev/null/at-all.so", &error), PHYS_ERROR_FILE);
    QCOMPARE(error.text, "/dev/null/at-all.so: Not a directory");
}

void PluginRefusal::aFolderIsNoPlugin() {
    phys_error error{};
    QCOMPARE(phys_registry_load_file(m_registry, "/", &error), PHYS_ERROR_FILE);
    QCOMPARE(error.text, "/: not a file");
}

void PluginRefusal::aFileThatTheSystemMakesUpIsNotWaitedFor() {
    for (const char *path : {"/proc/kmsg", "/proc/version"}) {
        phys_error error{};
        QCOMPARE(phys_registry_load_file(m_registry, path, &error), PHYS_ERROR_PLUGIN_REFUSED);
        QVERIFY2(QByteArray(error.text).startsWith(path), error.text);
    }
}

void PluginRefusal::aTextFileIsRefusedWithTheLoadersReason() {
    const QTemporaryDir folder;
    const QByteArray path = folder.filePath(QStringLiteral("text.so")).toUtf8();
    QFile file(QString::fromUtf8(path));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.write("this is no shared object, however long it may be: it has no ELF header at all\n") > 64);
    file.close();
    phys_error error{};
    QCOMPARE(phys_registry_load_file(m_registry, path.constData(), &error), PHYS_ERROR_PLUGIN_REFUSED);
    QCOMPARE(QByteArray(error.text),
             lineOf(path, "expected a shared object that loads; found: " + path + ": invalid ELF header"));
}

/// The system's loader would map pages beyond the end, and the process would end when it touches them.
void PluginRefusal::aFileThatIsCutOffIsRefusedWhereverItIsCut() {
    QFile whole(FIXTURES "/good/good.so");
    QVERIFY(whole.open(QIODevice::ReadOnly));
    const QByteArray bytes = whole.readAll();
    const QTemporaryDir folder;
    int loaded = 0;
    for (qsizetype size = 0; size < bytes.size(); size += 509) {
        const QString path = folder.filePath(QString("%1.so").arg(size));
        QFile cut(path);
        QVERIFY(cut.open(QIODevice::WriteOnly) && cut.write(bytes.left(size)) == size);
        cut.close();
        phys_registry *registry = nullptr;
        QCOMPARE(phys_registry_create(&registry, nullptr), PHYS_OK);
        phys_error error{};
        const phys_status status = phys_registry_load_file(registry, QFile::encodeName(path).constData(), &error);
        phys_registry_destroy(registry);
        if (status == PHYS_OK) {
            ++loaded; // only what no segment needs is missing: debug information, names of sections
            continue;
        }
        QCOMPARE(status, PHYS_ERROR_PLUGIN_REFUSED);
        QVERIFY2(QByteArray(error.text).contains("expected"), error.text);
    }
    QVERIFY(loaded < bytes.size() / 509);
}

void PluginRefusal::aSecondLoadIsTold() {
    const QByteArray path = FIXTURES "/good/good.so";
    QCOMPARE(phys_registry_load_file(m_registry, path.constData(), nullptr), PHYS_OK);
    const uint32_t before = phys_registry_count(m_registry);
    phys_error error{};
    QCOMPARE(phys_registry_load_file(m_registry, path.constData(), &error), PHYS_ERROR_PLUGIN_REFUSED);
    QCOMPARE(QByteArray(error.text), lineOf(path, "is loaded already"));
    QCOMPARE(phys_registry_count(m_registry), before);
}

void PluginRefusal::nullArgumentsAreNamed() {
    phys_error error{};
    QCOMPARE(phys_registry_load_file(nullptr, "x.so", &error), PHYS_ERROR_ARGUMENT);
    QCOMPARE(error.text, "registry is NULL");
    QCOMPARE(phys_registry_load_file(m_registry, nullptr, &error), PHYS_ERROR_ARGUMENT);
    QCOMPARE(error.text, "path is NULL");
    QCOMPARE(phys_registry_load_file(m_registry, "", &error), PHYS_ERROR_FILE);
    QCOMPARE(error.text, "path is empty; expected a file's name");
}

QTEST_GUILESS_MAIN(PluginRefusal)
#include "tst_plugin_refusal.moc"
