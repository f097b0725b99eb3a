// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "keylist.h"

#include <algorithm>

#include <QAction>
#include <QHeaderView>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace romanesco {

namespace {

QString plain(QString words)
{
    return words.remove(u'&').remove(u'…');
}

void addKey(QTreeWidgetItem &group, const QString &words, const QString &keys)
{
    auto *row = new QTreeWidgetItem(&group, {words, keys});
    row->setFlags(row->flags() | Qt::ItemNeverHasChildren);
}

bool holdsAll(const QString &text, const QStringList &words)
{
    return std::ranges::all_of(words, [&](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

}

KeyList::KeyList(QMainWindow &window)
    : QDialog(&window)
    , m_keys(new QTreeWidget)
{
    setWindowTitle(tr("Keys"));
    auto *words = new QLineEdit;
    words->setPlaceholderText(tr("Filter"));
    words->setAccessibleName(tr("Filter"));
    words->setClearButtonEnabled(true);
    m_keys->setAccessibleName(tr("Keys"));
    m_keys->setColumnCount(2);
    m_keys->setHeaderHidden(true);
    m_keys->setRootIsDecorated(false);
    m_keys->setUniformRowHeights(true);
    m_keys->setFrameShape(QFrame::NoFrame);
    auto *column = new QVBoxLayout(this);
    column->addWidget(words);
    column->addWidget(m_keys, 1);
    connect(words, &QLineEdit::textChanged, this, &KeyList::filter);

    for (const QAction *action : window.menuBar()->actions()) {
        if (const QMenu *menu = action->menu()) {
            addMenu(addGroup(plain(menu->title())), *menu);
        }
    }
    addGestures();
    filter({});
    m_keys->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_keys->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    m_keys->header()->setStretchLastSection(false);
    resize(520, 640);
    words->setFocus();
}

QTreeWidgetItem &KeyList::addGroup(const QString &name)
{
    auto *group = new QTreeWidgetItem(m_keys, {name});
    QFont bold = font();
    bold.setBold(true);
    group->setFont(0, bold);
    group->setFlags(Qt::ItemIsEnabled);
    group->setFirstColumnSpanned(true);
    return *group;
}

void KeyList::addMenu(QTreeWidgetItem &group, const QMenu &menu)
{
    for (const QAction *action : menu.actions()) {
        if (action->menu()) {
            addMenu(group, *action->menu());
        } else if (!action->shortcuts().isEmpty()) {
            addKey(group, plain(action->text()),
                   QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText)
                       .replace(QStringLiteral("; "), QStringLiteral(", ")));
        }
    }
}

/// What widgets do by themselves.
void KeyList::addGestures()
{
    QTreeWidgetItem &text = addGroup(tr("In the text"));
    addKey(text, tr("Step the number at the cursor"), tr("Alt+Up, Alt+Down"));
    addKey(text, tr("The same, a decimal finer"), tr("Alt+Shift+Up, Alt+Shift+Down"));
    addKey(text, tr("Move a number, finer with Shift"), tr("Ctrl+drag"));
    addKey(text, tr("Go to a definition, or open a file"), tr("Ctrl+click"));
    addKey(text, tr("Pin a number as a slider"), tr("Right click, Menu"));
    addKey(text, tr("Text size"), tr("Ctrl+wheel"));
    addKey(text, tr("Take what completion offers"), tr("Tab, Enter"));
    addKey(text, tr("Close the offer"), tr("Esc"));
    QTreeWidgetItem &find = addGroup(tr("In the find bar"));
    addKey(find, tr("Next match"), tr("Enter"));
    addKey(find, tr("Previous match"), tr("Shift+Enter"));
    addKey(find, tr("Close"), tr("Esc"));
    QTreeWidgetItem &measured = addGroup(tr("In the table of what was measured"));
    addKey(measured, tr("Use what is chosen"), tr("Enter, double click"));
    QTreeWidgetItem &picture = addGroup(tr("In the picture"));
    addKey(picture, tr("Turn"), tr("Drag, arrow keys"));
    addKey(picture, tr("Shift"), tr("Right drag, Shift+drag"));
    addKey(picture, tr("Zoom"), tr("Wheel, +, -"));
    addKey(picture, tr("Which words made a copy"), tr("Click"));
    addKey(picture, tr("Fly"), tr("W, A, S, D"));
    addKey(picture, tr("Look about while flying"), tr("Right drag"));
}

void KeyList::filter(const QString &text)
{
    const QStringList words = text.split(u' ', Qt::SkipEmptyParts);
    for (int i = 0; i < m_keys->topLevelItemCount(); ++i) {
        QTreeWidgetItem &group = *m_keys->topLevelItem(i);
        bool isAny = false;
        for (int j = 0; j < group.childCount(); ++j) {
            QTreeWidgetItem &row = *group.child(j);
            const bool isIn = holdsAll(group.text(0) + u' ' + row.text(0) + u' ' + row.text(1), words);
            row.setHidden(!isIn);
            isAny = isAny || isIn;
        }
        group.setHidden(!isAny);
        group.setExpanded(true);
    }
}

void showKeyList(QMainWindow &window)
{
    auto *list = window.findChild<KeyList *>();
    if (!list) {
        list = new KeyList(window);
        list->setAttribute(Qt::WA_DeleteOnClose);
    }
    list->show();
    list->raise();
    list->activateWindow();
}

}
