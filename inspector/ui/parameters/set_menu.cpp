// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameters/set_menu.h"

#include "core/setup/files.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parts/file_chooser.h"
#include "ui/parts/settings_keys.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QInputDialog>
#include <QPushButton>
#include <QSettings>
#include <QUndoCommand>
#include <QUndoStack>
#include <QUrl>

#include <utility>

namespace inspector::ui {

namespace {

const QString kFilter = QStringLiteral(" (*.txt)");
constexpr int kLongestEntry = 40; ///< characters

/// Escapes a name, which may contain the separator of keys.
QString keyOf(const QString &name) {
    return settings_keys::kParameterSets + QString::fromLatin1(QUrl::toPercentEncoding(name));
}

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
    for (const Setting &setting : set.values)
        values += QStringLiteral("%1 = %2<br>").arg(setting.id.toHtmlEscaped()).arg(setting.value);
    return QStringLiteral("<p>%1</p><p>%2</p>").arg(values, set.about.toHtmlEscaped());
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
    connect(this, &QMenu::aboutToShow, this, &SetMenu::fill);
}

std::vector<ParameterSet> SetMenu::kept() const {
    std::vector<ParameterSet> sets;
    const QString group = settings_keys::kParameterSets;
    for (const QString &key : m_settings.allKeys()) {
        if (!key.startsWith(group)) continue;
        const QString text = m_settings.value(key).toString();
        std::optional<ParameterSet> set = readSet(text.toUtf8(), key, nullptr);
        if (!set) continue;
        set->name = QUrl::fromPercentEncoding(key.mid(group.size()).toLatin1());
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
    dialog->setLabelText(tr("Name of the set"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString &name) {
        keep(presentSet(name.trimmed(), m_parameters), tr("save of %1").arg(name.trimmed()));
    });
    dialog->open(); // makes its buttons
    auto *buttons = dialog->findChild<QDialogButtonBox *>();
    const auto needName = [buttons](const QString &name) {
        buttons->button(QDialogButtonBox::Ok)->setEnabled(!name.trimmed().isEmpty());
    };
    connect(dialog, &QInputDialog::textValueChanged, buttons, needName);
    needName({});
}

void SetMenu::keep(const ParameterSet &set, const QString &text) {
    m_undo.push(new KeptSetCommand(m_settings, set.name, QString::fromUtf8(setText(set)), text));
}

void SetMenu::remove(const ParameterSet &set) {
    m_undo.push(new KeptSetCommand(m_settings, set.name, {}, tr("deletion of %1").arg(set.name)));
}

void SetMenu::askWhatToImport() {
    chooseFile(*window(), m_settings,
               {tr("Import parameters"), tr("Parameters") + kFilter + tr(";;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { import(path); });
}

/// Stores it under its name, and applies it.
void SetMenu::import(const QString &path) {
    QString error;
    const std::optional<QByteArray> text = readFile(path, kMegabyte, &error);
    std::optional<ParameterSet> set = text ? readSet(*text, path, &error) : std::nullopt;
    if (!set) return emit failed(error);
    if (set->name.isEmpty()) set->name = QFileInfo(path).completeBaseName();
    m_undo.beginMacro(tr("import of %1").arg(set->name));
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
