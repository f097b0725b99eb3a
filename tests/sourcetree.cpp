// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sourcetree.h"

QString romanesco::test::sourcePath(const char *fromTop)
{
    return QStringLiteral(ROMANESCO_SOURCE_DIR "/") + QString::fromUtf8(fromTop);
}
