// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>

#include <QTest>
#include <glm/vec3.hpp>

#include "drawing.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

/// The least distance at which a ray meets the box ±half round the origin; inf if it does not. By slabs.
double rayMeetsBox(const glm::dvec3 &origin, const glm::dvec3 &direction, double half)
{
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (-half - origin[axis]) / direction[axis];
        const double b = (half - origin[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

}

class TestPicture : public DrawingTest
{
    Q_OBJECT

private Q_SLOTS:
    /// With one sample a pixel shows what the ray through its centre meets, for a ray traced here by slabs.
    void coverageIsWhatARayThroughThePixelCentreMeets_data()
    {
        QTest::addColumn<bool>("isPerspective");
        QTest::newRow("perspective") << true;
        QTest::newRow("orthographic") << false;
    }

    void coverageIsWhatARayThroughThePixelCentreMeets()
    {
        QFETCH(const bool, isPerspective);
        const auto scene = sceneOf("<$>. \"box.obj\"\n");
        Camera camera = fittedCamera(*scene, double(width) / height);
        camera.projection = isPerspective ? Projection::Perspective : Projection::Orthographic;
        camera.viewHeight = 3.7;
        const Picture picture = draw(scene, plainView(camera));
        QCOMPARE(picture.width, width);
        int covered = 0;
        int wrong = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double u = ((x + 0.5) / width * 2.0 - 1.0) * width / height;
                const double v = 1.0 - (y + 0.5) / height * 2.0;
                const double tangent = std::tan(camera.fieldOfView * std::acos(-1.0) / 360.0);
                const double half = 0.5 * camera.viewHeight;
                const glm::dvec3 from = isPerspective ? glm::dvec3(0.0) : glm::dvec3(u * half, v * half, 0.0);
                const glm::dvec3 along =
                    isPerspective ? glm::dvec3(u * tangent, v * tangent, 1.0) : glm::dvec3(0, 0, 1);
                const bool isHit = std::isfinite(
                    rayMeetsBox(camera.position + camera.worldFromCamera * from, camera.worldFromCamera * along, 1.0));
                covered += isHit ? 1 : 0;
                wrong += isHit == isBackground(pixel(picture, x, y)) ? 1 : 0;
            }
        }
        QVERIFY(covered > width * height / 8);
        // Single precision may decide otherwise where an edge passes through a centre.
        QVERIFY2(wrong <= 3, qPrintable(QString::number(wrong)));
    }

    /// One sample per pixel centre differs from eight only at edges, and eight are between one and one.
    void moreSamplesSmoothEdgesOnly()
    {
        const auto scene = sceneOf("<$>. \"box.obj\"\n");
        View view = fittedView(*scene);
        const Picture one = draw(scene, view);
        view.samples = 8;
        const Picture eight = draw(scene, view);
        const double different = shareOfDifferent(one, eight, 2);
        QVERIFY2(different > 0.001 && different < 0.03, qPrintable(QString::number(different)));
    }

    void picturesRepeatExactly()
    {
        const auto scene = sceneOf("v 1 0 0\nx. \"box.obj\"\nt.p. (p, #, #)\ny. [#, t.1] x\n<$>. y\n");
        View view = fittedView(*scene);
        view.samples = 4;
        QCOMPARE(draw(scene, view).pixels, draw(scene, view).pixels);
    }

    /// The nearer of two boxes hides the farther, in whichever order they are written; at 1e-7 of the distance apart too.
    void whatIsNearerIsSeen_data()
    {
        QTest::addColumn<QString>("set");
        QTest::addColumn<double>("gap");
        for (const double gap : {1.0, 1e-3, 1e-5}) {
            QTest::addRow("near first, gap %g", gap) << "[t.1, k.2]" << gap;
            QTest::addRow("far first, gap %g", gap) << "[k.2, t.1]" << gap;
        }
    }

    void whatIsNearerIsSeen()
    {
        QFETCH(const QString, set);
        QFETCH(const double, gap);
        // Two quads that face the camera: the nearer one is turned to the light, so that its colour differs.
        const std::string quad = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
        const std::string text = "v 0 0 5\nv 0 0 " + std::to_string(5.0 + gap)
            + "\nflat 1 1 1\nlean 20 20 0\nx. \"box.obj\"\nt.p. (p, #, #)\nk.p. (p, lean, #)\n";
        const auto both = sceneOf(text + "<$>. " + set.toStdString() + " x\n", quad);
        const auto near = sceneOf(text + "<$>. [t.1] x\n", quad);
        QVERIFY(both && near);
        Camera camera;
        camera.position = {0, 0, 0};
        const Pixel expected = pixel(draw(near, plainView(camera)), width / 2, height / 2);
        // In the middle the leaning quad is behind by the gap.
        QVERIFY(pixel(draw(both, plainView(camera)), width / 2, height / 2) == expected);
        const auto far = sceneOf(text + "<$>. [k.2] x\n", quad);
        QVERIFY(!(pixel(draw(far, plainView(camera)), width / 2, height / 2) == expected));
    }

    /// The same scene, scaled and moved with its camera, gives the same picture.
    void sizeAndPlaceOfTheWorldDoNotMatter_data()
    {
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("offset");
        QTest::newRow("tiny") << 1e-30 << 0.0;
        QTest::newRow("huge") << 1e30 << 0.0;
        QTest::newRow("far mesh") << 1.0 << 1e7;
    }

    void sizeAndPlaceOfTheWorldDoNotMatter()
    {
        QFETCH(const double, size);
        QFETCH(const double, offset);
        const auto boxAt = [](double at, double half) {
            return sceneOf("<$>. \"box.obj\"\n", boxObj(glm::dvec3(at - half), glm::dvec3(at + half)));
        };
        const auto unit = boxAt(0.0, 1.0);
        const auto other = boxAt(offset, size);
        const Picture expected = draw(unit, fittedView(*unit));
        const Picture actual = draw(other, fittedView(*other));
        QVERIFY(shareOfBackground(expected) < 0.9);
        const double different = shareOfDifferent(expected, actual);
        QVERIFY2(different < 0.001, qPrintable(QString::number(different)));
    }

    /// Once copies are below a pixel, ten times the depth changes nothing that can be seen.
    void depthBelowAPixelIsNotSeen()
    {
        const auto sierpinski = [](const char *depth) {
            return sceneOf(std::string("v 0.5 0.5 0.5\nv 0.5 -0.5 -0.5\nv -0.5 0.5 -0.5\nv -0.5 -0.5 0.5\n"
                                       "half 0.5 0.5 0.5\nx. \"box.obj\"\nt.p. (p, #, half)\n"
                                       "z<x>. [t.1, t.2, t.3, t.4] x\n<$>. z ")
                           + depth + '\n');
        };
        const auto shallow = sierpinski("14");
        const auto deep = sierpinski("140");
        const View view = fittedView(*shallow);
        const Picture picture = draw(shallow, view);
        QVERIFY(shareOfBackground(picture) < 0.9);
        const double different = shareOfDifferent(picture, draw(deep, view));
        QVERIFY2(different <= 0.001, qPrintable(QString::number(different)));
    }

    /// A mirrored copy shows the same faces as the one it mirrors: nothing is culled by its winding.
    void mirroredCopiesAreWhole()
    {
        const std::string text = "v 0 0 0\nsame 1 1 1\nflip -1 1 1\nx. \"box.obj\"\nt.s. (#, #, s)\n";
        const auto plain = sceneOf(text + "<$>. [t.same] x\n");
        const auto mirrored = sceneOf(text + "<$>. [t.flip] x\n");
        QVERIFY(plain && mirrored);
        const View view = fittedView(*plain);
        QVERIFY(shareOfDifferent(draw(plain, view), draw(mirrored, view), 4) < 0.002);
    }

    void flatAndPointLikeCopiesAreDrawnWithoutHarm()
    {
        const auto scene = sceneOf("v 0 0 0\nsheet 1 0 1\npoint 0 0 0\nline 0 2 0\nx. \"box.obj\"\n"
                                   "t.s. (#, #, s)\n<$>. [t.sheet, t.point, t.line] x\n");
        QVERIFY(scene);
        const double background = shareOfBackground(draw(scene, fittedView(*scene)));
        QVERIFY(background > 0.2 && background < 0.95);
    }

    void theLastPictureStaysUntilTheNextHasASample()
    {
        const auto first = sceneOf("<$>. \"box.obj\"\n");
        const View view = fittedView(*first);
        const Picture picture = draw(first, view);
        m_renderer->setScene(nullptr);
        m_renderer->begin(view);
        QCOMPARE(m_renderer->finishedSamples(), 0);
        QCOMPARE(m_renderer->read().pixels, picture.pixels);
        while (!m_renderer->step(std::chrono::milliseconds(1000))) { }
        QCOMPARE(shareOfBackground(m_renderer->read()), 1.0);
    }

    /// Appendix B of the dissertation at its printed depth: 172,855,881 copies.
    void appendixBTakesLessThan64MegabytesOfBuffers()
    {
        const std::filesystem::path path = test::sourcePath("resources/examples/appendix-b.fdo").toStdString();
        const DiskFiles files;
        const auto text = files.read(path);
        QVERIFY(text);
        const auto scene = SceneLoader(files).load(path, *text).scene;
        QVERIFY(scene);
        View view = plainView(fittedCamera(*scene, 16.0 / 9.0));
        view.width = 1280;
        view.height = 720;
        const Picture picture = draw(scene, view);
        const DrawStatistics statistics = m_renderer->statistics();
        QVERIFY(statistics.instances > 10'000);
        QVERIFY(statistics.instances < 1'000'000);
        QVERIFY(statistics.bufferBytes + statistics.graphBytes < 64'000'000);
        const double background = shareOfBackground(picture);
        QVERIFY2(background > 0.5 && background < 0.98, qPrintable(QString::number(background)));
    }

    void aPictureTooLargeForTheDriverIsAnErrorNotACrash()
    {
        const auto scene = sceneOf("<$>. \"box.obj\"\n");
        View view = plainView(fittedCamera(*scene, 1.0));
        view.width = 1 << 20;
        view.height = 1 << 20;
        m_renderer->setScene(scene);
        m_renderer->begin(view);
        QVERIFY(m_renderer->step(std::chrono::milliseconds(1)));
        QVERIFY(!m_renderer->error().empty());
        // And it draws on afterwards.
        QVERIFY(shareOfBackground(draw(scene, fittedView(*scene))) < 0.9);
    }
};

ROMANESCO_TEST(TestPicture)

#include "testpicture.moc"
