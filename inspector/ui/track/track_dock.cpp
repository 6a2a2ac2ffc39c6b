// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/track/track_dock.h"

#include "core/program/fit_command.h"
#include "core/program/outputs.h"
#include "core/setup/files.h"
#include "core/setup/lines.h"
#include "core/track/fit_report.h"
#include "core/track/track_reader.h"
#include "ui/files/file_box.h"
#include "ui/files/file_chooser.h"
#include "ui/parameters/parameter_command.h"
#include "ui/parts/described.h"
#include "ui/parts/flow_layout.h"
#include "ui/parts/path_icon.h"
#include "ui/parts/settings_keys.h"
#include "ui/parts/settings_text.h"
#include "ui/parts/text_box.h"
#include "ui/plots/plot_file.h"
#include "ui/track/fit_table.h"
#include "ui/track/residual_plot.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QUndoStack>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace inspector::ui {

TrackDock::TrackDock(Session &session, QUndoStack &undo, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_undo(undo)
    , m_quantities(new FitTable)
    , m_report(new QPlainTextEdit)
    , m_residuals(new ResidualPlot)
    , m_results(new QSplitter)
    , m_halves(new QSplitter) {
    setObjectName(QStringLiteral("track"));
    m_report->setObjectName(QStringLiteral("track_report"));
    m_report->setAccessibleName(tr("Result of the fit"));
    m_report->setReadOnly(true);
    m_report->setFocusPolicy(Qt::ClickFocus);
    m_report->setPlaceholderText(
        tr("A table of a measured ball, with columns t, x, y and, if measured, tilt_x, tilt_y: the fit finds the "
           "friction, the restitution, the tilt's offset and delay with which the computed ball rolls like it."));
    m_results->addWidget(m_report);
    m_results->addWidget(m_residuals);
    m_halves->addWidget(m_quantities);
    m_halves->addWidget(m_results);
    for (QSplitter *splitter : {m_halves, m_results}) splitter->setChildrenCollapsible(false);
    arrange(Qt::Horizontal);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 6);
    layout->addWidget(makeControls());
    layout->addWidget(m_halves, 1);
    connect(m_fit, &QPushButton::clicked, this, &TrackDock::toggle);
    connect(m_takeOver, &QPushButton::clicked, this, &TrackDock::takeOver);
    connect(m_file, &QLineEdit::textChanged, this, &TrackDock::showRunning);
    connect(&m_worker, &FitWorker::progressed, this,
            [this](double share) { m_progress->setValue(int(share * m_progress->maximum())); });
    connect(&m_worker, &FitWorker::ended, this, &TrackDock::showOutcome);
    for (const TextBox *typed : {static_cast<TextBox *>(m_file), m_units})
        connect(typed, &QLineEdit::returnPressed, this, &TrackDock::openTrack);
    connect(m_follow, &QPushButton::clicked, this, &TrackDock::follow);
    QSettings &settings = session.settings();
    m_quantities->want(settings.value(settings_keys::kFitQuantities, usualFitQuantities()).toString());
    connect(m_quantities, &FitTable::wantedChanged, this,
            [this, &settings] { settings.setValue(settings_keys::kFitQuantities, m_quantities->words()); });
    const auto showBegin = [this] { m_quantities->showBegin(m_session.parameters().inputs()); };
    connect(&session.parameters(), &Parameters::changed, this, showBegin);
    connect(&session.parameters(), &Parameters::changed, this, &TrackDock::showConditions);
    connect(m_quantities, &FitTable::typed, this, &TrackDock::showConditions);
    connect(&session, &Session::trackChanged, this, &TrackDock::showRunning);
    connect(&session, &Session::levelOpened, this, &TrackDock::showLevel);
    showBegin();
    showRunning();
}

