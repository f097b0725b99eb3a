// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string_view>
#include <vector>

#include "core/geometry/material.h"
#include "core/text/diagnostic.h"

namespace romanesco {

/// The materials of an MTL text in its order (of two of one name the first counts), beside what is wrong with it.
struct MtlResult {
    struct Entry {
        /// Its diffuseTexture is relative to the MTL file, with "/" for each "\".
        Material material;
        /// Where the texture is named; empty for none.
        SourceRange texturePlace;
    };
    std::vector<Entry> materials;
    Diagnostics diagnostics;
};

/// Reads a Wavefront MTL text. All of a line behind `newmtl` is a material's name, blanks and all; of what follows it
///   Kd, Ks, Ke r [g b]   the colours, held to 0…1 (one number: grey)
///   Ns n                 the shininess, held to 0…1000000
///   d n, Tr n            the opacity, or 1 - n; held to 0…1, the later line counts
///   map_Kd [options] FILE   the texture, its name with blanks and all; options are passed over
/// and nothing else. A value that is no number costs an error and leaves what was. Cost linear in the text.
[[nodiscard]] MtlResult readMtl(std::string_view text);

}
