// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>

#include <QString>

#include "render/camera.h"

namespace romanesco::cli {

/// Names for numbered files: a text with one %d in it, the number, or %0Nd, the number with at least N digits (1 to 9).
class FramePattern
{
public:
    /// Nothing else with a % is a pattern. The error completes "… is not a pattern: ".
    [[nodiscard]] static std::expected<FramePattern, QString> parse(const QString &text);

    [[nodiscard]] QString name(int frame) const;

private:
    QString m_before;
    QString m_after;
    int m_digits = 1;
};

/// Frames of a full turn: those from first to last, both included, of 0 to count - 1.
struct Turntable {
    int count = 1;
    int first = 0;
    int last = 0;
};

/// From what --turntable and --frames say; none of the latter is all. The error is a sentence.
[[nodiscard]] std::expected<Turntable, QString> readTurntable(const QString &count, const QString &frames);

/// The camera of a frame: it goes to its right, round the vertical line through the pivot. Frame 0 is the camera as it is.
[[nodiscard]] Camera turned(Camera camera, const glm::dvec3 &pivot, int frame, int count);

}
