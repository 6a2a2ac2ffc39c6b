// SPDX-License-Identifier: MIT
// What a plugin shares with its host's process and has to leave as it is.
#pragma once

#include <array>
#include <csignal>
#include <string>
#include <sys/types.h>
#include <utility>

namespace plugin_check {

/// Of the process and the thread that makes it, at that moment.
class Surroundings {
public:
    Surroundings();

    /// What is otherwise now, in words, each with "; " before it; empty if nothing is.
    std::string changes() const;

private:
    static constexpr int kSignals = 65;
    using File = std::pair<dev_t, ino_t>;

    std::array<File, 256> m_files; ///< by descriptor; {0, 0}: closed
    std::array<struct sigaction, kSignals> m_signals{};
    sigset_t m_blocked{};
    std::string m_folder, m_locale, m_environment;
    mode_t m_mask;
    bool m_hasAlarm;
};

/// How the processor computes in this thread.
struct Arithmetic {
    static Arithmetic now();

    int rounding;
    int trapped; ///< exceptions
    bool hasSubnormals;
};

} // namespace plugin_check
