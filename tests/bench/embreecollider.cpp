// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "embreecollider.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <vector>

#include <embree4/rtcore.h>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>

#include "collideworkloads.h"
#include "core/fractal/statetable.h"

namespace romanesco::bench {

namespace {

/// The triangles of a scene, in Embree's own buffers.
struct Triangles {
    const glm::vec3 *vertices;
    const Mesh::Face *faces;

    [[nodiscard]] std::array<glm::vec3, 3> corners(std::uint32_t face) const
    {
        const Mesh::Face &f = faces[face];
        return {vertices[f[0]], vertices[f[1]], vertices[f[2]]};
    }
};

/// Ericson 2005, 5.1.5, as in Embree's tutorial closest_point.
glm::vec3 closestOnTriangle(const glm::vec3 &p, const std::array<glm::vec3, 3> &corners)
{
    const auto &[a, b, c] = corners;
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const glm::vec3 ap = p - a;
    const float d1 = glm::dot(ab, ap);
    const float d2 = glm::dot(ac, ap);
    if (d1 <= 0.0F && d2 <= 0.0F) {
        return a;
    }
    const glm::vec3 bp = p - b;
    const float d3 = glm::dot(ab, bp);
    const float d4 = glm::dot(ac, bp);
    if (d3 >= 0.0F && d4 <= d3) {
        return b;
    }
    const glm::vec3 cp = p - c;
    const float d5 = glm::dot(ab, cp);
    const float d6 = glm::dot(ac, cp);
    if (d6 >= 0.0F && d5 <= d6) {
        return c;
    }
    const float vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) {
        return a + d1 / (d1 - d3) * ab;
    }
    const float vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) {
        return a + d2 / (d2 - d6) * ac;
    }
    const float va = d3 * d6 - d5 * d4;
    if (va <= 0.0F && d4 >= d3 && d5 >= d6) {
        return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    }
    const float all = 1.0F / (va + vb + vc);
    return a + vb * all * ab + vc * all * ac;
}

/// A 4 by 4 matrix of which the last row is left out, times a point.
glm::vec3 transformed(const float *columns, const glm::vec3 &p)
{
    glm::vec3 result;
    for (int row = 0; row < 3; ++row) {
        result[row] = columns[row] * p.x + columns[4 + row] * p.y + columns[8 + row] * p.z + columns[12 + row];
    }
    return result;
}

}

/// The device with all that was made by it.
class EmbreeCollider::Scenes
{
public:
    Scenes()
        : m_device(rtcNewDevice(nullptr))
    {
        rtcSetDeviceErrorFunction(m_device, fail, nullptr);
        rtcSetDeviceMemoryMonitorFunction(m_device, count, this);
        m_top = newScene();
    }
    Scenes(const Scenes &) = delete;
    Scenes &operator=(const Scenes &) = delete;
    ~Scenes()
    {
        for (const RTCScene scene : m_scenes) {
            rtcReleaseScene(scene);
        }
        rtcReleaseDevice(m_device);
    }

    [[nodiscard]] RTCScene top() const { return m_top; }
    [[nodiscard]] RTCScene newScene()
    {
        const RTCScene scene = rtcNewScene(m_device);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
        return m_scenes.emplace_back(scene);
    }

    /// The mesh alone, as that scene.
    [[nodiscard]] Triangles fill(RTCScene scene, const Mesh &mesh)
    {
        const RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto *const vertices = static_cast<glm::vec3 *>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.vertices.size()));
        std::ranges::copy(mesh.vertices, vertices);
        auto *const faces = static_cast<Mesh::Face *>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Mesh::Face), mesh.faces.size()));
        std::ranges::copy(mesh.faces, faces);
        attach(scene, geometry);
        rtcCommitScene(scene);
        return {vertices, faces};
    }

    /// Puts a scene into the one on top.
    void place(RTCScene scene, const AffineMap &map)
    {
        const RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, scene);
        const glm::mat4x3 matrix(glm::vec3(map.linear[0]), glm::vec3(map.linear[1]), glm::vec3(map.linear[2]),
                                 glm::vec3(map.translation));
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &matrix);
        attach(m_top, geometry);
    }

    /// By number of the geometry in the scene on top, which is all that a callback is told of.
    std::vector<Triangles> trianglesOfTop;

    [[nodiscard]] std::size_t held() const { return static_cast<std::size_t>(m_held.load()); }
    [[nodiscard]] std::size_t peak() const { return static_cast<std::size_t>(m_peak.load()); }

