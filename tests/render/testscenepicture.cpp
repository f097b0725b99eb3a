// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <array>

#include <QTest>

#include "drawing.h"
#include "render/scenecut.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

const std::string sierpinski = "v 0.5 0.5 0.5\nv 0.5 -0.5 -0.5\nv -0.5 0.5 -0.5\nv -0.5 -0.5 0.5\nhalf 0.5 0.5 0.5\n"
                               "x. \"box.obj\"\nt.p. (p, #, half)\nz<x>. [t.1, t.2, t.3, t.4] x\n<$>. z 8\n";

AffineMap moved(const glm::dvec3 &by)
{
    return {glm::dmat3(1.0), by};
}

}

/// Scenes of several items.
class TestScenePicture : public DrawingTest
{
    Q_OBJECT

private Q_SLOTS:
    void oneItemInPlaceIsTheFractalItself()
    {
        const auto fractal = sceneOf(sierpinski);
        const auto scene = assembled({{fractal->items[0].model, AffineMap{}}});
        View view = fittedView(*fractal);
        view.samples = 2;
        const Picture expected = draw(fractal, view);
        QVERIFY(fittedView(*scene).camera.position == view.camera.position);
        QCOMPARE(draw(scene, view).pixels, expected.pixels);
    }

    /// A map round the whole of a fractal and the same map of an item draw the same.
    void anItemsPlaceIsAnOuterMap_data()
    {
        QTest::addColumn<QByteArray>("vectors");
        QTest::addColumn<AffineMap>("map");
        QTest::newRow("turned, of unequal scales")
            << QByteArray("1 2 3  20 40 60  1 0.5 2") << mapFromParts({1, 2, 3}, {20, 40, 60}, {1, 0.5, 2});
        QTest::newRow("mirrored") << QByteArray("0 0 1  0 30 0  -1 1 1")
                                  << mapFromParts({0, 0, 1}, {0, 30, 0}, {-1, 1, 1});
        QTest::newRow("flat") << QByteArray("0 0 0  10 20 30  1 0 1")
                              << mapFromParts({0, 0, 0}, {10, 20, 30}, {1, 0, 1});
    }

    void anItemsPlaceIsAnOuterMap()
    {
        QFETCH(const QByteArray, vectors);
        QFETCH(const AffineMap, map);
        const QStringList n = QString::fromLatin1(vectors).split(QLatin1Char(' '), Qt::SkipEmptyParts);
        std::string outer;
        for (int i = 0; i < 3; ++i) {
            const QStringList three = n.mid(3 * i, 3);
            outer += "abc"[i] + (QLatin1Char(' ') + three.join(QLatin1Char(' '))).toStdString() + '\n';
        }
        std::string text = outer + "o. (a, b, c)\n" + sierpinski;
        text.replace(text.find("<$>. z 8"), 8, "<$>. [o] z 8");
        for (int i = 4; i > 0; --i) { // three vectors stand above its own
            text.replace(text.find("t." + std::to_string(i)), 3, "t." + std::to_string(i + 3));
        }
        const auto expected = sceneOf(text);
        QVERIFY(expected);
        const auto actual = assembled({{modelOf(sierpinski), map}});
        const View view = fittedView(*expected);
        const Picture picture = draw(expected, view);
        const double background = shareOfBackground(picture);
        QVERIFY(background < 0.97 && background > 0.2);
        QVERIFY(shareOfDifferent(picture, draw(actual, view)) < 0.003);
    }

