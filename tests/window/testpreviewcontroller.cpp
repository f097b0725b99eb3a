// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <atomic>
#include <functional>
#include <semaphore>
#include <thread>
#include <utility>

#include <QSignalSpy>
#include <QTest>
#include <QTextDocument>
#include <QTimer>

#include "app/window/previewcontroller.h"

using namespace romanesco;

namespace {

TextSnapshot text(const QString &characters)
{
    QTextDocument document;
    document.setPlainText(characters);
    return TextSnapshot(document);
}

/// A text whose scene has so many copies as one and the depth say.
TextSnapshot goodText(int depth)
{
    return text(
        QStringLiteral("half 0.5 0.5 0.5\nt. (half, #, half)\nx. \"a.obj\"\nz<x>. [#, t] x\n<$>. z %1\n").arg(depth));
}

/// Serves one mesh. A gate can hold readers up.
class GatedFiles final : public FileAccess
{
public:
    explicit GatedFiles(bool isGated)
        : m_isGated(isGated)
    {
    }
    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override
    {
        ++reads;
        if (m_isGated) {
            entered.release();
            gate.acquire();
        }
        if (path.filename() != "a.obj") {
            return std::unexpected("no such file");
        }
        return "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    }

    mutable std::atomic<int> reads = 0;
    mutable std::counting_semaphore<> entered{0};
    mutable std::counting_semaphore<> gate{0};

private:
    bool m_isGated;
};

struct Sample {
    explicit Sample(bool isGated = false)
        : files(isGated)
    {
        controller = std::make_unique<PreviewController>(files);
        QObject::connect(controller.get(), &PreviewController::built, controller.get(),
                         [this](const Preview &preview) { built.push_back(preview); });
        QObject::connect(controller.get(), &PreviewController::counted, controller.get(),
                         [this](const Summary &summary) { counted.push_back(summary); });
    }
    quint64 build(const TextSnapshot &snapshot) const { return controller->build("/folder/text.fdo", snapshot); }
    bool waitForBuilt(std::size_t count) const
    {
        return QTest::qWaitFor([&] { return built.size() >= count; }, 20'000);
    }

    const GatedFiles files;
    std::vector<Preview> built;
    std::vector<Summary> counted;
    std::unique_ptr<PreviewController> controller;
};

/// Does something once, just before the first call that was queued for an object.
class BeforeDelivery : public QObject
{
public:
    explicit BeforeDelivery(std::function<void()> act)
        : m_act(std::move(act))
    {
    }
    [[nodiscard]] bool isWaiting() const { return bool(m_act); }

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::MetaCall && m_act) {
            std::exchange(m_act, nullptr)();
        }
        return false;
    }

private:
    std::function<void()> m_act;
};

}

class TestPreviewController : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theNewestTextWins();
    void anOlderResultSaysSo();
    void whatTakesLongIsGivenUp();
    void typingWithoutAPauseShowsPictures();
    void theLastGoodSceneStaysAfterAnError();
    void anotherFileHasNoLastGoodScene();
    void whatIsUnderWayIsForgottenToo();
    void whatIsOnItsWayIsForgottenToo();
    void aSceneIsCounted();
    void destructionDoesNotWaitForTheGate();
    void whatMaySurpriseComesWithTheScene();
};

/// While the first text is held up, two more are given: the second never runs.
void TestPreviewController::theNewestTextWins()
{
    Sample sample(true);
    sample.build(goodText(1));
    sample.files.entered.acquire();
    sample.build(goodText(2));
    const quint64 newest = sample.build(goodText(3));
    sample.files.gate.release(2);
    QVERIFY(sample.waitForBuilt(2));
    QVERIFY(sample.built.front().isOutdated);
    QCOMPARE(sample.built.front().scene->depth->value, 1u);
    QVERIFY(!sample.built.back().isOutdated);
    QCOMPARE(sample.built.back().revision, newest);
    QCOMPARE(sample.built.back().scene->depth->value, 3u);
    QCOMPARE(sample.controller->lastGoodScene(), sample.built.back().scene);
    QCOMPARE(sample.files.reads.load(), 2);
    QTest::qWait(50);
    QCOMPARE(sample.built.size(), 2u);
}

/// The second text is given when the first result is already on its way to the window.
void TestPreviewController::anOlderResultSaysSo()
{
    Sample sample;
    quint64 newest = 0;
    BeforeDelivery intruder([&] { newest = sample.build(goodText(2)); });
    sample.controller->installEventFilter(&intruder);
    sample.build(goodText(1));
    QVERIFY(sample.waitForBuilt(2));
    QVERIFY(newest > 0);
    QVERIFY(sample.built.front().isOutdated);
    QCOMPARE(sample.built.back().revision, newest);
    QVERIFY(!sample.built.back().isOutdated);
}

