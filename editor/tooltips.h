// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QString>

namespace romanesco {

class LanguageText;

/// A tool tip for a place in a text: the problems there, then what the language says of the word (a vector's value, a
/// map's matrix, an object's counts). Rich text in which nothing of the text is a tag; empty where there is nothing to
/// say.
[[nodiscard]] QString tipWords(const QStringList &problems, LanguageText &text, int position);

}
