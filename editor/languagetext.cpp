// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "languagetext.h"

#include <utility>

#include <QTextDocument>

namespace romanesco {

LanguageText::LanguageText(const QTextDocument &document, QObject *parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &QTextDocument::contentsChange, this, [this] { m_isStale = true; });
}

void LanguageText::setFileName(const QString &name)
{
    if (name.endsWith(QLatin1String(".fdo"))) {
        m_read.emplace<FdoDocument>();
    } else if (name.endsWith(QLatin1String(".sdo"))) {
        m_read.emplace<SdoSyntax>();
    } else {
        m_read.emplace<std::monostate>();
    }
    read();
}

const TextSnapshot &LanguageText::snapshot()
{
    bringUpToDate();
    return m_snapshot;
}

const FdoDocument *LanguageText::fdo()
{
    bringUpToDate();
    return std::get_if<FdoDocument>(&m_read);
}

const SdoSyntax *LanguageText::sdo()
{
    bringUpToDate();
    return std::get_if<SdoSyntax>(&m_read);
}

const std::vector<FoldingRange> &LanguageText::foldings()
{
    bringUpToDate();
    if (!std::exchange(m_hasFoldings, true)) {
        const bool isOurs = !std::holds_alternative<std::monostate>(m_read);
        m_foldings = isOurs ? foldingRanges(LineMap(m_snapshot.bytes())) : std::vector<FoldingRange>();
    }
    return m_foldings;
}

void LanguageText::bringUpToDate()
{
    if (!std::exchange(m_isStale, false)) {
        return;
    }
    // Colouring the text counts as a change too, but changes no character.
    TextSnapshot now(m_document);
    if (now.bytes() != m_snapshot.bytes()) {
        m_snapshot = std::move(now);
        read();
    }
}

void LanguageText::read()
{
    m_hasFoldings = false;
    if (auto *fdo = std::get_if<FdoDocument>(&m_read)) {
        fdo->setText(m_snapshot.bytes());
    } else if (auto *sdo = std::get_if<SdoSyntax>(&m_read)) {
        sdo->setText(m_snapshot.bytes());
    }
}

}
