# SPDX-License-Identifier: MIT
# The systems that the library is for, and what its compilers are told there so that each operation is rounded to a
# double by itself. src/base/ieee_doubles.h ends the compilation where that fails; tests/gates/bits/everywhere builds, runs and
# compares the bits of all of these:
#
#   system             processors                                                     compilers
#   Linux (glibc)      x86-64, x86 of 32 bits with SSE2, ARM of 64 and 32 bits,       GCC 12, Clang 14
#                      RISC-V, POWER (little-endian), s390x (big-endian)
#   Windows (MinGW)    x86-64                                                         GCC 12
#
# Other Unix systems with dlopen should do; what isn't in this table isn't tried.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" OR CMAKE_CXX_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
    message(FATAL_ERROR "libphysics is compiled by GCC or Clang; found ${CMAKE_CXX_COMPILER_ID} (libphysics/cmake/systems.cmake)")
endif()
if(NOT UNIX AND NOT MINGW)
    message(FATAL_ERROR "libphysics is for Linux and other Unix systems, and for Windows by MinGW; found ${CMAKE_SYSTEM_NAME} (libphysics/cmake/systems.cmake)")
endif()

include(CheckCXXSourceCompiles)
check_cxx_source_compiles("#ifndef __i386__\n#error not x86 of 32 bits\n#endif\nint main() {}" PHYS_IS_X86_OF_32_BITS)

# Options of a target come behind those of the project around it: a parent's -ffast-math ends here.
target_compile_options(physics_build_options INTERFACE
    -fno-fast-math
    -ffp-contract=off                                   # a fused multiply-add would give other bits on other machines
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>   # where GCC 12 makes fused operations all the same (vfmaddsub)
    $<$<BOOL:${PHYS_IS_X86_OF_32_BITS}>:-msse2 -mfpmath=sse>)   # x87 rounds to 64 bits, and to double when it likes
