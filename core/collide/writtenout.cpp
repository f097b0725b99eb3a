// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "writtenout.h"

#include <cassert>
#include <format>
#include <optional>

#include "core/fractal/copies.h"
#include "core/fractal/counts.h"

namespace romanesco {

namespace {

/// Vertices and faces alone, without the vertices that no face uses.
Mesh bareMesh(const Mesh &mesh)
{
    Mesh bare;
    std::vector<std::uint32_t> places(mesh.vertices.size(), Mesh::none);
    for (Mesh::Face face : mesh.faces) {
        for (std::uint32_t &corner : face) {
            std::uint32_t &place = places[corner];
            if (place == Mesh::none) {
                place = static_cast<std::uint32_t>(bare.vertices.size());
                bare.vertices.push_back(mesh.vertices[corner]);
            }
            corner = place;
        }
        bare.faces.push_back(face);
    }
    return bare;
}

}

std::expected<std::uint64_t, std::string> faceCount(const FractalGraph &graph, const Mesh &mesh, std::uint64_t most)
{
    const std::optional<Count> copies = instancesDistinct(graph);
    if (!copies) {
        return std::unexpected("the copies are of too many sets to be counted");
    }
    const std::optional<std::uint64_t> faces = (*copies * Count(mesh.faces.size())).toInteger();
    if (!faces || *faces > most) {
        return std::unexpected(std::format("{} copies of {} faces are too many (at most {} faces)", copies->toString(),
                                           mesh.faces.size(), most));
    }
    return *faces;
}

std::expected<Mesh, std::string> writtenOut(const FractalGraph &graph, const Mesh &mesh,
                                            const AffineMap &worldFromModel, std::uint64_t most,
                                            const std::stop_token &stop)
{
    assert(most <= 1'000'000'000 && "vertices have numbers of 32 bits");
    const auto faces = faceCount(graph, mesh, most);
    if (!faces) {
        return std::unexpected(faces.error());
    }
    const Mesh base = bareMesh(mesh);
    Mesh all;
    all.faces.reserve(*faces);
    CopyWalk copies(graph, CopyWalk::Addresses::Drop, stop);
    while (copies.next()) {
        const AffineMap worldFromBase = worldFromModel * copies.modelFromBase();
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        for (const glm::dvec3 &vertex : base.vertices) {
            all.vertices.push_back(worldFromBase(vertex));
        }
        for (const Mesh::Face &face : base.faces) {
            all.faces.push_back({first + face[0], first + face[1], first + face[2]});
        }
    }
    if (stop.stop_requested()) {
        return std::unexpected("cancelled");
    }
    assert(all.faces.size() == *faces && "copies are counted as they are walked");
    return all;
}

}
