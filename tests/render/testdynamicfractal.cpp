// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>
#include <cstdlib>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/scene/dynamicfractal.h"
#include "core/scene/sceneloader.h"
#include "render/headless/eglcontext.h"
#include "render/renderer.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

std::shared_ptr<const Scene> example(const std::string &name)
{
    const std::filesystem::path path = ROMANESCO_SOURCE_DIR "/resources/examples/" + name;
    const DiskFiles files;
    return SceneLoader(files).load(path, files.read(path).value()).scene;
}

double shareOfDifferent(const Picture &a, const Picture &b)
{
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        different += std::abs(int(a.pixels[i]) - int(b.pixels[i])) > 8 ? 1 : 0;
    }
    return double(different) / double(a.pixels.size());
}

double shareOfBackground(const Picture &picture)
{
    std::size_t found = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 3) {
        found += picture.pixels[i] == 0 && picture.pixels[i + 1] == 0 && picture.pixels[i + 2] == 255 ? 1 : 0;
    }
    return 3.0 * double(found) / double(picture.pixels.size());
}

/// In the middle of an edge of the sponge; about it, a third of the whole is as the whole.
const glm::dvec3 middle(0, 1.5, -1.5);

/// Looks there from a distance.
View viewFrom(double distance)
{
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.5, 0.4, -1));
    View view;
    view.camera.position = middle + distance * direction;
    view.camera.worldFromCamera = rotationLooking(-direction);
    view.width = 320;
    view.height = 240;
    view.backgroundTop = {0, 0, 1};
    view.backgroundBottom = {0, 0, 1};
    return view;
}

}

class TestDynamicFractal : public QObject
{
    Q_OBJECT

    std::unique_ptr<EglContext> m_context;
    std::unique_ptr<Renderer> m_renderer;

    Picture draw(const std::shared_ptr<const Scene> &scene, const View &view)
    {
        m_renderer->setScene(scene);
        m_renderer->begin(view);
        while (!m_renderer->step(std::chrono::milliseconds(1000))) { }
        return m_renderer->read();
    }

    Picture drawDynamic(const std::shared_ptr<const Scene> &scene, View view, std::size_t trail)
    {
        view.surroundings = dynamicSurroundings(scene, view.camera.position, trail);
        return draw(scene, view);
    }

private Q_SLOTS:
    void initTestCase();
    void theFractalIsSeenWhereItHasGone();
    void theWayInRepeats();
    void thereIsSomethingWhereDoublesEnd();
};

void TestDynamicFractal::initTestCase()
{
    auto context = EglContext::create();
    QVERIFY2(context, context ? "" : context.error().c_str());
    m_context = std::move(*context);
    auto renderer = Renderer::create();
    QVERIFY2(renderer, renderer ? "" : renderer.error().c_str());
    m_renderer = std::move(*renderer);
}

/// Against a scene in which it stands there.
void TestDynamicFractal::theFractalIsSeenWhereItHasGone()
{
    const auto scene = example("menger.fdo");
    const View view = viewFrom(0.03);
    for (const std::size_t trail : {0, 1}) {
        Scene there = *scene;
        SceneItem &item = there.items.front();
        item.worldFromModel = dynamicSurroundings(scene, view.camera.position, trail)->nodes.at(0).hereFromNode;
        QVERIFY(item.worldFromModel.linear[0].x < 0.4);
        there.extent = extentOf(there.items);
        const Picture expected = draw(std::make_shared<const Scene>(std::move(there)), view);
        const Picture found = drawDynamic(scene, view, trail);
        QVERIFY2(shareOfDifferent(found, expected) < 0.004,
                 qPrintable(QString::number(shareOfDifferent(found, expected))));
        QVERIFY(shareOfBackground(found) < 0.9);
        QVERIFY(shareOfDifferent(found, draw(scene, view)) > 0.05);
    }
}

void TestDynamicFractal::theWayInRepeats()
{
    const auto scene = example("menger.fdo");
    for (const std::size_t trail : {0, 2}) {
        const Picture first = drawDynamic(scene, viewFrom(0.7 * std::pow(3.0, -3)), trail);
        QVERIFY(shareOfBackground(first) > 0.1 && shareOfBackground(first) < 0.9);
        for (const int levels : {6, 12, 24}) {
            const Picture deep = drawDynamic(scene, viewFrom(0.7 * std::pow(3.0, -levels)), trail);
            const double off = shareOfDifferent(first, deep);
            QVERIFY2(off < 0.01, qPrintable(QStringLiteral("level %1, trail %2: %3").arg(levels).arg(trail).arg(off)));
        }
    }
}

/// Where copies would be too small for the world's doubles, larger ones stand.
void TestDynamicFractal::thereIsSomethingWhereDoublesEnd()
{
    const auto scene = example("menger.fdo");
    for (const double distance : {std::pow(3.0, -34), 0.0}) {
        for (const std::size_t trail : {0, 2}) {
            const Picture picture = drawDynamic(scene, viewFrom(distance), trail);
            QVERIFY(m_renderer->error().empty());
            QVERIFY(!picture.pixels.empty() && shareOfBackground(picture) < 0.9);
        }
    }
}

}

ROMANESCO_TEST(romanesco::test::TestDynamicFractal)
#include "testdynamicfractal.moc"
