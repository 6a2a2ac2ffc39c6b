// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/program/trade_command.h"
#include "core/session/session.h"
#include "core/trade/trade_worker.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QSortFilterProxyModel;
class QTableView;
class QToolButton;
class QUndoStack;

namespace inspector::ui {

class ElidedLabel;
class NumberBox;
class ScheduleChooser;
class TextBox;
class TradeChart;
class TradeTableModel;

/// Measures the trade of the open level in the background; shows chart, table, a tolerance and the recommended setting,
/// which can be applied.
class TradeDock : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the dock.
    TradeDock(Session &session, QUndoStack &undo, QWidget *parent = nullptr);

    QSize sizeHint() const override { return {900, 360}; }

    /// Writes, by the name's suffix, .csv (the figures of all settings, and beside them what they were measured with),
    /// .svg, .png or .pdf (the chart). Returns false, with one line in `error`, on failure.
    bool save(const QString &path, QString *error);

signals:
    void saveWanted();

protected:
    bool eventFilter(QObject *object, QEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void makeControls();
    void leaveKeysToTheGame();
    QWidget *makeTop();
    QWidget *makeUnknowns();
    QWidget *makeAnswers();
    void makeTable();
    void hideColumns();
    void hideNotes();
    void askForColumns(const QPoint &place);
    void keepColumns();
    void fitColumns();

    void showReady();       ///< enables the button if there is something to measure
    void toggle();          ///< starts or cancels a measurement
    QString enterNumbers(); ///< commits what was typed; returns the first refused one's reason
    void showResult();
    void showProgress(double share, const QString &what);
    void showEnd(const QString &error);
    void showTolerance(); ///< updates the recommendation, and chooses it
    void showAnswer();
    Recommendation answer() const;
    ChartDescription describedChart() const;
    bool saveTable(const QString &path, QString *error) const;
    void copy() const;
    void showBand(); ///< updates chart and recommendation for what is unknown
    void showGoodEnough();
    void showChangedWish();
    bool isOutOfDate() const; ///< measured under other conditions, or for other wishes than are set
    static QString outOfDate(const QString &text);
    QString otherConditions() const;
    void showConditions();
    QString goodEnoughText() const;
    void choose(size_t index);
    void showUsable();
    void use(); ///< applies the selected one
    void useGoodEnough();
    void use(const TradePoint &point);
    void changeLevel();
    QString remark() const; ///< about the measurement that ended last

    QString nameOf(const TradePoint &point) const; ///< the stepper's
    double radius() const;                         ///< m
    double tolerance() const;                      ///< m
    double share() const;                          ///< share of the uncertainty that an error may reach
    std::optional<size_t> chosenIndex() const;
    std::optional<Unknowns> unknowns(); ///< as typed; reports what is wrong with them
    uint32_t model() const;
    QString answerText(const TradePoint &point, double seconds) const;

    Session &m_session;
    QUndoStack &m_undo;
    TradeWorker m_worker;
    std::vector<Setting> m_measuredWith;
    Level m_measuredOn;
    QString m_shownConditions;
    QString m_error;  ///< why the last measurement failed
    QTimer m_refresh; ///< limits the update rate
    QPushButton *m_measure;
    QToolButton *m_save;
    ScheduleChooser *m_schedule;
    NumberBox *m_duration;
    QComboBox *m_model;
    TextBox *m_unknowns; ///< refused while they can't be read
    NumberBox *m_horizon;
    NumberBox *m_share;
    QLabel *m_unknownsError;
    QLabel *m_goodEnough;
    QPushButton *m_useGoodEnough;
    QProgressBar *m_progress;
    ElidedLabel *m_remark;
    TradeChart *m_chart;
    TradeTableModel *m_rows;
    QSortFilterProxyModel *m_sorted;
    QTableView *m_table;
    QSlider *m_tolerance;
    QLabel *m_toleranceText;
    QLabel *m_answer;
    QPushButton *m_use;
};

} // namespace inspector::ui
