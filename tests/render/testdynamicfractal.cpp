// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/scene/dynamicfractal.h"
#include "drawing.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// In the middle of an edge of the sponge; about it, a third of the whole is as the whole.
const glm::dvec3 middle(0, 1.5, -1.5);

/// Looks there from a distance.
View viewFrom(double distance)
{
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.5, 0.4, -1));
    Camera camera;
    camera.position = middle + distance * direction;
    camera.worldFromCamera = rotationLooking(-direction);
    return plainView(camera);
}

}

class TestDynamicFractal : public DrawingTest
{
    Q_OBJECT

    Picture drawDynamic(const std::shared_ptr<const Scene> &scene, View view, std::size_t trail)
    {
        view.surroundings = dynamicSurroundings(scene, view.camera.position, trail);
        return draw(scene, view);
    }

private Q_SLOTS:
    void theFractalIsSeenWhereItHasGone();
    void theWayInRepeats();
    void thereIsSomethingWhereDoublesEnd();
};

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
