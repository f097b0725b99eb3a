// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QList>
#include <QString>

namespace romanesco {

/// A fractal or a scene that the program brings along.
struct BroughtText {
    QString path;
    /// The file's, without its ending; a scene says that it is one.
    QString name;
    /// The comment of the first line.
    QString description;
};

/// Of a folder of the resources, by name.
[[nodiscard]] QList<BroughtText> broughtTexts(const QString &folder);

}
