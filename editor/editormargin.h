// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QWidget>

namespace romanesco {

class FdoEditor;

/// The strip left of the text: line numbers, a bar beside each line that has a problem, and a mark at each section that
/// can be folded. A click on the mark folds and unfolds it, elsewhere it puts the cursor into the line.
class EditorMargin : public QWidget
{
    Q_OBJECT
public:
    explicit EditorMargin(FdoEditor &editor);

    /// Wide enough for the number of the last line.
    [[nodiscard]] QSize sizeHint() const override;

protected:
    bool event(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    [[nodiscard]] int lineAt(int y) const;
    [[nodiscard]] int foldWidth() const;
    [[nodiscard]] bool isFoldMark(const QPoint &point) const;
    void paintFoldMark(QPainter &painter, int top, int height, bool isFolded) const;

    FdoEditor &m_editor;
};

}
