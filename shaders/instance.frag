#version 450 core
// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

layout(location = 0) in vec3 cameraPosition;

layout(location = 2) uniform bool isPerspective;

layout(location = 0) out vec4 colour;

// Linear colours.
const vec3 surface = vec3(0.62, 0.53, 0.38);
const vec3 sky = vec3(0.22, 0.26, 0.33);
const vec3 ground = vec3(0.07, 0.055, 0.045);
const vec3 sun = vec3(1.15, 1.08, 0.95);

// The key light rides with the camera, above it and to the left.
const vec3 toSun = normalize(vec3(-0.7, 0.75, -0.45));

void main()
{
    // The plane of the triangle, turned to the viewer: right for mirrored and sheared copies too.
    vec3 normal = normalize(cross(dFdx(cameraPosition), dFdy(cameraPosition)));
    vec3 toViewer = isPerspective ? -normalize(cameraPosition) : vec3(0.0, 0.0, -1.0);
    if (dot(normal, toViewer) < 0.0) {
        normal = -normal;
    }
    float diffuse = max(dot(normal, toSun), 0.0);
    float highlight = pow(max(dot(normal, normalize(toSun + toViewer)), 0.0), 40.0);
    vec3 ambient = mix(ground, sky, 0.5 + 0.5 * normal.y);
    colour = vec4(surface * (ambient + sun * diffuse) + 0.06 * sun * highlight, 1.0);
}
