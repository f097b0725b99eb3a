// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "samplecopies.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/export/copysampler.h"
#include "core/export/scenecopies.h"
#include "core/fractal/counts.h"
#include "core/geometry/normals.h"

namespace romanesco {

namespace {

/// By items, the shares of all faces; the same for all where they cannot be counted.
std::vector<double> sharesOf(const Scene &scene)
{
    std::vector<double> logarithms;
    for (const SceneItem &item : scene.items) {
        const std::optional<Count> copies = instancesDistinct(item.model->graph);
        const auto faces = static_cast<double>(item.model->mesh->faces.size());
        logarithms.push_back(copies ? copies->log10() + std::log10(faces) : 0.0);
    }
    const double most = std::ranges::max(logarithms);
    double sum = 0.0;
    std::vector<double> shares;
    for (const double logarithm : logarithms) {
        shares.push_back(std::pow(10.0, logarithm - most));
        sum += shares.back();
    }
    std::ranges::for_each(shares, [&](double &share) { share /= sum; });
    return shares;
}

}

SampleCopies::SampleCopies(const Scene &scene, std::uint64_t mostFaces, const std::stop_token &stop)
{
    m_copies.resize(scene.items.size());
    Count faces;
    const auto counts = SceneCopies::count(scene);
    for (std::size_t i = 0; counts && i < scene.items.size(); ++i) {
        faces += Count((*counts)[i]) * Count(scene.items[i].model->mesh->faces.size());
    }
    m_isWhole = counts && faces.toInteger().value_or(mostFaces + 1) <= mostFaces;
    if (m_isWhole) {
        takeAll(scene, *counts, stop);
    } else {
        draw(scene, mostFaces, stop);
    }
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        m_items.push_back({scene.items[i].model->mesh.get(), m_copies[i].size()});
    }
}

void SampleCopies::takeAll(const Scene &scene, const std::vector<std::uint64_t> &counts, const std::stop_token &stop)
{
    const SceneCopies all(scene, counts, SceneCopies::Branches::Unnamed, {}, stop);
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        // a stop is told by whoever writes them
        (void)all.visit(i, [&](const MeshCopy &copy) {
            m_copies[i].push_back(copy);
            return true;
        });
    }
}

void SampleCopies::draw(const Scene &scene, std::uint64_t mostFaces, const std::stop_token &stop)
{
    const std::vector<double> shares = sharesOf(scene);
    for (std::size_t i = 0; i < scene.items.size(); ++i) {
        const SceneItem &item = scene.items[i];
        const std::size_t faces = item.model->mesh->faces.size();
        if (faces == 0) {
            continue;
        }
        const double wanted = shares[i] * static_cast<double>(mostFaces) / static_cast<double>(faces);
        CopySampler sampler(item.model->graph);
        std::mt19937_64 random(1);
        for (double k = 0.0; k < std::max(wanted, 1.0) && !stop.stop_requested(); ++k) {
            const AffineMap map = item.worldFromModel * sampler.sample(random);
            m_copies[i].push_back({.worldFromMesh = map, .isMirrored = isMirrored(map.linear)});
        }
    }
}

std::size_t SampleCopies::faceCount() const
{
    std::size_t count = 0;
    for (const Item &item : m_items) {
        count += item.copyCount * item.mesh->faces.size();
    }
    return count;
}

std::expected<void, std::string> SampleCopies::visit(std::size_t item, const Visitor &visitor) const
{
    std::ranges::find_if_not(m_copies[item], visitor);
    return {};
}

}
