// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/fractaldescription.h"
#include "core/formats/scenedescription.h"
#include "model.h"
#include "savedview.h"

namespace romanesco {

/// A model at its place. Several items may share one model.
struct SceneItem {
    std::shared_ptr<const Model> model;
    /// Any affine map: mirrored, of unequal scales, flat.
    AffineMap worldFromModel = {};
    SceneDescription::Kind kind = SceneDescription::Kind::Fractal;
    /// As the .sdo writes it; empty where the file itself is the scene.
    std::string path = {};
    /// Of a ball: the coefficient of restitution, from 0 to 1, and the velocity at the start.
    double restitution = 1.0;
    glm::dvec3 velocity{0.0};
};

/// What is drawn: the items of an .sdo, or an .fdo or .obj as the only one, at the identity. Immutable, so it is passed
/// between threads as it is.
struct Scene {
    std::vector<SceneItem> items;
    /// Without one the view is fitted.
    std::optional<SceneDescription::Camera> camera;
    /// Goes before the camera.
    std::optional<SavedView> view;
    std::vector<SceneDescription::Light> lights;
    /// Holds all items; all zero where there is nothing.
    Box extent;
    /// In the scene's own text, the number that a depth slider moves; nothing for an .sdo, whose fractals are texts of
    /// their own.
    std::optional<FractalDescription::Depth> depth;
};

/// A scene of one model as it is.
[[nodiscard]] Scene sceneOf(std::shared_ptr<const Model> model);

/// A sphere that holds an item, in the world.
[[nodiscard]] Sphere boundingSphere(const SceneItem &item);
/// One that holds all items; empty where there is nothing.
[[nodiscard]] Sphere boundingSphere(const Scene &scene);

/// How far the items reach along a direction u: the greatest u·x of their points x, or a few per cent of their size more.
/// -inf for nothing. Cost: that of reachAlong() of a graph for each item that may reach farthest.
[[nodiscard]] double reachAlong(const std::vector<SceneItem> &items, const glm::dvec3 &direction);

/// A box that holds all items, each side reached as reachAlong() tells. All zero for nothing.
[[nodiscard]] Box extentOf(const std::vector<SceneItem> &items);

}
