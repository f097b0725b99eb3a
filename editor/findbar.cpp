// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "findbar.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include "fdoeditor.h"

namespace romanesco {

namespace {

constexpr int space = 4;

QHBoxLayout *row()
{
    auto *row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space);
    return row;
}

}

FindBar::FindBar(FdoEditor &editor, QWidget *parent)
    : QWidget(parent)
    , m_editor(editor)
    , m_search(*editor.document())
    , m_words(new QLineEdit)
    , m_replacement(new QLineEdit)
    , m_replacing(new QWidget)
    , m_case(option(QStringLiteral("Aa"), tr("Match upper and lower case")))
    , m_whole(option(QStringLiteral("|a|"), tr("Whole words only")))
    , m_expression(option(QStringLiteral(".*"), tr("Regular expression")))
    , m_replaceOne(new QPushButton(tr("Replace")))
    , m_replaceAll(new QPushButton(tr("Replace All")))
    , m_count(new QLabel)
    , m_remark(new QLabel)
{
    layOut();
    connectParts();
    hide();
}

void FindBar::layOut()
{
    m_words->setPlaceholderText(tr("Find"));
    m_words->setAccessibleName(tr("Find"));
    m_words->setClearButtonEnabled(true);
    m_replacement->setPlaceholderText(tr("Replace with"));
    m_replacement->setAccessibleName(tr("Replace with"));
    m_count->setAccessibleName(tr("Matches"));
    m_remark->setTextFormat(Qt::PlainText);
    m_remark->setWordWrap(true);
    m_remark->hide();

    QHBoxLayout *finding = row();
    for (QWidget *part : std::initializer_list<QWidget *>{m_words, m_case, m_whole, m_expression, m_count}) {
        finding->addWidget(part, part == m_words ? 1 : 0);
    }
    QHBoxLayout *replacing = row();
    replacing->addWidget(m_replacement, 1);
    replacing->addWidget(m_replaceOne);
    replacing->addWidget(m_replaceAll);
    m_replacing->setLayout(replacing);

    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(space, space, space, space);
    column->setSpacing(space);
    column->addLayout(finding);
    column->addWidget(m_replacing);
    column->addWidget(m_remark);
}

void FindBar::connectParts()
{
    connect(m_words, &QLineEdit::textChanged, this, &FindBar::startSearch);
    for (const QToolButton *option : {m_case, m_whole, m_expression}) {
        connect(option, &QToolButton::toggled, this, &FindBar::startSearch);
    }
    connect(m_replaceOne, &QPushButton::clicked, this, &FindBar::replaceOne);
    connect(m_replaceAll, &QPushButton::clicked, this, &FindBar::replaceAll);
    connect(&m_search, &TextSearch::advanced, this, [this] {
        goIfFound();
        showState();
    });
    connect(&m_search, &TextSearch::replacedAll, this, [this](int count) {
        m_replaced = {count, m_editor.document()->revision()};
        showState();
    });
    connect(&m_editor, &QPlainTextEdit::selectionChanged, this, [this] {
        m_replaced.reset();
        if (isVisible()) {
            showState();
        }
    });
}

QToolButton *FindBar::option(const QString &sign, const QString &name)
{
    auto *button = new QToolButton;
    button->setText(sign);
    button->setToolTip(name);
    button->setAccessibleName(name);
    button->setCheckable(true);
    button->setAutoRaise(true);
    return button;
}

void FindBar::openFind()
{
    open(false);
}

void FindBar::openReplace()
{
    open(true);
}

void FindBar::open(bool hasReplacement)
{
    m_replacing->setVisible(hasReplacement && !m_editor.isReadOnly());
    const QTextCursor cursor = m_editor.textCursor();
    m_origin = cursor.selectionStart();
    const QString selected = cursor.selectedText();
    show();
    if (!selected.isEmpty() && !selected.contains(QChar::ParagraphSeparator)) {
        m_expression->setChecked(false);
        m_words->setText(selected);
    }
    m_words->selectAll();
    m_words->setFocus();
    startSearch();
}

void FindBar::startSearch()
{
    if (!isVisible()) {
        return;
    }
    m_replaced.reset();
    m_search.setQuery({m_words->text(), m_expression->isChecked(), m_case->isChecked(), m_whole->isChecked()});
    m_way = Way::FromHere;
}

void FindBar::findNext()
{
    go(Way::Forward);
}

void FindBar::findPrevious()
{
    go(Way::Backward);
}

void FindBar::go(Way way)
{
    if (!isVisible()) {
        m_replacing->hide();
        show();
        startSearch();
    }
    m_replaced.reset();
    m_way = way;
    goIfFound();
}

