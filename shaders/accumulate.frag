#version 450 core
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

layout(binding = 0) uniform sampler2D sampled;

layout(location = 0) out vec4 colour;

void main()
{
    colour = texelFetch(sampled, ivec2(gl_FragCoord.xy), 0);
}
