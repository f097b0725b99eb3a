// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QDialog>

#include "recovery.h"

class QLabel;
class QListWidget;

namespace romanesco {

class DifferenceView;

/// Offers the texts that were found: which file, when, and what differs from what is on the disk. Closed, it leaves what was
/// not decided for the next time.
class RecoveryDialog : public QDialog
{
    Q_OBJECT
public:
    /// There is a text to offer.
    explicit RecoveryDialog(Recovery recovery, QWidget *parent = nullptr);

Q_SIGNALS:
    /// Whoever restores it has put it into a document, and into a journal, when it returns true: then what was found is
    /// removed.
    void restoreRequested(const romanesco::LostText &text, bool *isRestored);

private:
    void showText(int row);
    void restore();
    void discard();
    void dropCurrent();

    Recovery m_recovery;
    QListWidget *m_list;
    QLabel *m_words;
    DifferenceView *m_differences;
};

}
