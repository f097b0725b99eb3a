// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textediting.h"

#include <algorithm>

#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextBlock>

namespace romanesco {

namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\n';
}

/// Whether a cursor stands in front of a word and behind none.
bool isBeforeWord(std::size_t offset, const std::string &text)
{
    return offset < text.size() && !isBlank(text[offset]) && (offset == 0 || isBlank(text[offset - 1]));
}

/// The first and the last block that the selection is in; not the one at whose start it only ends.
std::pair<QTextBlock, QTextBlock> selectedLines(const QTextCursor &cursor)
{
    const QTextDocument &document = *cursor.document();
    const QTextBlock first = document.findBlock(cursor.selectionStart());
    QTextBlock last = document.findBlock(cursor.selectionEnd());
    if (last != first && cursor.selectionEnd() == last.position()) {
        last = last.previous();
    }
    return {first, last};
}

std::vector<QTextBlock> linesWithWords(const QTextCursor &cursor)
{
    const auto [first, last] = selectedLines(cursor);
    std::vector<QTextBlock> lines;
    for (QTextBlock line = first; line.isValid() && line.blockNumber() <= last.blockNumber(); line = line.next()) {
        if (!QStringView(line.text()).trimmed().isEmpty()) {
            lines.push_back(line);
        }
    }
    return lines;
}

/// The length of the mark that makes a line a comment, with its blank; 0 where it is none.
int commentMark(QStringView line)
{
    const QStringView words = line.trimmed();
    return !words.startsWith(u'#') ? 0 : words.startsWith(u"# ") ? 2 : 1;
}

}

std::size_t movedOffset(std::size_t offset, const TextEdits &edits, const std::string &text)
{
    std::size_t added = 0;
    std::size_t removed = 0;
    for (const TextEdit &edit : edits) {
        const auto [begin, end] = edit.range;
        if (offset < begin || (offset == begin && !(begin == end && isBeforeWord(offset, text)))) {
            break;
        }
        if (offset < end) {
            return begin + added - removed + std::min(offset - begin, edit.text.size());
        }
        added += edit.text.size();
        removed += end - begin;
    }
    return offset + added - removed;
}

void applyEdits(QPlainTextEdit &editor, const TextEdits &edits, const TextSnapshot &text, UndoStep step)
{
    if (edits.empty() || editor.isReadOnly()) {
        return;
    }
    const QTextCursor before = editor.textCursor();
    const std::size_t anchor = movedOffset(text.offset(before.anchor()), edits, text.bytes());
    const std::size_t position = movedOffset(text.offset(before.position()), edits, text.bytes());
    const int horizontal = editor.horizontalScrollBar()->value();
    const int vertical = editor.verticalScrollBar()->value();

    QTextCursor cursor(editor.document());
    if (step == UndoStep::Last) {
        cursor.joinPreviousEditBlock();
    } else {
        cursor.beginEditBlock();
    }
    // From the end, so that the places of the others stay what they are.
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        cursor.setPosition(text.position(edit->range.begin));
        cursor.setPosition(text.position(edit->range.end), QTextCursor::KeepAnchor);
        cursor.insertText(QString::fromStdString(edit->text));
    }
    cursor.endEditBlock();

    const TextSnapshot now(*editor.document());
    QTextCursor after = editor.textCursor();
    after.setPosition(now.position(anchor));
    after.setPosition(now.position(position), QTextCursor::KeepAnchor);
    editor.setTextCursor(after);
    editor.horizontalScrollBar()->setValue(horizontal);
    editor.verticalScrollBar()->setValue(vertical);
}

void toggleComment(QPlainTextEdit &editor)
{
    const std::vector<QTextBlock> lines = linesWithWords(editor.textCursor());
    if (lines.empty() || editor.isReadOnly()) {
        return;
    }
    const bool isComment = std::ranges::all_of(lines, [](const QTextBlock &line) { return commentMark(line.text()); });
    QTextCursor cursor(editor.document());
    cursor.beginEditBlock();
    for (const QTextBlock &line : lines) {
        const QString text = line.text();
        cursor.setPosition(line.position());
        if (isComment) {
            cursor.setPosition(line.position() + static_cast<int>(text.indexOf(u'#')));
            cursor.movePosition(QTextCursor::NextCharacter, QTextCursor::KeepAnchor, commentMark(text));
            cursor.removeSelectedText();
        } else {
            cursor.insertText(QStringLiteral("# "));
        }
    }
    cursor.endEditBlock();
}

void duplicateLines(QPlainTextEdit &editor)
{
    if (editor.isReadOnly()) {
        return;
    }
    QTextCursor selection = editor.textCursor();
    const auto [first, last] = selectedLines(selection);
    const int begin = first.position();
    const int length = last.position() + last.length() - begin;
    const int anchor = selection.anchor() + length;
    const int position = selection.position() + length;
    QTextCursor cursor(last);
    cursor.movePosition(QTextCursor::EndOfBlock);
    cursor.beginEditBlock();
    // Block by block, since the ends of lines are kept in their formats.
    for (QTextBlock line = first; line.position() < begin + length; line = line.next()) {
        cursor.insertBlock(line.blockFormat());
        cursor.insertText(line.text());
    }
    cursor.endEditBlock();
    selection.setPosition(std::min(anchor, editor.document()->characterCount() - 1));
    selection.setPosition(std::min(position, editor.document()->characterCount() - 1), QTextCursor::KeepAnchor);
    editor.setTextCursor(selection);
}

}
