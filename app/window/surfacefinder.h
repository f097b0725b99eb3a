// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QObject>

#include "core/base/newestjob.h"
#include "core/scene/sceneraywalk.h"

namespace romanesco {

/// Makes what finds the surface under the pointer, in the background. For the GUI thread.
class SurfaceFinder : public QObject
{
    Q_OBJECT
public:
    explicit SurfaceFinder(QObject *parent = nullptr);

    /// found() follows, once where it is asked for several times in the meantime, unless there is no memory for it or another
    /// scene is asked for before.
    void find(const std::shared_ptr<const Scene> &scene);

Q_SIGNALS:
    void found(const std::shared_ptr<romanesco::SceneRayWalk> &walk);

private:
    using Job = std::shared_ptr<const Scene>;

    void run(const Job &scene, const std::stop_token &stop);

    /// The scene that was asked for last and is not found yet.
    std::weak_ptr<const Scene> m_sought;
    /// The last, so that it ends first.
    NewestJob<Job> m_job;
};

}
