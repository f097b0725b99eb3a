// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "completionpopup.h"

#include <algorithm>

#include <QCompleter>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTextBlock>
#include <QTreeView>

#include "languagetext.h"

namespace romanesco {

namespace {

constexpr int mostVisible = 10;

bool isNamePart(QChar c)
{
    return c.isLetterOrNumber() || c.isMark() || c.isSurrogate() || c == u'_';
}

bool isAccepting(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab;
}

/// A list of two columns, quiet and without a header.
QTreeView *listView()
{
    auto *view = new QTreeView;
    view->setRootIsDecorated(false);
    view->setUniformRowHeights(true);
    view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view->header()->hide();
    view->header()->setStretchLastSection(false);
    return view;
}

}

CompletionPopup::CompletionPopup(QPlainTextEdit &editor, LanguageText &text)
    : QObject(&editor)
    , m_editor(editor)
    , m_text(text)
    , m_completer(new QCompleter(this))
    , m_model(new QStandardItemModel(this))
    , m_view(listView())
{
    m_completer->setWidget(&editor);
    m_completer->setModel(m_model);
    m_completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    m_completer->setMaxVisibleItems(mostVisible);
    m_completer->setPopup(m_view);
    m_view->setAccessibleName(tr("Completions"));
    connect(m_completer, qOverload<const QModelIndex &>(&QCompleter::activated), this,
            [this](const QModelIndex &index) { write(index.row()); });
}

bool CompletionPopup::isOpen() const
{
    return m_view->isVisible();
}

void CompletionPopup::open()
{
    update(true);
}

bool CompletionPopup::takes(const QKeyEvent &key) const
{
    if (!isOpen()) {
        return false;
    }
    return key.key() == Qt::Key_Escape || (isAccepting(key.key()) && m_view->currentIndex().isValid());
}

void CompletionPopup::follow(const QKeyEvent &key)
{
    const bool isTyped = !key.text().isEmpty() && isNamePart(key.text().back())
        && !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    if (isOpen()) {
        update(m_isAsked);
    } else if (isTyped) {
        update(false);
    }
}

std::vector<Completion> CompletionPopup::completions()
{
    const FileNames files = [this] {
        if (!m_listed) {
            m_listed = m_files ? m_files() : std::vector<std::string>();
        }
        return *m_listed;
    };
    const std::size_t offset = m_text.offset(m_editor.textCursor().position());
    if (const FdoDocument *fdo = m_text.fdo()) {
        return complete(*fdo, offset, files);
    }
    const SdoSyntax *sdo = m_text.sdo();
    return sdo ? complete(*sdo, offset, files) : std::vector<Completion>();
}

QString CompletionPopup::begunWord() const
{
    const QTextCursor cursor = m_editor.textCursor();
    const QString before = cursor.block().text().first(cursor.positionInBlock());
    qsizetype begin = before.size();
    while (begin > 0 && isNamePart(before[begin - 1])) {
        --begin;
    }
    return before.sliced(begin);
}

void CompletionPopup::update(bool isAsked)
{
    const QString begun = begunWord();
    if (!isOpen() && (isAsked || begun.size() <= 1)) {
        m_listed.reset();
    }
    const bool isNameBegun = !begun.isEmpty() && !begun.front().isDigit();
    const bool mayOpen = !m_editor.isReadOnly() && !m_editor.textCursor().hasSelection() && (isAsked || isNameBegun);
    m_completions = mayOpen ? completions() : std::vector<Completion>();
    const bool isWhole = m_completions.size() == 1 && m_completions.front().label == begun.toStdString();
    if (m_completions.empty() || (isWhole && !isAsked)) {
        m_view->hide();
        return;
    }
    m_isAsked = isAsked;
    m_snapshot = m_text.snapshot();
    fill(begun);
}

void CompletionPopup::fill(const QString &begun)
{
    m_model->clear();
    for (const Completion &completion : m_completions) {
        auto *label = new QStandardItem(QString::fromStdString(completion.label));
        auto *detail = new QStandardItem(QString::fromStdString(completion.detail));
        detail->setForeground(m_editor.palette().placeholderText());
        m_model->appendRow({label, detail});
    }
    m_view->setFont(m_editor.font());
    m_view->resizeColumnToContents(0);
    m_view->resizeColumnToContents(1);
    QRect place = m_editor.cursorRect().translated(m_editor.viewport()->pos());
    const int columns = m_view->columnWidth(0) + m_view->columnWidth(1);
    place.setWidth(columns + m_view->verticalScrollBar()->sizeHint().width() + 2 * m_view->frameWidth());
    m_completer->complete(place);
    const bool isWritten = std::ranges::contains(m_completions, begun.toStdString(), &Completion::label);
    m_view->setCurrentIndex(isWritten ? QModelIndex() : m_completer->completionModel()->index(0, 0));
}

void CompletionPopup::write(int row)
{
    if (row < 0 || static_cast<std::size_t>(row) >= m_completions.size()
        || m_snapshot.bytes() != m_text.snapshot().bytes()) {
        return;
    }
    const TextEdit edit = m_completions[static_cast<std::size_t>(row)].edit;
    const QString words = QString::fromStdString(edit.text);
    QTextCursor cursor = m_editor.textCursor();
    cursor.setPosition(m_snapshot.position(edit.range.begin));
    cursor.setPosition(m_snapshot.position(edit.range.end), QTextCursor::KeepAnchor);
    if (cursor.selectedText() != words) {
        cursor.insertText(words);
    }
    cursor.clearSelection();
    m_editor.setTextCursor(cursor);
}

}
