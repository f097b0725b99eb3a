// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "ballkeeper.h"

#include <algorithm>
#include <expected>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <glm/geometric.hpp>

#include "core/base/atomicfile.h"
#include "core/language/keptballs.h"
#include "core/physics/ballplaces.h"
#include "core/physics/scenephysics.h"
#include "editor/fdoeditor.h"
#include "texttab.h"

namespace romanesco {

namespace {

/// In parts of coordinates: what is smaller would not be where it was.
constexpr double finestRadius = 1e-12;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(BallKeeper)
};

/// A mesh for balls, as the text calls it.
struct BallMesh {
    std::string path;
    double radius = 1.0;
};

double radiusOf(const Mesh &mesh)
{
    double radius = 0.0;
    for (const glm::dvec3 &vertex : mesh.vertices) {
        radius = std::max(radius, glm::length(vertex));
    }
    return radius;
}

/// That of the scene's own balls, or one of radius 1 that is put beside the text. The error is a sentence.
std::expected<BallMesh, QString> ballMesh(const TextTab &tab, const Scene &scene)
{
    const auto own = std::ranges::find(scene.items, SceneDescription::Kind::Ball, &SceneItem::kind);
    if (own != scene.items.end()) {
        return BallMesh{own->path, radiusOf(*own->model->mesh)};
    }
    if (!tab.document().hasOwnFile()) {
        return std::unexpected(Words::tr("Save the scene first: its balls need a mesh beside it."));
    }
    QFile brought(QStringLiteral(":/examples/ball.obj"));
    if (!brought.open(QIODevice::ReadOnly)) {
        return std::unexpected(Words::tr("The mesh of a ball is missing."));
    }
    const QByteArray bytes = brought.readAll();
    const QDir folder = QFileInfo(tab.document().path()).dir();
    for (int number = 1;; ++number) {
        const QString name = number == 1 ? QStringLiteral("ball.obj") : QStringLiteral("ball-%1.obj").arg(number);
        QFile there(folder.filePath(name));
        if (!there.exists()) {
            const auto written =
                writeWhole(QFile::encodeName(there.fileName()).toStdString(),
                           std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
            if (!written) {
                return std::unexpected(Words::tr("%1 cannot be written: %2")
                                           .arg(there.fileName(), QString::fromStdString(written.error())));
            }
            return BallMesh{name.toStdString()};
        }
        if (there.open(QIODevice::ReadOnly) && there.readAll() == bytes) {
            return BallMesh{name.toStdString()};
        }
    }
}

}

QString keepBalls(TextTab &tab, const Scene &scene, const LiveSimulation::Frame &frame)
{
    FdoEditor &editor = tab.editor();
    const SdoSyntax *text = editor.language().sdo();
    if (!text) {
        return Words::tr("Balls are kept in scenes (.sdo); this text is none.");
    }
    if (editor.isReadOnly() || !frame.isStarted) {
        return Words::tr("There is nothing to keep.");
    }
    const auto own = ballsOf(scene);
    if (!own || own->size() != frame.ownBalls || ballCount(*text) != frame.ownBalls) {
        return Words::tr("The text has other balls now than those that fell. Reset, and let them fall again.");
    }
    BallMesh mesh;
    const auto isOwn = [&](const LiveSimulation::BallFrame &ball) { return ball.number < frame.ownBalls; };
    if (!std::ranges::all_of(frame.balls, isOwn)) {
        const auto found = ballMesh(tab, scene);
        if (!found) {
            return found.error();
        }
        mesh = *found;
    }
    std::vector<KeptBall> balls;
    for (const LiveSimulation::BallFrame &ball : frame.balls) {
        const Ball seen = inWorld({ball.after, ball.velocity, ball.radius, ball.restitution},
                                  frame.places[ball.place].surroundings.get());
        if (!(seen.radius > finestRadius * glm::length(seen.position))) {
            return Words::tr("Ball %1 is too small for the coordinates of a scene. Remove it, and keep the others.")
                .arg(ball.number + 1);
        }
        KeptBall kept{{}, seen.position, seen.velocity, seen.radius / mesh.radius, seen.restitution};
        if (isOwn(ball)) {
            kept.own = static_cast<std::size_t>(ball.number);
            kept.scale = seen.radius / (*own)[*kept.own].radius;
        }
        balls.push_back(kept);
    }
    editor.apply(withBalls(*text, balls, mesh.path), editor.language().snapshot());
    return {};
}

}
