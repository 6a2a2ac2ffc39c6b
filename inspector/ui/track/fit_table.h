// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/parameters.h"
#include "core/track/track_fit.h"

#include <QTableWidget>

namespace inspector::ui {

// The numbers of a board that a fit can look for: which of them, from where, and what was found. Coefficients begin
// where the parameters are; offsets, delay and frame where a person has typed.
class FitTable : public QTableWidget {
    Q_OBJECT

public:
    explicit FitTable(QWidget *parent = nullptr);

    std::vector<FitQuantity> wanted() const;
    QString words() const; // as parseFitQuantities() reads them
    void want(const QString &words);
    // Where a fit begins.
    BoardParameters begin(const Inputs &inputs) const;
    void setFrame(const TrackFrame &frame) { m_typed.frame = frame; } // to be shown by the next
    void showBegin(const Inputs &inputs);
    void showFound(const ModelFit &fit);
    void forgetFound();

    enum Column { Name, Begin, Found, Unit, kColumnCount };

signals:
    void wantedChanged();
    void refused(const QString &line); // a number that was typed

private:
    void read(QTableWidgetItem *item);

    std::vector<FitQuantity> m_quantities;
    BoardParameters m_typed{}; // but for its coefficients and its gravity
};

} // namespace inspector::ui
