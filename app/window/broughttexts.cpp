// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "broughttexts.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

namespace romanesco {

QList<BroughtText> broughtTexts(const QString &folder)
{
    QList<BroughtText> texts;
    const QStringList kinds{QStringLiteral("*.fdo"), QStringLiteral("*.sdo")};
    for (const QFileInfo &info : QDir(folder).entryInfoList(kinds, QDir::Files, QDir::Name)) {
        QFile file(info.filePath());
        const QString first = file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readLine()).trimmed() : QString();
        const QString plain = info.completeBaseName();
        texts << BroughtText{info.filePath(),
                             info.suffix() == QLatin1String("sdo")
                                 ? QCoreApplication::translate("BroughtTexts", "%1 (scene)").arg(plain)
                                 : plain,
                             first.startsWith(u'#') ? first.sliced(1).trimmed() : QString()};
    }
    return texts;
}

}
