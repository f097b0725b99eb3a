// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "depthtrial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/scene/anchor.h"
#include "deepfractal.h"
#include "worldmap.h"

namespace romanesco {

namespace {

constexpr std::array<std::size_t, 10> depths{1, 3, 5, 10, 15, 20, 30, 60, 200, 1000};
constexpr double infinity = std::numeric_limits<double>::infinity();
/// What is smaller, by its logarithm to base 10, the long numbers do not tell as exactly.
constexpr double leastLog10 = -600.0;

/// From the middle of the picture, in pixels.
using Pixel = std::optional<glm::dvec2>;

/// Where a point in the camera's axes is seen; nothing for what is not before it.
template<typename T>
Pixel pixelOf(const VectorOf<T> &p)
{
    static const double pixels = 0.5 * DepthTrial::height / std::tan(std::numbers::pi / 6.0);
    if (!(p[2] > T(0))) {
        return std::nullopt;
    }
    const glm::dvec2 seen{static_cast<double>(T(p[0] / p[2])), static_cast<double>(T(p[1] / p[2]))};
    return std::isfinite(seen.x) && std::isfinite(seen.y) ? Pixel(pixels * seen) : std::nullopt;
}

bool isInPicture(const Pixel &pixel)
{
    return pixel && std::abs(pixel->x) <= 0.5 * DepthTrial::width && std::abs(pixel->y) <= 0.5 * DepthTrial::height;
}

/// A camera at a place that a ball is looked at from.
struct Eye {
    /// Columns right, up, forward, in the world.
    glm::dmat3 axes{1.0};
    /// In the coordinates of the place.
    glm::dvec3 position{0.0};
    double distance = 1.0;

    static Eye before(const Sphere &ball)
    {
        const glm::dvec3 forward = glm::normalize(glm::dvec3(-1.0, -0.8, 1.2));
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), forward));
        const double distance = 2.0 * ball.radius; // at 60 degrees it fills the height
        return {{right, glm::cross(forward, right), forward}, ball.centre - distance * forward, distance};
    }
};

/// As a card has it: a map to the camera's axes, its numbers in float, applied to a point.
Pixel onCard(const AffineMap &map, const Eye &eye, const glm::dvec3 &camera, double unit, const glm::dvec3 &point)
{
    const glm::dmat3 cameraFromHere = glm::transpose(eye.axes) / unit;
    const AffineMap seen{cameraFromHere * map.linear, cameraFromHere * (map.translation - camera)};
    WorldMap<float> instance;
    for (int i = 0; i < 3; ++i) {
        for (int row = 0; row < 3; ++row) {
            instance.columns[static_cast<std::size_t>(i)][static_cast<std::size_t>(row)] =
                static_cast<float>(seen.linear[i][row]);
        }
        instance.translation[static_cast<std::size_t>(i)] = static_cast<float>(seen.translation[i]);
    }
    return pixelOf(instance(point));
}

/// All in one kind of numbers, a point first brought to the world.
template<typename T>
Pixel inWorld(const WorldMap<T> &map, const Eye &eye, const VectorOf<T> &camera, const glm::dvec3 &point)
{
    const VectorOf<T> p = map(point);
    VectorOf<T> seen{0, 0, 0};
    VectorOf<T> back{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 3; ++i) {
            const T turn = static_cast<T>(eye.axes[axis][i]);
            seen[static_cast<std::size_t>(axis)] += turn * p[static_cast<std::size_t>(i)];
            back[static_cast<std::size_t>(axis)] += turn * camera[static_cast<std::size_t>(i)];
        }
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        seen[axis] -= back[axis];
    }
    return pixelOf(seen);
}

template<typename T>
VectorOf<T> rounded(const VectorOf<Long> &v)
{
    return {static_cast<T>(v[0]), static_cast<T>(v[1]), static_cast<T>(v[2])};
}

AffineMap affine(const WorldMap<double> &map)
{
    const auto vector = [](const VectorOf<double> &v) { return glm::dvec3(v[0], v[1], v[2]); };
    return {{vector(map.columns[0]), vector(map.columns[1]), vector(map.columns[2])}, vector(map.translation)};
}

