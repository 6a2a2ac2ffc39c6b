// SPDX-License-Identifier: MIT
// A choice of stepper or step size, as the toolbar passes it to the session.
#pragma once

#include "core/session/session.h"

/// Its own rows get their initial values; the model and dt are kept.
inline bool chooseStepper(inspector::Session &session, const QByteArray &id) {
    return session.setStepping({id, session.dt(), {}});
}

inline bool chooseDt(inspector::Session &session, double dt) {
    inspector::Stepping wanted = session.stepping();
    wanted.dt = dt;
    return session.setStepping(wanted);
}
