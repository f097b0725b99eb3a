// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QScrollArea>

namespace romanesco {

class MeasureView;

/// The panel of what is measured. It is empty until it is looked at for the first time.
class MeasurePane : public QScrollArea
{
    Q_OBJECT
public:
    explicit MeasurePane(QWidget *parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override { return {320, 300}; }

Q_SIGNALS:
    /// Once.
    void opened(romanesco::MeasureView &view);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void turn();

    /// Null until then.
    MeasureView *m_view = nullptr;
};

}
