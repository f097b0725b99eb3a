# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: Romanesco authors

# Two Debian packages: the program, and the core for programs of others. Debian's policy wants a changelog and a
# copyright file in each; the program's dependencies stand here since the root that it is built in has no dpkg of its
# own to ask, and packaging/checks/package tries them in a system that has nothing else.
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)
add_custom_command(OUTPUT ${changelog}
    COMMAND ${GZIP} -9nc ${CMAKE_CURRENT_SOURCE_DIR}/debian/changelog > ${changelog}
    DEPENDS debian/changelog VERBATIM)
add_custom_target(romanesco_changelog ALL DEPENDS ${changelog})
foreach(package Program:romanesco Core:libromanesco-dev)
    string(REPLACE ":" ";" package ${package})
    list(GET package 0 component)
    list(GET package 1 name)
    install(FILES ${changelog} debian/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endforeach()

install(FILES debian/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME romanesco
    COMPONENT Program)

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL Program Core)
set(CPACK_PACKAGE_CONTACT "Romanesco authors <authors@romanesco.example>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME romanesco)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "editor for fractals
A fractal is a small mesh and a few lines that say how it is copied. Romanesco
shows it while you type, at any depth; lets balls fall on it; exports it as a
mesh; and measures what each approximation costs and how far off it is.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libc6 (>= 2.38), libstdc++6 (>= 14), libgcc-s1, libqt6core6t64 (>= 6.5), \
libqt6gui6 (>= 6.5), libqt6widgets6 (>= 6.5), libqt6opengl6 (>= 6.5), libqt6openglwidgets6 (>= 6.5), \
libqt6printsupport6 (>= 6.5), libqcustomplot2.1-qt6, libkf6syntaxhighlighting6, libepoxy0, libegl1, libhwy1t64")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-svg-plugins, qt6-wayland")

set(CPACK_DEBIAN_CORE_PACKAGE_NAME libromanesco-dev)
set(CPACK_DEBIAN_CORE_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CORE_DESCRIPTION "nearest points of fractals, and balls that fall on them
The part of Romanesco that knows nothing of windows: readers of its languages
and of OBJ, fractal graphs, colliders, and physics, as static libraries with a
CMake package.")
set(CPACK_DEBIAN_CORE_PACKAGE_DEPENDS "libglm-dev, libboost-dev, libhwy-dev")
include(CPack)
