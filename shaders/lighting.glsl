// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors

// Needs pass.glsl; with LAMPS the scene's own lights shine.
struct Light {
    // In the camera's axes, in units of the view.
    vec4 place;
    vec4 colour;
};
layout(std430, binding = 0) readonly buffer Lights {
    Light lights[];
};

const vec3 sky = vec3(0.22, 0.26, 0.33);
const vec3 ground = vec3(0.07, 0.055, 0.045);
// The key light rides with the camera, above it and to the left, where the scene has no lights of its own.
const vec3 sun = vec3(1.15, 1.08, 0.95);
const vec3 toSun = normalize(vec3(-0.7, 0.75, -0.45));

// Linear.
struct Finish {
    vec3 own;
    vec3 specular;
    float shininess;
};

vec3 shaded(Finish finish, vec3 normal, vec3 toViewer, vec3 toLight, vec3 light)
{
    float facing = max(dot(normal, toLight), 0.0);
    float highlight = pow(max(dot(normal, normalize(toLight + toViewer)), 0.0), finish.shininess);
    return light * (finish.own * facing + finish.specular * highlight);
}

// What a place of a surface sends to the viewer.
vec3 litFrom(Finish finish, vec3 place, vec3 normal, vec3 toViewer)
{
    vec3 light = finish.own * mix(ground, sky, 0.5 + 0.5 * normal.y);
#ifdef LAMPS
    for (int i = 0; i < lightCount; ++i) {
        vec3 toLight = normalize(lights[i].place.xyz - place);
        light += shaded(finish, normal, toViewer, toLight, lights[i].colour.rgb);
    }
#else
    light += shaded(finish, normal, toViewer, toSun, sun);
#endif
    return light;
}
