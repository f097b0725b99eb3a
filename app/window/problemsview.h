// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include <QTreeWidget>

#include "core/text/diagnostic.h"
#include "editor/textsnapshot.h"

namespace romanesco {

/// The list of all that is said about a text: where, and what. The other places that a problem is about stand below it.
class ProblemsView : public QTreeWidget
{
    Q_OBJECT
public:
    explicit ProblemsView(QWidget *parent = nullptr);

    /// Diagnostics of that text, sorted by place; file is the name to show.
    void setDiagnostics(const QString &file, const Diagnostics &diagnostics, const TextSnapshot &text);

    /// "1 error, 2 warnings"; empty where there is nothing to count.
    [[nodiscard]] QString counts() const;

protected:
    void paintEvent(QPaintEvent *event) override;

Q_SIGNALS:
    /// The user wants to see a range of the text.
    void chosen(romanesco::SourceRange range, const romanesco::TextSnapshot &text);
    /// The user wants to see a place in another file, which is named as in the text.
    void chosenElsewhere(const QString &file, romanesco::TextPosition position);

private:
    void choose(QTreeWidgetItem *item);
    void addNotes(const QString &file, const Diagnostic &diagnostic, QTreeWidgetItem &parent);

    TextSnapshot m_text;
    Diagnostics m_diagnostics;
};

}
