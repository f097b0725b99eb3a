// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string_view>

#include "core/geometry/mesh.h"
#include "core/text/diagnostic.h"

namespace romanesco {

/// A mesh beside what is wrong with its text. After an error the mesh holds what was read before it.
struct ObjResult {
    Mesh mesh;
    Diagnostics diagnostics;
};

/// Reads the vertices and faces of a Wavefront OBJ text: `v x y z`, and `f` with indices v, v/vt, v//vn or v/vt/vn, from
/// 1 or from the end (negative). A face of more than three corners becomes a fan from its first. A line that ends in a
/// backslash goes on in the next. Everything else is passed over. Stops at the first error. Cost linear in the text.
/// Coordinates pass unchanged.
[[nodiscard]] ObjResult readObj(std::string_view text);

}
