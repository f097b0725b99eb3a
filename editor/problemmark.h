// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QTextEdit>

#include "core/text/diagnostic.h"

namespace romanesco {

/// Red for errors, amber for warnings, grey for hints: readable on light and on dark.
[[nodiscard]] QColor severityColour(Severity severity);

/// A stretch that can be underlined: a problem without length (something is missing here) takes the character before
/// it, else the one after it, within its line.
[[nodiscard]] QTextCursor markedPlace(QTextDocument *document, int begin, int end);

/// With waves in the colour of the severity.
[[nodiscard]] QTextEdit::ExtraSelection underlined(const QTextCursor &place, Severity severity);

}
