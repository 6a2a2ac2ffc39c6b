# SPDX-License-Identifier: GPL-3.0-or-later
# Where `cmake --install` puts the inspector, the levels that it plays, and what a desktop wants to know of it.
include(GNUInstallDirs)

# In a prefix of its own the library is found beside the program; in /usr the system finds it.
if(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    # One RUNPATH for both trees: CMake pads that of the build tree to the installed one's length with an empty entry, and
    # that is the current folder.
    set_target_properties(physics-inspector PROPERTIES BUILD_WITH_INSTALL_RPATH ON
        INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR};$ORIGIN/../libphysics")
endif()
install(TARGETS physics-inspector RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT inspector)
install(TARGETS mazegen RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT inspector)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/mazes/levels DESTINATION ${CMAKE_INSTALL_DATADIR}/physics COMPONENT inspector)
install(FILES packaging/physics-inspector.desktop
    DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT inspector)
install(FILES packaging/physics-inspector.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT inspector)
install(FILES packaging/physics-inspector.metainfo.xml
    DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT inspector)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/physics-inspector RENAME copyright COMPONENT inspector)
