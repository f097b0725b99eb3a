// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "messagestrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>

namespace romanesco {

namespace {

struct Colours {
    QColor background;
    QColor ink;
};

/// Of notes, quiet and warm, on light and on dark.
Colours coloursFor(const QPalette &palette)
{
    const bool isDark = palette.color(QPalette::Base).lightness() < 128;
    return isDark ? Colours{QColor(0x3b, 0x33, 0x26), QColor(0xec, 0xdc, 0xb4)}
                  : Colours{QColor(0xfa, 0xef, 0xcf), QColor(0x54, 0x41, 0x12)};
}

}

MessageStrip::MessageStrip(Closing closing, QWidget *parent)
    : QFrame(parent)
    , m_label(new QLabel)
{
    colour();
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

void MessageStrip::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        colour();
        showText();
    }
}

void MessageStrip::colour()
{
    const auto [background, ink] = coloursFor(palette());
    if (palette().color(QPalette::Window) == background) {
        return; // what changed is this
    }
    QPalette colours;
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::ButtonText}) {
        colours.setColor(role, ink);
    }
    colours.setColor(QPalette::Window, background);
    colours.setColor(QPalette::Button, background);
    setPalette(colours);
}

void MessageStrip::say(const QString &text, bool isLink)
{
    m_text = text;
    m_isLink = isLink;
    showText();
    setAccessibleName(text);
    setCursor(isLink ? Qt::PointingHandCursor : Qt::ArrowCursor);
    show();
}

void MessageStrip::showText()
{
    // Names and messages may hold anything: never taken as markup.
    m_label->setTextFormat(m_isLink ? Qt::RichText : Qt::PlainText);
    const QString link = QStringLiteral("<a href=\"#\" style=\"text-decoration: none; color: %1\">%2</a>");
    m_label->setText(m_isLink ? link.arg(coloursFor(palette()).ink.name(), m_text.toHtmlEscaped()) : m_text);
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
