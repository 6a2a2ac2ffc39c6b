# SPDX-License-Identifier: MIT
# `cpack` makes Debian packages of what `cmake --install` installs: runtime, development, Python, inspector.
# Configure with -DCMAKE_INSTALL_PREFIX=/usr.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME physics)
set(CPACK_PACKAGE_VENDOR "physics")
set(CPACK_PACKAGE_CONTACT "physics maintainers <maintainers@physics.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development python)
if(PHYS_BUILD_INSPECTOR)
    list(APPEND CPACK_COMPONENTS_ALL inspector)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/libphysics)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libphysics1)          # 1: PHYS_ABI_VERSION
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/libphysics/cmake/debian/triggers ${PROJECT_BINARY_DIR}/debian/symbols)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Physics steps for a ball in a maze: the library
 Computes the steps of one ball that rolls through a maze of boxes, behind a
 stable C interface, with steppers from the cheapest to the exact one.")

set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/libphysics/cmake/debian/finish.cmake)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libphysics-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libphysics1 (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Physics steps for a ball in a maze: development files
 Headers, CMake package, pkg-config file, model and examples, all that it
 takes to link the library or to write a stepper as a plugin.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-libphysics)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libphysics1 (>= ${PROJECT_VERSION}), python3, python3-numpy")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Physics steps for a ball in a maze: Python package
 The library for numpy: scenes, steps with their events, and many balls for
 many steps at once.")

set(CPACK_DEBIAN_INSPECTOR_PACKAGE_NAME physics-inspector)
set(CPACK_DEBIAN_INSPECTOR_PACKAGE_SECTION science)
set(CPACK_DEBIAN_INSPECTOR_PACKAGE_DEPENDS "libphysics1 (>= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_INSPECTOR_DESCRIPTION "Physics steps for a ball in a maze: the inspector
 Shows a maze, tilts it, and plots what each stepper makes of the ball, with
 sliders for friction and restitution.")

# Which version brought which symbol: what the header says of each function.
function(physics_write_debian_symbols path)
    file(READ ${PROJECT_SOURCE_DIR}/libphysics/include/physics/physics.h header)
    file(STRINGS ${PROJECT_SOURCE_DIR}/libphysics/abi/symbols.txt names)
    set(text "libphysics.so.1 libphysics1 #MINVER#\n PHYS_1@PHYS_1 1.0\n")
    foreach(name ${names})
        if(NOT header MATCHES "PHYS_API [^;]*[ *]${name}\\(")
            message(FATAL_ERROR "physics.h: expected a declaration of ${name}")
        endif()
        string(FIND "${header}" "${CMAKE_MATCH_0}" place)
        string(SUBSTRING "${header}" 0 ${place} before)
        string(REGEX MATCH ".*Since ([0-9]+\\.[0-9]+)" since "${before}") # the last one
        string(APPEND text " ${name}@PHYS_1 ${CMAKE_MATCH_1}\n")
    endforeach()
    file(CONFIGURE OUTPUT ${path} CONTENT "${text}" @ONLY)
endfunction()
physics_write_debian_symbols(${PROJECT_BINARY_DIR}/debian/symbols)

include(CPack)
