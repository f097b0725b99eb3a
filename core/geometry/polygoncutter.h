// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace romanesco {

/// Three corners of a polygon, by their numbers from 0.
using CornerTriangle = std::array<std::uint32_t, 3>;

/// Cuts polygons in space into triangles. Keeps its memory for the next polygon; one thread at a time.
class PolygonCutter
{
public:
    /// n - 2 triangles of the n >= 3 corners, turning as the polygon does; good until the next call. Where all triangles
    /// round the first corner look the same way, as in every convex polygon, it is these, in order. Else ears are cut off
    /// in the plane of coordinates that shows the polygon largest, by cutEars(). What has no area or reaches beyond
    /// doubles becomes triangles round the first corner too. Any scale. Cost: linear for these.
    [[nodiscard]] std::span<const CornerTriangle> cut(std::span<const glm::dvec3> corners);

private:
    void makeLocal(std::span<const glm::dvec3> corners);
    [[nodiscard]] bool isFan(const glm::dvec3 &normal) const;
    void flatten(const glm::dvec3 &normal);

    /// Round the first corner, in units of about the polygon's size.
    std::vector<glm::dvec3> m_local;
    std::vector<glm::dvec2> m_flat;
    std::vector<CornerTriangle> m_triangles;
};

/// Appends n - 2 triangles of a polygon in the plane that turns left, n >= 3: ears are cut off one after another
/// (Meisters 1975; the lists of Eberly, "Triangulation by Ear Clipping", with a tree for the reflex corners). Together
/// they cover a simple polygon once, also one whose edges touch (a hole with a bridge); none is turned over, and corners
/// in line make no triangle without area where that can be avoided. Coordinates are from -2 to 2; they are rounded to
/// 2^-50, and what follows is judged exactly. A polygon that crosses itself gets some triangles,
/// always the same. Cost: near n log n (320,000 corners take
/// one to three seconds at worst in all shapes tried); no better bound than n^2 is known.
void cutEars(std::span<const glm::dvec2> corners, std::vector<CornerTriangle> &triangles);

}
