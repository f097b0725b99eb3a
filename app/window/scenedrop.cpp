// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "scenedrop.h"

#include <vector>

#include <QDir>
#include <QFileInfo>

#include "core/language/placement.h"
#include "editor/fdoeditor.h"
#include "texttab.h"

namespace romanesco {

QStringList addToScene(TextTab &tab, const QStringList &files)
{
    FdoEditor &editor = tab.editor();
    const SdoSyntax *scene = editor.language().sdo();
    if (!scene || editor.isReadOnly()) {
        return files;
    }
    const Document &document = tab.document();
    const QDir folder = QFileInfo(document.path()).dir();
    std::vector<FileToPlace> placed;
    QStringList rest;
    for (const QString &file : files) {
        const QString ending = QFileInfo(file).suffix().toLower();
        const QString path = document.hasOwnFile() ? folder.relativeFilePath(file) : file;
        const bool isFractal = ending == QLatin1String("fdo");
        if ((isFractal || ending == QLatin1String("obj")) && isWritablePath(path.toStdString())) {
            placed.push_back({path.toStdString(), isFractal});
        } else {
            rest << file;
        }
    }
    const TextEdits edits = withPlacedFiles(*scene, placed);
    editor.apply(edits, editor.language().snapshot());
    return rest;
}

}
