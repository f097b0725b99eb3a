// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include <QPointF>
#include <QString>

class QPainter;

namespace romanesco {

class FdoEditor;

/// A number that is written behind a vector's line and is no part of the text: the language counts vectors.
struct InlayNumber {
    int line = 0;
    QString text;
    /// Where its baseline starts, in the viewport.
    QPointF place;
};

/// Those of the lines in sight, of the text as it is now.
[[nodiscard]] std::vector<InlayNumber> inlayNumbers(FdoEditor &editor);

void paintInlayNumbers(QPainter &painter, FdoEditor &editor);

}
