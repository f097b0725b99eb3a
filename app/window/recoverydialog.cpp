// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "recoverydialog.h"

#include <utility>

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "differenceview.h"

namespace romanesco {

namespace {

QString nameOf(const LostText &text)
{
    return text.path.isEmpty() ? RecoveryDialog::tr("untitled.fdo") : QFileInfo(text.path).fileName();
}

QString wordsFor(const LostText &text)
{
    const QString when = QLocale().toString(text.time, QLocale::ShortFormat);
    if (text.path.isEmpty()) {
        return RecoveryDialog::tr("A text without a file was being edited at %1 and was not saved.").arg(when);
    }
    const QString words = RecoveryDialog::tr("“%1” was being edited at %2 and was not saved.").arg(text.path, when);
    switch (text.disk) {
    case LostText::Disk::Same:
        return words + u' ' + RecoveryDialog::tr("This is what differs from the file:");
    case LostText::Disk::Changed:
        return words + u' '
            + RecoveryDialog::tr(
                   "Another program has changed the file since. Restoring keeps both: the file stays as it "
                   "is until you save, and undo leads to its text. This is what differs from it:");
    case LostText::Disk::Gone:
        break;
    }
    return words + u' ' + RecoveryDialog::tr("The file can no longer be read. This is the text:");
}

}

RecoveryDialog::RecoveryDialog(Recovery recovery, QWidget *parent)
    : QDialog(parent)
    , m_recovery(std::move(recovery))
    , m_list(new QListWidget)
    , m_words(new QLabel)
    , m_differences(new DifferenceView)
{
    setWindowTitle(tr("Unsaved Texts"));
    m_words->setTextFormat(Qt::PlainText); // names may hold anything
    m_words->setWordWrap(true);
    m_list->setAccessibleName(tr("Texts that were not saved"));
    m_list->setMaximumHeight(m_list->fontMetrics().height() * 6);
    for (const LostText &text : m_recovery.texts()) {
        auto *item = new QListWidgetItem(nameOf(text), m_list);
        item->setToolTip(text.path);
    }
    m_list->setVisible(m_list->count() > 1);

    auto *buttons = new QDialogButtonBox;
    auto *restoreButton = buttons->addButton(tr("&Restore"), QDialogButtonBox::ActionRole);
    auto *discardButton = buttons->addButton(tr("&Discard"), QDialogButtonBox::DestructiveRole);
    auto *laterButton = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    restoreButton->setDefault(true);
    restoreButton->setToolTip(tr("Open the text as it was typed, not yet saved"));
    discardButton->setToolTip(tr("Remove what was typed for ever"));
    laterButton->setToolTip(tr("Ask again when the program starts the next time (Esc)"));
    connect(restoreButton, &QPushButton::clicked, this, &RecoveryDialog::restore);
    connect(discardButton, &QPushButton::clicked, this, &RecoveryDialog::discard);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QListWidget::currentRowChanged, this, &RecoveryDialog::showText);

    auto *column = new QVBoxLayout(this);
    column->addWidget(m_list);
    column->addWidget(m_words);
    column->addWidget(m_differences, 1);
    column->addWidget(buttons);
    resize(720, 480);
    m_list->setCurrentRow(0);
}

void RecoveryDialog::showText(int row)
{
    if (row < 0) {
        return;
    }
    const LostText &text = m_recovery.texts()[static_cast<std::size_t>(row)];
    m_words->setText(wordsFor(text));
    m_differences->setTexts(text.onDisk, text.text);
}

void RecoveryDialog::restore()
{
    const LostText &text = m_recovery.texts()[static_cast<std::size_t>(m_list->currentRow())];
    bool isRestored = false;
    Q_EMIT restoreRequested(text, &isRestored);
    if (isRestored) {
        dropCurrent();
    }
}

void RecoveryDialog::discard()
{
    dropCurrent();
}

void RecoveryDialog::dropCurrent()
{
    const int row = m_list->currentRow();
    m_recovery.drop(LostText(m_recovery.texts()[static_cast<std::size_t>(row)]));
    if (m_recovery.texts().empty()) {
        accept();
        return;
    }
    const QSignalBlocker blocker(m_list);
    delete m_list->takeItem(row);
    m_list->setCurrentRow(0);
    showText(0);
}

}
