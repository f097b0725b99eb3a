// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include "textmarks.h"

class QTextDocument;

namespace romanesco {

/// The bracket that a position stands behind, else in front of, and the one that it belongs to, within the line and
/// outside quotes. Nothing where either is missing. Cost linear in the line.
[[nodiscard]] std::vector<TextStretch> matchingBrackets(const QTextDocument &document, int position);

}
