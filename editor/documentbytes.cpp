// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "documentbytes.h"

#include <vector>

#include <QCoreApplication>
#include <QStringDecoder>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>

namespace romanesco {

namespace {

constexpr QByteArrayView byteOrderMark("\xEF\xBB\xBF");

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

}

std::expected<TextFileForm, QString> loadBytes(QTextDocument &document, const QByteArray &bytes)
{
    TextFileForm form;
    form.hasByteOrderMark = bytes.startsWith(byteOrderMark);
    const QByteArrayView body = QByteArrayView(bytes).sliced(form.hasByteOrderMark ? byteOrderMark.size() : 0);
    // Stateless, so that a character that is cut off at the end is an error and not awaited.
    QStringDecoder decoder(QStringDecoder::Utf8,
                           QStringDecoder::Flag::Stateless | QStringDecoder::Flag::ConvertInitialBom);
    const QString text = decoder(body);
    if (decoder.hasError()) {
        return std::unexpected(QCoreApplication::translate("DocumentBytes", "it is not UTF-8 text"));
    }

    document.setUndoRedoEnabled(false);
    document.setPlainText(text);
    setLineEnds(document, lineEnds(text));
    document.setUndoRedoEnabled(true);
    document.setModified(false);
    form.isFaithful = toBytes(document, form.hasByteOrderMark) == bytes;
    return form;
}

QByteArray toBytes(const QTextDocument &document, bool withByteOrderMark)
{
    QByteArray bytes;
    bytes.reserve(document.characterCount() + document.blockCount());
    if (withByteOrderMark) {
        bytes += byteOrderMark;
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
