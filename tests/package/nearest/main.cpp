// SPDX-License-Identifier: CC0-1.0
// SPDX-FileCopyrightText: Romanesco authors
//
// nearest FILE X Y Z   how far the surface of a fractal or a scene is from a point, and which way.
#include <cstdlib>
#include <print>

#include <core/scene/scenecollider.h>
#include <core/scene/sceneloader.h>

int main(int argc, char *argv[])
{
    using namespace romanesco;
    const DiskFiles files;
    const auto text = argc == 5 ? files.read(argv[1]) : std::unexpected("nearest FILE X Y Z");
    if (!text) {
        std::println(stderr, "{}", text.error());
        return EXIT_FAILURE;
    }
    const auto scene = SceneLoader(files).load(argv[1], *text).scene;
    const auto collider = scene ? SceneCollider::create(scene, {.kind = ColliderKind::Exact})
                                : std::unexpected("romanesco check FILE says what is wrong with it");
    if (!collider) {
        std::println(stderr, "{}", collider.error());
        return EXIT_FAILURE;
    }
    Hit hit;
    collider->search()->closest({.p = {std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4])}}, hit);
    std::println("{} away, at {} {} {}; {} faces were looked at", hit.distance, hit.point.x, hit.point.y, hit.point.z,
                 hit.cost.faceTests);
}
