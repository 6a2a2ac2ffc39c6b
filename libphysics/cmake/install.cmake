# SPDX-License-Identifier: MIT
# What `cmake --install` puts where: library, headers, CMake package, pkg-config file, plugin folder, documents.
# Debian's folder of libraries, whatever the prefix: its packages are made of the same tree.
# A plain lib is what an earlier configuration took by itself.
if(EXISTS /etc/debian_version AND CMAKE_LIBRARY_ARCHITECTURE AND "${CMAKE_INSTALL_LIBDIR}" MATCHES "^(lib)?$")
    set(CMAKE_INSTALL_LIBDIR lib/${CMAKE_LIBRARY_ARCHITECTURE} CACHE PATH "Folder of libraries below the prefix" FORCE)
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(physics_library_dir ${CMAKE_INSTALL_LIBDIR})
if(WIN32)
    set(physics_library_dir ${CMAKE_INSTALL_BINDIR})
endif()
set(physics_plugin_dir ${physics_library_dir}/physics-1)    # beside the library; 1: PHYS_ABI_VERSION
set(physics_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/physics)
set(physics_document_dir ${CMAKE_INSTALL_DATADIR}/doc/libphysics-dev)

install(TARGETS physics physics_headers EXPORT physics-targets
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY DESTINATION ${physics_plugin_dir} COMPONENT runtime)
install(DIRECTORY include/physics DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

install(EXPORT physics-targets NAMESPACE physics:: DESTINATION ${physics_cmake_dir} COMPONENT development)
configure_package_config_file(cmake/physics-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/physics-config.cmake
    INSTALL_DESTINATION ${physics_cmake_dir} PATH_VARS physics_plugin_dir)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/physics-config-version.cmake
    COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/physics-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/physics-config-version.cmake
    DESTINATION ${physics_cmake_dir} COMPONENT development)

# The prefix is told from the file's own place, so that an installed tree can be moved.
file(RELATIVE_PATH physics_prefix_from_pc /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" physics_prefix_from_pc "${physics_prefix_from_pc}")
if(PHYS_STATIC)
    set(physics_pc_definitions " -DPHYS_STATIC")
    set(physics_pc_libraries " -lstdc++ -lm")
endif()
configure_file(cmake/physics.pc.in ${CMAKE_CURRENT_BINARY_DIR}/physics.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/physics.pc
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)

if(CMAKE_INSTALL_LIBDIR STREQUAL "lib/${CMAKE_LIBRARY_ARCHITECTURE}")
    configure_file(cmake/links.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/links.cmake @ONLY)
    foreach(component runtime development)
        install(SCRIPT ${CMAKE_CURRENT_BINARY_DIR}/links.cmake COMPONENT ${component})
    endforeach()
endif()

# Links of the pages as installed: to where headers and the Python package's page are then; what isn't installed is
# named only.
file(RELATIVE_PATH physics_headers_from_pages /prefix/${physics_document_dir} /prefix/${CMAKE_INSTALL_INCLUDEDIR})
file(GLOB physics_pages RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} README.md docs/*.md)
foreach(page ${physics_pages})
    file(READ ${page} text)
    string(REGEX REPLACE "\\[([^][]*)\\]\\(\\.\\./\\.\\./[^)]*\\)" "\\1" text "${text}")
    string(REPLACE "](include/" "](${physics_headers_from_pages}/" text "${text}")
    string(REPLACE "](python/" "](../python3-libphysics/" text "${text}")
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/pages/${page} CONTENT "${text}" @ONLY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${page})
endforeach()
install(DIRECTORY docs examples DESTINATION ${physics_document_dir} COMPONENT development
    PATTERN __pycache__ EXCLUDE REGEX "/docs/[a-z_]*\\.md$" EXCLUDE)
install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/pages/ DESTINATION ${physics_document_dir} COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/mazes/levels/01.txt DESTINATION ${physics_document_dir}/examples
    COMPONENT development)

if(NOT PHYS_STATIC) # the package loads the shared library
    install(DIRECTORY python/libphysics DESTINATION lib/python3/dist-packages COMPONENT python   # where Debian's Python looks
        PATTERN __pycache__ EXCLUDE)
    install(FILES python/README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-libphysics COMPONENT python)
    install(DIRECTORY python/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-libphysics COMPONENT python
        USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
endif()

# Licences and changelog as Debian wants them in each package.
configure_file(cmake/debian/changelog.in ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog @ONLY)
find_program(GZIP gzip)
if(GZIP)
    execute_process(COMMAND ${GZIP} -9nc ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog
        OUTPUT_FILE ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
endif()
set(documented libphysics1:runtime libphysics-dev:development python3-libphysics:python)
if(PHYS_BUILD_INSPECTOR)
    list(APPEND documented physics-inspector:inspector)
endif()
foreach(package ${documented})
    string(REPLACE ":" ";" package ${package})
    list(GET package 0 name)
    list(GET package 1 component)
    install(FILES cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
    if(GZIP)
        install(FILES ${CMAKE_CURRENT_BINARY_DIR}/debian/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
            COMPONENT ${component})
    endif()
endforeach()
