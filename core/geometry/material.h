// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <glm/vec3.hpp>

#include "image.h"

namespace romanesco {

/// How a part of a mesh looks, as a Wavefront MTL file says it. Colours are red, green, blue from 0 to 1.
struct Material {
    std::string name;
    glm::vec3 diffuse{0.8F};
    glm::vec3 specular{0.0F};
    glm::vec3 emission{0.0F};
    /// Exponent of the highlight.
    float shininess = 0.0F;
    /// 0 is not seen at all.
    float opacity = 1.0F;
    /// Image that is multiplied with diffuse, a path as FileAccess takes it; empty for none.
    std::filesystem::path diffuseTexture{};
    /// Its pixels; null where nobody asked for them.
    std::shared_ptr<const Image> diffuseImage{};

    bool operator==(const Material &) const = default;
};

}
