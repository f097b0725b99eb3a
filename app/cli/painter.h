// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <memory>
#include <string>

#include <QString>

#include "output.h"
#include "render/headless/eglcontext.h"
#include "render/renderer.h"

namespace romanesco::cli {

/// Draws pictures of one scene, without a display. Complains where something fails, and where it is cancelled: the errors are
/// exit statuses.
class Painter
{
public:
    [[nodiscard]] static std::expected<Painter, int> create(std::shared_ptr<const Scene> scene);

    /// what: names the picture to who waits for it.
    [[nodiscard]] std::expected<Picture, int> draw(const View &view, Progress &progress, const QString &what);

private:
    Painter() = default;

    /// Outlives what was made in it.
    std::unique_ptr<EglContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
};

}
