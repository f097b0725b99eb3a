#version 450 core
#extension GL_GOOGLE_include_directive : require
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

#include "pass.glsl"

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
    gl_Position = clipFromCamera(cameraPosition);
}
