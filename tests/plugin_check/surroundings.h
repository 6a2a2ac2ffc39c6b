// SPDX-License-Identifier: MIT
// The process state that a plugin shares with its host and must leave unchanged.
#pragma once

#include <array>
#include <csignal>
#include <string>
#include <sys/types.h>
#include <utility>

namespace plugin_check {

/// Records the state of the process and of the constructing thread at that moment.
class Surroundings {
public:
    Surroundings();

    /// Describes what differs now, each with "; " before it; empty if nothing does.
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

/// The floating-point setting of this thread.
struct Arithmetic {
    static Arithmetic now();

    int rounding;
    int trapped; ///< exceptions
    bool hasSubnormals;
};

} // namespace plugin_check
