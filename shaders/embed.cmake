# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: Romanesco authors
string(REPLACE "," ";" STAGES "${STAGES}")
set(text "#pragma once\n\nnamespace romanesco::shaders {\n\n")
foreach(stage IN LISTS STAGES)
    string(REPLACE "." "_" name ${stage})
    file(READ ${SOURCE}/${stage} source)
    string(APPEND text "inline constexpr const char *${name} = R\"glsl(${source})glsl\";\n\n")
endforeach()
string(APPEND text "}\n")
file(WRITE ${OUTPUT} "${text}")
