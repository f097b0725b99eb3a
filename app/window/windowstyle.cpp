// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "windowstyle.h"

namespace romanesco {

QIcon WindowStyle::standardIcon(StandardPixmap icon, const QStyleOption *option, const QWidget *widget) const
{
    if (icon != SP_TitleBarNormalButton && icon != SP_TitleBarCloseButton) {
        return QProxyStyle::standardIcon(icon, option, widget);
    }
    auto known = m_icons.constFind(icon);
    if (known == m_icons.constEnd()) {
        known = m_icons.insert(icon, QProxyStyle::standardIcon(icon, option, widget));
    }
    return *known;
}

void WindowStyle::polish(QPalette &palette)
{
    m_icons.clear();
    QProxyStyle::polish(palette);
}

}
