// SPDX-License-Identifier: MIT
// A single dock on the screen, with its own session and settings.
#pragma once

#include "core/program/command_line.h"
#include "core/session/session.h"
#include "core/setup/settings_file.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include <memory>

namespace support {

// For docks that are made from a session and the undo stack.
template<typename Dock>
class DockFixture {
protected:
    // Empty, or why the dock can't be shown.
    QString open(int level) {
        const inspector::CommandLine line =
            inspector::parseCommandLine({"physics-inspector", "--level", QString::number(level)});
        QString error = line.error;
        if (!line.exitStatus) m_session = inspector::Session::open(line.options, m_settings, &error);
        if (!m_session) return error;
        m_dock = std::make_unique<Dock>(*m_session, m_undo);
        m_dock->resize(1200, 420);
        m_dock->show();
        return QTest::qWaitForWindowExposed(m_dock.get()) ? QString() : QStringLiteral("not exposed");
    }

    template<typename Widget>
    Widget &find(const char *name) {
        auto *widget = m_dock->template findChild<Widget *>(QLatin1String(name));
        if (!widget) qFatal("no %s", name);
        return *widget;
    }

    static constexpr int kLong = 90000; // ms: time limit of a wait on a busy machine

    QTemporaryDir m_folder;
    QSettings m_settings{m_folder.filePath("settings.ini"), inspector::settingsFormat()};
    QUndoStack m_undo;
    std::unique_ptr<inspector::Session> m_session;
    std::unique_ptr<Dock> m_dock;
};

} // namespace support
