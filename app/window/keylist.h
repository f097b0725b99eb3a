// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QDialog>

class QMainWindow;
class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace romanesco {

/// All keys of a window, a group for each of its menus, then those of the text and of the picture that no menu has. A line
/// above narrows it to what holds all words that are typed there; Esc closes.
class KeyList : public QDialog
{
    Q_OBJECT
public:
    /// Reads the menus as they are now.
    explicit KeyList(QMainWindow &window);

private:
    QTreeWidgetItem &addGroup(const QString &name);
    void addMenu(QTreeWidgetItem &group, const QMenu &menu);
    void addGestures();
    void filter(const QString &words);

    QTreeWidget *m_keys;
};

/// Opens it, or brings forward the one that is open.
void showKeyList(QMainWindow &window);

}
