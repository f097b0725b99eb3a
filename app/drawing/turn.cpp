// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "turn.h"

#include <QRegularExpression>

#include "core/geometry/rotation.h"
#include "core/scene/dynamicfractal.h"

namespace romanesco {

std::expected<FramePattern, QString> FramePattern::parse(const QString &text)
{
    const qsizetype percent = text.indexOf(QLatin1Char('%'));
    if (percent < 0) {
        return std::unexpected(QStringLiteral("it needs a %d for the number of the frame"));
    }
    if (text.indexOf(QLatin1Char('%'), percent + 1) >= 0) {
        return std::unexpected(QStringLiteral("it may have one % only"));
    }
    static const QRegularExpression number(QStringLiteral("%(?:0([1-9]))?d"));
    const QRegularExpressionMatch match = number.match(text);
    if (!match.hasMatch()) {
        return std::unexpected(QStringLiteral("after the % comes d, or 0, a digit from 1 and d"));
    }
    FramePattern pattern;
    pattern.m_before = text.left(match.capturedStart());
    pattern.m_after = text.mid(match.capturedEnd());
    pattern.m_digits = match.hasCaptured(1) ? match.captured(1).toInt() : 1;
    return pattern;
}

QString FramePattern::name(int frame) const
{
    return m_before + QString::number(frame).rightJustified(m_digits, QLatin1Char('0')) + m_after;
}

View Turn::at(int frame) const
{
    View result = view;
    result.camera = turned(view.camera, pivot, frame, count);
    if (trail) {
        result.surroundings = dynamicSurroundings(scene, result.camera.position, *trail);
    }
    return result;
}

Camera turned(Camera camera, const glm::dvec3 &pivot, int frame, int count)
{
    const glm::dmat3 turn = rotationFromDegrees({0.0, 360.0 * frame / count, 0.0});
    const glm::dvec3 fromPivot = camera.position - pivot;
    // a turn by nothing changes nothing, in the last digit neither
    camera.position += turn * fromPivot - fromPivot;
    camera.worldFromCamera = turn * camera.worldFromCamera;
    return camera;
}

}
