// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ballpictures.h"

#include <array>
#include <optional>

#include <glm/geometric.hpp>

#include "render/camera.h"
#include "tests/bench/render/picturesheet.h"

namespace romanesco::bench {

namespace {

constexpr int width = 300;
constexpr int height = 270;
/// From where the ball rests, in radii: where one looks from and to.
constexpr glm::dvec3 sightFrom{-3.2, 1.7, 5.8};
constexpr glm::dvec3 sightTo{0.0, -0.4, 0.0};
/// Exact, greedy, octree; told apart by people who see fewer colours too (Okabe and Ito 2008).
constexpr std::array<std::array<float, 3>, 3> colours{
    {{0.0f, 0.62f, 0.45f}, {0.90f, 0.62f, 0.0f}, {0.34f, 0.71f, 0.91f}}};

View viewOf(const Ball &resting)
{
    View view;
    view.width = width;
    view.height = height;
    view.samples = 8;
    view.leavesOutBalls = true;
    view.standsAlone = true;
    view.backgroundTop = {0.75f, 0.78f, 0.82f};
    view.backgroundBottom = view.backgroundTop;
    view.camera.position = resting.position + resting.radius * sightFrom;
    view.camera.worldFromCamera = rotationLooking(sightTo - sightFrom);
    view.camera.fieldOfView = 36.0;
    return view;
}

}

void writeBallPicture(OurFrames &frames, const ShrinkingGround &ground, const PicturedBall &ball,
                      const std::filesystem::path &path)
{
    frames.setScene(ground.scene);
    frames.draw(viewOf(ball.resting));
    PictureSheet sheet(3, 3, width, height);
    for (std::size_t column = 0; column < colours.size(); ++column) {
        const Shrinking &shrinking = ball.shrinking[column];
        const std::optional<Ball> last = shrinking.rest ? shrinking.held : shrinking.fallen;
        const std::array<std::optional<Ball>, 3> moments{ball.contacts[column].ball, shrinking.rest, last};
        for (std::size_t row = 0; row < moments.size(); ++row) {
            std::vector<BallSprite> sprites;
            if (moments[row]) {
                sprites.push_back({moments[row]->position, moments[row]->radius, colours[column]});
            }
            sheet.put(static_cast<int>(column), static_cast<int>(row), imageOf(frames.read(sprites)));
        }
    }
    save(withFewColours(sheet.image()), path);
}

}
