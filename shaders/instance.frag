#version 450 core
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// What is not set here costs nothing: software computes all branches for all pixels. Beside those of the vertex stage
// there are WIRES, LAMPS (the scene's own lights), SEE_THROUGH and DEEP.
layout(location = 0) in vec3 cameraPosition;
#ifdef SMOOTH
layout(location = 1) in vec3 cameraNormal;
#endif
#ifdef TEXTURED
layout(location = 2) in vec2 texturePlace;
#endif
#ifdef COLOURED
layout(location = 3) in vec3 colour;
#endif
#ifdef TINTED
layout(location = 4) flat in vec4 tint;
#endif
#ifdef WIRES
// In pixels.
layout(location = 5) noperspective in vec3 edgeDistance;
#endif

#include "pass.glsl"
#include "lighting.glsl"
#include "srgb.glsl"

// The material; colours are linear.
layout(location = 0) uniform vec3 diffuse;
layout(location = 1) uniform vec3 specular;
layout(location = 2) uniform float shininess;
layout(location = 3) uniform vec3 emission;
layout(location = 4) uniform float opacity;
layout(binding = 0) uniform sampler2D diffuseTexture;

layout(location = 0) out vec4 result;
#ifdef DEEP
out float gl_FragDepth;
#endif

const vec3 wire = vec3(0.015, 0.018, 0.025);

// The same for the same place in the same pass (Jarzynski and Olano 2020, pcg3d).
float noise(vec3 place)
{
    uvec3 v = floatBitsToUint(place) + uvec3(0u, 0u, number);
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return float(v.x >> 8u) / 16777216.0;
}

void main()
{
    // The plane of the triangle, turned to the viewer: right for mirrored and sheared copies too.
    vec3 plane = normalize(cross(dFdx(cameraPosition), dFdy(cameraPosition)));
    vec3 toViewer = isPerspective ? -normalize(cameraPosition) : vec3(0.0, 0.0, -1.0);
    plane = dot(plane, toViewer) < 0.0 ? -plane : plane;

    vec4 texel = vec4(1.0);
#ifdef TEXTURED
    texel = texture(diffuseTexture, texturePlace);
#endif
#ifdef SEE_THROUGH
    // What is see-through covers as many of the samples as it is opaque.
    float solid = opacity * texel.a;
    if (solid < 1.0 && noise(gl_FragCoord.xyz) >= solid) {
        discard;
    }
#endif
    vec3 own = diffuse * texel.rgb;
#ifdef COLOURED
    own *= colour;
#endif
#ifdef TINTED
    own = mix(own, linearFromSrgb(tint.rgb), tint.a);
#endif

    vec3 light = own;
    if (isLit) {
        vec3 normal = plane;
#ifdef SMOOTH
        float size = length(cameraNormal);
        if (size > 0.0) {
            normal = cameraNormal / size;
            normal = dot(normal, plane) < 0.0 ? -normal : normal;
        }
#endif
        light = litFrom(Finish(own, specular, shininess), cameraPosition, normal, toViewer);
    }
    light += emission;
#ifdef WIRES
    float edge = min(edgeDistance.x, min(edgeDistance.y, edgeDistance.z));
    light = mix(light, wire, 0.85 * (1.0 - smoothstep(0.4, 1.2, edge)));
#endif
#ifdef DEEP
    gl_FragDepth = deepDepth(cameraPosition.z);
#endif
    result = vec4(light, 1.0);
}
