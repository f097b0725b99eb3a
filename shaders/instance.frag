#version 450 core
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

layout(std140, binding = 0) uniform Pass {
    vec2 scale;
    vec2 jitter;
    vec2 halfSize;
    float near;
    float range;
    bool isPerspective;
    bool isLit;
    uint number;
    int lightCount;
};

// The material; colours are linear.
layout(location = 0) uniform vec3 diffuse;
layout(location = 1) uniform vec3 specular;
layout(location = 2) uniform float shininess;
layout(location = 3) uniform vec3 emission;
layout(location = 4) uniform float opacity;
layout(binding = 0) uniform sampler2D diffuseTexture;

struct Light {
    // In the camera's axes, in units of the view.
    vec4 place;
    vec4 colour;
};
layout(std430, binding = 0) readonly buffer Lights {
    Light lights[];
};

layout(location = 0) out vec4 result;
#ifdef DEEP
out float gl_FragDepth;
#endif

const vec3 sky = vec3(0.22, 0.26, 0.33);
const vec3 ground = vec3(0.07, 0.055, 0.045);
// The key light rides with the camera, above it and to the left, where the scene has no lights of its own.
const vec3 sun = vec3(1.15, 1.08, 0.95);
const vec3 toSun = normalize(vec3(-0.7, 0.75, -0.45));
const vec3 wire = vec3(0.015, 0.018, 0.025);

vec3 linearFromSrgb(vec3 c)
{
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

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

vec3 shaded(vec3 own, vec3 normal, vec3 toViewer, vec3 toLight, vec3 light)
{
    float facing = max(dot(normal, toLight), 0.0);
    float highlight = pow(max(dot(normal, normalize(toLight + toViewer)), 0.0), shininess);
    return light * (own * facing + specular * highlight);
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
        light = own * mix(ground, sky, 0.5 + 0.5 * normal.y);
#ifdef LAMPS
        for (int i = 0; i < lightCount; ++i) {
            vec3 toLight = normalize(lights[i].place.xyz - cameraPosition);
            light += shaded(own, normal, toViewer, toLight, lights[i].colour.rgb);
        }
#else
        light += shaded(own, normal, toViewer, toSun, sun);
#endif
    }
    light += emission;
#ifdef WIRES
    float edge = min(edgeDistance.x, min(edgeDistance.y, edgeDistance.z));
    light = mix(light, wire, 0.85 * (1.0 - smoothstep(0.4, 1.2, edge)));
#endif
#ifdef DEEP
    // Orthographic, over many sizes: in logarithms, as fine near the camera's plane as far from it.
    float way = log2(1.0 + abs(cameraPosition.z)) / log2(1.0 + range);
    gl_FragDepth = 0.5 - 0.5 * sign(cameraPosition.z) * way;
#endif
    result = vec4(light, 1.0);
}
