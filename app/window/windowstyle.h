// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QHash>
#include <QIcon>
#include <QProxyStyle>

namespace romanesco {

/// The system's style, which is asked only once for the icons of title bars: docks ask for theirs some dozen times while
/// they are laid out, and Qt's styles look in all folders of the icon theme each time.
class WindowStyle : public QProxyStyle
{
    Q_OBJECT
public:
    using QProxyStyle::polish;
    using QProxyStyle::QProxyStyle;

    [[nodiscard]] QIcon standardIcon(StandardPixmap icon, const QStyleOption *option,
                                     const QWidget *widget) const override;
    /// Other colours may have other icons.
    void polish(QPalette &palette) override;

private:
    mutable QHash<StandardPixmap, QIcon> m_icons;
};

}
