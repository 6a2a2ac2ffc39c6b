// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QObject>
#include <QTemporaryDir>
#include <QTimer>

#include <functional>
#include <memory>

class QProcess;
class QProgressDialog;
class QWidget;

namespace inspector {
class Session;
}

namespace inspector::gl {
class MazeView;
}

namespace inspector::ui {

enum class FilmKind {
    Pictures, ///< a folder of PNG files
    WebM,     ///< these two are single files, encoded by ffmpeg
    Gif
};

struct FilmPlan {
    double seconds = 10.0; ///< s of simulated time, up to the moment shown
    int perSecond = 25;    ///< pictures
    FilmKind kind = FilmKind::Pictures;
};

/// Asks for the film's length and, if ffmpeg is installed, its kind; doesn't block.
void askForFilm(QWidget &window, const FilmPlan &usual, const std::function<void(const FilmPlan &plan)> &use);

/// Steps through the past of the run shown, which a recording may be, picture by picture, and writes the pictures into
/// a new folder or encodes them into one file. Shows its progress and can be cancelled, which removes them, as does the
/// end of the window. Deletes itself at the end, after returning to the moment that was shown before.
class Film : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. scale: pixels per pixel of the view.
    Film(Session &session, gl::MazeView &view, const FilmPlan &plan, int scale, QWidget &window);
    ~Film() override;

    /// path: the new folder or the file. Returns false, with one line in `error`, if the folder exists and isn't empty,
    /// or can't be made.
    bool begin(const QString &path, QString *error);

signals:
    /// error: why it failed, or empty.
    void finished(const QString &error);
    void saved(const QString &path); ///< after finished(), unless it failed or was cancelled

private:
    bool makeFolder(const QString &path, QString *error);
    void goOn();
    QString fileOf(int picture) const; ///< from 1
    bool takePicture(QString *error);
    void joinPictures();
    void useJoined();
    void removeUnfinished();
    void finish();
    void end(const QString &error);

    Session &m_session;
    gl::MazeView &m_view;
    int m_scale;
    FilmPlan m_plan;
    double m_first; ///< s
    double m_last;
    double m_period;
    bool m_wasPresent;
    QString m_path;
    std::unique_ptr<QTemporaryDir> m_scratch; ///< holds the pictures to be encoded
    QDir m_folder;
    QProcess *m_tool = nullptr; ///< while it is encoding
    QProgressDialog *m_progress;
    QTimer m_look; ///< polls whether the requested moment is shown
    bool m_isUnfinished = false;
    int m_taken = 0;
    int m_count = 0;
};

} // namespace inspector::ui
