// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "messagestrip.h"

class QPushButton;

namespace romanesco {

class Document;

/// Says above a document what has become of its file, and offers what can be done about it. Hidden while all is well.
class DocumentStrip : public MessageStrip
{
    Q_OBJECT
public:
    /// document must outlive it.
    explicit DocumentStrip(Document &document, QWidget *parent = nullptr);

private:
    QPushButton *addButton(const QString &words, const QString &tip);
    void update();
    void showDifferences();

    Document &m_document;
    QPushButton *m_reload;
    QPushButton *m_keep;
    QPushButton *m_differences;
    QPushButton *m_editAnyway;
};

}
