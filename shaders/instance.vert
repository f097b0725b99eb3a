#version 450 core
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// SMOOTH, TEXTURED, COLOURED, TINTED are set for what there is of the kind in a draw.

// The base mesh within the unit sphere, and for each copy the three rows of cameraFromMesh: everything is relative to
// the camera, in its axes, in units of the view.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 row0;
layout(location = 2) in vec4 row1;
layout(location = 3) in vec4 row2;
// sRGB, and how much of it lies over the surface's own colour.
layout(location = 4) in vec4 copyTint;
// Zero where the face is flat.
layout(location = 5) in vec3 meshNormal;
layout(location = 6) in vec2 meshTexture;
layout(location = 7) in vec3 meshColour;

// clip = (scale.xy * camera.xy + jitter * w, depth), where depth is reversed: 1 near, 0 far.
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

layout(location = 0) out vec3 cameraPosition;
#ifdef SMOOTH
layout(location = 1) out vec3 cameraNormal;
#endif
#ifdef TEXTURED
layout(location = 2) out vec2 texturePlace;
#endif
#ifdef COLOURED
layout(location = 3) out vec3 colour;
#endif
#ifdef TINTED
layout(location = 4) flat out vec4 tint;
#endif

void main()
{
    vec4 point = vec4(position, 1.0);
    cameraPosition = vec3(dot(row0, point), dot(row1, point), dot(row2, point));
#ifdef SMOOTH
    // The cofactors: right for sheared and flat copies too, but for the sign, which the fragment stage finds.
    mat3 cofactors = mat3(cross(row1.xyz, row2.xyz), cross(row2.xyz, row0.xyz), cross(row0.xyz, row1.xyz));
    cameraNormal = meshNormal * cofactors;
#endif
#ifdef TEXTURED
    texturePlace = meshTexture;
#endif
#ifdef COLOURED
    colour = meshColour;
#endif
#ifdef TINTED
    tint = copyTint;
#endif
    float w = isPerspective ? cameraPosition.z : 1.0;
    float depth = isPerspective ? near : 0.5 - 0.5 * cameraPosition.z / range;
    gl_Position = vec4(scale * cameraPosition.xy + jitter * w, depth, w);
}