Long lengthOf(const WorldMap<Long> &map)
{
    Long squares = 0;
    for (const VectorOf<Long> &column : map.columns) {
        for (const Long &number : column) {
            squares += number * number;
        }
    }
    return sqrt(squares);
}

double frobenius(const glm::dmat3 &matrix)
{
    return std::sqrt(glm::dot(matrix[0], matrix[0]) + glm::dot(matrix[1], matrix[1]) + glm::dot(matrix[2], matrix[2]));
}

/// A copy with all below it, at a place on the way.
struct Copy {
    /// So many steps of the way lead there, and these after them.
    std::size_t sharedSteps;
    std::vector<Step> steps;
    AffineMap hereFromCopy;
    Sphere bound;
};

class Descent
{
public:
    explicit Descent(std::shared_ptr<const Scene> scene)
        : m_scene(std::move(scene))
        , m_graph(m_scene->items.front().model->graph)
        , m_states(m_graph)
        , m_anchor(m_scene)
        , m_floats{WorldMap<float>() * m_scene->items.front().worldFromModel}
        , m_doubles{WorldMap<double>() * m_scene->items.front().worldFromModel}
        , m_longs{WorldMap<Long>() * m_scene->items.front().worldFromModel}
    {
        m_goesOn = m_anchor.enter({0, 0});
    }

    /// What there is to be seen of the copies at a depth, from 1 on, the depths one after another.
    DepthRow at(std::size_t depth)
    {
        DepthRow row{.depth = depth};
        while (m_goesOn && m_longs.size() < depth) {
            goDown();
        }
        const Long size = lengthOf(m_longs.back()) / lengthOf(m_longs.front());
        row.sizeLog10 = size > 0 ? static_cast<double>(log10(size)) : -infinity;
        if (!m_goesOn) {
            row.reason = "not possible: the way ends before";
        } else if (row.sizeLog10 < leastLog10) {
            row.reason = "not known: 700 digits do not tell it";
        } else {
            compare(row);
        }
        return row;
    }

private:
    [[nodiscard]] StateId stateHere() { return m_states.find(m_way.empty() ? Positions{0} : m_state); }

    void goDown()
    {
        const StateId here = stateHere();
        const Expansion &expansion = m_states.expansion(here);
        const std::vector<Sphere> &bounds = m_states.childBounds(here);
        struct Child {
            Step step;
            StateId next;
        };
        std::vector<Child> children;
        std::size_t number = 0;
        for (const ChildRange &range : expansion.ranges) {
            for (std::uint32_t map = range.firstMap; map < range.endMap; ++map, ++number) {
                if (!bounds[number].isEmpty()) {
                    children.push_back({{range.set, map}, range.next});
                }
            }
        }
        m_goesOn = !children.empty();
        if (!m_goesOn) {
            return;
        }
        const Child &child = children[m_random() % children.size()];
        m_goesOn = m_anchor.enter(child.step);
        m_way.push_back(child.step);
        m_state = m_states.state(child.next).positions;
        const AffineMap &map = mapOf(child.step);
        m_floats.push_back(m_floats.back() * map);
        m_doubles.push_back(m_doubles.back() * map);
        m_longs.push_back(m_longs.back() * map);
    }

    [[nodiscard]] const AffineMap &mapOf(const Step &step) const { return m_graph.set(step.set).maps[step.map]; }

    /// Those below the place, and what stands round it.
    std::vector<Copy> copiesHere(const Surroundings &all)
    {
        std::vector<Copy> copies;
        for (const Surroundings::Node &node : all.nodes) {
            const bool isOwn = node.sharedSteps == all.path.size() && node.steps.empty();
            if (isOwn) {
                addChildren(node, copies);
            } else if (!node.isMeshOnly) {
                copies.push_back({node.sharedSteps,
                                  {node.steps.begin(), node.steps.end()},
                                  node.hereFromNode,
                                  m_graph.bound(node.state.front())});
            }
        }
        return copies;
    }

    void addChildren(const Surroundings::Node &node, std::vector<Copy> &copies)
    {
        for (const ChildRange &range : m_states.expansion(m_states.find(node.state)).ranges) {
            for (std::uint32_t map = range.firstMap; map < range.endMap; ++map) {
                const Step step{range.set, map};
                copies.push_back(
                    {node.sharedSteps, {step}, node.hereFromNode * mapOf(step), m_states.state(range.next).bound});
            }
        }
    }

