// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

class QMainWindow;
class QSplitter;

namespace romanesco {

class Panels;

/// Where the parts of the window are, which is kept from one start to the next.
class WindowLayout
{
public:
    /// All must outlive it.
    WindowLayout(QMainWindow &window, QSplitter &splitter, Panels &panels);

    /// As it was saved last.
    void restore();
    /// As at the first start; the window stays as large as it is.
    void reset();
    void save() const;

private:
    QMainWindow &m_window;
    QSplitter &m_splitter;
    Panels &m_panels;
};

}
