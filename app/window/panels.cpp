// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "panels.h"

#include <algorithm>

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>

#include "addresspane.h"
#include "measurepane.h"
#include "outlinepane.h"
#include "parameterspane.h"
#include "physicspane.h"
#include "previewcontroller.h"
#include "problemsview.h"

namespace romanesco {

Panels::Panels(QMainWindow &window)
    : m_window(window)
    , m_problems(new ProblemsView)
    , m_parameters(new ParametersPane)
    , m_physics(new PhysicsPane)
    , m_measure(new MeasurePane)
    , m_address(new AddressPane)
    , m_outline(new OutlinePane)
    , m_problemsDock(add(m_problems, tr("Problems"), QStringLiteral("problems")))
{
    add(m_parameters, tr("Parameters"), QStringLiteral("parameters"));
    add(m_physics, tr("Physics"), QStringLiteral("physics"));
    m_measureDock = add(m_measure, tr("Measure"), QStringLiteral("measure"));
    add(m_address, tr("Address"), QStringLiteral("address"));
    add(m_outline, tr("Outline"), QStringLiteral("outline"));
    layOut();
}

QDockWidget *Panels::add(QWidget *panel, const QString &title, const QString &name)
{
    auto *dock = new QDockWidget(title, &m_window);
    dock->setObjectName(name);
    dock->setWidget(panel);
    m_docks << dock;
    return dock;
}

void Panels::fill(QMenu &window) const
{
    for (QDockWidget *dock : m_docks) {
        QAction *action = window.addAction(dock->windowTitle());
        action->setCheckable(true);
        // of one that is behind another too, which is there, but nobody sees it
        QObject::connect(dock, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
        QObject::connect(action, &QAction::triggered, dock,
                         [this, dock](bool isWanted) { isWanted ? open(*dock) : dock->hide(); });
    }
}

void Panels::open(QDockWidget &dock) const
{
    dock.show();
    dock.raise();
    // a plot needs more room than a list
    const int wanted = dock.widget()->sizeHint().height();
    if (&dock == m_measureDock && !dock.isFloating() && dock.widget()->height() < wanted) {
        m_window.resizeDocks({&dock}, {wanted}, Qt::Vertical);
    }
}

void Panels::layOut()
{
    for (QDockWidget *dock : m_docks) {
        dock->setFloating(false);
        m_window.addDockWidget(Qt::BottomDockWidgetArea, dock);
        dock->setVisible(dock != m_measureDock);
        if (dock != m_problemsDock) {
            m_window.tabifyDockWidget(m_problemsDock, dock);
        }
    }
    m_problemsDock->raise();
    m_window.resizeDocks({m_problemsDock}, {170}, Qt::Vertical);
}

void Panels::goToNext(QList<QWidget *> parts, int step) const
{
    for (const QDockWidget *dock : m_docks) {
        if (!dock->visibleRegion().isEmpty()) { // behind another one it is hidden in all but name
            parts << dock->widget();
        }
    }
    const QWidget *now = QApplication::focusWidget();
    const auto has = [now](const QWidget *part) { return part == now || part->isAncestorOf(now); };
    const auto count = parts.size();
    const auto place = std::ranges::find_if(parts, has) - parts.begin();
    QWidget *next = parts[place == count ? 0 : (place + step + count) % count];
    while (next->focusPolicy() == Qt::NoFocus && next->nextInFocusChain()
           && next->isAncestorOf(next->nextInFocusChain())) {
        next = next->nextInFocusChain();
    }
    next->setFocus(Qt::TabFocusReason);
}

void Panels::showProblems(const QString &file, const Preview &preview)
{
    m_problems->setDiagnostics(file, preview.diagnostics, preview.text);
    const QString counts = m_problems->counts();
    m_problemsDock->setWindowTitle(counts.isEmpty() ? tr("Problems") : tr("Problems — %1").arg(counts));
}

}
