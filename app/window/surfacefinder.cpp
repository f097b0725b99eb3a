// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "surfacefinder.h"

#include <new>
#include <utility>

#include <QMetaObject>

namespace romanesco {

SurfaceFinder::SurfaceFinder(QObject *parent)
    : QObject(parent)
    , m_job([this](const Job &scene, const std::stop_token &stop) { run(scene, stop); })
{
}

void SurfaceFinder::find(const std::shared_ptr<const Scene> &scene)
{
    if (scene && m_sought.lock() != scene) {
        m_sought = scene;
        m_job.post(scene);
    }
}

/// On the job's thread.
void SurfaceFinder::run(const Job &scene, const std::stop_token &stop)
{
    try {
        auto made = SceneRayWalk::create(scene, stop);
        if (made && !stop.stop_requested()) {
            auto walk = std::make_shared<SceneRayWalk>(std::move(*made));
            QMetaObject::invokeMethod(
                this,
                [this, walk] {
                    if (m_sought.lock() == walk->scene()) {
                        m_sought.reset();
                    }
                    Q_EMIT found(walk);
                },
                Qt::QueuedConnection);
        }
    } catch (const std::bad_alloc &) {
        // Then nothing is found under the pointer.
    }
}

}
