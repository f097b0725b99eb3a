// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <variant>

#include <QObject>

#include "core/formats/sdosyntax.h"
#include "core/language/fdodocument.h"
#include "core/language/structure.h"
#include "textsnapshot.h"

class QTextDocument;

namespace romanesco {

/// A document's text as its language reads it: what the features of an editor ask. Brought up to date when something
/// asks, which after a small change takes some milliseconds even in 100,000 lines, and nothing when the text is the same.
class LanguageText : public QObject
{
    Q_OBJECT
public:
    /// document is an editor's and must outlive it.
    explicit LanguageText(const QTextDocument &document, QObject *parent = nullptr);

    /// The ending of the name tells the language: .fdo, .sdo, or none that is known.
    void setFileName(const QString &name);

    /// Of the text as it is now.
    [[nodiscard]] const TextSnapshot &snapshot();
    /// Null where the text is in another language.
    [[nodiscard]] const FdoDocument *fdo();
    [[nodiscard]] const SdoSyntax *sdo();
    /// The sections that can be folded.
    [[nodiscard]] const std::vector<FoldingRange> &foldings();

    [[nodiscard]] std::size_t offset(int position) { return snapshot().offset(position); }
    [[nodiscard]] int position(std::size_t offset) { return snapshot().position(offset); }

private:
    void bringUpToDate();
    void read();

    const QTextDocument &m_document;
    bool m_isStale = true;
    TextSnapshot m_snapshot;
    std::variant<std::monostate, FdoDocument, SdoSyntax> m_read;
    std::vector<FoldingRange> m_foldings;
    bool m_hasFoldings = false;
};

}
