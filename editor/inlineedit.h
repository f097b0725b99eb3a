// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>

#include <QFrame>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace romanesco {

/// A small line to type into, over an editor's text: for a new name, or a line's number. Enter takes what is typed; while
/// it will not do, the reason stands below and Enter does nothing. Esc, a click elsewhere or another text close it.
class InlineEdit : public QFrame
{
    Q_OBJECT
public:
    struct Question {
        /// For people who do not see it.
        QString title;
        QString text;
        /// Why the words will not do; empty where they will.
        std::function<QString(const QString &)> check;
        std::function<void(const QString &)> take;
    };

    /// Opens one at a position of the text, all of its words selected. It deletes itself.
    static InlineEdit *open(QPlainTextEdit &editor, int position, Question question);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    InlineEdit(QPlainTextEdit &editor, int position, Question question);
    void check();
    void take();
    void leave();
    void place();

    QPlainTextEdit &m_editor;
    int m_position;
    Question m_question;
    QLineEdit *m_line;
    QLabel *m_reason;
};

}
