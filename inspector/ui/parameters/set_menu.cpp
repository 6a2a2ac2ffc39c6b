// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/set_menu.h"

#include "core/setup/files.h"
#include "ui/files/file_chooser.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parts/described.h"
#include "ui/parts/settings_keys.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QInputDialog>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QUndoCommand>
#include <QUndoStack>
#include <QUrl>

#include <algorithm>
#include <utility>

namespace inspector::ui {

namespace {

const QString kFilter = QStringLiteral(" (*.txt)");
constexpr int kLongestEntry = 40; ///< characters

/// A slash would divide the key.
QString keyOf(QString name) {
    name.replace(QLatin1Char('%'), QLatin1String("%25")).replace(QLatin1Char('/'), QLatin1String("%2F"));
    return settings_keys::kParameterSets + name;
}

QString nameOf(const QString &key) {
    return QUrl::fromPercentEncoding(key.mid(settings_keys::kParameterSets.size()).toUtf8());
}

bool isBuiltIn(const QString &name) { return std::ranges::count(knownSets(), name, &ParameterSet::name) > 0; }

/// Stores a set's text in the settings; an empty one is removed.
class KeptSetCommand : public QUndoCommand {
public:
    KeptSetCommand(QSettings &settings, const QString &name, QString after, const QString &text)
        : QUndoCommand(text)
        , m_settings(settings)
        , m_key(keyOf(name))
        , m_before(settings.value(m_key).toString())
        , m_after(std::move(after)) {}

    void undo() override { store(m_before); }
    void redo() override { store(m_after); }

private:
    void store(const QString &text) { text.isEmpty() ? m_settings.remove(m_key) : m_settings.setValue(m_key, text); }

