// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <vector>

#include <QTimer>
#include <QTreeWidget>

#include "core/text/sourcerange.h"

namespace romanesco {

class FdoEditor;

/// What the text declares, line by line: a click leads there, and that of the cursor's line is marked. What a scene places
/// has a tick: without it, its line is a comment. The text is followed shortly after an edit, while the pane is seen.
class OutlinePane : public QTreeWidget
{
    Q_OBJECT
public:
    explicit OutlinePane(QWidget *parent = nullptr);
    ~OutlinePane() override;

    /// From now on it is about this text, which outlives that.
    void follow(FdoEditor &editor);
    /// What the text says now, and whether it can be changed.
    void update();

protected:
    void showEvent(QShowEvent *event) override;

private:
    struct Entry {
        QString name;
        QString kind;
        SourceRange range;
        std::size_t line = 0;
        bool canHide = false;
        bool isShown = true;
    };
    [[nodiscard]] std::vector<Entry> entries() const;
    [[nodiscard]] bool isShowing(const std::vector<Entry> &entries) const;
    void fill();
    void markCurrent();
    void go(QTreeWidgetItem *item);
    void changeVisibility(QTreeWidgetItem *item);

    FdoEditor *m_editor = nullptr;
    /// Lives as long as an editor is followed, for what is connected to it.
    std::unique_ptr<QObject> m_whileFollowed;
    std::vector<Entry> m_entries;
    bool m_canEdit = false;
    /// What is pressed was a tick, and leads nowhere.
    bool m_hasTicked = false;
    /// Runs while the text rests.
    QTimer m_rest;
};

}
