// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace romanesco::bench {

/// What figures 17 and 18 of the dissertation have of a model.
struct Published {
    double loadSeconds;
    std::uint64_t bytes;
    /// Calls of its ClosestPointFace: of its collider for fractals, or of its simple one.
    std::uint64_t faceTests;
    /// Of its bounding boxes, by a formula.
    std::uint64_t boxTests;
};

/// b·t^d faces.
struct Shape {
    std::uint64_t b;
    std::uint64_t t;
    std::uint64_t d;
};

/// A model that is evaluated, as a file.
struct EvaluationModel {
    /// The dissertation's number, with a letter where several stand for one.
    std::string id;
    std::string title;
    std::filesystem::path path;
    /// As the text writes them.
    std::uint64_t faces;
    Published published;
    /// Of a fractal.
    std::optional<Shape> shape = {};
    /// Instead of the one in the text.
    std::optional<std::uint64_t> depth = {};

    /// Read from the disk, with the depth. Ends the program where it cannot be read.
    [[nodiscard]] std::string text() const;
    /// Ends the program where it cannot be made.
    [[nodiscard]] std::shared_ptr<const Scene> scene() const;
    /// Of the file and the mesh that it names.
    [[nodiscard]] std::uint64_t fileBytes() const;
};

/// Those of figure 16. Makes the two ordinary meshes, as OBJ files in a folder, and looks that they are what they are to
/// be, with the shapes of the others; ends the program where they are not.
[[nodiscard]] std::vector<EvaluationModel> evaluationModels(const std::filesystem::path &folder);

}
