// SPDX-License-Identifier: MIT
// Several suites in one program, linked once: QTEST_MAIN and its variants add a suite to the program instead of
// defining main; suites.cpp runs the suite that the first argument names. physics_add_suites includes this before each
// source, precompiled or not.
#pragma once

#include <QTest>

namespace support {

class Suite {
public:
    using Run = int (*)(int argc, char **argv);

    /// file: the source's name, which is also the suite's. Must live as long as the program.
    Suite(const char *file, Run start);

    QByteArray name() const;
    int run(int argc, char **argv) const { return m_run(argc, argv); }

    static const Suite *first();
    const Suite *next() const { return m_next; }

private:
    const char *m_file;
    Run m_run;
    const Suite *m_next;
};

} // namespace support

#undef QTEST_MAIN_WRAPPER
#define QTEST_MAIN_WRAPPER(TestObject, ...)                                                                            \
    static int run##TestObject(int argc, char *argv[]) {                                                               \
        QTest::Internal::callInitMain<TestObject>();                                                                   \
        __VA_ARGS__                                                                                                    \
        TestObject suite;                                                                                              \
        return QTest::qExec(&suite, argc, argv);                                                                       \
    }                                                                                                                  \
    static const support::Suite suiteOf##TestObject(__FILE_NAME__, run##TestObject);
