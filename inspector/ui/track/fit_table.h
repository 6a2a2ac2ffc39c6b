// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/parameters.h"
#include "core/track/track_fit.h"

#include <QTableWidget>

namespace inspector::ui {

/// The quantities that can be fitted: which of them are selected, their initial and their fitted values. Coefficients
/// start at the parameters' values; offsets, delay and frame at what the user typed.
class FitTable : public QTableWidget {
    Q_OBJECT

public:
    explicit FitTable(QWidget *parent = nullptr);

    std::vector<FitQuantity> wanted() const;
    QString words() const; ///< in the form that parseFitQuantities() reads
    void want(const QString &words);
    /// The initial values of a fit.
    BoardParameters begin(const Inputs &inputs) const;
    void setFrame(const TrackFrame &frame) { m_typed.frame = frame; } ///< shown by the next call
    void showBegin(const Inputs &inputs);
    void showFound(const ModelFit &fit);
    void forgetFound();
    /// What this fit took for true and isn't typed here any more; empty if all is.
    QString othersOf(const FitPlan &plan) const;
    /// What is wrong with the first initial value that was refused; empty if none was.
    QString refusal() const;

    enum Column { Name, Begin, Found, Unit, kColumnCount };

signals:
    void wantedChanged();
    void typed(); ///< another initial value

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void read(QTableWidgetItem *item);
    void showReason(QTableWidgetItem &begin, const QString &reason);
    QString reasonOf(int row) const;
    void fitFound();

    std::vector<FitQuantity> m_quantities;
    BoardParameters m_typed{}; ///< without coefficients and gravity
    int m_numbersWidth = 0;    ///< of the widest numbers found, pixels
};

} // namespace inspector::ui
