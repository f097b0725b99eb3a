// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "painter.h"

#include <format>
#include <utility>

#include <QBuffer>
#include <QImage>

namespace romanesco {

std::expected<Painter, std::string> Painter::create(std::shared_ptr<const Scene> scene)
{
    Painter painter;
    auto context = EglContext::create();
    if (!context) {
        return std::unexpected(context.error());
    }
    painter.m_context = std::move(*context);
    auto renderer = Renderer::create();
    if (!renderer) {
        return std::unexpected(renderer.error());
    }
    painter.m_renderer = std::move(*renderer);
    painter.m_renderer->setScene(std::move(scene));
    return painter;
}

std::expected<Picture, std::string> Painter::draw(const View &view, const GoesOn &goesOn)
{
    m_width = view.width;
    m_height = view.height;
    m_renderer->begin(view);
    for (bool isFinished = false; !isFinished; isFinished = m_renderer->step(std::chrono::milliseconds(100))) {
        // before each picture too, of which a series may have many
        if (!goesOn(m_renderer->finishedSamples())) {
            return std::unexpected("cancelled");
        }
    }
    if (!m_renderer->error().empty()) {
        return std::unexpected(m_renderer->error());
    }
    return read({});
}

std::expected<Picture, std::string> Painter::withBalls(std::span<const BallSprite> balls)
{
    return read(balls);
}

std::expected<Picture, std::string> Painter::read(std::span<const BallSprite> balls)
{
    Picture picture = m_renderer->read(balls);
    if (picture.pixels.empty() && !m_renderer->error().empty()) {
        return std::unexpected(m_renderer->error());
    }
    if (picture.pixels.empty()) {
        return std::unexpected(
            std::format("The graphics driver has no room for a picture of {}x{}.", m_width, m_height));
    }
    return picture;
}

QByteArray pngOf(const Picture &picture)
{
    const QImage image(picture.pixels.data(), picture.width, picture.height, picture.width * 3, QImage::Format_RGB888);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

}
