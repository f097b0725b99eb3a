// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <cmath>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "core/base/file.h"
#include "core/scene/depthchange.h"
#include "drawing.h"
#include "render/depthpyramid.h"
#include "render/sceneview.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

View viewOf(const SceneView &from)
{
    View view = plainView(from.camera());
    view.surroundings = from.surroundings();
    return view;
}

}

/// Views that are counted from places inside.
class TestDeepPicture : public DrawingTest
{
    Q_OBJECT

private Q_SLOTS:
    void placesInsideShowWhatTheWorldShows_data();
    void placesInsideShowWhatTheWorldShows();
    void spongesLookTheSameAtAnyDepth();
    void anotherTextKeepsThePlace();
    void savedViewsAreTheSamePictures_data();
    void savedViewsAreTheSamePictures();
    void aViewWhoseWayIsGoneIsNoView();
    void coloursAndSelectionsReachInside();
    void picturesOfOtherScenesAreNotMixedUp();
    void whatIsLeftOutIsNotSeen_data();
    void whatIsLeftOutIsNotSeen();
    void denseScenesAreCheap();
    void pyramidsHideWhatIsBehindAllPixels();
};

void TestDeepPicture::placesInsideShowWhatTheWorldShows_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("isPerspective");
    for (const char *file : {"menger.fdo", "tree.fdo", "romanesco.fdo", "two-sets.fdo", "terrain.sdo"}) {
        QTest::addRow("%s", file) << QString::fromLatin1(file) << true;
        QTest::addRow("%s, orthographic", file) << QString::fromLatin1(file) << false;
    }
}

/// Where both can tell: some levels down.
void TestDeepPicture::placesInsideShowWhatTheWorldShows()
{
    QFETCH(const QString, file);
    QFETCH(const bool, isPerspective);
    const auto scene = example(file.toStdString());
    QVERIFY(scene);
    SceneView inside;
    inside.setScene(scene);
    inside.start(double(width) / height);
    inside.setProjection(isPerspective ? Projection::Perspective : Projection::Orthographic);
    OrbitCamera outside;
    if (scene->camera) {
        outside.start(cameraOf(*scene->camera), around(*scene));
    } else {
        outside.fit(*scene, double(width) / height);
    }
    outside.setProjection(inside.camera().projection);
    std::size_t deepest = 0;
    for (int i = 0; i < 12; ++i) {
        inside.zoom(0.75, {0.1, 0.05});
        outside.zoom(0.75, {0.1, 0.05});
        inside.orbit({0.02, 0.0});
        outside.orbit({0.02, 0.0});
        deepest = std::max(deepest, inside.surroundings()->path.size());
        if (i % 4 == 3) {
            View world = viewOf(inside);
            world.camera = outside.camera();
            world.surroundings.reset();
            const Picture expected = draw(scene, world);
            const Picture found = draw(scene, viewOf(inside));
            const double off = shareOfDifferent(expected, found);
            QVERIFY2(off < 0.004, qPrintable(QStringLiteral("%1: %2").arg(i).arg(off)));
        }
    }
    QVERIFY(deepest > 0);
}

void TestDeepPicture::spongesLookTheSameAtAnyDepth()
{
    const auto scene = example("menger.fdo", "3000");
    QVERIFY(scene);
    Anchor anchor(scene);
    QVERIFY(anchor.enter({0, 0}));
    std::optional<Picture> first;
    for (int level = 1; level <= 2000; ++level) {
        QVERIFY(anchor.enter({0, static_cast<std::uint32_t>(level % 7)}));
        if (level < 140 || level % 140 != 0) {
            continue;
        }
        View view;
        view.width = width;
        view.height = height;
        view.pixelTolerance = 8.0;
        view.surroundings = anchor.surroundings();
        const Sphere bound = anchor.bound();
        view.camera.position = bound.centre + bound.radius * glm::dvec3(0.9, 0.8, -1.1);
        view.camera.worldFromCamera = rotationLooking(bound.centre - view.camera.position);
        const Picture picture = draw(scene, view);
        QVERIFY(first || shareOfBackground(picture) < 0.9);
        if (!first) {
            first = picture;
        }
        const double off = shareOfDifferent(*first, picture);
        QVERIFY2(off < 0.002, qPrintable(QStringLiteral("%1: %2").arg(level).arg(off)));
    }
}

void TestDeepPicture::anotherTextKeepsThePlace()
{
    SceneView view;
    view.setScene(example("menger.fdo", "3"));
    view.start(double(width) / height);
    for (int i = 0; i < 10; ++i) {
        view.zoom(0.8, {0.2, 0.2});
    }
    const auto before = view.surroundings();
    const Camera camera = view.camera();
    QVERIFY(before->path.size() >= 2);
    view.setScene(example("menger.fdo", "9"));
    QVERIFY(view.surroundings()->path.size() >= before->path.size());
    view.setScene(example("menger.fdo", "3"));
    QVERIFY(view.surroundings()->path.size() <= 3);
    view.setScene(example("menger.fdo", "0"));
    QVERIFY(view.surroundings()->path.empty());
    // The same place all the time, counted from wherever.
    const auto placeInWorld = [](const SceneView &from) {
        const Surroundings &all = *from.surroundings();
        return all.origin + std::exp2(all.unitExponent) * from.camera().position;
    };
    const glm::dvec3 expected = before->origin + std::exp2(before->unitExponent) * camera.position;
    QVERIFY(glm::distance(placeInWorld(view), expected) < 1e-9);
    view.setScene(nullptr);
    QVERIFY(!view.surroundings());
}

