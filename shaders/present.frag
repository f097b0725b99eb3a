#version 450 core
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

layout(location = 0) in vec2 place;

layout(binding = 0) uniform sampler2D accumulated;
layout(location = 0) uniform float sampleCount;
layout(location = 1) uniform vec3 backgroundTop;
layout(location = 2) uniform vec3 backgroundBottom;

layout(location = 0) out vec4 colour;

#include "srgb.glsl"

// What is not covered shows the background.
void main()
{
    vec3 behind = mix(backgroundBottom, backgroundTop, place.y);
#ifdef SINGLE
    // One sample is as it will be shown, and covered or not.
    vec4 picture = texture(accumulated, place);
    colour = vec4(behind * (1.0 - picture.a) + picture.rgb, 1.0);
#else
    // The sum of the samples holds light and coverage.
    vec4 picture = texture(accumulated, place) / sampleCount;
    vec3 light = picture.rgb + (1.0 - picture.a) * linearFromSrgb(behind);
    colour = vec4(srgbFromLinear(clamp(light, 0.0, 1.0)), 1.0);
#endif
}
