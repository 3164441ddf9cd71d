# SPDX-License-Identifier: MIT
# For programs that use the proposed extensions: <GL/glext_emu.h>, and glext_emu.pc, by which pkg-config tells where it
# lies. There is nothing to link: the commands come from GetProcAddress, as those of any extension.
set(proposed_registry ${PROJECT_SOURCE_DIR}/glext_emu/registry/proposed.xml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${proposed_registry})
file(STRINGS ${proposed_registry} PROPOSED_EXTENSIONS REGEX "<extension name=")
list(TRANSFORM PROPOSED_EXTENSIONS REPLACE ".*<extension name=\"([A-Za-z0-9_]+)\".*" "\\1")
list(JOIN PROPOSED_EXTENSIONS " " PROPOSED_EXTENSIONS)
configure_file(${CMAKE_CURRENT_LIST_DIR}/glext_emu.pc.in ${PROJECT_BINARY_DIR}/glext_emu.pc @ONLY)

install(FILES ${PROJECT_BINARY_DIR}/include/GL/glext_emu.h DESTINATION include/GL COMPONENT layer)
install(FILES ${PROJECT_BINARY_DIR}/glext_emu.pc DESTINATION lib/pkgconfig COMPONENT layer)
