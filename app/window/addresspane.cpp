// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "addresspane.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

namespace romanesco {

namespace {

/// Of a way of very many steps the first and the last.
constexpr std::size_t mostAtAnEnd = 250;

}

AddressPane::AddressPane(QWidget *parent)
    : QWidget(parent)
    , m_hint(new QLabel(tr("Click a copy in the picture to see which words of the text made it.")))
    , m_list(new QListWidget)
    , m_zoom(new QPushButton(tr("&Zoom Into It")))
    , m_collapse(new QPushButton(tr("Co&llapse to Here")))
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 8, 0);
    row->addWidget(m_hint, 1);
    row->addWidget(m_list, 1);
    auto *buttons = new QVBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_zoom);
    buttons->addWidget(m_collapse);
    row->addLayout(buttons);
    m_hint->setWordWrap(true);
    m_hint->setMargin(8);
    m_hint->setAlignment(Qt::AlignTop);
    // What is listed must not make the picture smaller.
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    m_list->setMinimumHeight(1);
    m_list->setAccessibleName(tr("Address of the copy"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setUniformItemSizes(true);
    m_zoom->setToolTip(tr("Lets the copy that stands out fill the view (Z in the picture)"));
    // Clicks, arrow keys and Enter alike.
    connect(m_list, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem *item) {
        if (item && item->data(Qt::UserRole).isValid()) {
            Q_EMIT chosen(item->data(Qt::UserRole).toUInt());
        }
    });
    connect(m_zoom, &QPushButton::clicked, this, &AddressPane::zoomRequested);
    connect(m_collapse, &QPushButton::clicked, this, &AddressPane::collapseRequested);
    setSteps({});
    setCollapse(std::nullopt);
}

void AddressPane::setCollapse(std::optional<quint64> depth)
{
    m_collapse->setEnabled(depth.has_value());
    m_collapse->setToolTip(
        depth ? tr("Changes the depth in the text to %1, so that the chosen step is the last (C in the picture)")
                    .arg(*depth)
              : tr("Changes the depth in the text, so that the chosen step is the last (C in the picture)"));
}

void AddressPane::setSteps(const std::vector<AddressStep> &steps)
{
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (i == mostAtAnEnd && steps.size() > 2 * mostAtAnEnd + 1) {
            i = steps.size() - mostAtAnEnd - 1;
            m_list->addItem(QStringLiteral("…"));
            continue;
        }
        auto *item = new QListWidgetItem(steps[i].words, m_list);
        if (steps[i].use) {
            item->setData(Qt::UserRole, static_cast<uint>(i + 1));
        }
    }
    m_list->setCurrentRow(m_list->count() - 1);
    m_list->scrollToBottom();
    m_hint->setVisible(steps.empty());
    m_list->setVisible(!steps.empty());
    m_zoom->setEnabled(!steps.empty());
}

}
