// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QWidget>

#include "textsearch.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace romanesco {

class FdoEditor;

/// Find and replace, in a bar below the text: all matches are marked while it is open, Enter goes to the next, Shift+Enter
/// to the one before, Esc closes. Opened with a selection it looks for that.
class FindBar : public QWidget
{
    Q_OBJECT
public:
    /// Hidden at first. editor must outlive it.
    explicit FindBar(FdoEditor &editor, QWidget *parent = nullptr);

public Q_SLOTS:
    void openFind();
    void openReplace();
    /// From the cursor on, and from the end on again from the start. Opens the bar where it is closed.
    void findNext();
    void findPrevious();
    /// The match that is selected; then goes to the next. Where none is selected, it only goes there.
    void replaceOne();
    /// One undo step.
    void replaceAll();

protected:
    void changeEvent(QEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    enum class Way { FromHere, Forward, Backward };

    void layOut();
    void connectParts();
    [[nodiscard]] QToolButton *option(const QString &sign, const QString &name);
    void open(bool hasReplacement);
    void startSearch();
    void go(Way way);
    void goIfFound();
    [[nodiscard]] std::optional<TextStretch> wanted() const;
    void select(TextStretch match);
    void showState();

    FdoEditor &m_editor;
    TextSearch m_search;
    QLineEdit *m_words;
    QLineEdit *m_replacement;
    QWidget *m_replacing;
    QToolButton *m_case;
    QToolButton *m_whole;
    QToolButton *m_expression;
    QPushButton *m_replaceOne;
    QPushButton *m_replaceAll;
    QLabel *m_count;
    QLabel *m_remark;
    /// What replaceAll() has done last, told until the text is another or the user goes on.
    struct Replaced {
        int count;
        int revision;
    };
    std::optional<Replaced> m_replaced;
    /// Where to go as soon as it is found.
    std::optional<Way> m_way;
    /// Where the search began, which what is typed is looked for from.
    int m_origin = 0;
};

}
