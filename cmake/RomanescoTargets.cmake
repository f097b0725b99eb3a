# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: Romanesco authors

# One place for what every target is compiled with.
add_library(romanesco_options INTERFACE)
target_compile_options(romanesco_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    # The same bits on every compiler and optimisation level: no fused multiply-add.
    -ffp-contract=off)
# Q_SIGNALS, Q_SLOTS and Q_EMIT are Qt's; the plain words stay ours.
target_compile_definitions(romanesco_options INTERFACE QT_NO_KEYWORDS)
if(ROMANESCO_WERROR)
    target_compile_options(romanesco_options INTERFACE -Werror)
endif()
target_include_directories(romanesco_options INTERFACE ${PROJECT_SOURCE_DIR})

# romanesco_library(NAME SOURCES file… LINKS target…)
# A static library, one for each folder. LINKS names the only folders and packages it may include from.
function(romanesco_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    # How the project is compiled is nothing to those who use an installed library.
    target_link_libraries(${name} PUBLIC $<BUILD_INTERFACE:romanesco_options> ${ARG_LINKS})
endfunction()
