// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_stack.h"

#include "ui/parts/settings_keys.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/quantity_menu.h"

#include <QContextMenuEvent>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <numeric>

namespace inspector::ui {

namespace {

const QString kUsualPlots = QStringLiteral("velocity_x,velocity_y,speed,ghost_speed");
const QString kPhase = QStringLiteral("phase:");
constexpr qsizetype kMostRestored = 16; ///< a settings file may list any number

/// A predefined plot.
struct Offer {
    const char *name;
    const char *content;
};
constexpr Offer kOffers[] = {
    {QT_TRANSLATE_NOOP("inspector::ui::PlotStack", "Velocity"), "velocity_x,velocity_y,speed,ghost_speed"},
    {QT_TRANSLATE_NOOP("inspector::ui::PlotStack", "Position"),
     "position_x,position_y,ghost_x,ghost_y,track_x,track_y"},
    {QT_TRANSLATE_NOOP("inspector::ui::PlotStack", "Tilt"), "tilt_x,tilt_y"},
    {QT_TRANSLATE_NOOP("inspector::ui::PlotStack", "Energy"), "energy,kinetic,potential,ghost_energy"},
    {QT_TRANSLATE_NOOP("inspector::ui::PlotStack", "Energy lost"), "lost_impact,lost_rolling,lost_slip,scheme"},
    {QT_TRANSLATE_NOOP("inspector::ui::PlotStack", "Distance to the ghost"), "log:distance"},
    {QT_TRANSLATE_NOOP("inspector::ui::PlotStack", "Time to compute a step"), "log:step_time"},
};

} // namespace

PlotStack::PlotStack(const SampleRing &samples, QSettings &settings, QWidget *parent)
    : QSplitter(Qt::Vertical, parent)
    , m_samples(samples)
    , m_settings(settings)
    , m_time(std::make_shared<TimeView>()) {
    setObjectName(QStringLiteral("plots"));
    setChildrenCollapsible(false);
    restore();
    connect(this, &QSplitter::splitterMoved, this, &PlotStack::remember);
}

QuantityPlot *PlotStack::addPlot(const PlotContent &content) {
    const QList<int> heights = sizes();
    QuantityPlot *plot = makePlot(content);
    shareHeight(heights);
    remember();
    emit added(plot);
    return plot;
}

PhasePlot *PlotStack::addPhasePlot(Channel x, Channel y) {
    const QList<int> heights = sizes();
    PhasePlot *plot = makePhasePlot(x, y);
    shareHeight(heights);
    remember();
    emit added(plot);
    return plot;
}

void PlotStack::tellPlaces() {
    for (QuantityPlot *plot : m_plots) plot->setPlace({plot == m_plots.front(), plot == m_plots.back()});
}

/// Gives the newest plot the mean height; the others keep their proportions. heights: before it was added.
void PlotStack::shareHeight(QList<int> heights) {
    heights += std::accumulate(heights.begin(), heights.end(), 0) / int(heights.size());
    setSizes(heights); // which scales them to the room
}

QuantityPlot *PlotStack::makePlot(const PlotContent &content) {
    auto *plot = new QuantityPlot(m_samples, content, m_time);
    plot->setObjectName(m_plots.empty() ? QStringLiteral("velocity_plot")
                                        : QStringLiteral("plot_%1").arg(m_plots.size() + 1));
    m_plots.push_back(plot);
    addWidget(plot);
    tellPlaces();
    plot->showBounces(m_bounces, m_selected);
    connect(plot, &TimePlot::bounceClicked, this, &PlotStack::bounceClicked);
    connect(plot, &QuantityPlot::contentChanged, this, &PlotStack::remember);
    offerMenu(plot);
    return plot;
}

PhasePlot *PlotStack::makePhasePlot(Channel x, Channel y) {
    auto *plot = new PhasePlot(m_samples, x, y, m_time);
    plot->setObjectName(QStringLiteral("phase_plot_%1").arg(m_phasePlots.size() + 1));
    m_phasePlots.push_back(plot);
    addWidget(plot);
    offerMenu(plot);
    return plot;
}

void PlotStack::offerMenu(QWidget *plot) {
    plot->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(plot, &QWidget::customContextMenuRequested, this, [this, plot](const QPoint &place) {
        auto *menu = new QMenu(this);
        menu->setObjectName(QStringLiteral("plot_menu"));
        menu->setAttribute(Qt::WA_DeleteOnClose);
        fillMenu(*menu, plot);
        menu->popup(plot->mapToGlobal(place));
    });
}

void PlotStack::removePlot(QWidget *plot) {
    const auto over = std::find(m_plots.begin(), m_plots.end(), plot);
    if (over != m_plots.end()) {
        if (m_plots.size() == 1) return;
        m_plots.erase(over);
    }
    std::erase(m_phasePlots, plot);
    tellPlaces();
    plot->hide();
    plot->deleteLater();
    remember();
}

void PlotStack::fillMenu(QMenu &menu, QWidget *plot) {
    if (auto *over = qobject_cast<QuantityPlot *>(plot)) {
        const auto isChosen = [over](Channel channel) {
            const std::vector<Channel> &shown = over->content().channels;
            return std::find(shown.begin(), shown.end(), channel) != shown.end();
        };
        addQuantities(*menu.addMenu(tr("Quantities")), isChosen, [over](Channel channel) {
            PlotContent content = over->content();
            if (std::erase(content.channels, channel) == 0) content.channels.push_back(channel);
            over->setContent(content);
        });
        QAction *powers = menu.addAction(tr("Logarithmic values"));
        powers->setCheckable(true);
        powers->setChecked(over->content().isLogarithmic);
        connect(powers, &QAction::triggered, over, [over](bool isOn) {
            PlotContent content = over->content();
            content.isLogarithmic = isOn;
            over->setContent(content);
        });
        if (!over->content().channels.empty())
            addQuantities(
                *menu.addMenu(tr("New plot of the first quantity over")), [](Channel) { return false; },
                [this, y = over->content().channels.front()](Channel x) { addPhasePlot(x, y); });
        menu.addSeparator();
    }
    QMenu *added = menu.addMenu(tr("Add plot"));
    for (const Offer &offer : kOffers)
        connect(added->addAction(tr(offer.name)), &QAction::triggered, this,
                [this, &offer] { addPlot(plotContentOf(QLatin1String(offer.content))); });
    connect(added->addAction(tr("The way on the board (y over x)")), &QAction::triggered, this,
            [this] { addPhasePlot(Channel::PositionX, Channel::PositionY); });
    QAction *removed = menu.addAction(tr("Remove this plot"));
    removed->setEnabled(m_plots.size() > 1 || !qobject_cast<QuantityPlot *>(plot));
    connect(removed, &QAction::triggered, this, [this, plot] { removePlot(plot); });
}

/// Plots behind another dock are drawn once they are seen.
void PlotStack::refresh(const RunContext &context) {
    for (QuantityPlot *plot : m_plots) plot->setContext(context);
    if (isSeen()) drawAll();
}

/// The stack itself is covered by its plots, some of which may be scrolled away.
bool PlotStack::isSeen() const {
    return std::ranges::any_of(shown(), [](const QWidget *plot) { return !plot->visibleRegion().isEmpty(); });
}

/// From top to bottom, without those that were removed.
QList<QCustomPlot *> PlotStack::shown() const {
    QList<QCustomPlot *> plots;
    for (int i = 0; i < count(); ++i)
        if (auto *plot = qobject_cast<QCustomPlot *>(widget(i)); plot && !plot->isHidden()) plots += plot;
    return plots;
}

void PlotStack::drawAll() {
    for (QuantityPlot *plot : m_plots) plot->refresh();
    for (PhasePlot *plot : m_phasePlots) plot->refresh();
}

void PlotStack::showBounces(const std::vector<double> &times, std::optional<double> selected) {
    m_bounces = times;
    m_selected = selected;
    for (QuantityPlot *plot : m_plots) plot->showBounces(times, selected);
}

void PlotStack::setFollowing(bool isOn) {
    for (QuantityPlot *plot : m_plots) plot->setFollowing(isOn);
}

void PlotStack::setPaused(bool isOn) { first().setPaused(isOn); }
void PlotStack::clear() { first().clear(); }

void PlotStack::reset() {
    while (m_plots.size() > 1) removePlot(m_plots.back());
    while (!m_phasePlots.empty()) removePlot(m_phasePlots.back());
    first().setContent(plotContentOf(kUsualPlots));
}

void PlotStack::restore() {
    const QStringList contents = m_settings.value(settings_keys::kPlots, QStringList{kUsualPlots}).toStringList();
    const QStringList heights = m_settings.value(settings_keys::kPlotSizes).toStringList();
    for (const QString &text : contents.mid(0, kMostRestored)) {
        const bool isPhase = text.startsWith(kPhase);
        const PlotContent content = plotContentOf(isPhase ? text.mid(kPhase.size()) : text);
        if (isPhase && content.channels.size() == 2) makePhasePlot(content.channels[0], content.channels[1]);
        if (!isPhase && (text.isEmpty() || !content.channels.empty())) makePlot(content);
    }
    if (m_plots.empty()) makePlot(plotContentOf(kUsualPlots));
    QList<int> sizes;
    for (const QString &height : heights) sizes += std::clamp(height.toInt(), 0, QWIDGETSIZE_MAX);
    if (sizes.size() == QSplitter::count()) setSizes(sizes);
}

/// The plots in their order: time plots first.
void PlotStack::remember() {
    QStringList contents;
    for (const QuantityPlot *plot : m_plots) contents += textOf(plot->content());
    for (const PhasePlot *plot : m_phasePlots) contents += kPhase + textOf(PlotContent{{plot->x(), plot->y()}, false});
    QStringList heights;
    for (const int height : sizes()) heights += QString::number(height);
    m_settings.setValue(settings_keys::kPlots, contents);
    m_settings.setValue(settings_keys::kPlotSizes, heights);
}

bool PlotStack::save(const QString &path, QString *error) {
    drawAll();
    const bool isTable = QFileInfo(path).suffix().compare(QLatin1String("csv"), Qt::CaseInsensitive) == 0;
    if (isTable || count() == 1) return first().save(path, error);
    const QList<QCustomPlot *> shown = this->shown();
    int lowest = kLeastPlotSize.height();
    for (const QCustomPlot *plot : shown) lowest = std::clamp(plot->height(), 1, lowest);
    const auto stretched = [lowest](const QWidget *plot) { return plot->height() * kLeastPlotSize.height() / lowest; };
    const int wide = std::max(width(), kLeastPlotSize.width());
    std::vector<PlacedPlot> plots;
    int top = 0;
    for (QCustomPlot *plot : shown) {
        plots.push_back({*plot, {0, top, wide, stretched(plot)}});
        top += stretched(plot);
    }
    for (QuantityPlot *plot : m_plots) plot->dressForPicture(stretched(plot));
    const bool isSaved = savePlots(plots, {wide, top}, path, error);
    for (QuantityPlot *plot : m_plots) plot->dressForWindow();
    return isSaved;
}

} // namespace inspector::ui
