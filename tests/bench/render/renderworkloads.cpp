// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renderworkloads.h"

#include <cstdio>
#include <cstdlib>
#include <map>

#include "core/base/file.h"
#include "core/formats/fdoreader.h"
#include "core/scene/sceneloader.h"
#include "render/camera.h"

namespace romanesco::bench {

namespace {

/// From where to where one looks.
struct Sight {
    glm::dvec3 from;
    glm::dvec3 to;
};

/// Near and inside.
const std::map<std::string, std::array<Sight, 2>> sights{
    {"menger", {{{{1.2, 1.9, -2.1}, {0.4, 0.9, -1.3}}, {{0.1, 0.2, -0.45}, {0.55, 0.0, 0.4}}}}},
    {"sierpinski", {{{{0.35, 0.75, -0.9}, {0.0, 0.6, 0.0}}, {{0.1, 0.3, -0.35}, {-0.2, 0.55, 0.4}}}}},
    {"tree", {{{{0.9, 2.4, -1.4}, {0.2, 1.9, 0.0}}, {{0.2, 1.5, -0.35}, {0.1, 2.2, 0.6}}}}},
    {"tree7", {{{{1.3, 1.4, -2.2}, {0.7, 0.7, -1.0}}, {{-0.1, -0.3, -1.1}, {0.9, 0.5, -0.9}}}}},
    {"romanesco", {{{{0.6, -0.3, -1.1}, {0.3, -0.9, -0.3}}, {{0.0, -1.0, -0.1}, {0.5, -1.3, 0.4}}}}},
    {"two-sets", {{{{1.5, 1.2, -1.9}, {0.8, 0.6, -0.3}}, {{0.5, 0.4, -0.6}, {-0.2, 0.9, 0.5}}}}},
    {"appendix-b", {{{{7.0, 8.0, -15.0}, {6.0, 6.5, -8.0}}, {{1.5, 1.0, -6.0}, {7.0, 6.0, -9.0}}}}},
};

}

std::string runName(const std::string &name, std::uint64_t depth, Place place, const std::string &kind)
{
    return name + "-" + std::to_string(depth) + "/" + placeNames[static_cast<std::size_t>(place)] + "/" + kind;
}

std::string depthRunName(const std::string &name, std::uint64_t depth)
{
    return "depth/" + name + "-" + std::to_string(depth);
}

FractalDescription FractalText::description() const
{
    return readFdo(text).description.value();
}

std::shared_ptr<const Scene> FractalText::scene() const
{
    return SceneLoader(DiskFiles()).load(path, text).scene;
}

FractalText fractalText(const std::string &name, std::uint64_t depth)
{
    const std::filesystem::path top(ROMANESCO_SOURCE_DIR);
    FractalText made{top / "resources/examples" / (name + ".fdo"), {}};
    if (!std::filesystem::exists(made.path)) {
        made.path = top / "tests/data/collide" / (name + ".fdo");
    }
    const auto read = DiskFiles().read(made.path);
    if (!read) {
        std::fprintf(stderr, "cannot read %s: %s\n", made.path.c_str(), read.error().c_str());
        std::exit(1);
    }
    made.text = *read;
    const SourceRange digits = made.description().depth.value().range;
    made.text.replace(digits.begin, digits.length(), std::to_string(depth));
    return made;
}

View viewOf(const std::string &name, const Scene &scene, Place place, const PictureSize &size, double tolerance)
{
    View view;
    view.width = size.width;
    view.height = size.height;
    view.pixelTolerance = tolerance;
    view.backgroundBottom = view.backgroundTop;
    if (place == Place::Far) {
        view.camera = fittedCamera(scene, double(size.width) / size.height);
    } else {
        const auto &[from, to] = sights.at(name)[place == Place::Near ? 0 : 1];
        view.camera.position = from;
        view.camera.worldFromCamera = rotationLooking(to - from);
    }
    return view;
}

}
