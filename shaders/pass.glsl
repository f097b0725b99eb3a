// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// What all draws of a pass have in common. clip = (scale.xy * camera.xy + jitter * w, depth), where depth is reversed: 1
// near, 0 far.
layout(std140, binding = 0) uniform Pass {
    vec2 scale;
    vec2 jitter;
    vec2 halfSize;
    // Perspective: w = camera.z and depth = near / w. Orthographic: w = 1 and depth falls linearly over the range.
    float near;
    float range;
    bool isPerspective;
    bool isLit;
    uint number;
    int lightCount;
};

vec4 clipFromCamera(vec3 place)
{
    float w = isPerspective ? place.z : 1.0;
    float depth = isPerspective ? near : 0.5 - 0.5 * place.z / range;
    return vec4(scale * place.xy + jitter * w, depth, w);
}

// Orthographic, over many sizes: in logarithms, as fine near the camera's plane as far from it.
float deepDepth(float z)
{
    float way = log2(1.0 + abs(z)) / log2(1.0 + range);
    return 0.5 - 0.5 * sign(z) * way;
}
