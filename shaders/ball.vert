#version 450 core
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// A ball is a square, across the way to its centre, that its rim just fits into.

// The centre, in the camera's axes and in units of the view, and the radius.
layout(location = 0) in vec4 ball;
// sRGB.
layout(location = 1) in vec3 ballColour;

#include "pass.glsl"

// From the centre, along side and up.
layout(location = 0) out vec2 across;
layout(location = 1) flat out vec4 sphere;
layout(location = 2) flat out vec3 side;
layout(location = 3) flat out vec3 up;
// How far from the centre its outline lies in the square's plane.
layout(location = 4) flat out float rim;
layout(location = 5) flat out vec3 colour;

void main()
{
    sphere = ball;
    colour = ballColour;
    vec3 centre = ball.xyz;
    float away = length(centre);
    float ratio = ball.w / away;
    if (isPerspective && !(ratio < 1.0)) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0); // round the camera: not to be seen
        return;
    }
    vec3 forward = isPerspective ? centre / away : vec3(0.0, 0.0, 1.0);
    side = normalize(cross(abs(forward.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), forward));
    up = cross(forward, side);
    rim = isPerspective ? ball.w / sqrt(1.0 - ratio * ratio) : ball.w;
    float pixel = (isPerspective ? away : 1.0) / (scale.y * halfSize.y);
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    across = corner * (rim + 1.5 * pixel);
    gl_Position = clipFromCamera(centre + across.x * side + across.y * up);
}
