#version 450 core
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// The base mesh within the unit sphere, and for each copy the three rows of cameraFromMesh: everything is relative to
// the camera, in its axes, in units of the view.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 row0;
layout(location = 2) in vec4 row1;
layout(location = 3) in vec4 row2;

// clip = (scale.xy * camera.xy + jitter * w, depth), where depth is reversed: 1 near, 0 far.
layout(location = 0) uniform vec2 scale;
layout(location = 1) uniform vec2 jitter;
// Perspective: w = camera.z and depth = near / w. Orthographic: w = 1 and depth falls linearly over the range.
layout(location = 2) uniform bool isPerspective;
layout(location = 3) uniform float near;
layout(location = 4) uniform float range;

layout(location = 0) out vec3 cameraPosition;

void main()
{
    vec4 point = vec4(position, 1.0);
    cameraPosition = vec3(dot(row0, point), dot(row1, point), dot(row2, point));
    float w = isPerspective ? cameraPosition.z : 1.0;
    float depth = isPerspective ? near : 0.5 - 0.5 * cameraPosition.z / range;
    gl_Position = vec4(scale * cameraPosition.xy + jitter * w, depth, w);
}
