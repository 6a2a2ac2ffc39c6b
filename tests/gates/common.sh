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
