// SPDX-License-Identifier: MIT
// Strict comparisons: QCOMPARE considers doubles equal that differ by 1e-12.
#pragma once

#include <QTest>

#include <physics/physics.h>

#include <cmath>
#include <cstring>

namespace support {

inline QByteArray digits(double value) { return QByteArray::number(value, 'g', 17); }

/// The same bytes: 0 isn't -0, and a NaN equals itself.
template<class T>
bool sameBits(const T &a, const T &b) {
    return std::memcmp(static_cast<const void *>(&a), static_cast<const void *>(&b), sizeof(T)) == 0;
}

} // namespace support

/// The same number (0 equals -0; NaN equals nothing).
#define COMPARE_EXACT(actual, expected)                                                                                \
    do {                                                                                                               \
        const double found_ = (actual);                                                                                \
        const double wanted_ = (expected);                                                                             \
        QVERIFY2(found_ == wanted_, (QByteArray(#actual " is ") + support::digits(found_) + ", expected exactly " +    \
                                     support::digits(wanted_))                                                         \
                                        .constData());                                                                 \
    } while (false)

/// Differ by at most `slack`, for which the caller gives a reason.
#define COMPARE_WITHIN(actual, expected, slack)                                                                        \
    do {                                                                                                               \
        const double found_ = (actual);                                                                                \
        const double wanted_ = (expected);                                                                             \
        const double slack_ = (slack);                                                                                 \
        QVERIFY2(std::abs(found_ - wanted_) <= slack_,                                                                 \
                 (QByteArray(#actual " is ") + support::digits(found_) + ", expected " + support::digits(wanted_) +    \
                  " within " + support::digits(slack_) + ", off by " + support::digits(found_ - wanted_))              \
                     .constData());                                                                                    \
    } while (false)
