# SPDX-License-Identifier: MIT
# A copy of the library that is changed on purpose and built; sourced, with `folder` (libphysics) and `scratch` set.

# fresh_copy NAME: a copy of the library's sources; later runs of this test compile the same files again.
fresh_copy() {
    copy=$scratch/$1
    rm -rf "$copy"
    mkdir -p "$copy"
    cp -r "$folder"/{abi,include,src,steppers} "$copy"
}

# change FILE SED_PROGRAM: fails if the program changes nothing.
change() {
    cp "$copy/$1" "$scratch/before"
    sed -i "$2" "$copy/$1"
    ! cmp -s "$scratch/before" "$copy/$1" || fail "nothing to break in $1: adapt this test"
}

# build: the copy's library, all in one go and without optimisation.
build() {
    find "$copy/src" "$copy/steppers" -name '*.cpp' ! -name '*_windows.cpp' -print0 | sort -z |
        xargs -0 -P2 -I{} sh -c '${CMAKE_CXX_COMPILER_LAUNCHER:-} "${CXX:-g++}" -std=c++20 -g -O0 -fPIC -w \
            -fvisibility=hidden -fvisibility-inlines-hidden -I"$0/include" -I"$0/src" -I"$0/steppers" \
            -c "$1" -o "$1.o"' "$copy" {}
    g++ -shared -Wl,-soname,libphysics.so.1 -Wl,--version-script="$copy/src/physics.map" -o "$copy/libphysics.so" \
        $(find "$copy/src" "$copy/steppers" -name '*.o')
    ln -sf libphysics.so "$copy/libphysics.so.1"
}
