// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trade/trade_dock.h"

#include "core/setup/tables.h"
#include "core/trade/trade_answer.h"
#include "core/trade/trade_table.h"
#include "ui/parts/board_vector.h"
#include "ui/parts/described.h"
#include "ui/parts/elided_label.h"
#include "ui/parts/empty_text.h"
#include "ui/parts/flow_layout.h"
#include "ui/parts/number_box.h"
#include "ui/parts/path_icon.h"
#include "ui/parts/settings_keys.h"
#include "ui/parts/settings_text.h"
#include "ui/parts/stepping_command.h"
#include "ui/parts/text_box.h"
#include "ui/parts/theme.h"
#include "ui/parts/turning_splitter.h"
#include "ui/trade/schedule_chooser.h"
#include "ui/trade/trade_chart.h"
#include "ui/trade/trade_table_model.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace inspector::ui {

namespace {

/// The slider counts twentieths of a decade between a nanometre and a decimetre; 0 is 1 mm.
constexpr int kPerDecade = 20;
constexpr int kFinestTolerance = -6 * kPerDecade;
constexpr int kCoarsestTolerance = 2 * kPerDecade;
constexpr int kChartPeriod = 200; ///< ms
constexpr int kNarrowTrade = 40;  ///< lines of text

template<typename Widget>
Widget *named(Widget *widget, const char *name) {
    widget->setObjectName(QLatin1String(name));
    return widget;
}

/// A widget with words before and after it that stay beside it.
QWidget *between(const QString &before, QWidget *widget, const QString &after) {
    auto *group = new QWidget;
    auto *layout = new QHBoxLayout(group);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new QLabel(before));
    layout->addWidget(widget);
    if (!after.isEmpty()) layout->addWidget(new QLabel(after));
    return group;
}

/// Cost, error, and what makes a setting unfit.
QStringList usualColumns() {
    return {QStringLiteral("cpu_per_second [us]"), QStringLiteral("position_largest [R]"),
            QStringLiteral("share_of_unknown [%]"), QStringLiteral("wrong_impacts")};
}

bool isSameBoard(const Scene &a, const Scene &b) {
    if (a == b) return true; // else it may have been read again
    phys_state starts[2];
    const uint32_t count = phys_scene_box_count(a.get());
    return phys_scene_radius(a.get()) == phys_scene_radius(b.get()) && count == phys_scene_box_count(b.get()) &&
           std::memcmp(phys_scene_boxes(a.get()), phys_scene_boxes(b.get()), count * sizeof(phys_box)) == 0 &&
           phys_scene_start(a.get(), &starts[0]) == PHYS_OK && phys_scene_start(b.get(), &starts[1]) == PHYS_OK &&
           toGlm(starts[0].position) == toGlm(starts[1].position);
}

} // namespace

TradeDock::TradeDock(Session &session, QUndoStack &undo, QWidget *parent)
    : QWidget(parent)
    , m_session(session)
    , m_undo(undo)
    , m_chart(new TradeChart)
    , m_rows(new TradeTableModel(this))
    , m_sorted(new QSortFilterProxyModel(this)) {
    setObjectName(QStringLiteral("trade"));
    makeControls();
    leaveKeysToTheGame();
    makeTable();
    auto *halves = new TurningSplitter(kNarrowTrade, {400, 600}, {400, 600}); // per mille
    halves->addWidget(m_chart);
    halves->addWidget(makeAnswers());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 6);
    layout->addWidget(makeTop());
    layout->addWidget(makeUnknowns());
    layout->addWidget(m_unknownsError);
    layout->addWidget(halves, 1);

    connect(m_schedule, &ScheduleChooser::changed, this, &TradeDock::showReady);
    connect(m_measure, &QPushButton::clicked, this, &TradeDock::toggle);
    connect(m_save, &QToolButton::clicked, this, &TradeDock::saveWanted);
    connect(m_model, &QComboBox::currentIndexChanged, this, &TradeDock::showResult);
    connect(&m_worker, &TradeWorker::changed, &m_refresh, [this] {
        if (!m_refresh.isActive()) m_refresh.start(kChartPeriod);
    });
    m_refresh.setSingleShot(true);
    connect(&m_refresh, &QTimer::timeout, this, &TradeDock::showResult);
    connect(&m_worker, &TradeWorker::progressed, this, &TradeDock::showProgress);
    connect(&m_worker, &TradeWorker::ended, this, &TradeDock::showEnd);
    connect(m_chart, &TradeChart::chosen, this, &TradeDock::choose);
    connect(m_tolerance, &QSlider::valueChanged, this, &TradeDock::showTolerance);
    connect(m_use, &QPushButton::clicked, this, qOverload<>(&TradeDock::use));
    connect(m_useGoodEnough, &QPushButton::clicked, this, &TradeDock::useGoodEnough);
    connect(m_unknowns, &QLineEdit::textChanged, this, &TradeDock::showReady);
    connect(m_unknowns, &QLineEdit::textChanged, this, &TradeDock::showChangedWish);
    for (NumberBox *box : {m_share, m_horizon}) connect(box, &NumberBox::entered, this, &TradeDock::showChangedWish);
    connect(&session, &Session::levelOpened, this, &TradeDock::changeLevel);
    connect(&session.parameters(), &Parameters::changed, this, &TradeDock::showConditions);
    showTolerance();
    showReady();
}