/// Report and residuals are beside each other, or above each other where the table would have no room for its numbers.
void TrackDock::arrange(Qt::Orientation orientation) {
    m_results->setOrientation(orientation);
    const bool isWide = orientation == Qt::Horizontal;
    m_halves->setSizes(isWide ? QList<int>{420, 580} : QList<int>{660, 340}); // per mille
    m_results->setSizes(isWide ? QList<int>{466, 534} : QList<int>{400, 600});
}

void TrackDock::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    constexpr int kNarrow = 44; // lines of text
    const Qt::Orientation wanted = width() < kNarrow * fontMetrics().height() ? Qt::Vertical : Qt::Horizontal;
    if (m_results->orientation() != wanted) arrange(wanted);
}

QWidget *TrackDock::makeControls() {
    m_file = new FileBox;
    m_file->setObjectName(QStringLiteral("track_file"));
    m_file->setPlaceholderText(tr("Table with columns t, x, y"));
    describe(m_file, tr("Table of the measured ball"),
             tr("A file with columns t, x, y and, if measured, tilt_x, tilt_y"));
    connect(m_file, &FileBox::chooseWanted, this, &TrackDock::chooseTrackFile);
    m_units = new TextBox;
    m_units->setObjectName(QStringLiteral("track_units"));
    m_units->setPlaceholderText(tr("Units: t=ms, x=mm, px=0.25mm, fps=60, mirror=y"));
    describe(m_units, tr("Units of the table"), tr("What the names of the columns don't say"));
    connect(m_units, &QLineEdit::textEdited, this, [this] { m_units->setRefused(false); });
    m_fit = new QPushButton(tr("Fit"));
    m_fit->setObjectName(QStringLiteral("track_fit"));
    describe(m_fit, {}, tr("Find the board on which the computed ball rolls like the measured one"));
    m_follow = new QPushButton(tr("Roll along"));
    m_follow->setObjectName(QStringLiteral("track_follow"));
    m_follow->setCheckable(true);
    describe(m_follow, {}, tr("Start where the measured ball started, under the tilts of its table"));
    m_takeOver = new QPushButton(tr("Use these"));
    m_takeOver->setObjectName(QStringLiteral("track_take_over"));
    describe(m_takeOver, tr("Use what was found"),
             tr("Set model and coefficients to what the fit has found, and the others to what it assumed"));
    m_progress = new QProgressBar;
    m_progress->setRange(0, 1000);
    m_progress->setAccessibleName(tr("Progress of the fit"));
    m_save = new QToolButton;
    m_save->setObjectName(QStringLiteral("track_save"));
    m_save->setIcon(glyphIcon(Glyph::Save));
    m_save->setAutoRaise(true);
    describe(m_save, tr("Save the fit"), tr("Save as CSV, PNG or PDF…"));
    connect(m_save, &QToolButton::clicked, this, &TrackDock::saveWanted);
    for (QAbstractButton *button : std::initializer_list<QAbstractButton *>{m_fit, m_follow, m_takeOver, m_save})
        button->setFocusPolicy(Qt::TabFocus); // a click doesn't take the keyboard from the game
    return flowOf({m_file, m_units, m_fit, m_save, m_progress, m_takeOver, m_follow});
}

void TrackDock::chooseTrackFile() {
    chooseFile(*this, m_session.settings(),
               {tr("A measured ball"), tr("Tables (*.csv *.txt *.tsv);;All files (*)"), {}, FileUse::Read},
               [this](const QString &path) { open(path, m_units->text()); });
}

/// If it is refused, the names of the open one come back.
bool TrackDock::open(const QString &path, const QString &units) {
    const QString fileBefore = m_file->text();
    const QString unitsBefore = m_units->text();
    m_file->setText(path);
    m_units->setText(units);
    if (openTrack()) return true;
    if (!m_track) return false;
    m_file->setText(fileBefore);
    m_units->setText(unitsBefore);
    return false;
}

QString TrackDock::units() const { return m_units->text(); }

void TrackDock::setFrame(const TrackFrame &frame) {
    m_quantities->setFrame(frame);
    m_quantities->showBegin(m_session.parameters().inputs());
}

