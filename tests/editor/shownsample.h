// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include "editor/fdoeditor.h"

namespace romanesco::test {

/// The editor with an .fdo text, on its way to the screen.
inline std::unique_ptr<FdoEditor> shownEditor(const QString &text)
{
    auto editor = std::make_unique<FdoEditor>();
    editor->resize(600, 400);
    editor->setFileName(QStringLiteral("a.fdo"));
    editor->setPlainText(text);
    editor->show();
    return editor;
}

}