void TradeDock::makeControls() {
    m_measure = named(new QPushButton(tr("Measure")), "trade_measure");
    describe(m_measure, {}, tr("Measure what every stepper and step size costs, and how far off it is"));
    m_save = named(new QToolButton, "trade_save");
    m_save->setIcon(glyphIcon(Glyph::Save));
    m_save->setAutoRaise(true);
    describe(m_save, tr("Save the figures"), tr("Save as CSV, PNG, PDF or SVG…"));
    m_schedule = new ScheduleChooser(m_session.settings());
    m_duration = named(new NumberBox, "trade_duration");
    m_duration->setKind(numberKind({0.5, 600.0, QStringLiteral("s")}, 1.0));
    m_duration->setValue(kTradeDuration);
    describe(m_duration, tr("Duration"), tr("Simulated time, at most"));
    m_model = named(new QComboBox, "trade_model");
    m_model->addItems({tr("Rolling model"), tr("Rigid model")}); // in the order of their numbers
    describe(m_model, tr("Model"), tr("The model whose figures are shown"));
    m_unknowns = named(new TextBox(usualUnknowns()), "trade_unknowns");
    m_unknowns->home(false); // show its beginning
    describe(m_unknowns, tr("Not known"),
             tr("What isn't known exactly of the real board, and by how much: tilt, start or a parameter by its name; "
                "none: nothing"));
    m_unknownsError = named(new QLabel, "trade_unknowns_error");
    m_unknownsError->setWordWrap(true);
    m_unknownsError->setTextFormat(Qt::PlainText);
    (new AlarmText(*m_unknownsError, QPalette::WindowText))->setOn(true);
    m_horizon = named(new NumberBox, "trade_horizon");
    m_horizon->setKind(numberKind({0.1, 60.0, QStringLiteral("s")}, 0.1));
    m_horizon->setValue(kTradeHorizon);
    describe(m_horizon, tr("Horizon"), tr("How far ahead a setting has to be good enough"));
    m_share = named(new NumberBox, "trade_share");
    m_share->setKind(numberKind({1.0, 100.0, QStringLiteral("%")}, 1.0));
    m_share->setValue(25.0);
    describe(m_share, tr("Share of what isn't known"),
             tr("Errors below this share of what isn't known are good enough"));
    for (NumberBox *box : {m_duration, m_horizon, m_share}) {
        box->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        connect(box, &NumberBox::entered, box, &NumberBox::setValue);
    }
    m_goodEnough = named(new QLabel, "trade_good_enough");
    m_goodEnough->setText(tr("Good enough for what isn't known: not measured yet"));
    m_useGoodEnough = named(new QPushButton(tr("Use this")), "trade_use_good_enough");
    describe(m_useGoodEnough, tr("Use the cheapest setting that is good enough"),
             tr("Let the simulation go on with the cheapest setting that is good enough"));
    m_useGoodEnough->setEnabled(false);
    m_progress = named(new QProgressBar, "trade_progress");
    m_progress->setRange(0, 1000);
    m_progress->setAccessibleName(tr("Progress of the measurement"));
    m_progress->setVisible(false);
    m_remark = named(new ElidedLabel, "trade_remark");
    m_remark->setText(remark());
    m_tolerance = named(new QSlider(Qt::Horizontal), "trade_tolerance");
    m_tolerance->setRange(kFinestTolerance, kCoarsestTolerance);
    m_tolerance->setPageStep(kPerDecade);
    describe(m_tolerance, tr("Accepted error"),
             tr("The largest error that is accepted; the cheapest setting below it is chosen"));
    m_toleranceText = named(new QLabel, "trade_tolerance_text");
    m_toleranceText->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Error under 8.9e-05 mm = 8.9e-05 R")));
    m_answer = named(new QLabel, "trade_answer");
    for (QLabel *label : {m_goodEnough, m_answer}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    m_use = named(new QPushButton(tr("Use this")), "trade_use");
    describe(m_use, {}, tr("Let the simulation go on with the chosen stepper, step size and model"));
    m_use->setEnabled(false);
}

/// Radius of the measured ball; before a measurement, of the open level's. m
double TradeDock::radius() const {
    const Scene &measured = m_worker.plan().scene;
    return phys_scene_radius((measured ? measured : m_session.scene()).get());
}

QString TradeDock::answerText(const TradePoint &point, double seconds) const {
    return tr("Cheapest: %1 at %2, off by %3 mm in the first %4 s of each schedule; %5 µs of CPU a second")
        .arg(nameOf(point), stepSizeText(point.dt))
        .arg(errorUntil(point, seconds) * radius() * 1e3, 0, 'g', 2)
        .arg(seconds, 0, 'g', 3)
        .arg(point.cost.perSecond * 1e6, 0, 'g', 3);
}

/// A click on one of these doesn't take the keyboard from the game.
void TradeDock::leaveKeysToTheGame() {
    for (QWidget *widget :
         {static_cast<QWidget *>(m_measure), static_cast<QWidget *>(m_save), static_cast<QWidget *>(m_model),
          static_cast<QWidget *>(m_tolerance), static_cast<QWidget *>(m_use), static_cast<QWidget *>(m_useGoodEnough)})
        widget->setFocusPolicy(Qt::TabFocus);
}

QWidget *TradeDock::makeTop() {
    m_remark->setMinimumWidth(fontMetrics().averageCharWidth() * 30);
    return flowOf({m_measure, m_save, m_schedule, m_duration, m_model, m_progress, m_remark});
}

QWidget *TradeDock::makeUnknowns() {
    auto *label = new QLabel(tr("&Not known:"));
    label->setBuddy(m_unknowns);
    m_unknowns->setMinimumWidth(fontMetrics().averageCharWidth() * 30);
    return flowOf(
        {label, m_unknowns, between(tr("error below"), m_share, tr("of it")), between(tr("for"), m_horizon, {})});
}

/// The table and, below it, what to use; the chart beside them has the whole height.
QWidget *TradeDock::makeAnswers() {
    auto *answers = new QWidget;
    answers->setMinimumWidth(280); // beside the chart less than kNarrowTrade, else the splitter would never turn
    auto *grid = new QGridLayout(answers);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->addWidget(m_table, 0, 0, 1, 3);
    grid->addWidget(m_goodEnough, 1, 0, 1, 2);
    grid->addWidget(m_useGoodEnough, 1, 2);
    grid->addWidget(m_toleranceText, 2, 0);
    grid->addWidget(m_tolerance, 2, 1, 1, 2);
    grid->addWidget(m_answer, 3, 0, 1, 2);
    grid->addWidget(m_use, 3, 2);
    grid->setRowStretch(0, 1);
    grid->setColumnStretch(1, 1);
    return answers;
}

void TradeDock::makeTable() {
    m_table = named(new QTableView, "trade_table");
    m_table->setAccessibleName(tr("Measured settings"));
    m_rows->setColours([this](const QByteArray &stepper) { return m_chart->colourOf(stepper); });
    m_sorted->setSourceModel(m_rows);
    m_sorted->setSortRole(TradeTableModel::kSortRole);
    m_sorted->setFilterKeyColumn(TradeTableModel::Model);
    m_table->setModel(m_sorted);
    new EmptyText(*m_table, tr("Not measured yet"));
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(-1, Qt::AscendingOrder); // in the order of measurement
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection); // several can be copied
    m_table->installEventFilter(this);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setIconSize({10, 10});
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored); // it scrolls by itself
    hideColumns();
    QHeaderView *header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    // Put cost and error side by side.
    header->moveSection(TradeTableModel::columnOf("cpu_per_second [us]"), TradeTableModel::kNameColumns);
    header->setMinimumSectionSize(20);
    header->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(header, &QHeaderView::customContextMenuRequested, this, &TradeDock::askForColumns);
    m_table->verticalHeader()->hide();
    fitColumns();
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        m_chart->choose(chosenIndex());
        showUsable();
    });
}

