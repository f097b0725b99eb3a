// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "windowlayout.h"

#include <QLayout>
#include <QMainWindow>
#include <QSplitter>
#include <QToolBar>

#include "panels.h"
#include "windowstate.h"

namespace romanesco {

WindowLayout::WindowLayout(QMainWindow &window, QSplitter &splitter, Panels &panels)
    : m_window(window)
    , m_splitter(splitter)
    , m_panels(panels)
{
}

void WindowLayout::restore()
{
    const WindowState state;
    if (!m_window.restoreGeometry(state.value("geometry").toByteArray())) {
        m_window.resize(1280, 800);
        m_panels.layOut(); // of the height that there is now
    }
    m_window.restoreState(state.value("docks").toByteArray());
    if (!m_splitter.restoreState(state.value("splitter").toByteArray())) {
        m_splitter.setSizes({500, 780});
    }
}

void WindowLayout::reset()
{
    for (QToolBar *bar : m_window.findChildren<QToolBar *>()) {
        bar->show();
    }
    m_panels.layOut();
    m_window.layout()->activate(); // what the docks leave is the splitter's
    m_splitter.setSizes({500, 780});
}

void WindowLayout::save() const
{
    WindowState state;
    state.setValue("geometry", m_window.saveGeometry());
    state.setValue("docks", m_window.saveState());
    state.setValue("splitter", m_splitter.saveState());
}

}
