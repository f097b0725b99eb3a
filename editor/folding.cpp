// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "folding.h"

#include <algorithm>

#include <QAbstractTextDocumentLayout>
#include <QPlainTextEdit>
#include <QTextBlock>

#include "languagetext.h"

namespace romanesco {

namespace {

bool isHidden(const QTextBlock &line)
{
    return line.isValid() && !line.isVisible();
}

}

Folding::Folding(QPlainTextEdit &editor, LanguageText &text)
    : QObject(&editor)
    , m_editor(editor)
    , m_text(text)
{
    connect(editor.document(), &QTextDocument::contentsChange, this,
            [this](int begin, int, int added) { openWhatIsEdited(begin, added); });
    connect(&editor, &QPlainTextEdit::cursorPositionChanged, this, [this] {
        if (isHidden(m_editor.textCursor().block())) {
            unfoldRound(m_editor.textCursor().block());
        }
    });
}

bool Folding::canFold(int line)
{
    const auto &sections = m_text.foldings();
    return std::ranges::binary_search(sections, static_cast<std::size_t>(line), {}, &FoldingRange::first);
}

bool Folding::isFolded(int line) const
{
    const QTextBlock block = m_editor.document()->findBlockByNumber(line);
    return block.isVisible() && isHidden(block.next());
}

void Folding::toggle(int line)
{
    if (isFolded(line)) {
        unfoldRound(m_editor.document()->findBlockByNumber(line));
    } else if (canFold(line)) {
        fold(*sectionAt(line));
    }
}

void Folding::foldAtCursor()
{
    if (const std::optional<FoldingRange> section = sectionAt(m_editor.textCursor().blockNumber())) {
        fold(*section);
        m_editor.ensureCursorVisible();
    }
}

void Folding::unfoldAtCursor()
{
    unfoldRound(m_editor.textCursor().block());
}

void Folding::foldAll()
{
    for (const FoldingRange &section : m_text.foldings()) {
        fold(section);
    }
    m_editor.ensureCursorVisible();
}

void Folding::unfoldAll()
{
    setVisible(m_editor.document()->begin(), QTextBlock(), true);
}

std::optional<FoldingRange> Folding::sectionAt(int line)
{
    const auto &sections = m_text.foldings();
    const auto next = std::ranges::upper_bound(sections, static_cast<std::size_t>(line), {}, &FoldingRange::first);
    const bool isInside = next != sections.begin() && static_cast<std::size_t>(line) <= std::prev(next)->last;
    return isInside ? std::optional(*std::prev(next)) : std::nullopt;
}

void Folding::fold(FoldingRange section)
{
    const QTextDocument &document = *m_editor.document();
    const QTextBlock head = document.findBlockByNumber(static_cast<int>(section.first));
    const QTextBlock end = document.findBlockByNumber(static_cast<int>(section.last) + 1);
    QTextCursor cursor = m_editor.textCursor();
    const auto line = static_cast<std::size_t>(cursor.blockNumber());
    if (section.first < line && line <= section.last) {
        cursor.setPosition(head.position() + head.length() - 1);
        m_editor.setTextCursor(cursor);
    }
    setVisible(head.next(), end, false);
}

/// Opens the fold that a line is in or that begins below it.
void Folding::unfoldRound(const QTextBlock &line)
{
    QTextBlock first = isHidden(line) ? line : line.next();
    if (!isHidden(first)) {
        return;
    }
    while (isHidden(first.previous())) {
        first = first.previous();
    }
    QTextBlock end = first;
    while (isHidden(end)) {
        end = end.next();
    }
    setVisible(first, end, true);
}

void Folding::setVisible(QTextBlock first, const QTextBlock &end, bool isVisible)
{
    QTextDocument &document = *m_editor.document();
    const int begin = first.position();
    for (QTextBlock line = first; line.isValid() && line != end; line = line.next()) {
        line.setVisible(isVisible);
        line.setLineCount(isVisible ? std::max(1, line.layout()->lineCount()) : 0);
    }
    const int last = end.isValid() ? end.position() : document.characterCount();
    document.markContentsDirty(begin, last - begin);
    QAbstractTextDocumentLayout &layout = *document.documentLayout();
    Q_EMIT layout.documentSizeChanged(layout.documentSize());
    m_editor.viewport()->update();
    Q_EMIT changed();
}

void Folding::openWhatIsEdited(int begin, int added)
{
    const QTextDocument &document = *m_editor.document();
    const QTextBlock last = document.findBlock(std::min(begin + added, document.characterCount() - 1));
    for (QTextBlock line = document.findBlock(begin); line.isValid(); line = line.next()) {
        unfoldRound(line);
        if (line == last) {
            break;
        }
    }
}

}
