// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "tooltips.h"

#include <QStringList>

#include "core/language/hover.h"
#include "languagetext.h"

namespace romanesco {

namespace {

std::optional<Hover> hoverAt(LanguageText &text, int position)
{
    const std::size_t offset = text.offset(position);
    if (const FdoDocument *fdo = text.fdo()) {
        return hover(*fdo, offset);
    }
    const SdoSyntax *sdo = text.sdo();
    return sdo ? hover(*sdo, offset) : std::nullopt;
}

}

QString tipWords(const QStringList &problems, LanguageText &text, int position)
{
    QString words;
    for (const QString &problem : problems) {
        words += QStringLiteral("<p>%1</p>").arg(problem.toHtmlEscaped());
    }
    if (const std::optional<Hover> hover = hoverAt(text, position)) {
        words += QStringLiteral("<p style=\"white-space:pre\"><b>%1</b>")
                     .arg(QString::fromStdString(hover->title).toHtmlEscaped());
        for (const std::string &line : hover->lines) {
            words += QStringLiteral("<br>") + QString::fromStdString(line).toHtmlEscaped();
        }
        words += QStringLiteral("</p>");
    }
    return words;
}

}