private:
    static void attach(RTCScene scene, RTCGeometry geometry)
    {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }

    static void fail(void *, RTCError, const char *message)
    {
        std::fprintf(stderr, "Embree: %s\n", message);
        std::exit(1);
    }

    /// Comes from any thread.
    static bool count(void *user, ssize_t bytes, bool)
    {
        auto &scenes = *static_cast<Scenes *>(user);
        const ssize_t held = scenes.m_held += bytes;
        ssize_t peak = scenes.m_peak;
        while (held > peak && !scenes.m_peak.compare_exchange_weak(peak, held)) { }
        return true;
    }

    std::atomic<ssize_t> m_held{0};
    std::atomic<ssize_t> m_peak{0};
    RTCDevice m_device;
    std::vector<RTCScene> m_scenes;
    RTCScene m_top;
};

/// Makes a scene of each state that few copies hang of, and places it.
class EmbreeCollider::Instancer
{
public:
    Instancer(const FractalGraph &graph, const Mesh &mesh, Scenes &scenes)
        : m_mesh(mesh)
        , m_scenes(scenes)
        , m_table(graph)
        , m_most(std::sqrt(copiesBelow(m_table.root())))
    {
    }

    void placeAll()
    {
        findPlacements();
        for (const auto &[state, maps] : m_placements) {
            // Embree takes a map for a similarity by an absolute tolerance: its inverse must not be large
            double unit = std::numeric_limits<double>::infinity();
            for (const AffineMap &map : maps) {
                unit = std::min(unit, operatorNorm(map.linear));
            }
            const RTCScene scene = m_scenes.newScene();
            const Triangles triangles = m_scenes.fill(scene, writtenOut(state, unit));
            for (const AffineMap &map : maps) {
                m_scenes.place(scene, map * scaling(1.0 / unit));
                m_scenes.trianglesOfTop.push_back(triangles);
            }
        }
        rtcCommitScene(m_scenes.top());
    }

private:
    /// In place of a state: the base mesh.
    static constexpr StateId alone = std::numeric_limits<StateId>::max();

    static AffineMap scaling(double factor) { return {glm::dmat3(factor), glm::dvec3(0.0)}; }

    void findPlacements()
    {
        const auto enters = [&](const AffineMap &map, StateId state) {
            if (copiesBelow(state) > m_most) {
                return true;
            }
            m_placements[state].push_back(map);
            return false;
        };
        goDown(m_table.root(), enters, [&](const AffineMap &map) { m_placements[alone].push_back(map); });
    }

    double copiesBelow(StateId state)
    {
        if (const auto known = m_copies.find(state); known != m_copies.end()) {
            return known->second;
        }
        const Expansion &expansion = m_table.expansion(state);
        double copies = expansion.hasLeaf ? 1.0 : 0.0;
        for (const ChildRange &range : expansion.ranges) {
            copies += (range.endMap - range.firstMap) * copiesBelow(range.next);
        }
        return m_copies[state] = copies;
    }

    /// Calls enters(map, state) for what hangs of a state, and where that is true for what hangs of it; use(map) for copies.
    void goDown(StateId from, const auto &enters, const auto &use)
    {
        std::vector<std::pair<AffineMap, StateId>> waiting{{AffineMap{}, from}};
        while (!waiting.empty()) {
            const auto [map, state] = waiting.back();
            waiting.pop_back();
            if (!enters(map, state)) {
                continue;
            }
            const Expansion &expansion = m_table.expansion(state);
            if (expansion.hasLeaf) {
                use(map);
            }
            for (const ChildRange &range : expansion.ranges) {
                for (std::uint32_t i = range.firstMap; i < range.endMap; ++i) {
                    waiting.emplace_back(map * m_table.graph().set(range.set).maps[i], range.next);
                }
            }
        }
    }

