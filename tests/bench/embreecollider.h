// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include "core/collide/collider.h"
#include "core/fractal/fractalgraph.h"
#include "core/geometry/mesh.h"

namespace romanesco::bench {

/// Embree's hierarchies of boxes, in single precision, built with RTC_BUILD_QUALITY_HIGH on all cores; asked by
/// rtcPointQuery(), with the callback of its tutorial. Face tests are calls of that; node visits are not told.
class EmbreeCollider final : public Collider
{
public:
    /// Of all faces in one hierarchy.
    [[nodiscard]] static EmbreeCollider flattened(const Mesh &all);

    /// One hierarchy of instances over hierarchies of faces, since Embree is packaged for a single level of instances. A
    /// branch of the graph is an instance where no more copies hang of it than the square root of all, so that there are
    /// about as many instances as copies in one: equal branches share their faces. Any affine maps. The graph is of
    /// that mesh and has few levels.
    [[nodiscard]] static EmbreeCollider instanced(const FractalGraph &graph, const Mesh &mesh);

    EmbreeCollider(EmbreeCollider &&) noexcept;
    ~EmbreeCollider() override;

    [[nodiscard]] std::unique_ptr<Search> search() const override;
    /// What Embree says that it holds, buffers of vertices and faces with it.
    [[nodiscard]] std::size_t memoryUse() const override;
    /// The most that it held at a time.
    [[nodiscard]] std::size_t peakMemory() const;

private:
    class Scenes;
    class Instancer;
    class Descent;

    explicit EmbreeCollider(std::unique_ptr<Scenes> scenes);

    std::unique_ptr<Scenes> m_scenes;
};

}