    template<typename T>
    [[nodiscard]] WorldMap<T> composed(const std::vector<WorldMap<T>> &along, const Copy &copy) const
    {
        WorldMap<T> map = along[copy.sharedSteps];
        for (const Step &step : copy.steps) {
            map = map * mapOf(step);
        }
        return map;
    }

    void compare(DepthRow &row)
    {
        const std::shared_ptr<const Surroundings> all = m_anchor.surroundings();
        const Eye eye = Eye::before(m_anchor.bound());
        // the unit by the lengths of one map, so that it is that of the place to the last digit
        const auto own = std::ranges::find_if(all->nodes, [&](const Surroundings::Node &node) {
            return node.sharedSteps == all->path.size() && node.steps.empty();
        });
        const Long unit = lengthOf(m_longs.back()) / Long(frobenius(own->hereFromNode.linear));
        VectorOf<Long> camera = m_longs.back().translation;
        for (int i = 0; i < 3; ++i) {
            camera[static_cast<std::size_t>(i)] += unit * Long(eye.position[i]);
        }
        const glm::dvec3 nearCamera(static_cast<double>(camera[0]), static_cast<double>(camera[1]),
                                    static_cast<double>(camera[2]));
        const double worldUnit = static_cast<double>(unit) * eye.distance;
        for (const Copy &copy : copiesHere(*all)) {
            const WorldMap<Long> exact = composed(m_longs, copy);
            const WorldMap<float> inFloat = composed(m_floats, copy);
            const AffineMap inDouble = affine(composed(m_doubles, copy));
            bool isSeen = false;
            for (const glm::dvec3 &point : pointsOf(copy.bound)) {
                const Pixel truth = inWorld(exact, eye, camera, point);
                if (!isInPicture(truth)) {
                    continue;
                }
                isSeen = true;
                const auto widen = [&](double &worst, const Pixel &pixel) {
                    worst = std::max(worst, pixel ? glm::distance(*pixel, *truth) : infinity);
                };
                widen(row.inFloat, inWorld(inFloat, eye, rounded<float>(camera), point));
                widen(row.inDouble, onCard(inDouble, eye, nearCamera, worldUnit, point));
                widen(row.inFrames, onCard(copy.hereFromCopy, eye, eye.position, eye.distance, point));
            }
            row.copies += isSeen ? 1 : 0;
        }
    }

    static std::array<glm::dvec3, 7> pointsOf(const Sphere &bound)
    {
        const double r = bound.radius;
        std::array<glm::dvec3, 7> points{glm::dvec3(0), {r, 0, 0}, {-r, 0, 0}, {0, r, 0},
                                         {0, -r, 0},    {0, 0, r}, {0, 0, -r}};
        for (glm::dvec3 &point : points) {
            point += bound.centre;
        }
        return points;
    }

    std::shared_ptr<const Scene> m_scene;
    const FractalGraph &m_graph;
    StateTable m_states;
    Anchor m_anchor;
    std::vector<Step> m_way;
    /// At its end.
    Positions m_state;
    bool m_goesOn = true;
    /// After so many steps.
    std::vector<WorldMap<float>> m_floats;
    std::vector<WorldMap<double>> m_doubles;
    std::vector<WorldMap<Long>> m_longs;
    std::mt19937_64 m_random{1};
};

}

std::span<const std::size_t> trialDepths()
{
    return depths;
}

std::expected<DepthTrial, std::string> tryDepths(const Scene &scene, const TrialContext &context)
{
    DepthTrial trial;
    const auto deep = deepFractal(scene, depths.back() + 1);
    if (!deep) {
        trial.reason = deep.error();
        return trial;
    }
    Descent descent(*deep);
    for (const std::size_t depth : depths) {
        if (context.isStopped()) {
            return std::unexpected("cancelled");
        }
        context.tell("numbers at depth " + std::to_string(depth),
                     static_cast<double>(trial.rows.size()) / static_cast<double>(depths.size()));
        trial.rows.push_back(descent.at(depth));
    }
    return trial;
}

}
