// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "core/scene/anchor.h"
#include "randomscenes.h"

/// Where nodes are in the world, however deep.
namespace romanesco::test {

/// Digits enough to tell copies of a thousand levels apart in world coordinates: the oracle.
using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<700>, boost::multiprecision::et_off>;
using OracleVector = std::array<Long, 3>;

struct OracleMap {
    std::array<OracleVector, 3> columns{OracleVector{1, 0, 0}, OracleVector{0, 1, 0}, OracleVector{0, 0, 1}};
    OracleVector translation{0, 0, 0};

    [[nodiscard]] OracleVector turned(const glm::dvec3 &v) const
    {
        OracleVector result;
        for (std::size_t i = 0; i < 3; ++i) {
            result[i] = columns[0][i] * v.x + columns[1][i] * v.y + columns[2][i] * v.z;
        }
        return result;
    }
    [[nodiscard]] OracleMap then(const AffineMap &inner) const
    {
        OracleMap result;
        for (int i = 0; i < 3; ++i) {
            result.columns[static_cast<std::size_t>(i)] = turned(inner.linear[i]);
        }
        result.translation = turned(inner.translation);
        for (std::size_t i = 0; i < 3; ++i) {
            result.translation[i] += translation[i];
        }
        return result;
    }
    [[nodiscard]] Long size() const
    {
        Long squares = 0;
        for (const OracleVector &column : columns) {
            for (const Long &number : column) {
                squares += number * number;
            }
        }
        return sqrt(squares);
    }
};

/// Nodes of surroundings as the world has them.
class WorldNodes
{
public:
    explicit WorldNodes(const Surroundings &all)
        : m_all(all)
    {
        m_along.push_back(OracleMap().then(all.scene->items[all.pathItem].worldFromModel));
        for (const Step &step : all.path) {
            m_along.push_back(after(m_along.back(), all.pathItem, step));
        }
    }

    [[nodiscard]] OracleMap operator()(const Surroundings::Node &node) const
    {
        OracleMap map = node.item == m_all.pathItem ? m_along[node.sharedSteps]
                                                    : OracleMap().then(m_all.scene->items[node.item].worldFromModel);
        for (const Step &step : node.steps) {
            map = after(map, node.item, step);
        }
        return map;
    }

private:
    [[nodiscard]] OracleMap after(const OracleMap &map, std::size_t item, const Step &step) const
    {
        return map.then(m_all.scene->items[item].model->graph.set(step.set).maps[step.map]);
    }

    const Surroundings &m_all;
    std::vector<OracleMap> m_along;
};

/// Of a tetrahedron.
inline std::shared_ptr<const Model> modelOf(const std::string &text)
{
    const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
    const FractalDescription description = readFdo(text).description.value();
    return modelOf(FractalGraph::build(description, boundingSphere(mesh)).value(), mesh);
}

}
