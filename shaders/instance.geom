#version 450 core
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Tells each corner how far it is from the edge across, so that the fragment stage can draw wires.
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

layout(location = 0) in vec3 cornerPosition[];
#ifdef SMOOTH
layout(location = 1) in vec3 cornerNormal[];
#endif
#ifdef TEXTURED
layout(location = 2) in vec2 cornerTexture[];
#endif
#ifdef COLOURED
layout(location = 3) in vec3 cornerColour[];
#endif
#ifdef TINTED
layout(location = 4) flat in vec4 cornerTint[];
#endif

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
layout(location = 5) noperspective out vec3 edgeDistance;

// Triangles whose heights are less than this many pixels show no wires, lest there be nothing else.
const float leastHeight = 3.0;

vec3 heights()
{
    // What reaches behind the camera has no place on the screen.
    if (min(gl_in[0].gl_Position.w, min(gl_in[1].gl_Position.w, gl_in[2].gl_Position.w)) <= 0.0) {
        return vec3(1e9);
    }
    vec2 a = halfSize * gl_in[0].gl_Position.xy / gl_in[0].gl_Position.w;
    vec2 b = halfSize * gl_in[1].gl_Position.xy / gl_in[1].gl_Position.w;
    vec2 c = halfSize * gl_in[2].gl_Position.xy / gl_in[2].gl_Position.w;
    float area = abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    vec3 across = vec3(distance(b, c), distance(c, a), distance(a, b));
    vec3 found = area / max(across, vec3(1e-9));
    return min(found.x, min(found.y, found.z)) < leastHeight ? vec3(1e9) : found;
}

void main()
{
    vec3 height = heights();
    bool hasWires = height.x < 1e9;
    for (int i = 0; i < 3; ++i) {
        cameraPosition = cornerPosition[i];
#ifdef SMOOTH
        cameraNormal = cornerNormal[i];
#endif
#ifdef TEXTURED
        texturePlace = cornerTexture[i];
#endif
#ifdef COLOURED
        colour = cornerColour[i];
#endif
#ifdef TINTED
        tint = cornerTint[i];
#endif
        edgeDistance = hasWires ? vec3(0.0) : height;
        if (hasWires) {
            edgeDistance[i] = height[i];
        }
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