/// Those that say what to use are shown, and others that were chosen; tool tips have all figures of a row.
void TradeDock::hideColumns() {
    const QStringList shown = m_session.settings().value(settings_keys::kTradeColumns, usualColumns()).toStringList();
    m_table->setColumnHidden(TradeTableModel::Model, true); // the model is chosen above
    for (const TradeColumn &column : tradeColumns())
        m_table->setColumnHidden(TradeTableModel::columnOf(column.id), !shown.contains(QLatin1String(column.id)));
    hideNotes();
}

/// Unless a setting of the model shown has one.
void TradeDock::hideNotes() {
    const bool hasNotes = std::ranges::any_of(
        m_rows->points(), [this](const TradePoint &each) { return each.model == model() && !each.note.isEmpty(); });
    m_table->setColumnHidden(m_rows->columnCount() - 1, !hasNotes);
}

void TradeDock::askForColumns(const QPoint &place) {
    auto *menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("trade_columns"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const TradeColumn &column : tradeColumns()) {
        QAction *choice = menu->addAction(QString::fromUtf8(column.label));
        choice->setToolTip(QString::fromUtf8(column.help));
        choice->setCheckable(true);
        choice->setChecked(!m_table->isColumnHidden(TradeTableModel::columnOf(column.id)));
        connect(choice, &QAction::toggled, this, [this, &column](bool isShown) {
            m_table->setColumnHidden(TradeTableModel::columnOf(column.id), !isShown);
            fitColumns();
            keepColumns();
        });
    }
    menu->setToolTipsVisible(true);
    menu->popup(m_table->horizontalHeader()->mapToGlobal(place));
}

