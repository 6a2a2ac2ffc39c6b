# SPDX-License-Identifier: MIT
# What the checks of packages share; sourced. Sets `scratch`, a folder that is removed at the end.
. "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unset PHYS_PLUGIN_PATH LD_LIBRARY_PATH PKG_CONFIG_PATH

# quietly COMMAND...: its output is shown only if it fails.
quietly() {
    "$@" >"$scratch/output" 2>&1 || { cat "$scratch/output" >&2; fail "failed: $*"; }
}

# What makes CMake compile a library's sources in one go, which takes a third of the time.
in_one_go=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0)

# rolls PROGRAM: the C example runs and the ball has moved.
rolls() {
    "$1" "$source/mazes/levels/01.txt" >"$scratch/table"
    [ "$(wc -l <"$scratch/table")" -eq 21 ] || fail "expected 20 lines and a heading from $1"
    [ "$(sed -n 2p "$scratch/table" | cut -c1-24)" != "$(sed -n 10p "$scratch/table" | cut -c1-24)" ] ||
        fail "the ball doesn't move"
}
