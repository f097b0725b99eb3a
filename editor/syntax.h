// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <KSyntaxHighlighting/Definition>
#include <KSyntaxHighlighting/Theme>

class QPalette;
class QString;

namespace romanesco {

/// KSyntaxHighlighting's definitions and themes, read once for all editors. Our own definitions come from the resources
/// under :/org.kde.syntax-highlighting/syntax-addons. For the GUI thread.

/// Reads them, so that the first editor need not: from any thread. Some ten milliseconds.
void readSyntaxes();

/// By the ending of a file's name; not valid where nothing is known of it.
[[nodiscard]] KSyntaxHighlighting::Definition syntaxFor(const QString &fileName);

/// A light or a dark theme, as the palette is.
[[nodiscard]] KSyntaxHighlighting::Theme themeFor(const QPalette &palette);

}
