// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include <QTreeWidget>

#include "core/text/diagnostic.h"
#include "editor/textsnapshot.h"

namespace romanesco {

/// The list of all that is said about a text: where, and what.
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

private:
    TextSnapshot m_text;
    Diagnostics m_diagnostics;
};

}