void FindBar::goIfFound()
{
    if (!m_way) {
        return;
    }
    if (const std::optional<TextStretch> match = wanted()) {
        const bool isTyping = m_way == Way::FromHere;
        select(*match);
        m_origin = isTyping ? m_origin : match->begin;
        m_way.reset();
    } else if (m_search.isComplete()) {
        m_way.reset();
    }
}

/// The match to go to, if it is known already.
std::optional<TextStretch> FindBar::wanted() const
{
    const std::vector<TextStretch> &matches = m_search.matches();
    const QTextCursor cursor = m_editor.textCursor();
    if (m_way == Way::Backward) {
        const int here = cursor.selectionStart();
        const auto next = std::ranges::lower_bound(matches, here, {}, &TextStretch::begin);
        if (m_search.foundUpTo() < here || (next == matches.begin() && !m_search.isComplete()) || matches.empty()) {
            return std::nullopt;
        }
        return next == matches.begin() ? matches.back() : *std::prev(next);
    }
    // A match without length at the cursor is the one that is left.
    const TextStretch selected{cursor.selectionStart(), cursor.selectionEnd()};
    const int from = m_way == Way::FromHere ? m_origin : selected.end;
    auto next = std::ranges::lower_bound(matches, from, {}, &TextStretch::begin);
    if (m_way == Way::Forward && next != matches.end() && *next == selected) {
        ++next;
    }
    if (next != matches.end()) {
        return *next;
    }
    return m_search.isComplete() && !matches.empty() ? std::optional(matches.front()) : std::nullopt;
}

void FindBar::select(TextStretch match)
{
    QTextCursor cursor = m_editor.textCursor();
    cursor.setPosition(match.begin);
    cursor.setPosition(match.end, QTextCursor::KeepAnchor);
    m_editor.setTextCursor(cursor);
    m_editor.ensureCursorVisible();
}

void FindBar::replaceOne()
{
    QTextCursor cursor = m_editor.textCursor();
    const TextStretch selected{cursor.selectionStart(), cursor.selectionEnd()};
    const bool isMatch = std::ranges::binary_search(m_search.matches(), selected.begin, {}, &TextStretch::begin);
    const auto words = isMatch ? m_search.replacement(selected, m_replacement->text()) : std::nullopt;
    if (words && !m_editor.isReadOnly()) {
        cursor.insertText(*words);
        m_editor.setTextCursor(cursor);
    }
    findNext();
}

void FindBar::replaceAll()
{
    if (!m_editor.isReadOnly() && !m_words->text().isEmpty()) {
        m_way.reset();
        m_search.replaceAll(m_replacement->text());
    }
}

void FindBar::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    // Marks have the colours of the theme.
    if (event->type() == QEvent::PaletteChange && isVisible()) {
        showState();
    }
}

void FindBar::hideEvent(QHideEvent *event)
{
    // Not where only the window is hidden.
    if (isHidden()) {
        m_way.reset();
        m_search.setQuery({});
        m_editor.mark(MarkLayer::Matches, {}, {});
    }
    QWidget::hideEvent(event);
}

void FindBar::keyPressEvent(QKeyEvent *event)
{
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->key() == Qt::Key_Escape) {
        hide();
        m_editor.setFocus();
    } else if (isEnter && m_replacement->hasFocus()) {
        replaceOne();
    } else if (isEnter) {
        go(event->modifiers() & Qt::ShiftModifier ? Way::Backward : Way::Forward);
    } else {
        QWidget::keyPressEvent(event);
    }
}

void FindBar::showState()
{
    const std::vector<TextStretch> &matches = m_search.matches();
    QTextCharFormat format;
    format.setBackground(m_editor.colour(KSyntaxHighlighting::Theme::SearchHighlight));
    m_editor.mark(MarkLayer::Matches, matches, format);

    m_remark->setText(m_search.error());
    m_remark->setVisible(!m_search.error().isEmpty());
    m_words->setAccessibleDescription(m_search.error());
    const int begin = m_editor.textCursor().selectionStart();
    const auto current = std::ranges::lower_bound(matches, begin, {}, &TextStretch::begin);
    const bool isAtMatch = current != matches.end() && current->begin == begin;
    const auto count = static_cast<int>(matches.size());
    if (m_words->text().isEmpty() || !m_search.error().isEmpty()) {
        m_count->clear();
    } else if (m_replaced && m_replaced->revision == m_editor.document()->revision()) {
        m_count->setText(tr("%n replaced", nullptr, m_replaced->count));
    } else if (!m_search.isComplete()) {
        m_count->setText(tr("%1 so far").arg(count));
    } else if (count == 0) {
        m_count->setText(tr("No matches"));
    } else if (isAtMatch) {
        m_count->setText(tr("%1 of %2").arg(current - matches.begin() + 1).arg(count));
    } else {
        m_count->setText(tr("%n matches", nullptr, count));
    }
}

}
