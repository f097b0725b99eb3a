// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "turntable.h"

#include <QRegularExpression>

#include "core/geometry/rotation.h"

namespace romanesco::cli {

namespace {

constexpr int mostFrames = 1'000'000;

/// Digits, at most as many as an int holds in any case; -1 for anything else.
int wholeNumber(const QString &text)
{
    static const QRegularExpression digits(QStringLiteral("^[0-9]{1,9}$"));
    return digits.match(text).hasMatch() ? text.toInt() : -1;
}

}

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

std::expected<Turntable, QString> readTurntable(const QString &count, const QString &frames)
{
    Turntable turntable{.count = wholeNumber(count)};
    if (turntable.count < 1 || turntable.count > mostFrames) {
        return std::unexpected(
            QStringLiteral("--turntable takes a whole number from 1 to %1, not \"%2\"").arg(mostFrames).arg(count));
    }
    turntable.last = turntable.count - 1;
    if (frames.isNull()) {
        return turntable;
    }
    const QStringList ends = frames.split(QLatin1String(".."));
    turntable.first = ends.size() == 2 ? wholeNumber(ends[0]) : -1;
    turntable.last = ends.size() == 2 ? wholeNumber(ends[1]) : -1;
    if (turntable.first < 0 || turntable.last < turntable.first || turntable.last >= turntable.count) {
        return std::unexpected(QStringLiteral("--frames takes A..B, two of the numbers from 0 to %1, not \"%2\"")
                                   .arg(turntable.count - 1)
                                   .arg(frames));
    }
    return turntable;
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
