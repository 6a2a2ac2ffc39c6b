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
    Pictures, // a folder of PNG files
    WebM,     // these two are one file, made of the pictures by ffmpeg
    Gif
};

struct FilmPlan {
    double seconds = 10.0; // of simulated time, up to the moment shown
    int perSecond = 25;    // pictures
    FilmKind kind = FilmKind::Pictures;
};

// Asks how long the film is to be, and where ffmpeg is installed, of which kind; nothing waits for the answer.
void askForFilm(QWidget &window, const FilmPlan &usual, const std::function<void(const FilmPlan &plan)> &use);

// Goes through the past of the run shown, picture by picture, and writes them into a new folder, or one file of them;
// shows how far it is, and can be cancelled, which removes them. Deletes itself at its end, when the moment from before
// is shown again.
class Film : public QObject {
    Q_OBJECT

public:
    // All outlive it. scale: pixels for each of the view.
    Film(Session &session, gl::MazeView &view, const FilmPlan &plan, int scale, QWidget &window);

    // path: the new folder or the file. False, and one line in `error`, if the folder is there and holds something, or
    // can't be made.
    bool begin(const QString &path, QString *error);

signals:
    // error: why not, or empty.
    void finished(const QString &error);

private:
    bool makeFolder(const QString &path, QString *error);
    void goOn();
    QString fileOf(int picture) const; // from 1
    bool takePicture(QString *error);
    void joinPictures();
    void useJoined();
    void removePictures();
    void end(const QString &error);

    Session &m_session;
    gl::MazeView &m_view;
    int m_scale;
    FilmPlan m_plan;
    double m_first; // s
    double m_last;
    double m_period;
    bool m_wasInPast;
    QString m_path;
    std::unique_ptr<QTemporaryDir> m_scratch; // of pictures that become one file
    QDir m_folder;
    QProcess *m_tool = nullptr; // while it makes the file
    QProgressDialog *m_progress;
    QTimer m_look;         // whether the moment sought is shown
    uint64_t m_wanted = 0; // place
    int m_taken = 0;
    int m_count = 0;
};

} // namespace inspector::ui
