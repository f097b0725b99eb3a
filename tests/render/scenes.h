// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <map>
#include <memory>
#include <string>

#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/scene/anchor.h"
#include "core/scene/sceneloader.h"
#include "tests/sourcetree.h"

namespace romanesco::test {

/// Files that exist only in a test.
class TableFiles final : public FileAccess
{
public:
    std::map<std::string, std::string> files;

    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override
    {
        const auto found = files.find(path.string());
        return found == files.end() ? std::expected<std::string, std::string>(std::unexpect, "no such file")
                                    : found->second;
    }
};

/// A box of two triangles a side: corners a and b.
inline std::string boxObj(const glm::dvec3 &a, const glm::dvec3 &b)
{
    std::string text;
    for (int corner = 0; corner < 8; ++corner) {
        const double x = corner & 1 ? b.x : a.x;
        const double y = corner & 2 ? b.y : a.y;
        const double z = corner & 4 ? b.z : a.z;
        char line[200];
        std::snprintf(line, sizeof(line), "v %.17g %.17g %.17g\n", x, y, z);
        text += line;
    }
    return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
}

/// A scene from an .fdo text whose mesh "box.obj" is the cube ±1, unless another is given. Null where the text is wrong.
inline std::shared_ptr<const Scene> sceneOf(const std::string &text,
                                            const std::string &mesh = boxObj({-1, -1, -1}, {1, 1, 1}))
{
    TableFiles files;
    files.files["box.obj"] = mesh;
    return SceneLoader(files).load("test.fdo", text).scene;
}

/// One that comes with the program, of another depth if there is one given.
inline std::shared_ptr<const Scene> example(const std::string &name, const std::string &depth = {})
{
    const std::filesystem::path path = test::sourcePath("resources/examples/").toStdString() + name;
    const DiskFiles files;
    std::string text = files.read(path).value();
    if (!depth.empty()) {
        const std::size_t last = text.rfind(' ', text.find_last_of("0123456789"));
        text = text.substr(0, last + 1) + depth + "\n";
    }
    return SceneLoader(files).load(path, text).scene;
}

/// Round the whole scene.
inline Sphere around(const Scene &scene)
{
    return {scene.extent.centre(), 0.5 * glm::length(scene.extent.size())};
}

/// The root of a model at a place.
inline std::vector<Surroundings::Node> rootAt(const AffineMap &map)
{
    return {{.item = 0, .state = Positions{0}, .hereFromNode = map}};
}

/// The model of such a scene.
inline std::shared_ptr<const Model> modelOf(const std::string &text,
                                            const std::string &mesh = boxObj({-1, -1, -1}, {1, 1, 1}))
{
    return sceneOf(text, mesh)->items.at(0).model;
}

/// A scene of such models, each at its place.
inline std::shared_ptr<const Scene>
assembled(const std::vector<std::pair<std::shared_ptr<const Model>, AffineMap>> &items)
{
    Scene scene;
    for (const auto &[model, worldFromModel] : items) {
        scene.items.push_back({.model = model, .worldFromModel = worldFromModel});
    }
    scene.extent = extentOf(scene.items);
    return std::make_shared<const Scene>(std::move(scene));
}

}
