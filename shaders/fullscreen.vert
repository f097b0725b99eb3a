#version 450 core
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

layout(location = 0) out vec2 place;

// One triangle that covers the picture; place is (0, 0) at the bottom left and (1, 1) at the top right.
void main()
{
    place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
