// SPDX-License-Identifier: MIT
#include "registry/plugin_call.h"

namespace phys {

namespace {

bool isFailure(phys_status status) {
    switch (status) {
#define PHYS_CASE(name, value, text) case value:
        PHYS_STATUS_LIST(PHYS_CASE)
#undef PHYS_CASE
        return status != PHYS_OK;
    default:
        return false;
    }
}

} // namespace

phys_status passOn(const phys_stepper_api &api, const char *function, phys_status status, phys_error &own,
                   phys_error *err) {
    if (!isFailure(status)) {
        return fail(err, PHYS_ERROR_PLUGIN_RESULT,
                    "%s of plugin stepper '%s' returned the status %d; expected 0 or a PHYS_ERROR_* code", function,
                    api.id, status);
    }
    own.text[sizeof own.text - 1] = '\0';
    if (!own.text[0]) {
        return fail(err, status, "%s of plugin stepper '%s' failed without a reason: %s", function, api.id,
                    phys_status_text(status));
    }
    return fail(err, status, "%s", own.text);
}

phys_status refuseException(const phys_stepper_api &api, const char *function, const char *reason, phys_error *err) {
    return fail(err, PHYS_ERROR_PLUGIN_RESULT, "%s of plugin stepper '%s' threw an exception%s%s; expected a status",
                function, api.id, reason ? ": " : "", reason ? reason : "");
}

} // namespace phys
