// SPDX-License-Identifier: MIT
// Unknowns of a board, from the words that --unknown accepts.
#pragma once

#include "core/trade/trade_options.h"

inline inspector::Unknowns unknownsOf(const char *words) {
    QString error;
    const std::optional<inspector::Unknowns> unknowns = inspector::parseUnknowns(words, &error);
    if (!unknowns) qFatal("%s", qPrintable(error));
    return *unknowns;
}
