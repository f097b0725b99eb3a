// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "documentstrip.h"

#include <QDialog>
#include <QLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "differenceview.h"
#include "document.h"

namespace romanesco {

DocumentStrip::DocumentStrip(Document &document, QWidget *parent)
    : MessageStrip(Closing::ByProgram, parent)
    , m_document(document)
    , m_reload(addButton(tr("&Reload"), tr("Take the text of the file; undo leads back to this one")))
    , m_keep(addButton(tr("&Keep Mine"), tr("Keep this text; the next save writes it over the file")))
    , m_differences(addButton(tr("Show &Differences"), tr("What differs between the file and this text")))
    , m_editAnyway(addButton(tr("&Edit Anyway"), tr("Whichever window saves last is asked what to keep")))
{
    connect(m_reload, &QPushButton::clicked, &document, &Document::reload);
    connect(m_keep, &QPushButton::clicked, &document, &Document::keepText);
    connect(m_differences, &QPushButton::clicked, this, &DocumentStrip::showDifferences);
    connect(m_editAnyway, &QPushButton::clicked, &document, &Document::editAnyway);
    connect(&document, &Document::fileStateChanged, this, &DocumentStrip::update);
    update();
}

QPushButton *DocumentStrip::addButton(const QString &words, const QString &tip)
{
    auto *button = new QPushButton(words);
    button->setToolTip(tip);
    layout()->addWidget(button);
    return button;
}

void DocumentStrip::update()
{
    using State = Document::FileState;
    const State state = m_document.fileState();
    const bool isChanged = state == State::Changed;
    for (QPushButton *button : {m_reload, m_keep, m_differences}) {
        button->setVisible(isChanged);
    }
    m_editAnyway->setVisible(!isChanged && m_document.isHeldElsewhere());
    const QString name = m_document.name();
    if (isChanged) {
        say(tr("Another program has changed “%1”, and the text here has changes that are not saved.").arg(name));
    } else if (state == State::Removed) {
        say(tr("“%1” is no longer on the disk. The text is still here; saving writes it there again.").arg(name));
    } else if (state == State::Unreadable) {
        say(tr("“%1” can no longer be read: %2. The text is still here.").arg(name, m_document.fileTrouble()));
    } else if (m_document.isHeldElsewhere()) {
        say(tr("“%1” is open in another window, so it can only be read here.").arg(name));
    } else {
        fallSilent();
    }
}

void DocumentStrip::showDifferences()
{
    const auto onDisk = textOf(m_document.bytesOnDisk());
    if (!onDisk) {
        return;
    }
    auto *dialog = new QDialog(window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Differences of “%1”").arg(m_document.name()));
    auto *view = new DifferenceView;
    view->setTexts(*onDisk, m_document.text().bytes());
    (new QVBoxLayout(dialog))->addWidget(view);
    dialog->resize(720, 480);
    dialog->show();
}

}