void TestDeepPicture::savedViewsAreTheSamePictures_data()
{
    QTest::addColumn<int>("zooms");
    QTest::addColumn<bool>("isPerspective");
    QTest::newRow("from outside") << 0 << true;
    QTest::newRow("a little inside") << 12 << true;
    QTest::newRow("deep inside") << 700 << true;
    QTest::newRow("deep inside, orthographic") << 700 << false;
}

/// To the bit, through the text.
void TestDeepPicture::savedViewsAreTheSamePictures()
{
    QFETCH(const int, zooms);
    QFETCH(const bool, isPerspective);
    const std::filesystem::path path = test::sourcePath("resources/examples/menger.fdo").toStdString();
    const DiskFiles files;
    const DepthChange endless(files, DepthChange::endless);
    const std::string text = endless.changed(files.read(path).value());
    const auto load = [&](const std::string &line) { return SceneLoader(files).load(path, line + "\n" + text).scene; };
    SceneView from;
    const auto scene = load("");
    from.setScene(scene);
    from.setRayWalk(std::make_shared<SceneRayWalk>(SceneRayWalk::create(scene).value()));
    from.start(double(width) / height);
    from.setProjection(isPerspective ? Projection::Perspective : Projection::Orthographic);
    from.orbit({0.13, 0.07});
    for (int i = 0; i < zooms; ++i) {
        from.zoom(0.7, {0.03, 0.02});
    }
    const std::string line = viewLine(from.saved());
    const auto saved = load(line);
    QVERIFY2(saved && saved->view, line.c_str());
    QVERIFY(zooms < 100 || saved->view->place->steps.size() > 100);
    SceneView again;
    again.setScene(saved);
    again.start(double(width) / height);
    QVERIFY(bool(saved->view->place) == (zooms > 100));
    if (zooms > 100) {
        QVERIFY(again.camera().position == from.camera().position);
    } else {
        QVERIFY(glm::distance(again.cameraInWorld().position, from.cameraInWorld().position) < 1e-15);
    }
    const Picture expected = draw(scene, viewOf(from));
    QVERIFY(shareOfBackground(expected) < 0.999);
    // The angles are rounded once.
    const double off = shareOfDifferent(expected, draw(saved, viewOf(again)));
    QVERIFY2(off < 1e-3, qPrintable(QString::number(off)));
}

void TestDeepPicture::aViewWhoseWayIsGoneIsNoView()
{
    const std::filesystem::path path = test::sourcePath("resources/examples/sierpinski.fdo").toStdString();
    const DiskFiles files;
    const std::string text = files.read(path).value();
    SceneView fitted;
    fitted.setScene(SceneLoader(files).load(path, text).scene);
    fitted.start(1.5);
    for (const char *place : {"in 1: ", "in 0: 7.0 ", "in 0: 0.9 ", "in 0: 0.0*7 "}) {
        const std::string line = std::string("# view: ") + place + "at (1, 2, 3) # 60\n";
        const auto scene = SceneLoader(files).load(path, line + text).scene;
        QVERIFY2(scene->view, line.c_str());
        SceneView view;
        view.setScene(scene);
        view.start(1.5);
        QVERIFY(view.camera() == fitted.camera());
    }
}

void TestDeepPicture::coloursAndSelectionsReachInside()
{
    const auto scene = example("menger.fdo", "3");
    SceneView inside;
    inside.setScene(scene);
    inside.start(double(width) / height);
    OrbitCamera outside;
    outside.fit(*scene, double(width) / height);
    for (int i = 0; i < 8; ++i) {
        inside.zoom(0.8, {0.2, 0.2});
        outside.zoom(0.8, {0.2, 0.2});
    }
    QVERIFY(inside.surroundings()->path.size() >= 2);
    for (const Colouring colouring : {Colouring::Depth, Colouring::Branch, Colouring::Set, Colouring::Materials}) {
        View view = viewOf(inside);
        view.appearance.colours.colouring = colouring;
        const Step first = inside.surroundings()->path[0];
        const auto steps = colouring == Colouring::Materials ? std::vector<Step>() : std::vector{first};
        view.appearance.colours.selection = Selection{0, steps};
        const Picture found = draw(scene, view);
        view.camera = outside.camera();
        view.surroundings.reset();
        const Picture expected = draw(scene, view);
        QVERIFY2(shareOfDifferent(found, expected) < 0.004, qPrintable(QString::number(int(colouring))));
        view.appearance.colours = {};
        QVERIFY(shareOfDifferent(draw(scene, view), expected) > 0.01);
    }
}

