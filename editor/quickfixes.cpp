// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "quickfixes.h"

#include <QMenu>
#include <QPlainTextEdit>
#include <QTextBlock>
#include <QToolTip>

#include "languagetext.h"
#include "textediting.h"

namespace romanesco {

QuickFixes::QuickFixes(QPlainTextEdit &editor, LanguageText &text)
    : QObject(&editor)
    , m_editor(editor)
    , m_text(text)
{
}

void QuickFixes::setDiagnostics(const Diagnostics &diagnostics, const TextSnapshot &text)
{
    m_places.clear();
    for (const Diagnostic &diagnostic : diagnostics) {
        if (diagnostic.fix) {
            m_places.push_back({diagnostic.range, *diagnostic.fix});
        }
    }
    m_snapshot = text;
}

std::vector<Fix> QuickFixes::atCursor()
{
    if (m_places.empty() || m_editor.isReadOnly() || m_snapshot.bytes() != m_text.snapshot().bytes()) {
        return {};
    }
    const QTextCursor cursor = m_editor.textCursor();
    const std::size_t here = m_snapshot.offset(cursor.position());
    const std::size_t lineBegin = m_snapshot.offset(cursor.block().position());
    const std::size_t lineEnd = m_snapshot.offset(cursor.block().position() + cursor.block().length() - 1);
    std::vector<Fix> touched;
    std::vector<Fix> inLine;
    for (const Place &place : m_places) {
        if (place.range.touches(here)) {
            touched.push_back(place.fix);
        }
        if (lineBegin <= place.range.begin && place.range.begin <= lineEnd) {
            inLine.push_back(place.fix);
        }
    }
    return touched.empty() ? inLine : touched;
}

void QuickFixes::offer()
{
    const std::vector<Fix> fixes = atCursor();
    const QPoint below = m_editor.viewport()->mapToGlobal(m_editor.cursorRect().bottomLeft());
    if (fixes.empty()) {
        QToolTip::showText(below, tr("There is nothing here that could be mended by itself."), m_editor.viewport());
        return;
    }
    auto *menu = new QMenu(&m_editor);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setAccessibleName(tr("Fixes"));
    for (const Fix &fix : fixes) {
        QString title = QString::fromStdString(fix.title);
        title.replace(u'&', QLatin1String("&&"));
        connect(menu->addAction(title), &QAction::triggered, this, [this, fix, text = m_snapshot] {
            // The menu stays open while the text becomes another.
            if (text.bytes() == m_text.snapshot().bytes()) {
                applyEdits(m_editor, fix.edits, text);
            }
        });
    }
    menu->setActiveAction(menu->actions().constFirst());
    menu->popup(below);
}

}
