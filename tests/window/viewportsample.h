// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cmath>

#include <QMouseEvent>
#include <QSignalSpy>

#include "app/window/resourcefiles.h"
#include "app/window/viewport.h"
#include "core/scene/sceneloader.h"
#include "glapplication.h"

namespace romanesco::test {

inline std::shared_ptr<const Scene> exampleScene(const char *name)
{
    const ResourceFiles files;
    const std::filesystem::path path = std::filesystem::path(":/examples") / name;
    return SceneLoader(files).load(path, files.read(path).value()).scene;
}

/// The share of pixels that are brighter than the background ever is.
inline double brightShare(const QImage &picture)
{
    qsizetype bright = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            bright += qGray(picture.pixel(x, y)) > 60 ? 1 : 0;
        }
    }
    return double(bright) / double(picture.width() * picture.height());
}

/// Where the camera stands, from wherever it is counted.
inline glm::dvec3 placeInWorld(const Viewport &viewport)
{
    const Surroundings &all = *viewport.view().surroundings();
    return all.origin + std::exp2(all.unitExponent) * viewport.camera().position;
}

/// A viewport by itself, with the Sierpinski example.
struct ViewportSample {
    Viewport viewport;
    QSignalSpy finished{&viewport, &Viewport::pictureFinished};
    QSignalSpy clicks{&viewport, &Viewport::clicked};

    ViewportSample()
    {
        viewport.resize(160, 120);
        viewport.setScene(exampleScene("sierpinski.fdo"));
        viewport.resetView();
        viewport.show();
    }
    bool waitForPicture()
    {
        return QTest::qWaitFor([&] { return viewport.isPictureFinished(); }, 60'000);
    }
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint from, QPoint to)
    {
        const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton which, Qt::MouseButtons held) {
            QMouseEvent event(type, at, viewport.mapToGlobal(at), which, held, modifiers);
            QCoreApplication::sendEvent(&viewport, &event);
        };
        send(QEvent::MouseButtonPress, from, button, button);
        send(QEvent::MouseMove, to, Qt::NoButton, button);
        send(QEvent::MouseButtonRelease, to, button, Qt::NoButton);
    }
};

}