void TestDeepPicture::picturesOfOtherScenesAreNotMixedUp()
{
    const auto scene = example("menger.fdo", "3");
    const auto other = example("tree.fdo", "3");
    SceneView view;
    view.setScene(scene);
    view.start(double(width) / height);
    const View ofFirst = viewOf(view);
    View plain = ofFirst;
    plain.surroundings.reset();
    QVERIFY(draw(other, ofFirst).pixels == draw(other, plain).pixels);
}

void TestDeepPicture::whatIsLeftOutIsNotSeen_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("depth");
    QTest::addColumn<bool>("isPerspective");
    for (const bool isPerspective : {true, false}) {
        const char *projection = isPerspective ? "" : ", orthographic";
        QTest::addRow("menger%s", projection) << "menger.fdo" << "3" << isPerspective;
        QTest::addRow("tree%s", projection) << "tree.fdo" << "6" << isPerspective;
        QTest::addRow("romanesco%s", projection) << "romanesco.fdo" << "2" << isPerspective;
        QTest::addRow("terrain%s", projection) << "terrain.sdo" << "" << isPerspective;
    }
}

void TestDeepPicture::whatIsLeftOutIsNotSeen()
{
    QFETCH(const QString, file);
    QFETCH(const QString, depth);
    QFETCH(const bool, isPerspective);
    const auto scene = example(file.toStdString(), depth.toStdString());
    SceneView from;
    from.setScene(scene);
    from.start(double(width) / height);
    from.setProjection(isPerspective ? Projection::Perspective : Projection::Orthographic);
    for (int i = 0; i < 3; ++i) {
        View view = viewOf(from);
        view.samples = 2;
        const Picture without = draw(scene, view);
        const std::uint64_t sent = m_renderer->statistics().instances;
        view.leavesOutHidden = false;
        const Picture all = draw(scene, view);
        QVERIFY(sent <= m_renderer->statistics().instances);
        // Where surfaces coincide the first that is drawn is seen, and what is near is drawn first.
        const double different = shareOfDifferent(all, without, 0);
        QVERIFY2(different <= 2e-3, qPrintable(QString::number(different)));
        from.zoom(0.3, {0.1, 0.1});
    }
}

void TestDeepPicture::denseScenesAreCheap()
{
    const auto scene = example("menger.fdo", "5");
    SceneView from;
    from.setScene(scene);
    from.start(double(width) / height);
    View view = viewOf(from);
    const auto sentFor = [&] {
        draw(scene, view);
        return m_renderer->statistics().instances;
    };
    const std::uint64_t first = sentFor();
    const std::uint64_t again = sentFor();
    from.orbit({0.02, 0.01});
    view.camera = from.camera();
    const std::uint64_t moved = sentFor();
    view.leavesOutHidden = false;
    const std::uint64_t all = sentFor();
    const QString counts = QStringLiteral("%1, %2, %3 of %4").arg(first).arg(again).arg(moved).arg(all);
    QVERIFY2(8 * first < all && again <= first && 8 * moved < all, qPrintable(counts));
}

/// Against a look at every pixel.
void TestDeepPicture::pyramidsHideWhatIsBehindAllPixels()
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> depth(0.2f, 0.9f);
    const auto upTo = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    int hidden = 0;
    int missed = 0;
    for (const auto &[w, h] : {std::pair(1, 1), std::pair(7, 3), std::pair(64, 64), std::pair(133, 71)}) {
        std::vector<float> depths;
        for (int i = 0; i < w * h; ++i) {
            // far away in the middle only
            depths.push_back(depth(random) * (i % w > w / 3 && i % w < w / 2 ? 0.1f : 1.0f));
        }
        DepthPyramid pyramid;
        QVERIFY(pyramid.isEmpty());
        pyramid.build(depths, w, h);
        for (int i = 0; i < 20'000; ++i) {
            const int left = upTo(w + 10) - 5;
            const int bottom = upTo(h + 10) - 5;
            const int right = left + upTo(w);
            const int top = bottom + upTo(h);
            const double nearest = 0.3 * double(depth(random));
            float farthest = 1.0f;
            for (int y = std::clamp(bottom, 0, h - 1); y <= std::clamp(top, 0, h - 1); ++y) {
                for (int x = std::clamp(left, 0, w - 1); x <= std::clamp(right, 0, w - 1); ++x) {
                    farthest = std::min(farthest, depths[static_cast<std::size_t>(y * w + x)]);
                }
            }
            const bool isHidden = pyramid.isHidden({double(left), double(bottom), double(right), double(top), nearest});
            QVERIFY(!isHidden || nearest < double(farthest));
            hidden += isHidden ? 1 : 0;
            missed += !isHidden && nearest < double(farthest) ? 1 : 0;
        }
    }
    QVERIFY2(hidden > 4 * missed, qPrintable(QStringLiteral("%1 hidden, %2 missed").arg(hidden).arg(missed)));
}

ROMANESCO_TEST(TestDeepPicture)
#include "testdeeppicture.moc"
