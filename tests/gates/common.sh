# SPDX-License-Identifier: MIT
# What the gates' checks share; sourced.
set -euo pipefail

fail() {
    echo "$(basename "$0"): $*" >&2
    exit 1
}

# A check that can't be made here says so; ctest shows it as skipped.
skip() {
    echo "$(basename "$0"): skipped: $*"
    exit 77
}

# What makes a compiler quicker, whatever it compiles: no warnings, which are errors where the suites are built, and
# garbage that GCC collects later.
quick_flags=-w
if "${CXX:-c++}" --version | grep 'Free Software' >/dev/null; then quick_flags+=' --param=ggc-min-heapsize=1000000'; fi
