// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>

#include <QCommandLineOption>
#include <QCommandLineParser>
#include <QString>

#include "app/drawing/painter.h"
#include "app/drawing/turn.h"
#include "core/physics/simulation.h"

namespace romanesco::cli {

/// --render, --size and --fps: pictures of balls that fall, from where the scene is looked at. All but the balls is drawn once.
class BallFrames
{
public:
    /// What the options ask for.
    struct Choice {
        FramePattern names;
        int width = 0;
        int height = 0;
        double perSecond = 0.0;
    };
    class Options
    {
    public:
        void addTo(QCommandLineParser &parser) const { parser.addOptions({m_render, m_size, m_perSecond}); }
        [[nodiscard]] bool areSet(const QCommandLineParser &parser) const { return parser.isSet(m_render); }
        /// Complains where they make no sense.
        [[nodiscard]] std::optional<Choice> chosen(const QCommandLineParser &parser) const;

    private:
        QCommandLineOption m_render{
            QStringLiteral("render"),
            QStringLiteral("Pictures instead of rows; OUT.png has a %d in it for the number, or "
                           "%04d for four digits."),
            QStringLiteral("OUT.png")};
        QCommandLineOption m_size;
        QCommandLineOption m_perSecond{QStringLiteral("fps"), QStringLiteral("Pictures a second (25)."),
                                       QStringLiteral("N"), QStringLiteral("25")};

    public:
        Options();
    };

    /// The error is a sentence.
    [[nodiscard]] static std::expected<BallFrames, std::string> create(const Choice &choice,
                                                                       const std::shared_ptr<const Scene> &scene);

    /// At the start and after each step: writes the pictures that are due until then, each file whole or not at all; balls are
    /// where they are at its time. Complains and returns false where that fails.
    [[nodiscard]] bool take(const Simulation &simulation);

private:
    BallFrames(const Choice &choice, Painter painter);

    Choice m_choice;
    Painter m_painter;
    int m_next = 0;
};

}
