// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string_view>

#include "core/formats/fractaldescription.h"
#include "fdodocument.h"

namespace romanesco {

/// What is right in a fractal but may surprise, at its place in the text and sorted by place, one of a kind for each set:
/// - an iteration that does not converge (its maps, `#` left out, do not all make things smaller);
/// - flat maps; mirroring maps; maps that shear what is turned inside them; rotations near gimbal lock;
/// - depths whose copies are smaller than doubles tell apart in coordinates of the whole.
/// Only sets that the result <$> is made of are looked at. (Equal maps are told by describeFdo().) The description must
/// be of this document. Cost: some hundred nanoseconds for each use.
[[nodiscard]] Diagnostics stabilityHints(const FdoDocument &document, const FractalDescription &description);

/// The same for a text alone, which is read for it. Nothing where it has no meaning.
[[nodiscard]] Diagnostics stabilityHints(std::string_view text);

}