/// Without the room that Qt reserves in each for the arrow of the sorted one: as wide as the header is high.
void TradeDock::fitColumns() {
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    m_table->horizontalHeader()->setSortIndicatorShown(false);
    m_table->resizeColumnsToContents();
    m_table->horizontalHeader()->setSortIndicatorShown(true);
}

void TradeDock::keepColumns() {
    QStringList shown;
    for (const TradeColumn &column : tradeColumns())
        if (!m_table->isColumnHidden(TradeTableModel::columnOf(column.id))) shown += QLatin1String(column.id);
    m_session.settings().setValue(settings_keys::kTradeColumns, shown);
}

std::optional<Unknowns> TradeDock::unknowns() {
    QString error;
    std::optional<Unknowns> result = parseUnknowns(m_unknowns->text().trimmed(), &error);
    m_unknownsError->setText(error);
    m_unknowns->setRefused(!error.isEmpty());
    m_unknownsError->setVisible(!error.isEmpty());
    return result;
}

void TradeDock::showReady() {
    const std::optional<Unknowns> unknowns = this->unknowns();
    if (unknowns) m_session.lookAhead().setUnknowns(*unknowns);
    const bool isReady = unknowns && !m_schedule->words().isEmpty();
    m_measure->setEnabled(m_worker.isRunning() || isReady);
    if (m_worker.isRunning()) return;
    const QString problem = m_schedule->problem();
    m_remark->setText(problem.isEmpty() ? remark() : problem);
}

/// Clicking the button leaves the keyboard, and text being typed, in its field.
QString TradeDock::enterNumbers() {
    for (NumberBox *box : findChildren<NumberBox *>()) {
        if (!box->isVisibleTo(this)) continue;
        box->enter();
        if (box->isRefused()) return box->accessibleName() + QStringLiteral(": ") + box->reason();
    }
    return {};
}

void TradeDock::toggle() {
    if (m_worker.isRunning()) return m_worker.cancel();
    if (const QString problem = enterNumbers(); !problem.isEmpty()) return m_remark->setText(problem);
    TradePlan plan;
    plan.registry = m_session.registry();
    plan.scene = m_session.scene();
    plan.inputs = m_session.parameters().inputs();
    plan.stepSizes = usualStepSizes();
    if (std::find(plan.stepSizes.begin(), plan.stepSizes.end(), m_session.dt()) == plan.stepSizes.end())
        plan.stepSizes.push_back(m_session.dt());
    plan.unknowns = unknowns().value_or(Unknowns());
    plan.horizon = m_horizon->value();
    plan.share = share();
    m_model->setCurrentIndex(int(plan.inputs.params.model));
    m_measure->setText(tr("Cancel"));
    m_progress->setVisible(true);
    m_progress->setValue(0);
    m_measuredOn = m_session.level();
    m_measuredWith = boardSettings(m_session.parameters());
    m_shownConditions.clear();
    m_worker.start(plan, m_schedule->words(), m_duration->value());
}

