// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "render/headless/sceneframes.h"

#include <cmath>
#include <thread>

#include <QTest>

#include "core/measure/frametrial.h"
#include "render/sceneview.h"
#include "scenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Small ones, of few samples, that nothing takes long.
constexpr int width = 160;
constexpr int height = 90;
constexpr int samples = 16;

std::unique_ptr<SceneFrames> framesOf(const std::shared_ptr<const Scene> &scene)
{
    return SceneFrames::create(scene, width, height).value();
}

FrameTrial tried(const std::shared_ptr<const Scene> &scene,
                 const FrameTrial::Options &options = {.mostSamples = samples})
{
    return tryFrames(*framesOf(scene), *scene, options).value();
}

const FrameRow &rowOf(const FrameTrial &trial, FramePlace place, double tolerance)
{
    return *std::ranges::find_if(trial.rows,
                                 [&](const FrameRow &row) { return row.place == place && row.tolerance == tolerance; });
}

/// Without a trial and a frame source.
std::vector<std::uint8_t> drawn(const std::shared_ptr<const Scene> &scene, double tolerance, int count)
{
    const auto context = EglContext::create().value();
    const auto renderer = Renderer::create().value();
    SceneView from;
    from.setScene(scene);
    from.start(double(width) / height);
    View view;
    view.camera = from.camera();
    view.surroundings = from.surroundings();
    view.width = width;
    view.height = height;
    view.pixelTolerance = tolerance;
    view.samples = count;
    view.standsAlone = true;
    renderer->setScene(scene);
    renderer->begin(view);
    while (!renderer->step(std::chrono::milliseconds(1000))) { }
    return renderer->read().pixels;
}

double rmsOf(const std::vector<std::uint8_t> &a, const std::vector<std::uint8_t> &b)
{
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        squares += std::pow(double(a[i]) - double(b[i]), 2);
    }
    return std::sqrt(squares / double(a.size()));
}

}

class TestSceneFrames : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void errorsAreThoseOfThePictures();
    void coarserPicturesTakeLessAndAreFartherOff();
    void allIsTheSameInEveryRunAndThread();
    void whatIsDrawnIsCounted();
    void nearIsNear();
    void tooManyCopiesAreToldInWords();
    void fewerSamplesAreTakenWhereTheyWouldTakeLong();
    void stoppingIsHeard();
};

/// Drawn once more without the trial, and compared by hand.
void TestSceneFrames::errorsAreThoseOfThePictures()
{
    const auto scene = example("sierpinski.fdo", "5");
    const FrameTrial trial = tried(scene);
    const auto reference = drawn(scene, 0.0, samples);
    QCOMPARE(trial.references.size(), 2u);
    QCOMPARE(trial.references[0].samples, samples);
    QCOMPARE(trial.references[0].tolerance, 0.0);
    QCOMPARE(trial.references[0].leftover.rms, rmsOf(drawn(scene, 0.0, samples / 2), reference));
    for (const double tolerance : {0.0, 1.0, 4.0, 8.0, 16.0}) {
        const FrameRow &row = rowOf(trial, FramePlace::View, tolerance);
        QCOMPARE(row.reason, std::string());
        QCOMPARE(row.moving.rms, rmsOf(drawn(scene, tolerance, 1), reference));
        QCOMPARE(row.alone.rms, rmsOf(drawn(scene, tolerance, samples), reference));
    }
    QVERIFY(rowOf(trial, FramePlace::View, 16.0).alone.rms > 1.0);
    QCOMPARE(rowOf(trial, FramePlace::View, 0.0).alone.rms, 0.0);
}

void TestSceneFrames::coarserPicturesTakeLessAndAreFartherOff()
{
    const FrameTrial trial = tried(example("sierpinski.fdo", "7"));
    QCOMPARE(trial.rows.size(), 2 * framePixelTolerances().size());
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const FrameRow &row = trial.rows[i];
        QCOMPARE(row.tolerance, framePixelTolerances()[i % framePixelTolerances().size()]);
        QVERIFY(row.milliseconds.lowerQuartile <= row.milliseconds.median);
        QVERIFY(row.milliseconds.median > 0.0 && row.cost.bytes > 0);
        if (row.place == FramePlace::View && row.tolerance > 0.0) {
            const FrameRow &finer = trial.rows[i - 1];
            QVERIFY(row.cost.statesVisited <= finer.cost.statesVisited);
            QVERIFY(row.alone.rms >= finer.alone.rms);
        }
    }
    QVERIFY(rowOf(trial, FramePlace::View, 16.0).cost.faces < rowOf(trial, FramePlace::View, 0.0).cost.faces / 8);
}

