// SPDX-License-Identifier: MIT
// Calls into a plugin: any fault becomes one status and one line.
#pragma once

#include "base/error.h"

#include <physics/plugin.h>

#include <cfenv>
#include <exception>

namespace phys {

/// Passes on a plugin's failure with a reliable code and text. own: the text written by the plugin.
phys_status passOn(const phys_stepper_api &api, const char *function, phys_status status, phys_error &own,
                   phys_error *err);

/// An exception that left a plugin. reason: nullptr if it has no text.
phys_status refuseException(const phys_stepper_api &api, const char *function, const char *reason, phys_error *err);

/// Restores the floating-point environment, whatever is done to it in between.
class KeptEnvironment {
public:
    KeptEnvironment() { std::fegetenv(&m_before); }
    ~KeptEnvironment() { std::fesetenv(&m_before); }
    KeptEnvironment(const KeptEnvironment &) = delete;
    KeptEnvironment &operator=(const KeptEnvironment &) = delete;

private:
    std::fenv_t m_before;
};

/// Calls call(own) with a separate error struct, as plugin.h promises, and lets nothing but a status out: neither an
/// exception nor another rounding. function: its name in phys_stepper_api, for the message.
template<class Call>
phys_status callPlugin(const phys_stepper_api &api, const char *function, phys_error *err, Call call) noexcept {
    const KeptEnvironment environment;
    try {
        phys_error own{};
        const phys_status status = call(own);
        return status == PHYS_OK ? PHYS_OK : passOn(api, function, status, own, err);
    } catch (const std::exception &exception) {
        return refuseException(api, function, exception.what(), err);
    } catch (...) {
        return refuseException(api, function, nullptr, err);
    }
}

} // namespace phys