void TradeDock::showResult() {
    const TradeResult &result = m_worker.result();
    m_rows->show(m_worker.plan(), result);
    m_sorted->setFilterFixedString(modelName(model()));
    hideNotes();
    showTolerance();
    showBand();
    fitColumns();
}

void TradeDock::showBand() {
    showGoodEnough();
    if (!m_worker.result().spans.empty()) m_chart->show(describedChart(), m_worker.result());
}

ChartDescription TradeDock::describedChart() const {
    const TradeResult &result = m_worker.result();
    ChartDescription chart = describeChart(m_worker.plan(), result, model(), shownSchedule(result));
    if (isOutOfDate()) chart.title += tr(" (out of date)"); // where it widens no line of the legend
    for (ChartCurve &curve : chart.curves) curve.name = stepperName(m_worker.plan().registry, curve.stepper);
    return chart;
}

void TradeDock::changeEvent(QEvent *event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange) fitColumns();
}

void TradeDock::showChangedWish() {
    if (!m_worker.result().spans.empty()) showBand();
}

bool TradeDock::isOutOfDate() const {
    if (m_worker.result().spans.empty()) return false;
    const TradePlan &plan = m_worker.plan();
    QString error;
    return !otherConditions().isEmpty() || parseUnknowns(m_unknowns->text().trimmed(), &error) != plan.unknowns ||
           share() != plan.share || m_horizon->value() != plan.askedHorizon;
}

/// What the figures were measured on or with, one line, if that isn't the present board; otherwise empty.
QString TradeDock::otherConditions() const {
    const TradePlan &plan = m_worker.plan();
    if (!plan.scene) return {};
    if (!isSameBoard(plan.scene, m_session.scene())) return tr("These figures are of another level.");
    const Parameters &parameters = m_session.parameters();
    const std::vector<Setting> others = differingFrom(parameters, m_measuredWith);
    return others.empty() ? QString()
                          : tr("These figures are of other parameters: %1.").arg(settingsText(parameters, others));
}

/// The keys' tilts change parameters 60 times a second, which is nothing to the figures.
void TradeDock::showConditions() {
    const QString conditions = otherConditions();
    if (conditions == std::exchange(m_shownConditions, conditions)) return;
    showChangedWish();
    showAnswer();
    if (!m_worker.isRunning()) m_remark->setText(remark());
}

QString TradeDock::nameOf(const TradePoint &point) const {
    return stepperName(m_worker.plan().registry, point.stepper);
}

double TradeDock::share() const { return m_share->value() / 100.0; }

void TradeDock::showGoodEnough() {
    const bool isPast = isOutOfDate();
    const TradeResult &result = m_worker.result();
    m_useGoodEnough->setEnabled(result.goodEnough && model() == m_worker.plan().inputs.params.model && !isPast);
    m_goodEnough->setText(isPast ? outOfDate(goodEnoughText()) : goodEnoughText());
}

QString TradeDock::outOfDate(const QString &text) { return tr("Out of date, measure again. %1").arg(text); }

/// The recommendation for the model that was set when the measurement began.
QString TradeDock::goodEnoughText() const {
    const TradeResult &result = m_worker.result();
    if (!result.goodEnough) {
        const bool hasNone = result.isComplete && !m_worker.plan().unknowns.empty();
        return hasNone ? recommendForUnknowns(m_worker.plan(), result).line : QString();
    }
    if (model() != m_worker.plan().inputs.params.model) return {};
    const TradePoint &point = result.points[result.goodEnough->point];
    const std::vector<PassedOver> &cheaper = result.goodEnough->passedOver;
    const auto settingOf = [this](const TradePoint &one) {
        return tr("%1 at %2").arg(nameOf(one), stepSizeText(one.dt));
    };
    const QString passedOver =
        cheaper.empty() ? QString() : passedOverText(*result.goodEnough, settingOf(result.points[cheaper[0].point]));
    const QString text =
        tr("Good enough: %1 at %2, off by at most %3 % of what isn't known on %4 schedules; %5 µs of CPU a second")
            .arg(nameOf(point), stepSizeText(point.dt))
            .arg(result.goodEnough->largest * 100.0, 0, 'g', 2)
            .arg(result.goodEnough->validations + int(m_worker.plan().schedules.size()))
            .arg(point.cost.perSecond * 1e6, 0, 'g', 3);
    return text + passedOver + shortSchedulesText(m_worker.plan());
}

