// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <expected>
#include <memory>
#include <optional>

#include <QString>

#include "render/renderer.h"

namespace romanesco {

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

/// Pictures of a full turn round a point: `count` of them from 0 on, of which 0 is the view as it is.
struct Turn {
    std::shared_ptr<const Scene> scene;
    View view;
    /// In the coordinates of the view's camera.
    glm::dvec3 pivot{0.0};
    int count = 1;
    /// Of the dissertation's zoom, where that is asked for (see dynamicSurroundings()).
    std::optional<std::size_t> trail = {};

    [[nodiscard]] View at(int frame) const;
};

/// The camera of a frame: it goes to its right, round the vertical line through the pivot. Frame 0 is the camera as it is.
[[nodiscard]] Camera turned(Camera camera, const glm::dvec3 &pivot, int frame, int count);

}
