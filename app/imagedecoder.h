// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <string>

#include "core/geometry/image.h"

namespace romanesco {

/// Textures are made smaller where a side is longer, in pixels.
inline constexpr int longestTextureSide = 4'096;

/// Pixels of a file in one of the formats that Qt reads: an ImageDecoder. Any thread.
[[nodiscard]] std::expected<Image, std::string> decodeImage(const std::string &bytes);

}
