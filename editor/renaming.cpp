// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renaming.h"

#include <QCoreApplication>

#include "core/language/navigation.h"

#include "fdoeditor.h"
#include "inlineedit.h"

namespace romanesco {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Renaming)
};

}

void askForName(FdoEditor &editor)
{
    LanguageText &text = editor.language();
    const FdoDocument *fdo = text.fdo();
    const std::size_t offset = text.offset(editor.textCursor().position());
    if (!fdo || editor.isReadOnly()) {
        editor.sayAtCursor(fdo ? Words::tr("This text can only be read.") : Words::tr("There are no names here."));
        return;
    }
    const std::optional<SourceRange> name = renamable(*fdo, offset);
    if (!name) {
        const auto refusal = rename(*fdo, offset, "name");
        editor.sayAtCursor(refusal ? QString() : QString::fromStdString(refusal.error()));
        return;
    }
    const auto edits = [&text, offset](const QString &words) {
        return rename(*text.fdo(), offset, words.toStdString());
    };
    const std::string_view now = std::string_view(text.snapshot().bytes()).substr(name->begin, name->length());
    InlineEdit::open(
        editor, text.position(name->begin),
        {.title = Words::tr("New name"),
         .text = QString::fromUtf8(now.data(), static_cast<qsizetype>(now.size())),
         .check =
             [edits](const QString &words) {
                 const auto result = edits(words);
                 return result ? QString() : QString::fromStdString(result.error());
             },
         .take = [edits,
                  &editor](const QString &words) { editor.apply(*edits(words), editor.language().snapshot()); }});
}

void askForLine(FdoEditor &editor)
{
    const auto check = [&editor](const QString &words) {
        bool isNumber = false;
        const int line = words.toInt(&isNumber);
        return isNumber && line >= 1 && line <= editor.blockCount()
            ? QString()
            : Words::tr("The lines are numbered from 1 to %1.").arg(editor.blockCount());
    };
    InlineEdit::open(
        editor, editor.textCursor().position(),
        {.title = Words::tr("Go to line"), .text = QString(), .check = check, .take = [&editor](const QString &words) {
             editor.goToLine(words.toInt());
         }});
}

}
