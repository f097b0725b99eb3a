#version 450 core
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// DEEP and LAMPS as for surfaces.
layout(location = 0) in vec2 across;
layout(location = 1) flat in vec4 sphere;
layout(location = 2) flat in vec3 side;
layout(location = 3) flat in vec3 up;
layout(location = 4) flat in float rim;
layout(location = 5) flat in vec3 colour;

#include "pass.glsl"
#include "lighting.glsl"
#include "srgb.glsl"

// Of the picture behind, and its size in pixels of what is drawn into.
layout(binding = 0) uniform sampler2D depths;
layout(location = 0) uniform vec2 picturePerPixel;

layout(location = 0) out vec4 result;

void main()
{
    float away = length(across);
    float pixel = max(length(dFdx(across)), length(dFdy(across)));
    float covered = clamp((rim - away) / pixel + 0.5, 0.0, 1.0);
    if (covered == 0.0) {
        discard;
    }
    // Beside the outline the nearest of it. All is counted from the place in the plane, so that floats do for far balls.
    vec2 within = across * min(1.0, 0.999 * rim / max(away, 1e-30));
    vec3 toCentre = -(within.x * side + within.y * up);
    vec3 ray = isPerspective ? normalize(sphere.xyz - toCentre) : vec3(0.0, 0.0, 1.0);
    float along = dot(ray, toCentre);
    float half2 = along * along - dot(toCentre, toCentre) + sphere.w * sphere.w;
    vec3 fromCentre = (along - sqrt(max(half2, 0.0))) * ray - toCentre;
    vec3 place = sphere.xyz + fromCentre;
    if (isPerspective && place.z <= near) {
        discard;
    }
#ifdef DEEP
    float depth = deepDepth(place.z);
#else
    float depth = isPerspective ? near / place.z : 0.5 - 0.5 * place.z / range;
#endif
    if (texelFetch(depths, ivec2(gl_FragCoord.xy * picturePerPixel), 0).r > depth) {
        discard;
    }
    vec3 light = linearFromSrgb(colour);
    if (isLit) {
        light = litFrom(Finish(light, vec3(0.12), 60.0), place, normalize(fromCentre), -ray);
    }
    result = vec4(srgbFromLinear(clamp(light, 0.0, 1.0)) * covered, covered);
}
