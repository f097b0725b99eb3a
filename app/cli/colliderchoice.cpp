// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "colliderchoice.h"

#include "core/formats/numbers.h"
#include "output.h"

namespace romanesco::cli {

std::optional<double> numberOf(const QCommandLineParser &parser, const QCommandLineOption &option)
{
    const ParsedNumber number = numberFromText(parser.value(option).toStdString());
    const bool isUnderstood = number.status == NumberStatus::Good || number.status == NumberStatus::Underflow;
    return isUnderstood && number.value >= 0.0 ? std::optional(number.value) : std::nullopt;
}

std::optional<SceneCollider::Options> ColliderChoice::chosen(const QCommandLineParser &parser) const
{
    const QString name = parser.value(m_collider);
    const std::optional<ColliderKind> kind = colliderKind(name.toStdString());
    if (!kind) {
        complain(
            QStringLiteral("--collider takes exact, approximate, greedy, octree, bvh or simple, not \"%1\"").arg(name));
        return std::nullopt;
    }
    if (parser.isSet(m_tolerance) && *kind != ColliderKind::Approximate) {
        complain(QStringLiteral("only --collider approximate has a tolerance"));
        return std::nullopt;
    }
    const std::optional<double> tolerance = numberOf(parser, m_tolerance);
    if (!tolerance) {
        complain(QStringLiteral("--tolerance takes a number from 0 on, not \"%1\"").arg(parser.value(m_tolerance)));
        return std::nullopt;
    }
    return SceneCollider::Options{*kind, *tolerance};
}

}
