// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string_view>

#include <QPlainTextEdit>

namespace romanesco {

/// What differs between two texts, line by line: those that went, in red after "−", and those that came, in green after "+",
/// with a few lines round them. To look at.
class DifferenceView : public QPlainTextEdit
{
    Q_OBJECT
public:
    explicit DifferenceView(QWidget *parent = nullptr);

    /// LF between the lines. Of very many lines, and of very long ones, the first part is shown, and it is said that there
    /// is more.
    void setTexts(std::string_view before, std::string_view after);
};

}
