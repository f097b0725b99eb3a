// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <string>

#include "collidertrial.h"
#include "core/base/count.h"
#include "depthtrial.h"
#include "digittrial.h"
#include "frametrial.h"
#include "share.h"
#include "steptrial.h"

/// How figures are shown to people.
namespace romanesco {

/// Three digits or so: "0.0123", "12.3", "4,560", "1.2e+09"; "0" for none.
[[nodiscard]] std::string figure(double value);

/// The shortest digits that read back as the same number: "0.001", "1e-6".
[[nodiscard]] std::string briefly(double value);

/// "38,400,000".
[[nodiscard]] std::string grouped(std::uint64_t number);

/// "38,400,000 faces", "more than 10^40 faces", "too many faces to be counted".
[[nodiscard]] std::string facesText(const std::optional<Count> &faces);

/// Of a place, in parts of the scene: "0.0123", "1e-477".
[[nodiscard]] std::string sizeText(const DepthRow &row);

/// Pixels on a screen; infinity is "not seen".
[[nodiscard]] std::string pixelsText(double pixels);

/// "1,234,567", "10^40.2"; "–" for what is not known.
[[nodiscard]] std::string countText(const std::optional<Count> &count);

/// "12.3 (11–14)": a share in per cent with its interval; a dash where it is of nothing.
[[nodiscard]] std::string percent(const Share &share);

/// What is measured, in a sentence.
[[nodiscard]] std::string wordsOf(const ColliderTrial &trial);
[[nodiscard]] std::string wordsOf(const ColliderTrial::Set &set);
[[nodiscard]] std::string wordsOf(const StepTrial &trial);
[[nodiscard]] std::string wordsOf(const FrameTrial &trial);
[[nodiscard]] std::string wordsOf(const FrameReference &reference);
[[nodiscard]] std::string wordsOf(const DepthTrial &trial);
[[nodiscard]] std::string wordsOf(const DigitTrial &trial);

}