    QSettings &m_settings;
    QString m_key, m_before, m_after;
};

/// A longer name would put the rest of the menu off the screen.
QString entryOf(const QString &name, const QMenu &menu) {
    const QFontMetrics metrics = menu.fontMetrics();
    QString entry = metrics.elidedText(name, Qt::ElideRight, metrics.averageCharWidth() * kLongestEntry);
    return entry.replace(QLatin1Char('&'), QLatin1String("&&"));
}

QString tipOf(const ParameterSet &set) {
    QString values;
    for (const Setting &setting : set.values) values += QStringLiteral("%1 = %2\n").arg(setting.id).arg(setting.value);
    return wrapped(values + QLatin1Char('\n') + set.about);
}

} // namespace

SetMenu::SetMenu(const Parameters &parameters, QSettings &settings, QUndoStack &undo, std::function<bool()> ghostHasOwn,
                 QWidget *parent)
    : QMenu(parent)
    , m_parameters(parameters)
    , m_settings(settings)
    , m_undo(undo)
    , m_ghostHasOwn(std::move(ghostHasOwn)) {
    setObjectName(QStringLiteral("set_menu"));
    renameKeys();
    connect(this, &QMenu::aboutToShow, this, &SetMenu::fill);
}

/// Earlier versions escaped more.
void SetMenu::renameKeys() {
    for (const QString &key : keys()) {
        const QString now = keyOf(nameOf(key));
        if (now == key) continue;
        m_settings.setValue(now, m_settings.value(key));
        m_settings.remove(key);
    }
}

QStringList SetMenu::keys() const {
    return m_settings.allKeys().filter(QRegularExpression(QLatin1Char('^') + settings_keys::kParameterSets));
}

std::vector<ParameterSet> SetMenu::kept() const {
    std::vector<ParameterSet> sets;
    for (const QString &key : keys()) {
        const QString text = m_settings.value(key).toString();
        std::optional<ParameterSet> set = readSet(text.toUtf8(), key, nullptr);
        if (!set) continue;
        set->name = nameOf(key);
        set->about = tr("Saved by you.");
        sets.push_back(*std::move(set));
    }
    return sets;
}

void SetMenu::fill() {
    clear();
    setToolTipsVisible(true);
    addSets(*this, Owner::Ball);
    addSeparator();
    QMenu *ghosts = addMenu(tr("For the ghost"));
    ghosts->setEnabled(m_ghostHasOwn());
    addSets(*ghosts, Owner::Ghost);
    addSeparator();
    addAction(tr("Save these parameters as…"), this, &SetMenu::askForName)->setObjectName(QStringLiteral("set_save"));
    addDeletions(*addMenu(tr("Delete")));
    addAction(tr("Import…"), this, &SetMenu::askWhatToImport)->setObjectName(QStringLiteral("set_import"));
    addAction(tr("Export…"), this, &SetMenu::askWhereToExport)->setObjectName(QStringLiteral("set_export"));
}

void SetMenu::addSets(QMenu &menu, Owner owner) {
    menu.setToolTipsVisible(true);
    for (const ParameterSet &set : knownSets()) addSet(menu, owner, set);
    const std::vector<ParameterSet> own = kept();
    if (!own.empty()) menu.addSeparator();
    for (const ParameterSet &set : own) addSet(menu, owner, set);
}

void SetMenu::addSet(QMenu &menu, Owner owner, const ParameterSet &set) {
    QAction *use = menu.addAction(entryOf(set.name, menu), this, [this, set, owner] { emit chosen(set, owner); });
    use->setToolTip(tipOf(set));
}

void SetMenu::addDeletions(QMenu &menu) {
    menu.setObjectName(QStringLiteral("set_delete"));
    const std::vector<ParameterSet> own = kept();
    menu.setEnabled(!own.empty());
    for (const ParameterSet &set : own) menu.addAction(entryOf(set.name, menu), this, [this, set] { remove(set); });
}

void SetMenu::askForName() {
    auto *dialog = new QInputDialog(window());
    dialog->setObjectName(QStringLiteral("set_name"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save parameters"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString &typed) {
        const QString name = typed.trimmed();
        keep(presentSet(name, m_parameters), tr("save of %1").arg(entryOf(name, *this)));
    });
    dialog->open(); // makes its buttons
    connect(dialog, &QInputDialog::textValueChanged, dialog,
            [this, dialog](const QString &typed) { judgeName(*dialog, typed.trimmed()); });
    judgeName(*dialog, {});
}

/// Says what the name would do.
void SetMenu::judgeName(QInputDialog &dialog, const QString &name) const {
    const bool replaces = !name.isEmpty() && m_settings.contains(keyOf(name));
    dialog.setLabelText(isBuiltIn(name) ? tr("Name of the set: a built-in one has this")
                        : replaces      ? tr("Name of the set: replaces yours of this")
                                        : tr("Name of the set"));
    QAbstractButton *save = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    save->setText(replaces ? tr("Replace") : tr("Save"));
    save->setEnabled(!name.isEmpty() && !isBuiltIn(name));
}

void SetMenu::keep(const ParameterSet &set, const QString &text) {
    m_undo.push(new KeptSetCommand(m_settings, set.name, QString::fromUtf8(setText(set)), text));
}

void SetMenu::remove(const ParameterSet &set) {
    m_undo.push(new KeptSetCommand(m_settings, set.name, {}, tr("deletion of %1").arg(entryOf(set.name, *this))));
}

void SetMenu::askWhatToImport() {
    chooseFile(*window(), m_settings,
               {tr("Import parameters"), tr("Parameters") + kFilter + tr(";;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { import(path); });
}

/// Also free is the name of the same set.
QString SetMenu::freeName(const QString &wanted, ParameterSet set) const {
    const auto isFree = [&](const QString &name) {
        set.name = name;
        const QString there = m_settings.value(keyOf(name)).toString();
        return !isBuiltIn(name) && (there.isEmpty() || there == QString::fromUtf8(setText(set)));
    };
    QString name = wanted;
    for (int number = 2; !isFree(name); ++number) name = QStringLiteral("%1 %2").arg(wanted).arg(number);
    return name;
}

/// Stores it under its name, or a similar one if another set has that, and applies it.
void SetMenu::import(const QString &path) {
    QString error;
    const std::optional<QByteArray> text = readFile(path, kMegabyte, &error);
    std::optional<ParameterSet> set = text ? readSet(*text, path, &error) : std::nullopt;
    if (!set) return emit failed(error);
    if (set->name.isEmpty()) set->name = QFileInfo(path).completeBaseName();
    set->name = freeName(set->name, *set);
    m_undo.beginMacro(tr("import of %1").arg(entryOf(set->name, *this)));
    keep(*set, {});
    emit chosen(*set, Owner::Ball);
    m_undo.endMacro();
}

void SetMenu::askWhereToExport() {
    chooseFile(*window(), m_settings,
               {tr("Export parameters"), tr("Parameters") + kFilter, tr("parameters.txt"), FileUse::Write},
               [this](const QString &path) { exportTo(path); });
}

void SetMenu::exportTo(const QString &path) {
    QString error;
    const QByteArray text = setText(presentSet(QFileInfo(path).completeBaseName(), m_parameters));
    replaceFile(path, text, &error) ? emit exported(path) : emit failed(error);
}

} // namespace inspector::ui
