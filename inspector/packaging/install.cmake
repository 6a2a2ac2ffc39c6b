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
foreach(page README.md inspector/README.md mazes/README.md libphysics/README.md) # with the links between them
    get_filename_component(folder ${page} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${CMAKE_INSTALL_DATADIR}/physics/doc/${folder}
        COMPONENT inspector)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/libphysics/docs DESTINATION ${CMAKE_INSTALL_DATADIR}/physics/doc/libphysics
    COMPONENT inspector FILES_MATCHING PATTERN "*.md" PATTERN "*.svg")
install(FILES packaging/physics-inspector.desktop
    DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT inspector)
install(FILES packaging/physics-inspector.svg
    DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT inspector)
install(FILES packaging/io.github.physics.inspector.metainfo.xml # by its id
    DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT inspector)
install(FILES packaging/physics-inspector-types.xml
    DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME physics-inspector.xml COMPONENT inspector)
foreach(program physics-inspector mazegen)
    install(FILES packaging/completion.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program} COMPONENT inspector)
endforeach()

# Manual pages are what the programs say of themselves; another machine's programs can't be asked.
find_program(GZIP gzip)
function(inspector_man_page program summary)
    set(page ${CMAKE_CURRENT_BINARY_DIR}/${program}.1.gz)
    add_custom_command(OUTPUT ${page} VERBATIM
        COMMAND bash -c "set -o pipefail; \"$0\" \"$1\" \"$2\" \"$3\" | \"$4\" -9n >\"$5\""
            ${CMAKE_CURRENT_SOURCE_DIR}/packaging/man_page $<TARGET_FILE:${program}> ${PROJECT_VERSION} ${summary} ${GZIP} ${page}
        DEPENDS ${program} packaging/man_page)
    add_custom_target(${program}_man_page ALL DEPENDS ${page})
    install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT inspector)
endfunction()
if(GZIP AND NOT CMAKE_CROSSCOMPILING AND NOT PHYS_SANITIZE)
    inspector_man_page(physics-inspector "shows, plays and tunes a ball rolling through a maze")
    inspector_man_page(mazegen "makes mazes for a rolling ball")
endif()