/// A refused one takes nothing away from the open one.
bool TrackDock::openTrack() {
    QString error;
    const std::optional<TrackUnits> units = parseTrackUnits(m_units->text(), &error);
    std::optional<Track> track = units ? readTrackFile(m_file->path(), *units, &error) : std::nullopt;
    m_units->setRefused(!units);
    if (!track) {
        m_report->setPlainText((QStringList(error) + reportLines()).join(QLatin1Char('\n')));
        return false;
    }
    forgetFit();
    m_track = std::move(track);
    m_level = oneLine(m_session.level().name);
    emit opened(m_file->path());
    layOver(m_quantities->begin(m_session.parameters().inputs()));
    showReport();
    return true;
}

/// About the open track or its fit, which begins with what it assumed where that isn't set any more.
QStringList TrackDock::reportLines() const {
    if (!m_track || !m_session.track()) return {};
    if (!m_outcome || !m_outcome->fit) {
        const TrackFrame frame = m_quantities->begin(m_session.parameters().inputs()).frame;
        return trackReport(*m_track, frame, m_session.scene().get());
    }
    QStringList lines = fitSummary(m_outcome->plan, *m_outcome->fit);
    if (const QString others = othersText(); !others.isEmpty())
        lines.prepend(tr("Found with other parameters than are set now: %1.").arg(others));
    return lines;
}

void TrackDock::showReport() { m_report->setPlainText(reportLines().join(QLatin1Char('\n'))); }

/// With what a fit has found, if there is one.
void TrackDock::showAnew() {
    const ModelFit *fit = m_outcome && m_outcome->fit ? &m_outcome->fit->best() : nullptr;
    if (!m_session.isFollowingTrack()) layOver(fit ? fit->board : m_quantities->begin(m_session.parameters().inputs()));
    if (fit) m_quantities->showFound(*fit);
    if (fit) m_residuals->show(*fit, m_outcome->fit->noise);
    showReport();
}

void TrackDock::layOver(const BoardParameters &board) {
    m_session.showTrack(std::make_shared<ShownTrack>(*m_track, board, usualBegin(*m_track)));
}

/// Follows the track from time 0 on, with the fitted board if there is one.
void TrackDock::follow(bool isOn) {
    if (isOn && m_track) {
        const ModelFit *fit = m_outcome && m_outcome->fit ? &m_outcome->fit->best() : nullptr;
        const BoardParameters board = fit ? fit->board : m_quantities->begin(m_session.parameters().inputs());
        m_session.showTrack(std::make_shared<ShownTrack>(*m_track, board, 0.0, fit ? fit->start() : std::nullopt));
    }
    m_session.followTrack(isOn);
    showRunning();
}

void TrackDock::forgetFit() {
    m_outcome.reset();
    hideFit();
}

void TrackDock::hideFit() {
    m_worker.cancel();
    m_quantities->forgetFound();
    m_residuals->clear();
}

/// While the past of another level is shown the fit is hidden with its track.
void TrackDock::showLevel() {
    const bool isOfOther = m_outcome && m_session.track() && m_outcome->plan.scene != m_session.scene();
    isOfOther ? forgetFit() : hideFit();
    showRunning();
    if (!m_track) return;
    if (m_session.track()) return showAnew();
    m_report->setPlainText(
        tr("%1 lies over level %2 and is shown there. Enter in the file's box opens it for this one.")
            .arg(oneLine(QFileInfo(m_track->name).fileName()), m_level));
}

void TrackDock::showRunning() {
    const bool runs = m_worker.isRunning();
    m_fit->setText(runs ? tr("Cancel") : tr("Fit"));
    m_fit->setEnabled(runs || m_file->isOfFile());
    m_progress->setVisible(runs);
    m_follow->setEnabled(m_session.track() && m_session.track()->hasTilts());
    m_follow->setChecked(m_session.isFollowingTrack());
    m_takeOver->setEnabled(!runs && !found().empty());
}

