// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QWidget>

namespace romanesco {

class PointerTool;
class Viewport;

/// What a tool draws over the whole picture of a viewport. The mouse goes through it, and no saved picture holds it.
class ToolOverlay : public QWidget
{
    Q_OBJECT
public:
    /// A child of the viewport.
    explicit ToolOverlay(Viewport &viewport);

    /// Null for none. It must live as long as it is shown.
    void show(const PointerTool *tool);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    const PointerTool *m_tool = nullptr;
};

}
