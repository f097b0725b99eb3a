// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>

#include <QString>

#include "core/scene/scene.h"
#include "render/appearance.h"

namespace romanesco {

/// Where a copy stands, as the text calls it: "sponge[1] box.7 › sponge[2] box.19"; of a way of many steps the first and
/// the last, and how many there are. text is the .fdo that the scene is of; of an item of an .sdo it is its file and the
/// number of steps. Cost: about a microsecond for each step, and reading the text.
[[nodiscard]] QString addressWords(const Scene &scene, const Selection &selection, const std::string &text);

}
