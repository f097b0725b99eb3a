// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QStringList>

namespace romanesco {

class TextTab;

/// Adds meshes and fractals to the scene of a text, a line for each, all of them one undo step: by a path that is relative to
/// the text's folder, where it has one. Those that stay are returned: all for a text that is no .sdo or may not be edited,
/// other kinds of files, and paths that no text can hold.
[[nodiscard]] QStringList addToScene(TextTab &tab, const QStringList &files);

}
