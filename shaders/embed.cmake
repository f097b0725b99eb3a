# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: Romanesco authors

# Drivers know no #include: what a stage includes takes the line's place, and the extension is not asked for.
string(REPLACE "," ";" STAGES "${STAGES}")
set(text "#pragma once\n\nnamespace romanesco::shaders {\n\n")
foreach(stage IN LISTS STAGES)
    string(REPLACE "." "_" name ${stage})
    file(READ ${SOURCE}/${stage} source)
    string(REPLACE "#extension GL_GOOGLE_include_directive : require\n" "" source "${source}")
    while(source MATCHES "#include \"([^\"]+)\"\n")
        file(READ ${SOURCE}/${CMAKE_MATCH_1} included)
        string(REPLACE "${CMAKE_MATCH_0}" "${included}" source "${source}")
    endwhile()
    string(APPEND text "inline constexpr const char *${name} = R\"glsl(${source})glsl\";\n\n")
endforeach()
string(APPEND text "}\n")
file(WRITE ${OUTPUT} "${text}")
