// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "problemsview.h"

#include <algorithm>
#include <array>
#include <span>

#include <QFontDatabase>
#include <QPainter>

#include "core/text/linemap.h"
#include "core/text/places.h"
#include "editor/fdoeditor.h"

namespace romanesco {

namespace {

enum Column { Place, Message };
constexpr int columnGap = 24;
/// More than anybody reads; a file of another kind may have one on every line.
constexpr std::size_t mostRows = 1'000;

QIcon makeDot(Severity severity)
{
    constexpr int side = 64;
    QPixmap picture(side, side);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(severityColour(severity));
    painter.drawEllipse(QRectF(side / 4.0, side / 4.0, side / 2.0, side / 2.0));
    return QIcon(picture);
}

QIcon dot(Severity severity)
{
    static const std::array dots{makeDot(Severity::Error), makeDot(Severity::Warning), makeDot(Severity::Hint)};
    return dots[static_cast<std::size_t>(severity)];
}

QString severityWord(Severity severity)
{
    switch (severity) {
    case Severity::Error:
        return ProblemsView::tr("Error");
    case Severity::Warning:
        return ProblemsView::tr("Warning");
    case Severity::Hint:
        break;
    }
    return ProblemsView::tr("Hint");
}

}

ProblemsView::ProblemsView(QWidget *parent)
    : QTreeWidget(parent)
{
    setAccessibleName(tr("Problems"));
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(NoFrame);
    setColumnCount(2);
    setItemsExpandable(false);
    connect(this, &QTreeWidget::itemClicked, this, &ProblemsView::choose);
    connect(this, &QTreeWidget::itemActivated, this, &ProblemsView::choose);
}

void ProblemsView::choose(QTreeWidgetItem *item)
{
    if (item->flags() == Qt::NoItemFlags) {
        return;
    }
    QTreeWidgetItem *parent = item->parent();
    const Diagnostic &diagnostic = m_diagnostics[static_cast<std::size_t>(indexOfTopLevelItem(parent ? parent : item))];
    if (!parent) {
        Q_EMIT chosen(diagnostic.range, m_text);
        return;
    }
    const Note &note = diagnostic.notes[static_cast<std::size_t>(parent->indexOfChild(item))];
    if (note.file.empty()) {
        Q_EMIT chosen(note.range, m_text);
    } else {
        Q_EMIT chosenElsewhere(QString::fromStdString(note.file), note.position);
    }
}

void ProblemsView::setDiagnostics(const QString &file, const Diagnostics &diagnostics, const TextSnapshot &text)
{
    m_text = text;
    m_diagnostics = diagnostics;
    clear();
    const LineMap lines(text.bytes());
    Places places(lines);
    const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    for (const Diagnostic &diagnostic : std::span(diagnostics).first(std::min(diagnostics.size(), mostRows))) {
        const TextPosition at = places.at(diagnostic.range.begin);
        const QString message = QString::fromStdString(diagnostic.message());
        const QString word = severityWord(diagnostic.severity());
        auto *item = new QTreeWidgetItem(this);
        item->setIcon(Place, dot(diagnostic.severity()));
        item->setText(Place, QStringLiteral("%1:%2:%3").arg(file).arg(at.line).arg(at.column));
        item->setFont(Place, fixed);
        item->setToolTip(Place, word);
        item->setText(Message, message);
        item->setToolTip(Message, message);
        item->setData(Message, Qt::AccessibleTextRole, tr("%1: %2", "severity: message").arg(word, message));
        addNotes(file, diagnostic, *item);
    }
    expandAll();
    if (diagnostics.size() > mostRows) {
        auto *rest = new QTreeWidgetItem(this);
        rest->setText(Message, tr("and %1 more").arg(diagnostics.size() - mostRows));
        rest->setFlags(Qt::NoItemFlags);
    }
    resizeColumnToContents(Place);
    setColumnWidth(Place, columnWidth(Place) + columnGap);
}

void ProblemsView::addNotes(const QString &file, const Diagnostic &diagnostic, QTreeWidgetItem &parent)
{
    for (const Note &note : diagnostic.notes) {
        const QString where = note.file.empty() ? file : QString::fromStdString(note.file);
        const QString message = QString::fromStdString(note.message());
        auto *item = new QTreeWidgetItem(&parent);
        item->setText(Place, QStringLiteral("%1:%2:%3").arg(where).arg(note.position.line).arg(note.position.column));
        item->setFont(Place, parent.font(Place));
        item->setText(Message, message);
        item->setToolTip(Message, message);
        item->setData(Message, Qt::AccessibleTextRole, tr("Note: %1").arg(message));
    }
}

void ProblemsView::paintEvent(QPaintEvent *event)
{
    QTreeWidget::paintEvent(event);
    if (topLevelItemCount() == 0) {
        QPainter painter(viewport());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(viewport()->rect().adjusted(12, 8, -12, -8), Qt::AlignTop | Qt::AlignLeft, tr("No problems"));
    }
}

QString ProblemsView::counts() const
{
    const auto count = [this](Severity severity) {
        return static_cast<int>(std::ranges::count(m_diagnostics, severity, &Diagnostic::severity));
    };
    QStringList parts;
    if (const int errors = count(Severity::Error); errors > 0) {
        parts += errors == 1 ? tr("1 error") : tr("%1 errors").arg(errors);
    }
    if (const int warnings = count(Severity::Warning); warnings > 0) {
        parts += warnings == 1 ? tr("1 warning") : tr("%1 warnings").arg(warnings);
    }
    if (const int hints = count(Severity::Hint); hints > 0) {
        parts += hints == 1 ? tr("1 hint") : tr("%1 hints").arg(hints);
    }
    return parts.join(QStringLiteral(", "));
}

}
