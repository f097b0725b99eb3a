// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "supports.h"

namespace romanesco {

/// A sphere that falls, slides and bounces. It has no spin and no friction, and its mass is its volume.
struct Ball {
    /// The centre, in the world or at a place of one (see World).
    glm::dvec3 position{0.0};
    /// A second.
    glm::dvec3 velocity{0.0};
    /// Above 0.
    double radius = 1.0;
    /// The coefficient of restitution, from 0 to 1.
    double restitution = 1.0;
};

/// A ball, and what is known of it from step to step.
struct BallState : Ball {
    /// What it is counted from, its size and its speed too: 0 is the world.
    std::uint32_t place = 0;
    /// No point of the surface is nearer to the centre; 0 where that is not known.
    double clearance = 0.0;
    /// How its flight goes on, where that is known.
    struct Foresight {
        /// For so long it touches no surface, if it flies on from here with this velocity; 0 where nothing is known.
        double time = 0.0;
        glm::dvec3 velocity{0.0};
        /// Whether it comes near one then; else no more is known.
        bool endsNear = false;
    };
    Foresight foresight = {};
    /// What holds it up, and where it slides along.
    Supports supports = {};
    /// It rests: nothing moves it until something that it touches changes.
    bool isAsleep = false;
    /// It lies on other balls, or they on it: for so many steps it has hardly moved.
    bool isPiled = false;
    unsigned calmSteps = 0;
};

}
