# SPDX-License-Identifier: MIT
# What compilers and linkers do against the misuse of faults, where they can, in builds that are to be installed. None of
# it changes a number.
include(CheckCXXCompilerFlag)

# Not for Windows: GCC can't unwind a stack that it probes there, and the checks would need another library. Sanitizers
# check more, and don't go with it.
if(UNIX AND NOT PHYS_SANITIZE)
    foreach(flag -fstack-protector-strong -fstack-clash-protection -fcf-protection)
        string(MAKE_C_IDENTIFIER "PHYS_HAS${flag}" known)
        check_cxx_compiler_flag("${flag} -Werror" ${known})
        if(${known})
            target_compile_options(physics_build_options INTERFACE $<$<NOT:$<CONFIG:Debug>>:${flag}>)
        endif()
    endforeach()
    # The C library's checked functions, which need an optimising compiler.
    target_compile_options(physics_build_options INTERFACE
        "$<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
endif()
if(UNIX AND NOT APPLE) # all symbols are bound at the start, and their table is read-only from then on
    target_link_options(physics_build_options INTERFACE LINKER:-z,relro LINKER:-z,now)
endif()
