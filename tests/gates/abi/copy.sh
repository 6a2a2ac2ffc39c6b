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

# build: the copy's library, all sources in one and without optimisation.
build() {
    find "$copy/src" "$copy/steppers" -name '*.cpp' ! -name '*_windows.cpp' | LC_ALL=C sort |
        sed 's/.*/#include "&"/' >"$copy/library.cpp"
    ${CMAKE_CXX_COMPILER_LAUNCHER:-} "${CXX:-g++}" -std=c++20 -g -O0 $quick_flags -fPIC -fvisibility=hidden \
        -fvisibility-inlines-hidden -I"$copy/include" -I"$copy/src" -I"$copy/steppers" \
        -c "$copy/library.cpp" -o "$copy/library.o"
    g++ -shared -Wl,-soname,libphysics.so.1 -Wl,--version-script="$copy/src/physics.map" -o "$copy/libphysics.so" \
        "$copy/library.o"
    ln -sf libphysics.so "$copy/libphysics.so.1"
}