void TrackDock::toggle() {
    if (m_worker.isRunning()) {
        m_worker.cancel();
        m_report->setPlainText(tr("Cancelled."));
        return showRunning();
    }
    if (const QString wrong = m_quantities->refusal(); !wrong.isEmpty()) return m_report->setPlainText(wrong);
    if (!openTrack()) return;
    std::vector<FitQuantity> wanted = m_quantities->wanted();
    if (wanted.empty()) return m_report->setPlainText(tr("Nothing is chosen to look for."));
    m_report->appendPlainText(tr("Fitting…"));
    m_progress->setValue(0);
    m_assumed = boardSettings(m_session.parameters());
    m_begunWith.level = m_session.level();
    m_begunWith.settings = m_assumed;
    m_begunWith.fit.track = m_track->name;
    m_begunWith.fit.unitWords = m_units->text();
    std::erase_if(m_assumed, [&wanted](const Setting &setting) {
        return std::ranges::count(wanted, setting.id, &FitQuantity::id) > 0;
    });
    m_worker.start({m_session.registry(),
                    m_session.scene(),
                    *m_track,
                    m_quantities->begin(m_session.parameters().inputs()),
                    std::move(wanted),
                    {}});
    showRunning();
}

void TrackDock::showOutcome(const std::shared_ptr<const FitOutcome> &outcome) {
    m_outcome = outcome;
    showRunning();
    if (!outcome->fit) return m_report->setPlainText(outcome->error);
    m_shownOthers = othersText();
    m_session.followTrack(false);
    showAnew();
}

/// What the fit took for true and isn't set any more.
QString TrackDock::othersText() const {
    const Parameters &parameters = m_session.parameters();
    QStringList others{settingsText(parameters, differingFrom(parameters, m_assumed)),
                       m_quantities->othersOf(m_outcome->plan)};
    others.removeAll(QString());
    return others.join(QStringLiteral(", "));
}

/// Tilts change parameters 60 times a second, which is nothing to a fit.
void TrackDock::showConditions() {
    if (!m_outcome || !m_outcome->fit) return;
    const QString others = othersText();
    if (others != std::exchange(m_shownOthers, others)) showReport();
}

/// Nothing if there is no result.
std::vector<Setting> TrackDock::found() const {
    if (!m_session.track() || !m_outcome || !m_outcome->fit) return {};
    std::vector<Setting> settings = fittedSettings(*m_outcome->fit);
    if (settings.empty()) return {};
    const std::vector<Setting> assumed = differingFrom(m_session.parameters(), m_assumed);
    settings.insert(settings.end(), assumed.begin(), assumed.end());
    return settings;
}

bool TrackDock::save(const QString &path, QString *error) {
    if (!m_outcome || !m_outcome->fit) {
        *error = tr("%1: nothing has been fitted yet").arg(path);
        return false;
    }
    if (!path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive))
        return savePlot(*m_residuals, m_residuals->size().expandedTo(kLeastPlotSize), path, error);
    const FitPlan &plan = m_outcome->plan;
    const QStringList report =
        fitReport(plan, *m_outcome->fit) + QStringList("options: " + fitOptions(*m_outcome->fit));
    return replaceFile(path, fitCsv(m_outcome->fit->best()), error) &&
           replaceFile(settingsFileOf(path), fitSettings(m_begunWith, plan, report), error);
}

void TrackDock::takeOver() {
    Parameters &parameters = m_session.parameters();
    const std::vector<Setting> after = found();
    std::vector<Setting> before;
    before.reserve(after.size());
    for (const Setting &setting : after)
        before.push_back({setting.id, parameters.value(parameters.indexOf(setting.id))});
    QString error;
    if (!parameters.set(after, &error)) return m_report->appendPlainText(error);
    static int gesture = -1; // negative, because the user's edits count upwards
    m_undo.push(new ParameterCommand(parameters, before, after, gesture--, tr("values of a measured ball")));
}

} // namespace inspector::ui
