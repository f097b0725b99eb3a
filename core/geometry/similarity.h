// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "affinemap.h"

namespace romanesco {

/// An affine map that keeps angles: all lengths grow by one factor. It may mirror.
struct Similarity {
    AffineMap map;
    AffineMap inverse;
    /// Above 0, to the last digits.
    double scale = 1.0;
};

/// A map with what belongs to it; nothing where angles change by more than 1e-14, where it is flat, or where a double
/// does not hold its inverse.
[[nodiscard]] std::optional<Similarity> similarityOf(const AffineMap &map);

}
