// SPDX-License-Identifier: MIT
// Runs one of a program's suites. Usage: PROGRAM SUITE [FACT... and other arguments of QtTest]
#include "support/suites.h"

#include <cstdio>

namespace support {

namespace {

const Suite *newest = nullptr;

} // namespace

Suite::Suite(const char *file, Run start)
    : m_file(file)
    , m_run(start)
    , m_next(newest) {
    newest = this;
}

QByteArray Suite::name() const {
    const QByteArray file(m_file);
    return file.left(file.lastIndexOf('.'));
}

const Suite *Suite::first() { return newest; }

} // namespace support

int main(int argc, char **argv) {
    for (const support::Suite *suite = support::Suite::first(); argc > 1 && suite; suite = suite->next()) {
        if (suite->name() != argv[1]) continue;
        argv[1] = argv[0];
        return suite->run(argc - 1, argv + 1);
    }
    std::fprintf(stderr, "%s: expected a suite:", argv[0]);
    for (const support::Suite *suite = support::Suite::first(); suite; suite = suite->next())
        std::fprintf(stderr, " %s", suite->name().constData());
    std::fprintf(stderr, "\n");
    return 2;
}
