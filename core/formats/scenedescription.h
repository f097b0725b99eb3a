// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/geometry/affinemap.h"
#include "core/text/sourcerange.h"

namespace romanesco {

/// What an .sdo text says: what stands in a scene and how it is looked at. Ranges are of that text.
struct SceneDescription {
    struct Camera {
        glm::dvec3 position{0.0};
        /// In radians, the only angles that are.
        glm::dvec3 rotation{0.0};
        bool isOrthographic = false;
        /// The vertical field of view in degrees; of an orthographic camera the height of the view in scene units.
        double view = 60.0;
        SourceRange range;
    };

    enum class Kind { Object, Fractal, Ball };
    struct Item {
        Kind kind = Kind::Object;
        /// As written, relative to the folder of the text.
        std::string path;
        /// With its quotes.
        SourceRange pathRange;
        AffineMap worldFromModel;
        /// Of a ball: the coefficient of restitution, from 0 to 1, and the velocity at the start.
        double restitution = 1.0;
        glm::dvec3 velocity{0.0};
    };

    /// A point light; its colour is linear RGB.
    struct Light {
        glm::dvec3 position{0.0};
        glm::dvec3 colour{1.0};
    };

    std::optional<Camera> camera;
    /// In the order of the text.
    std::vector<Item> items;
    std::vector<Light> lights;
};

}
