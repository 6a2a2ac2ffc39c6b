// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a recording while an engine steps. It compares each step with the one before and writes the differences, so
// that restarts, other levels, steppers and step sizes need no calls of their own.
#pragma once

#include "core/engine/engine.h"
#include "core/recording/recording.h"
#include "core/setup/files.h"

#include <chrono>
#include <memory>
#include <optional>

namespace inspector {

/// The source of an engine's scene and stepper, which the engine itself doesn't know.
struct Origin {
    MazeSource maze;
    phys_stepper_info stepper{};
    Registry registry; ///< keeps the stepper's texts and rows alive
};

/// The hash is of the file's current bytes; 0 for a file that can't be read.
Origin originOf(const Registry &registry, const QByteArray &stepper, const QString &maze);

class Recorder {
public:
    /// Opens the file, replacing an existing one; check isGood().
    explicit Recorder(const QString &path);
    ~Recorder(); ///< writes what is left
    Recorder(const Recorder &) = delete;
    Recorder &operator=(const Recorder &) = delete;

    /// Takes effect from the next step on.
    void setOrigin(const Origin &origin);
    /// Called after each step of the engine, by the thread that steps it.
    void note(const Engine &engine);
    /// Called after a failed step, with the library's message.
    void noteFailure(const Engine &engine, const QString &line);
    /// Writes buffered data to the file.
    void flush();
    /// Ends the recording.
    void close();

    /// False once something could not be written; nothing more is written then.
    bool isGood() const { return m_error.isEmpty(); }
    QString error() const { return m_error; } ///< one line

private:
    bool hasNewConditions(const Engine &engine) const;
    void putConditions(const Engine &engine);
    void putNews(const Engine &engine, const phys_state &from);
    void put(const QByteArray &text);
    void fail(const QString &reason);
    bool isFlushDue() const;

    std::unique_ptr<OutputFile> m_file; ///< null once it is closed
    QByteArray m_waiting;
    std::chrono::steady_clock::time_point m_flushed;
    QString m_error;
    Origin m_origin;
    bool m_originIsNew = true;
    std::optional<Conditions> m_conditions; ///< as last written
    std::optional<phys_state> m_state;      ///< after the last step written; empty on a new level
};

} // namespace inspector
