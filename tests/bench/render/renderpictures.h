// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>
#include <vector>

#include "ourframes.h"
#include "renderworkloads.h"

namespace romanesco::bench {

/// The pictures of docs/rendering.md, into a folder: what is drawn from all places, and a part of a picture at several
/// tolerances. Ends the program where they cannot be written.
void writePictures(OurFrames &frames, const std::vector<Subject> &subjects, const std::filesystem::path &folder);

}
