// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <string>
#include <string_view>

#include <QByteArray>
#include <QString>

class QTextDocument;

namespace romanesco {

class FdoEditor;

/// What a text file has beside its text. Each line's end is kept with the line, in the document.
struct TextFileForm {
    bool hasByteOrderMark = false;
    /// Whether toBytes() gives back the very bytes. Not so for a text with characters that Qt keeps for itself
    /// (U+2029, U+FDD0, U+FDD1): such a document must not be saved over its file.
    bool isFaithful = true;
};

/// Puts the text of a file into a document: a new text, without undo history, unmodified. Lines end at LF, CR LF or CR,
/// mixed as they may be. The error is a sentence; the document is then as it was.
[[nodiscard]] std::expected<TextFileForm, QString> loadBytes(QTextDocument &document, const QByteArray &bytes);

/// The same as one undo step that changes only the lines that differ; the cursor stays in its line where that stays. The text
/// is then modified.
[[nodiscard]] std::expected<TextFileForm, QString> changeToBytes(FdoEditor &editor, const QByteArray &bytes);

/// Another text with LF between the lines, as TextSnapshot has it, in the same way. New lines end as those before them.
void changeToText(FdoEditor &editor, std::string_view text);

/// The text of a file, with LF between the lines.
[[nodiscard]] std::expected<std::string, QString> textOf(const QByteArray &bytes);

/// The file for a document: UTF-8, each line with the end it was loaded with, a new line with that of the line it was
/// split from.
[[nodiscard]] QByteArray toBytes(const QTextDocument &document, bool withByteOrderMark);

}
