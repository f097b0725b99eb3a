// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "documentbytes.h"

#include <vector>

#include <QCoreApplication>
#include <QStringDecoder>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>

#include "core/text/linediff.h"
#include "core/text/unicode.h"
#include "fdoeditor.h"

namespace romanesco {

namespace {

/// A property of block formats, since these follow the lines through edits and undo; absent it is LF.
constexpr int lineEndProperty = QTextFormat::UserProperty + 1;
enum LineEnd { Lf, CrLf, Cr };

std::vector<LineEnd> lineEnds(QStringView text)
{
    std::vector<LineEnd> ends;
    for (qsizetype at = 0; at < text.size(); ++at) {
        if (text[at] == u'\n') {
            ends.push_back(Lf);
        } else if (text[at] == u'\r') {
            const bool isPair = at + 1 < text.size() && text[at + 1] == u'\n';
            ends.push_back(isPair ? CrLf : Cr);
            at += isPair ? 1 : 0;
        }
    }
    return ends;
}

void setLineEnd(QTextCursor &cursor, LineEnd end)
{
    QTextBlockFormat format;
    format.setProperty(lineEndProperty, int(end));
    cursor.mergeBlockFormat(format);
}

void setLineEnds(QTextDocument &document, const std::vector<LineEnd> &ends)
{
    // The last line has no end; should it be split one day, it takes that of the line before.
    LineEnd end = Lf;
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const auto number = static_cast<std::size_t>(block.blockNumber());
        end = number < ends.size() ? ends[number] : end;
        if (end != Lf) {
            QTextCursor cursor(block);
            setLineEnd(cursor, end);
        }
    }
}

/// For a document that has had other lines.
void changeLineEnds(QTextDocument &document, const std::vector<LineEnd> &ends)
{
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        const auto number = static_cast<std::size_t>(block.blockNumber());
        if (number < ends.size() && block.blockFormat().intProperty(lineEndProperty) != ends[number]) {
            QTextCursor cursor(block);
            setLineEnd(cursor, ends[number]);
        }
    }
}

QByteArrayView lineEnd(const QTextBlock &block)
{
    switch (block.blockFormat().intProperty(lineEndProperty)) {
    case CrLf:
        return "\r\n";
    case Cr:
        return "\r";
    default:
        return "\n";
    }
}

/// Without the byte order mark.
std::expected<QString, QString> decoded(const QByteArray &bytes)
{
    const QByteArrayView body =
        QByteArrayView(bytes).sliced(bytes.startsWith(byteOrderMark) ? qsizetype(byteOrderMark.size()) : 0);
    // Stateless, so that a character that is cut off at the end is an error and not awaited.
    QStringDecoder decoder(QStringDecoder::Utf8,
                           QStringDecoder::Flag::Stateless | QStringDecoder::Flag::ConvertInitialBom);
    QString text = decoder(body);
    if (decoder.hasError()) {
        return std::unexpected(QCoreApplication::translate("DocumentBytes", "it is not UTF-8 text"));
    }
    return text;
}

std::string withPlainLineEnds(QString text)
{
    text.replace(QLatin1String("\r\n"), QLatin1String("\n")).replace(u'\r', u'\n');
    return text.toStdString();
}

TextFileForm formOf(const QTextDocument &document, const QByteArray &bytes)
{
    const bool hasByteOrderMark = bytes.startsWith(byteOrderMark);
    return {hasByteOrderMark, toBytes(document, hasByteOrderMark) == bytes};
}

}

std::expected<TextFileForm, QString> loadBytes(QTextDocument &document, const QByteArray &bytes)
{
    const auto text = decoded(bytes);
    if (!text) {
        return std::unexpected(text.error());
    }
    document.setUndoRedoEnabled(false);
    document.setPlainText(*text);
    setLineEnds(document, lineEnds(*text));
    document.setUndoRedoEnabled(true);
    document.setModified(false);
    return formOf(document, bytes);
}

std::expected<TextFileForm, QString> changeToBytes(FdoEditor &editor, const QByteArray &bytes)
{
    const auto text = decoded(bytes);
    if (!text) {
        return std::unexpected(text.error());
    }
    QTextCursor cursor(editor.document());
    cursor.beginEditBlock();
    changeToText(editor, withPlainLineEnds(*text));
    changeLineEnds(*editor.document(), lineEnds(*text));
    cursor.endEditBlock();
    return formOf(*editor.document(), bytes);
}

void changeToText(FdoEditor &editor, std::string_view text)
{
    const TextSnapshot before = editor.snapshot();
    // What the user may not edit may still follow its file.
    const bool isReadOnly = editor.isReadOnly();
    editor.setReadOnly(false);
    editor.apply(editsBetween(before.bytes(), text), before);
    editor.setReadOnly(isReadOnly);
}

std::expected<std::string, QString> textOf(const QByteArray &bytes)
{
    return decoded(bytes).transform(withPlainLineEnds);
}

QByteArray toBytes(const QTextDocument &document, bool withByteOrderMark)
{
    QByteArray bytes;
    bytes.reserve(document.characterCount() + document.blockCount());
    if (withByteOrderMark) {
        bytes += QByteArrayView(byteOrderMark);
    }
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        bytes += block.text().toUtf8();
        if (block.next().isValid()) {
            bytes += lineEnd(block);
        }
    }
    return bytes;
}

}
