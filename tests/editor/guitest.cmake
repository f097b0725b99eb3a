# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: Romanesco authors

# romanesco_gui_test(FOLDER SOURCE PLATFORM LINKS target…)
# A test that needs a QApplication, so each source is a program with a main function of its own. PLATFORM is Qt's:
# offscreen, or xcb where OpenGL is needed.
function(romanesco_gui_test folder source platform)
    cmake_parse_arguments(ARG "" "" "LINKS" ${ARGN})
    cmake_path(GET source STEM class)
    set(program test_${folder}_${class})
    add_executable(${program} ${source})
    target_link_libraries(${program} PRIVATE romanesco_options romanesco_sourcetree Qt6::Test ${ARG_LINKS})
    target_compile_definitions(${program} PRIVATE QT_NO_KEYWORDS)
    set_target_properties(${program} PROPERTIES AUTOMOC ON)
    # A display of its own: tests that run beside one another would move one another's mouse.
    set(display)
    if(platform STREQUAL xcb)
        set(display "${PROJECT_SOURCE_DIR}/packaging/withdisplay")
    endif()
    add_test(NAME ${folder}.${class} COMMAND ${display} $<TARGET_FILE:${program}>)
    set_tests_properties(${folder}.${class} PROPERTIES TIMEOUT 300 ENVIRONMENT "QT_QPA_PLATFORM=${platform}")
    if(platform STREQUAL xcb)
        set_property(TEST ${folder}.${class} APPEND PROPERTY LABELS display)
    else()
        # With a display in sight, this platform would find OpenGL on it.
        set_tests_properties(${folder}.${class} PROPERTIES ENVIRONMENT_MODIFICATION "DISPLAY=unset:")
        set_property(TEST ${folder}.${class} APPEND PROPERTY LABELS offscreen)
        add_dependencies(offscreen_tests ${program})
    endif()
endfunction()