    /// Pixel by pixel: where only one item is seen alone, it is seen together; whichever order they stand in.
    void eachItemIsDrawnWithItsOwnMeshAndPlace()
    {
        const auto box = modelOf("<$>. \"box.obj\"\n");
        const auto pyramid =
            modelOf("<$>. \"box.obj\"\n", "v -1 -1 -1\nv 1 -1 -1\nv 0 -1 1\nv 0 1 0\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        const std::vector<std::pair<std::shared_ptr<const Model>, AffineMap>> items{
            {box, moved({-3, 0, 0})},
            {pyramid, AffineMap{}},
            {box, mapFromParts({3, 0, 0}, {0, 30, 0}, {1, 2, 1})}};
        const auto together = assembled(items);
        const auto backwards = assembled({items[2], items[1], items[0]});
        const View view = fittedView(*together);
        const Picture all = draw(together, view);
        QCOMPARE(m_renderer->statistics().instances, 3u);
        QCOMPARE(draw(backwards, view).pixels, all.pixels);
        std::vector<std::size_t> covered(items.size());
        std::vector<Picture> alone;
        for (const auto &item : items) {
            alone.push_back(draw(assembled({item}), view));
        }
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < std::size_t(width) * height; ++i) {
            bool isCovered = false;
            for (std::size_t k = 0; k < items.size(); ++k) {
                covered[k] += isBackground(pixel(alone[k], i)) ? 0 : 1;
                isCovered = isCovered || !isBackground(pixel(alone[k], i));
            }
            wrong += isCovered == isBackground(pixel(all, i)) ? 1 : 0;
        }
        for (const std::size_t count : covered) {
            QVERIFY(count > 500);
        }
        QVERIFY2(wrong <= 5, qPrintable(QString::number(wrong)));
    }

    /// A billion units from the origin, where floats end and doubles have seven digits left.
    void whatIsFarFromTheOriginIsDrawnAsSharply()
    {
        const auto model = modelOf(sierpinski);
        const auto here = assembled({{model, AffineMap{}}});
        const glm::dvec3 far(1e9, -2e9, 3e9);
        const auto there = assembled({{model, moved(far)}});
        View view = fittedView(*here);
        const Picture expected = draw(here, view);
        view.camera.position += far;
        QVERIFY(shareOfDifferent(expected, draw(there, view)) < 0.003);
    }

    void meshesThatLeaveTheSceneAreTakenBack()
    {
        const auto box = modelOf("<$>. \"box.obj\"\n");
        const auto many = modelOf("<$>. \"box.obj\"\n", [] {
            std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
            for (int i = 0; i < 10'000; ++i) {
                text += "f 1 2 3\n";
            }
            return text;
        }());
        const auto both = assembled({{box, AffineMap{}}, {many, AffineMap{}}});
        const View view = fittedView(*both);
        draw(assembled({{box, AffineMap{}}}), view);
        const std::size_t before = m_renderer->statistics().bufferBytes;
        draw(both, view);
        QCOMPARE(m_renderer->statistics().bufferBytes, before + 10'000 * 12 + 36);
        draw(assembled({{box, AffineMap{}}}), view);
        QCOMPARE(m_renderer->statistics().bufferBytes, before);
    }

    void aSceneOfNothingIsTheBackground()
    {
        const auto nothing = assembled({});
        QCOMPARE(shareOfBackground(draw(nothing, fittedView(*nothing))), 1.0);
    }

    /// What is counted and held is the sum of all items; a model that stands twice is walked twice but held once.
    void statisticsAreSums()
    {
        const auto model = modelOf(sierpinski);
        const auto cutOf = [](const std::shared_ptr<const Scene> &scene) {
            SceneCut cut(*scene);
            cut.begin(Projector(fittedCamera(*scene, double(width) / height), around(*scene), 0.0, width, height),
                      Anchor(scene).surroundings(), 0.0);
            std::uint64_t found = 0;
            while (!cut.isComplete()) {
                found += cut.next(100).size();
            }
            return std::array<std::uint64_t, 3>{found, cut.instanceCount(), cut.memoryUse()};
        };
        const auto one = cutOf(assembled({{model, AffineMap{}}}));
        const auto two = cutOf(assembled({{model, AffineMap{}}, {model, moved({1, 2, 3})}}));
        QCOMPARE(one[0], std::uint64_t(65'536));
        QCOMPARE(one[1], one[0]);
        QCOMPARE(two[0], 2 * one[0]);
        QCOMPARE(two[1], two[0]);
        QCOMPARE(two[2], one[2]);
    }
};

ROMANESCO_TEST(TestScenePicture)

#include "testscenepicture.moc"