/// Its result never arrives.
void TestPreviewController::whatTakesLongIsGivenUp()
{
    Sample sample(true);
    sample.build(goodText(1));
    sample.files.entered.acquire();
    const quint64 newest = sample.build(goodText(2));
    QTest::qWait(400);
    sample.files.gate.release(2);
    QVERIFY(sample.waitForBuilt(1));
    QCOMPARE(sample.built.front().revision, newest);
}

/// Each text takes longer than the first patience, and a newer one comes long before.
void TestPreviewController::typingWithoutAPauseShowsPictures()
{
    Sample sample(true);
    std::atomic_bool isOver = false;
    const std::jthread slowDisk([&] {
        while (!isOver) {
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            sample.files.gate.release();
        }
    });
    std::size_t depth = 0;
    QTimer typing;
    QObject::connect(&typing, &QTimer::timeout, &typing, [&] { sample.build(goodText(int(++depth % 5))); });
    typing.start(20);
    const bool isShown = sample.waitForBuilt(2);
    typing.stop();
    isOver = true;
    sample.files.gate.release(1000);
    QVERIFY(isShown);
}

void TestPreviewController::theLastGoodSceneStaysAfterAnError()
{
    Sample sample;
    sample.build(goodText(2));
    QVERIFY(sample.waitForBuilt(1));
    const std::shared_ptr<const Scene> good = sample.built.front().scene;
    QVERIFY(good);
    QCOMPARE(sample.controller->lastGoodScene(), good);

    sample.build(text(QStringLiteral("<$>. rigt\n")));
    QVERIFY(sample.waitForBuilt(2));
    QVERIFY(!sample.built.back().scene);
    QVERIFY(hasErrors(sample.built.back().diagnostics));
    QCOMPARE(sample.controller->lastGoodScene(), good);
}

void TestPreviewController::anotherFileHasNoLastGoodScene()
{
    Sample sample;
    sample.build(goodText(2));
    QVERIFY(sample.waitForBuilt(1));
    sample.controller->forget();
    QVERIFY(!sample.controller->lastGoodScene());
}

void TestPreviewController::whatIsUnderWayIsForgottenToo()
{
    Sample sample(true);
    sample.build(goodText(1));
    sample.files.entered.acquire();
    sample.controller->forget();
    sample.files.gate.release();
    const quint64 newest = sample.build(goodText(2));
    sample.files.entered.acquire();
    sample.files.gate.release();
    QVERIFY(sample.waitForBuilt(1));
    QCOMPARE(sample.built.size(), 1u);
    QCOMPARE(sample.built.front().revision, newest);
}

void TestPreviewController::whatIsOnItsWayIsForgottenToo()
{
    Sample sample;
    BeforeDelivery intruder([&] { sample.controller->forget(); });
    sample.controller->installEventFilter(&intruder);
    sample.build(goodText(1));
    QVERIFY(QTest::qWaitFor([&] { return !intruder.isWaiting(); }, 20'000));
    QTest::qWait(50);
    QVERIFY(sample.built.empty());
    QVERIFY(!sample.controller->lastGoodScene());
}

void TestPreviewController::aSceneIsCounted()
{
    Sample sample;
    sample.build(goodText(3));
    QVERIFY(QTest::qWaitFor([&] { return !sample.counted.empty(); }, 20'000));
    QCOMPARE(sample.counted.front().instancesAsWritten, Count(8));
    QCOMPARE(sample.counted.front().instancesDistinct, std::optional(Count(4)));
}

/// A text that waits is dropped, not built.
void TestPreviewController::destructionDoesNotWaitForTheGate()
{
    Sample sample(true);
    sample.build(goodText(1));
    sample.files.entered.acquire();
    sample.build(goodText(2));
    sample.files.gate.release();
    sample.controller.reset();
    QVERIFY(sample.built.empty());
}

void TestPreviewController::whatMaySurpriseComesWithTheScene()
{
    const Sample sample;
    sample.build(text(QStringLiteral("flat 1 0 1\nt. (#, #, flat)\nx. \"a.obj\"\n<$>. [t] x\n")));
    QVERIFY(sample.waitForBuilt(1));
    QVERIFY(sample.built[0].scene);
    QCOMPARE(sample.built[0].diagnostics.size(), std::size_t{1});
    QVERIFY(sample.built[0].diagnostics[0].code == DiagnosticCode::Singular);
}

QTEST_MAIN(TestPreviewController)
#include "testpreviewcontroller.moc"
