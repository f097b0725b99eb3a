// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "messagestrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>

namespace romanesco {

namespace {

const QColor background(0x3b, 0x33, 0x26);
const QColor ink(0xec, 0xdc, 0xb4);

}

MessageStrip::MessageStrip(Closing closing, QWidget *parent)
    : QFrame(parent)
    , m_label(new QLabel)
{
    QPalette colours = palette();
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::ButtonText}) {
        colours.setColor(role, ink);
    }
    colours.setColor(QPalette::Window, background);
    colours.setColor(QPalette::Button, background);
    setPalette(colours);
    setAutoFillBackground(true);

    m_label->setWordWrap(true);
    m_label->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_label, &QLabel::linkActivated, this, &MessageStrip::followed);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 6, 12, 6);
    layout->addWidget(m_label, 1);
    if (closing == Closing::ByUser) {
        auto *button = new QToolButton;
        button->setText(QStringLiteral("✕"));
        button->setAutoRaise(true);
        button->setToolTip(tr("Close this message"));
        button->setAccessibleName(tr("Close this message"));
        connect(button, &QToolButton::clicked, this, [this] {
            const QString said = m_text;
            fallSilent();
            Q_EMIT closed(said);
        });
        layout->addWidget(button, 0, Qt::AlignTop);
    }
    hide();
}

void MessageStrip::say(const QString &text, bool isLink)
{
    m_text = text;
    m_isLink = isLink;
    // Names and messages may hold anything: never taken as markup.
    m_label->setTextFormat(isLink ? Qt::RichText : Qt::PlainText);
    const QString link = QStringLiteral("<a href=\"#\" style=\"text-decoration: none; color: %1\">%2</a>");
    m_label->setText(isLink ? link.arg(ink.name(), text.toHtmlEscaped()) : text);
    setAccessibleName(text);
    setCursor(isLink ? Qt::PointingHandCursor : Qt::ArrowCursor);
    show();
}

void MessageStrip::fallSilent()
{
    m_text.clear();
    hide();
}

void MessageStrip::mouseReleaseEvent(QMouseEvent *event)
{
    if (m_isLink && event->button() == Qt::LeftButton && rect().contains(event->position().toPoint())) {
        Q_EMIT followed();
    }
}

}
