// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "aboutbox.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace romanesco {

namespace {

QString tr(const char *words)
{
    return QCoreApplication::translate("romanesco::AboutBox", words);
}

}

void showAbout(QWidget &window, const QString &graphics)
{
    const QString system = graphics.isEmpty() ? tr("no OpenGL") : graphics;
    auto *box = new QMessageBox(QMessageBox::NoIcon, tr("About Romanesco"),
                                tr("Romanesco %1\n\nAn editor for fractals.\n\nQt %2\n%3")
                                    .arg(QCoreApplication::applicationVersion(), QLatin1String(qVersion()), system),
                                QMessageBox::Close, &window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}
