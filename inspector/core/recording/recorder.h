// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a recording while an engine steps. It looks at each step only: what differs from the step before is written,
// so that restarts, other levels, steppers and step sizes need no words of their own.
#pragma once

#include "core/engine/engine.h"
#include "core/recording/recording.h"
#include "core/setup/files.h"

#include <chrono>
#include <memory>
#include <optional>

namespace inspector {

// What a recording has to know of an engine's scene and stepper, which don't know where they came from.
struct Origin {
    MazeSource maze;
    phys_stepper_info stepper{};
    Registry registry; // keeps the stepper's texts and rows
};

// The hash is that of the file as it is now; 0 for a file that can't be read.
Origin originOf(const Registry &registry, const QByteArray &stepper, const QString &maze);

class Recorder {
public:
    // Opens the file, in the place of one that is there; look at isGood().
    explicit Recorder(const QString &path);
    ~Recorder(); // writes what is left
    Recorder(const Recorder &) = delete;
    Recorder &operator=(const Recorder &) = delete;

    // From the next step on.
    void setOrigin(const Origin &origin);
    // After each step of the engine, from the thread that steps it.
    void note(const Engine &engine);
    // After one that failed, with the library's line.
    void noteFailure(const Engine &engine, const QString &line);
    // Puts into the file what still waits to be written.
    void flush();
    // Ends the recording.
    void close();

    // False once something could not be written; the rest isn't, then.
    bool isGood() const { return m_error.isEmpty(); }
    QString error() const { return m_error; } // one line

private:
    bool hasNewConditions(const Engine &engine) const;
    void putConditions(const Engine &engine);
    void putNews(const Engine &engine, const phys_state &from);
    void put(const QByteArray &text);
    void fail(const QString &reason);
    bool isFlushDue() const;

    std::unique_ptr<OutputFile> m_file; // null once it is closed
    QByteArray m_waiting;
    std::chrono::steady_clock::time_point m_flushed;
    QString m_error;
    Origin m_origin;
    bool m_originIsNew = true;
    std::optional<Conditions> m_conditions; // as written
    std::optional<phys_state> m_state;      // after the last step written; nothing on a new level
};

} // namespace inspector
