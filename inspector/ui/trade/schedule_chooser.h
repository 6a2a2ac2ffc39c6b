// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QSettings;

namespace inspector::ui {

class FileBox;
class NumberBox;

/// Chooses the tilts of a trade measurement: the autopilot's, random from a seed, or from a file.
class ScheduleChooser : public QWidget {
    Q_OBJECT

public:
    /// settings: store the folder of the file; must outlive the chooser.
    explicit ScheduleChooser(QSettings &settings, QWidget *parent = nullptr);

    /// As on the command line (core/trade/trade_options.h); empty while no file is named, or none that exists.
    QString words() const;
    /// What is wrong with the file that was entered, one line; else empty.
    QString problem() const;

signals:
    void changed();

private:
    enum Kind { Both, Autopilot, Busy, Random, File };

    void addFile();
    void showKind();
    void openFile();

    QSettings &m_settings;
    QComboBox *m_kind;
    QWidget *m_random; ///< the seed with its label
    NumberBox *m_seed;
    FileBox *m_file;
};

} // namespace inspector::ui