/// A window measures in a thread of its own.
void TestSceneFrames::allIsTheSameInEveryRunAndThread()
{
    const auto scene = example("menger.fdo", "3");
    const FrameTrial first = tried(scene);
    FrameTrial second;
    std::jthread([&] { second = tried(scene); }).join();
    QCOMPARE(first.rows.size(), second.rows.size());
    for (std::size_t i = 0; i < first.rows.size(); ++i) {
        const FrameRow &a = first.rows[i];
        const FrameRow &b = second.rows[i];
        QCOMPARE(a.reason, b.reason);
        QCOMPARE(a.cost.copies, b.cost.copies);
        QCOMPARE(a.cost.faces, b.cost.faces);
        QCOMPARE(a.cost.statesVisited, b.cost.statesVisited);
        QCOMPARE(a.moving.rms, b.moving.rms);
        QCOMPARE(a.moving.share, b.moving.share);
        QCOMPARE(a.alone.rms, b.alone.rms);
        QCOMPARE(a.alone.share, b.alone.share);
    }
    QCOMPARE(first.device, second.device);
    QCOMPARE(first.references[1].leftover.rms, second.references[1].leftover.rms);
}

void TestSceneFrames::whatIsDrawnIsCounted()
{
    const auto frames = framesOf(example("sierpinski.fdo", "4"));
    const FrameCost cost = frames->draw({.pixelTolerance = 0.0, .samples = 3}, {}).value();
    QCOMPARE(cost.copies, 256u);
    QCOMPARE(cost.faces, 4 * 256u);
    QCOMPARE(cost.statesVisited, 1u + 4 + 16 + 64 + 256);
    QVERIFY(cost.seconds > 0.0);
    QCOMPARE(frames->pixels().value().size(), std::size_t(3 * width * height));
}

/// A sixteenth of the way off a cube there is nothing but the cube.
void TestSceneFrames::nearIsNear()
{
    const auto frames = framesOf(sceneOf("x. \"box.obj\"\n<$>. x\n"));
    const auto corners = [&](FramePlace place) {
        (void)frames->draw({.place = place}, {}).value();
        const std::vector<std::uint8_t> pixels = frames->pixels().value();
        return std::pair{std::vector(pixels.begin(), pixels.begin() + 3), std::vector(pixels.end() - 3, pixels.end())};
    };
    const auto far = corners(FramePlace::View);
    const auto near = corners(FramePlace::Near);
    QVERIFY(far.first != far.second); // the background
    QVERIFY(near.first != far.first && near.second != far.second);
    QVERIFY(near.first[0] > 100 && near.second[0] > 100);
}

void TestSceneFrames::tooManyCopiesAreToldInWords()
{
    const FrameTrial trial = tried(example("menger.fdo", "40"), {.mostOperations = 400'000, .mostSamples = 8});
    QCOMPARE(rowOf(trial, FramePlace::View, 0.0).reason,
             std::string("not possible: more than 10^53 faces (at most 400,000)"));
    QVERIFY(rowOf(trial, FramePlace::View, 0.25).reason.starts_with("not drawn: at "));
    QVERIFY(rowOf(trial, FramePlace::View, 0.25).reason.ends_with(" copies already"));
    QCOMPARE(rowOf(trial, FramePlace::View, 16.0).reason, std::string());
    QVERIFY(rowOf(trial, FramePlace::View, 16.0).cost.copies > 100);
    const FrameReference &reference = trial.references.front();
    QVERIFY(reference.tolerance > 0.25);
    QCOMPARE(rowOf(trial, FramePlace::View, reference.tolerance).alone.rms, 0.0);
    QVERIFY(rowOf(trial, FramePlace::View, 16.0).alone.rms > 0.0);
}

void TestSceneFrames::fewerSamplesAreTakenWhereTheyWouldTakeLong()
{
    const auto scene = example("sierpinski.fdo", "4");
    const FrameTrial all = tried(scene, {});
    QCOMPARE(all.references.front().samples, 64);
    const FrameTrial less = tried(scene, {.mostInAll = 1});
    QCOMPARE(less.references.front().samples, 8);
    QVERIFY(less.references.front().leftover.rms > all.references.front().leftover.rms);
}

void TestSceneFrames::stoppingIsHeard()
{
    const auto scene = example("menger.fdo", "30");
    const auto frames = framesOf(scene);
    std::stop_source stop;
    stop.request_stop();
    const auto cost = frames->draw({.pixelTolerance = 0.5}, stop.get_token());
    QVERIFY(!cost);
    QCOMPARE(cost.error(), std::string("cancelled"));

    std::stop_source later;
    int told = 0;
    const auto trial = tryFrames(*frames, *scene, {}, {later.get_token(), [&](const std::string &, double share) {
                                                           QVERIFY(share >= 0.0 && share <= 1.0);
                                                           told += 1;
                                                           later.request_stop();
                                                       }});
    QVERIFY(!trial && trial.error() == "cancelled");
    QCOMPARE(told, 1);
}

}

ROMANESCO_TEST(romanesco::test::TestSceneFrames)
#include "testsceneframes.moc"
