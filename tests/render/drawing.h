// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>

#include <QTest>

#include "render/headless/eglcontext.h"
#include "render/renderer.h"
#include "scenes.h"

namespace romanesco::test {

/// A test class that draws, without a window or a display.
class DrawingTest : public QObject
{
    Q_OBJECT

    std::unique_ptr<EglContext> m_context;

protected:
    std::unique_ptr<Renderer> m_renderer;

    Picture draw(const std::shared_ptr<const Scene> &scene, const View &view)
    {
        m_renderer->setScene(scene);
        m_renderer->begin(view);
        while (!m_renderer->step(std::chrono::milliseconds(1000))) { }
        return m_renderer->read();
    }

private Q_SLOTS:
    void initTestCase()
    {
        auto context = EglContext::create();
        QVERIFY2(context, context ? "" : context.error().c_str());
        m_context = std::move(*context);
        auto renderer = Renderer::create();
        QVERIFY2(renderer, renderer ? "" : renderer.error().c_str());
        m_renderer = std::move(*renderer);
        qInfo("%s", m_renderer->description().c_str());
    }
};

constexpr int width = 320;
constexpr int height = 240;

using Pixel = std::array<int, 3>;

/// Pure blue is no colour that a surface takes.
inline bool isBackground(const Pixel &p)
{
    return p == Pixel{0, 0, 255};
}

inline View plainView(const Camera &camera)
{
    View view;
    view.camera = camera;
    view.width = width;
    view.height = height;
    view.backgroundTop = {0.0f, 0.0f, 1.0f};
    view.backgroundBottom = view.backgroundTop;
    return view;
}

inline View fittedView(const Scene &scene)
{
    return plainView(fittedCamera(scene, double(width) / height));
}

/// Counted from the first of the upper row.
inline Pixel pixel(const Picture &picture, std::size_t i)
{
    return {picture.pixels[3 * i], picture.pixels[3 * i + 1], picture.pixels[3 * i + 2]};
}

inline Pixel pixel(const Picture &picture, int x, int y)
{
    return pixel(picture, static_cast<std::size_t>(y * picture.width + x));
}

inline bool areNear(const Pixel &a, const Pixel &b, int most)
{
    return std::abs(a[0] - b[0]) <= most && std::abs(a[1] - b[1]) <= most && std::abs(a[2] - b[2]) <= most;
}

/// Of the pixels, those for which isMeant(i) holds; between 0 and 1.
template<typename Predicate>
double share(const Picture &picture, Predicate isMeant)
{
    const std::size_t count = picture.pixels.size() / 3;
    std::size_t found = 0;
    for (std::size_t i = 0; i < count; ++i) {
        found += isMeant(i) ? 1 : 0;
    }
    return double(found) / double(count);
}

inline double shareOfBackground(const Picture &picture)
{
    return share(picture, [&](std::size_t i) { return isBackground(pixel(picture, i)); });
}

/// By more than the threshold in any colour.
inline double shareOfDifferent(const Picture &a, const Picture &b, int threshold = 8)
{
    return share(a, [&](std::size_t i) { return !areNear(pixel(a, i), pixel(b, i), threshold); });
}

}
