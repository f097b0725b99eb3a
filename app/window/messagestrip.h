// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace romanesco {

/// One sentence above what it is about, instead of a box that stops everything. Hidden while it has nothing to say.
class MessageStrip : public QFrame
{
    Q_OBJECT
public:
    enum class Closing { ByUser, ByProgram };
    explicit MessageStrip(Closing closing, QWidget *parent = nullptr);

    /// Shows a text; one that leads somewhere is a link, and a click anywhere on the strip follows it.
    void say(const QString &text, bool isLink = false);
    void fallSilent();

    /// Empty while silent.
    [[nodiscard]] const QString &text() const { return m_text; }

Q_SIGNALS:
    void followed();
    /// By the user.
    void closed(const QString &text);

protected:
    void changeEvent(QEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    void colour();
    void showText();

    QString m_text;
    bool m_isLink = false;
    QLabel *m_label;
};

}
