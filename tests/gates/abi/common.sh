# SPDX-License-Identifier: MIT
# What the checks of the binary interface share; sourced.
. "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

need_debug_information() {
    readelf --section-headers "$1" | grep '\.debug_info' >/dev/null ||
        skip "$1 has no debug information, without which abidiff sees no types"
}

# compare_interface BASELINE INCLUDE_FOLDER LIBRARY: any difference fails, however compatible it may be.
compare_interface() {
    abidiff --headers-dir2 "$2" "$1" "$3"
}
