// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "painter.h"

#include <format>

#include "commandline.h"

namespace romanesco::cli {

namespace {

std::unexpected<int> fail(const std::string &words)
{
    complain(QString::fromStdString(words));
    return std::unexpected<int>(CannotDo);
}

}

std::expected<Painter, int> Painter::create(std::shared_ptr<const Scene> scene)
{
    Painter painter;
    auto context = EglContext::create();
    if (!context) {
        return fail(context.error());
    }
    painter.m_context = std::move(*context);
    auto renderer = Renderer::create();
    if (!renderer) {
        return fail(renderer.error());
    }
    painter.m_renderer = std::move(*renderer);
    painter.m_renderer->setScene(std::move(scene));
    return painter;
}

std::expected<Picture, int> Painter::draw(const View &view, Progress &progress, const QString &what)
{
    m_renderer->begin(view);
    for (bool isFinished = false; !isFinished; isFinished = m_renderer->step(std::chrono::milliseconds(100))) {
        // before each picture too, of which a series may have many
        if (isCancelled()) {
            return fail("cancelled");
        }
        progress.show(
            QStringLiteral("%1: %2 of %3 samples").arg(what).arg(m_renderer->finishedSamples()).arg(view.samples));
    }
    if (!m_renderer->error().empty()) {
        return fail(m_renderer->error());
    }
    Picture picture = m_renderer->read();
    if (picture.pixels.empty() && !m_renderer->error().empty()) {
        return fail(m_renderer->error());
    }
    if (picture.pixels.empty()) {
        return fail(std::format("The graphics driver has no room for a picture of {}x{}.", view.width, view.height));
    }
    return picture;
}

}
