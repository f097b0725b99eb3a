// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "syntax.h"

#include <KSyntaxHighlighting/Repository>
#include <QPalette>
#include <QString>

namespace romanesco {

namespace {

KSyntaxHighlighting::Repository &repository()
{
    static KSyntaxHighlighting::Repository all;
    return all;
}

}

void readSyntaxes()
{
    repository();
}

KSyntaxHighlighting::Definition syntaxFor(const QString &fileName)
{
    return repository().definitionForFileName(fileName);
}

KSyntaxHighlighting::Theme themeFor(const QPalette &palette)
{
    // Not themeForPalette(): it takes any theme whose background is the palette's, and some of those are loud.
    const bool isDark = palette.color(QPalette::Base).lightness() < 128;
    using Repository = KSyntaxHighlighting::Repository;
    return repository().defaultTheme(isDark ? Repository::DarkTheme : Repository::LightTheme);
}

}
