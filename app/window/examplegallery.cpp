// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "examplegallery.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QIcon>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "broughttexts.h"
#include "texttabs.h"

namespace romanesco {

namespace {

/// As packaging/thumbnails draws them.
constexpr QSize thumbnailSize(192, 144);
constexpr QSize space(16, 32);

constexpr int pathRole = Qt::UserRole;
constexpr int descriptionRole = Qt::UserRole + 1;

QIcon thumbnailOf(const QString &path)
{
    return QIcon(TextTabs::examplesFolder + QStringLiteral("/thumbnails/") + QFileInfo(path).fileName()
                 + QStringLiteral(".png"));
}

}

ExampleGallery::ExampleGallery(QWidget *parent)
    : QDialog(parent)
    , m_list(new QListWidget)
    , m_description(new QLabel)
{
    setWindowTitle(tr("Examples"));
    m_list->setAccessibleName(tr("Examples"));
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setUniformItemSizes(true);
    m_list->setIconSize(thumbnailSize);
    m_list->setGridSize(thumbnailSize + space);
    m_list->setFrameShape(QFrame::NoFrame);
    for (const BroughtText &text : broughtTexts(TextTabs::examplesFolder)) {
        auto *item = new QListWidgetItem(thumbnailOf(text.path), text.name, m_list);
        item->setData(pathRole, text.path);
        item->setData(descriptionRole, text.description);
        item->setData(Qt::AccessibleDescriptionRole, text.description);
        item->setToolTip(text.description);
    }
    m_description->setWordWrap(true);
    m_description->setTextFormat(Qt::PlainText);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_list, 1);
    column->addWidget(m_description);
    column->addWidget(buttons);
    resize(3 * m_list->gridSize().width() + 64, 2 * m_list->gridSize().height() + 160);

    connect(m_list, &QListWidget::currentItemChanged, this, &ExampleGallery::describe);
    // The button takes Enter, and a double click is the list's own.
    connect(m_list, &QListWidget::itemDoubleClicked, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this, [this] {
        if (const QListWidgetItem *item = m_list->currentItem()) {
            Q_EMIT chosen(item->data(pathRole).toString());
        }
    });
    m_list->setCurrentRow(0);
    m_list->setFocus();
}

void ExampleGallery::describe()
{
    const QListWidgetItem *item = m_list->currentItem();
    m_description->setText(item ? item->data(descriptionRole).toString() : QString());
}

}