void TradeDock::showProgress(double share, const QString &what) {
    m_progress->setValue(int(share * m_progress->maximum()));
    const bool isDisturbed = m_session.simulation().latest().running;
    m_remark->setText(
        isDisturbed ? tr("The simulation runs beside and disturbs the cost figures; pause it. %1").arg(what) : what);
}

void TradeDock::showEnd(const QString &error) {
    m_measure->setText(tr("Measure"));
    showReady();
    m_progress->setVisible(false);
    showResult();
    m_error = error;
    m_remark->setText(remark());
}

QString TradeDock::remark() const {
    const TradeResult &result = m_worker.result();
    if (!m_worker.plan().scene)
        return tr("Measures every stepper and step size against stepper exact, beside the simulation.");
    if (!m_error.isEmpty()) return m_error;
    if (QString conditions = otherConditions(); !conditions.isEmpty()) return conditions;
    QStringList lines = tradeSummary(m_worker.plan(), result);
    if (!m_worker.plan().unknowns.empty()) lines.removeFirst(); // the unknowns have a box of their own
    const QString summary = result.points.empty() ? QString() : lines.join(QStringLiteral("; "));
    return result.isComplete ? summary : tr("Cancelled; figures as far as they are known. %1").arg(summary);
}

double TradeDock::tolerance() const { return 0.001 * std::pow(10.0, double(m_tolerance->value()) / kPerDecade); }

uint32_t TradeDock::model() const { return uint32_t(m_model->currentIndex()); }

Recommendation TradeDock::answer() const {
    TradeOptions wish;
    wish.under = {tolerance(), false};
    return recommend(m_worker.result(), model(), wish, radius());
}

void TradeDock::showAnswer() {
    m_toleranceText->setText(
        tr("Error under %1 mm = %2 R").arg(tolerance() * 1e3, 0, 'g', 2).arg(tolerance() / radius(), 0, 'g', 2));
    if (m_worker.result().points.empty()) return m_answer->clear();
    const Recommendation answer = this->answer();
    const QString text = answer.point ? answerText(*answer.point, answer.seconds) : answer.line;
    m_answer->setText(otherConditions().isEmpty() ? text : outOfDate(text));
    showUsable();
}

void TradeDock::showTolerance() {
    showAnswer();
    const TradeResult &result = m_worker.result();
    const Recommendation answer = this->answer();
    m_table->clearSelection();
    if (!answer.point) return;
    const auto isIt = [&](const TradePoint &point) {
        return point.stepper == answer.point->stepper && point.dt == answer.point->dt &&
               point.model == answer.point->model;
    };
    choose(size_t(std::find_if(result.points.begin(), result.points.end(), isIt) - result.points.begin()));
}

void TradeDock::choose(size_t index) {
    const QModelIndex row = m_sorted->mapFromSource(m_rows->index(int(index), 0));
    m_table->selectionModel()->setCurrentIndex(row, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    m_table->scrollTo(row, QAbstractItemView::PositionAtCenter);
}

/// What was measured on another board may not even run on this one.
void TradeDock::showUsable() {
    const std::optional<size_t> index = chosenIndex();
    m_use->setEnabled(index && m_rows->points()[*index].isValid && otherConditions().isEmpty());
}

/// Several rows are only selected to be copied.
std::optional<size_t> TradeDock::chosenIndex() const {
    const QModelIndexList rows = m_table->selectionModel()->selectedRows();
    if (rows.size() != 1) return std::nullopt;
    return size_t(m_sorted->mapToSource(rows.first()).row());
}

void TradeDock::use() {
    const std::optional<size_t> index = chosenIndex();
    if (!index) return;
    use(TradePoint(m_rows->points()[*index])); // a copy, because the change may reset the table
}

void TradeDock::useGoodEnough() {
    const TradeResult &result = m_worker.result();
    if (result.goodEnough) use(result.points[result.goodEnough->point]);
}

void TradeDock::use(const TradePoint &point) {
    const Stepping wanted{point.stepper, point.dt, {{QStringLiteral("model"), double(point.model)}}};
    changeStepping(m_session, m_undo, wanted, tr("use of a measured setting"));
}

void TradeDock::changeLevel() {
    if (m_worker.isRunning()) m_worker.cancel(); // showEnd() follows
    showAnswer();
    showConditions();
}

} // namespace inspector::ui
