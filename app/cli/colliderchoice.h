// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <QCommandLineOption>
#include <QCommandLineParser>

#include "core/scene/scenecollider.h"

namespace romanesco::cli {

/// The number from 0 on that an option has.
[[nodiscard]] std::optional<double> numberOf(const QCommandLineParser &parser, const QCommandLineOption &option);

/// --collider and --tolerance.
class ColliderChoice
{
public:
    void addTo(QCommandLineParser &parser) const { parser.addOptions({m_collider, m_tolerance}); }

    /// What was chosen. Complains where that makes no sense.
    [[nodiscard]] std::optional<SceneCollider::Options> chosen(const QCommandLineParser &parser) const;

private:
    QCommandLineOption m_collider{
        QStringLiteral("collider"),
        QStringLiteral("How to search: exact (the default), approximate, greedy, octree, bvh or simple."),
        QStringLiteral("KIND"), QStringLiteral("exact")};
    QCommandLineOption m_tolerance{
        QStringLiteral("tolerance"),
        QStringLiteral("Distances found by approximate are at most 1 + EPS times the least (default: 0.001)."),
        QStringLiteral("EPS"), QStringLiteral("1e-3")};
};

}
