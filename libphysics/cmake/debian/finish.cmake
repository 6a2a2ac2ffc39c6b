# SPDX-License-Identifier: MIT
# After cpack: takes out the scripts by which CPack calls ldconfig itself; the package's trigger does that, once for all
# packages that are installed together.
find_program(DPKG_DEB dpkg-deb REQUIRED)
foreach(package IN LISTS CPACK_PACKAGE_FILES)
    if(package MATCHES "/libphysics1_")
        set(tree ${CPACK_TEMPORARY_DIRECTORY}/finish)
        file(REMOVE_RECURSE ${tree})
        execute_process(COMMAND ${DPKG_DEB} --raw-extract ${package} ${tree} COMMAND_ERROR_IS_FATAL ANY)
        file(REMOVE ${tree}/DEBIAN/postinst ${tree}/DEBIAN/postrm)
        execute_process(COMMAND ${DPKG_DEB} --root-owner-group --build ${tree} ${package}
            OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
        file(REMOVE_RECURSE ${tree})
    endif()
endforeach()
