// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QWidget>

class QLabel;
class QStackedLayout;
class QToolBar;

namespace romanesco {

class AxesTripod;
class MessageStrip;
class QualityControl;
class Viewport;

/// The viewport with its axes, with a bar of tools under it, and with a strip over its upper edge for what is to be said of the picture. The strip lies
/// above the picture, so that it comes and goes without a new picture. Where pictures are impossible there is a text instead.
class ViewportPane : public QWidget
{
    Q_OBJECT
public:
    explicit ViewportPane(QWidget *parent = nullptr);

    [[nodiscard]] Viewport &viewport() const { return *m_viewport; }
    [[nodiscard]] AxesTripod &axes() const { return *m_axes; }
    [[nodiscard]] QualityControl &quality() const { return *m_quality; }
    [[nodiscard]] MessageStrip &strip() const { return *m_strip; }

    /// Buttons for the bar under the picture.
    void addTools(const QList<QAction *> &tools);

protected:
    bool event(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void placeStrip();
    void showReason(const QString &reason);
    void showPicture();

    Viewport *m_viewport;
    AxesTripod *m_axes;
    QLabel *m_reason;
    QStackedLayout *m_layout;
    MessageStrip *m_strip;
    QToolBar *m_bar;
    /// Tools stand before it.
    QAction *m_firstRight;
    QualityControl *m_quality;
};

}
