// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "statusline.h"

#include <QLabel>
#include <QLocale>

#include "countwords.h"

namespace romanesco {

namespace {

QLabel *makeLabel(const QString &accessibleName)
{
    auto *label = new QLabel;
    label->setAccessibleName(accessibleName);
    label->setTextFormat(Qt::PlainText);
    label->setContentsMargins(4, 0, 12, 0);
    return label;
}

}

StatusLine::StatusLine(QWidget *parent)
    : QStatusBar(parent)
    , m_place(makeLabel(tr("Cursor")))
    , m_summary(makeLabel(tr("The fractal as written")))
    , m_depth(makeLabel(tr("Depth")))
    , m_collider(makeLabel(tr("Collider")))
    , m_drawn(makeLabel(tr("Drawn")))
{
    // Long numbers must not hold the window open.
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWidget(m_place);
    addWidget(m_summary, 1);
    addPermanentWidget(m_depth);
    addPermanentWidget(m_collider);
    addPermanentWidget(m_drawn);
    m_collider->hide();
}

void StatusLine::setCursorPlace(int line, int column)
{
    m_place->setText(tr("Ln %1, Col %2").arg(line).arg(column));
}

void StatusLine::setSummary(const std::optional<Summary> &summary)
{
    const QString text = summary ? summaryText(*summary) : QString();
    m_summary->setText(text);
    m_summary->setToolTip(text);
}

void StatusLine::setDepth(std::optional<quint64> depth)
{
    m_depth->setText(depth ? tr("depth %1").arg(QLocale().toString(*depth)) : QString());
}

void StatusLine::setCollider(const QString &words)
{
    m_collider->setText(words);
    m_collider->setVisible(!words.isEmpty());
}

void StatusLine::setDrawn(const DrawStatistics &statistics, double pixelTolerance)
{
    const QLocale locale;
    m_drawn->setText(tr("%1 drawn · %2 ms · tolerance %3 px")
                         .arg(locale.toString(static_cast<qulonglong>(statistics.instances)),
                              locale.toString(statistics.milliseconds, 'f', statistics.milliseconds < 10 ? 1 : 0),
                              locale.toString(pixelTolerance, 'g', 2)));
    m_drawn->setToolTip(tr("Copies drawn, the time of one pass over the scene, and the size on the screen below which "
                           "copies are drawn as one"));
}

void StatusLine::clearDrawn()
{
    m_drawn->clear();
}

}
