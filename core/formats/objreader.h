// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/text/diagnostic.h"

namespace romanesco {

/// A mesh beside what is wrong with its text. After an error the mesh holds what was read before it.
struct ObjResult {
    Mesh mesh;
    /// Sorted by place; at most one error.
    Diagnostics diagnostics;

    /// What leads to the looks of mesh.materials, which only have names yet.
    struct Sources {
        struct Library {
            std::string name;
            SourceRange place;
        };
        /// The files that `mtllib` names, in order.
        std::vector<Library> libraries;
        /// Beside mesh.materials: the `usemtl` of the first face that has it.
        std::vector<SourceRange> materialPlaces;
    };
    Sources sources;
};

/// Reads the faces of a Wavefront OBJ text (appendix B1 of the Advanced Visualizer manual) and what belongs to them:
///   v x y z [w]       w weighs the points of curves and is passed over
///   v x y z r g b     colours, held to 0…1; a vertex without is white beside others with
///   vt u [v [w]]      v is 0 if not given, w is passed over
///   vn x y z
///   f corner corner corner…   each v, v/vt, v//vn or v/vt/vn: from 1, or from the last so far (negative)
///   o NAME, g NAME    the later of them names the group; what follows the keyword is one name, blanks and all
///   s NUMBER, s off   the smoothing group
///   usemtl NAME       the material: only its name is known here, the look is the default's
///   mtllib FILE…      each ends at a word in .mtl, or with the line
/// A face of n corners becomes n - 2 triangles by PolygonCutter. A line that ends in a backslash goes on in the next.
/// Kept is what faces use: no groups and materials without faces, no normals or texture coordinates that none names.
/// What can be passed over (points, lines, curves, unknown words) costs one warning a kind. Stops at the first error, and
/// when told to. text is below 4 GB. Numbers are correctly rounded, coordinates pass unchanged. Cost linear in the text,
/// but for faces of many corners that are not convex; memory that of the mesh, which grows by doubling.
[[nodiscard]] ObjResult readObj(std::string_view text, const std::stop_token &stop = {});

}