    Mesh writtenOut(StateId state, double unit)
    {
        Mesh all;
        const auto use = [&](const AffineMap &map) { append(all, m_mesh, scaling(unit) * map); };
        if (state == alone) {
            use({});
        } else {
            goDown(state, [](const AffineMap &, StateId) { return true; }, use);
        }
        return all;
    }

    const Mesh &m_mesh;
    Scenes &m_scenes;
    StateTable m_table;
    std::map<StateId, double> m_copies;
    std::map<StateId, std::vector<AffineMap>> m_placements;
    double m_most;
};

class EmbreeCollider::Descent final : public Search
{
public:
    explicit Descent(const Scenes &scenes)
        : m_scenes(scenes)
    {
    }

    /// It has no such question, and nobody asks.
    void sweep(const Sweep &, Touch &) override { std::abort(); }

    void closest(const Query &query, Hit &hit) override
    {
        const glm::vec3 p(query.p);
        RTCPointQuery sphere{p.x, p.y, p.z, 0.0F, static_cast<float>(query.radius)};
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        Best best{.scenes = m_scenes};
        rtcPointQuery(m_scenes.top(), &sphere, &context, look, &best);
        hit = {};
        hit.promise = Promise::None;
        hit.cost.faceTests = best.faceTests;
        if (best.face != Mesh::none) {
            hit.point = best.point;
            hit.face = best.face;
            hit.distance = glm::distance(query.p, hit.point);
            hit.direction = (query.p - hit.point) / hit.distance;
        }
    }

private:
    struct Best {
        const Scenes &scenes;
        glm::vec3 point{0.0F};
        std::uint32_t face = Mesh::none;
        std::uint64_t faceTests = 0;
    };

    static bool look(RTCPointQueryFunctionArguments *arguments)
    {
        Best &best = *static_cast<Best *>(arguments->userPtr);
        ++best.faceTests;
        const RTCPointQueryContext &context = *arguments->context;
        const bool isInstance = context.instStackSize > 0;
        const Triangles &triangles = best.scenes.trianglesOfTop[isInstance ? context.instID[0] : arguments->geomID];
        std::array<glm::vec3, 3> corners = triangles.corners(arguments->primID);

        // in the instance's frame where distances there are as here, but for a factor
        glm::vec3 p(arguments->query->x, arguments->query->y, arguments->query->z);
        const bool isSimilar = isInstance && arguments->similarityScale > 0.0F;
        if (isSimilar) {
            p = transformed(context.world2inst[0], p);
        } else if (isInstance) {
            for (glm::vec3 &corner : corners) {
                corner = transformed(context.inst2world[0], corner);
            }
        }
        const glm::vec3 point = closestOnTriangle(p, corners);
        const float distance = glm::distance(p, point) / (isSimilar ? arguments->similarityScale : 1.0F);
        if (distance >= arguments->query->radius) {
            return false;
        }
        arguments->query->radius = distance;
        best.point = isSimilar ? transformed(context.inst2world[0], point) : point;
        best.face = arguments->primID;
        return true;
    }

    const Scenes &m_scenes;
};

EmbreeCollider::EmbreeCollider(std::unique_ptr<Scenes> scenes)
    : m_scenes(std::move(scenes))
{
}

EmbreeCollider::EmbreeCollider(EmbreeCollider &&) noexcept = default;
EmbreeCollider::~EmbreeCollider() = default;

EmbreeCollider EmbreeCollider::flattened(const Mesh &all)
{
    auto scenes = std::make_unique<Scenes>();
    scenes->trianglesOfTop.push_back(scenes->fill(scenes->top(), all));
    return EmbreeCollider(std::move(scenes));
}

EmbreeCollider EmbreeCollider::instanced(const FractalGraph &graph, const Mesh &mesh)
{
    auto scenes = std::make_unique<Scenes>();
    Instancer(graph, mesh, *scenes).placeAll();
    return EmbreeCollider(std::move(scenes));
}

std::unique_ptr<Search> EmbreeCollider::search() const
{
    return std::make_unique<Descent>(*m_scenes);
}

std::size_t EmbreeCollider::memoryUse() const
{
    return m_scenes->held();
}

std::size_t EmbreeCollider::peakMemory() const
{
    return m_scenes->peak();
}

}
