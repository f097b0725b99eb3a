// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/scene/savedview.h"

#include <cmath>
#include <random>

#include <QTest>

#include "core/scene/sceneloader.h"
#include "tablefiles.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

bool isSame(const SavedView &a, const SavedView &b)
{
    return a.place == b.place && a.isEndless == b.isEndless && a.camera.position == b.camera.position
        && a.camera.rotation == b.camera.rotation && a.camera.isOrthographic == b.camera.isOrthographic
        && a.camera.view == b.camera.view;
}

const std::string fractal = "# view: endless, in 0: 0.1*3 at (1, 2, 3) (0, 0, 0) 60 perspective\n"
                            "<$>. \"mesh.obj\"\n";

}

class TestSavedView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsWrittenIsReadAgain();
    void repetitionsAreWrittenOnce();
    void viewsAreFoundInTexts();
    void otherCommentsAreNoViews_data();
    void otherCommentsAreNoViews();
    void scenesHaveTheirViews();
    void savingEditsOnlyWhatItMust_data();
    void savingEditsOnlyWhatItMust();
};

/// All digits, any length.
void TestSavedView::whatIsWrittenIsReadAgain()
{
    std::mt19937_64 random(seed(1));
    std::uniform_real_distribution<double> exponent(-150.0, 150.0);
    std::uniform_real_distribution<double> angle(-3.2, 3.2);
    const auto place = [&] { return (random() % 2 ? 1.0 : -1.0) * std::pow(10.0, exponent(random)); };
    for (int i = 0; i < 500; ++i) {
        SavedView view;
        view.isEndless = random() % 2 == 0;
        view.camera.position = {place(), place(), i % 3 ? place() : 0.0};
        view.camera.rotation = {angle(random), angle(random), angle(random)};
        view.camera.isOrthographic = random() % 2 == 0;
        view.camera.view = view.camera.isOrthographic ? std::abs(place()) : 1.0 + std::abs(angle(random));
        if (i % 4 != 0) {
            view.place.emplace();
            view.place->item = random() % 1'000;
            for (std::size_t steps = random() % 400; view.place->steps.size() < steps;) {
                const Step step{static_cast<SetId>(random() % 5), static_cast<std::uint32_t>(random() % 30)};
                view.place->steps.insert(view.place->steps.end(), 1 + random() % 20, step);
            }
        }
        const std::string text = "v 1 2 3\r\n" + viewLine(view) + "\r\nv 4 5 6\r\n";
        const auto found = findView(text);
        QVERIFY2(found, text.c_str());
        QVERIFY2(isSame(found->first, view), text.c_str());
        QCOMPARE(text.substr(found->second.begin, found->second.length()), viewLine(view));
    }
}

void TestSavedView::repetitionsAreWrittenOnce()
{
    SavedView view;
    view.camera = {{1, 2, -9}, {0, 0.5, 0}, false, 60, {}};
    QCOMPARE(viewLine(view), "# view: (1, 2, -9) (0, 0.5, 0) 60 perspective");
    QCOMPARE(cameraLine(view.camera), "c (1, 2, -9) (0, 0.5, 0) 60 perspective");
    view.isEndless = true;
    view.place.emplace();
    view.place->item = 2;
    view.place->steps.assign(100'000, {0, 7});
    view.place->steps.push_back({3, 1});
    QCOMPARE(viewLine(view), "# view: endless, in 2: 0.7*100000 3.1 at (1, 2, -9) (0, 0.5, 0) 60 perspective");
    // As deep as a view may be, and one step more.
    QVERIFY(!findView(viewLine(view)));
    view.place->steps.pop_back();
    const auto deepest = findView(viewLine(view));
    QVERIFY(deepest && isSame(deepest->first, view));
}

void TestSavedView::viewsAreFoundInTexts()
{
    QVERIFY(!findView(""));
    QVERIFY(!findView("v 1 2 3\n"));
    const auto only = findView("# view: (1, 2, 3) # 40");
    QVERIFY(only && only->first.camera.view == 40.0 && !only->first.place);
    // The first of two.
    const auto first = findView("# view: from above\n# view: (1, 2, 3) # 40\n# view: (1, 2, 3) # 50\n");
    QVERIFY(first && first->first.camera.view == 40.0 && first->second.begin == 19);
}

void TestSavedView::otherCommentsAreNoViews_data()
{
    QTest::addColumn<QByteArray>("line");
    const QByteArrayList lines{
        "# view:",
        "# view: from the left",
        "# view (1, 2, 3) # 40",
        " # view: (1, 2, 3) # 40",
        "# view: (1, 2, 3) # 40 and more",
        "# view: (1, 2, 3) # 40 # mine",
        "# view: (1, 2, 3) # 40 ",
        "# view: (1, 2) # 40",
        "# view: (1, 2, 3) # 180",
        "# view: endless (1, 2, 3) # 40",
        "# view: in 0: (1, 2, 3) # 40",
        "# view: in -1: at (1, 2, 3) # 40",
        "# view: in 0: 1 at (1, 2, 3) # 40",
        "# view: in 0: 1.2* at (1, 2, 3) # 40",
        "# view: in 0: 1.2*100001 at (1, 2, 3) # 40",
        "# view: in 0: 1.2*99999 1.2*2 at (1, 2, 3) # 40",
        "# view: in 0: 1.2*99999999999999999999 at (1, 2, 3) # 40",
        "# view: in 0: 4294967296.2 at (1, 2, 3) # 40",
        "# view: (1, 2, nan) # 40",
        "# view: (1e200, 2, 3) # 40",
        "# view: (1, 2, 3) # 1e200 orthographic",
        "# view: in 4294967296: at (1, 2, 3) # 40",
    };
    for (const QByteArray &line : lines) {
        QTest::addRow("%s", line.constData()) << line;
    }
}

void TestSavedView::otherCommentsAreNoViews()
{
    QFETCH(const QByteArray, line);
    QVERIFY(!findView(line.toStdString()));
}

void TestSavedView::scenesHaveTheirViews()
{
    TableFiles files({{"mesh.obj", triangleObj}, {"f.fdo", fractal}});
    const SceneResult loaded = SceneLoader(files).load("f.fdo", "# view: (1, 2, 3) # 40\n<$>. \"mesh.obj\"\n");
    QVERIFY(loaded.scene && loaded.scene->view && loaded.scene->view->camera.view == 40.0);
    // A file that a scene places has no say.
    const SceneResult scene = SceneLoader(files).load("s.sdo", "# view: in 0: at (1, 2, 3) # 50\nf \"f.fdo\" #\n");
    QVERIFY(scene.scene && scene.scene->view && scene.scene->view->camera.view == 50.0);
    QVERIFY(!SceneLoader(files).load("s.sdo", "f \"f.fdo\" #\n").scene->view);
}

void TestSavedView::savingEditsOnlyWhatItMust_data()
{
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<bool>("isSdo");
    QTest::addColumn<bool>("isDeep");
    QTest::addColumn<QByteArray>("after");
    const QByteArray camera = "c (9, 8, 7) (0, 0.5, 0) 60 perspective";
    const QByteArray deep = "# view: in 0: 0.1*3 at (1, 2, 3) (0, 0, 0) 50 perspective";
    const QByteArray plain = "# view: (1, 2, 3) (0, 0, 0) 50 perspective";
    const QByteArray old = "# view: (4, 5, 6) # 20";
    const auto row = [](const char *name, bool isSdo, bool isDeep, const QByteArray &before, const QByteArray &after) {
        QTest::newRow(name) << before << isSdo << isDeep << after;
    };
    row("fractal, new", false, false, "v 1 2 3\n", plain + "\nv 1 2 3\n");
    row("fractal, again", false, true, "v 1 2 3\n" + old + "\n# x", "v 1 2 3\n" + deep + "\n# x");
    row("scene, new", true, false, "l # #\n", camera + "\nl # #\n");
    row("scene, again", true, false, "l # #\n  c # # 30 # mine\n", "l # #\n  " + camera + " # mine\n");
    row("scene, new, deep", true, true, "l # #\n", deep + "\n" + camera + "\nl # #\n");
    row("scene, again, deep", true, true, "c # # 30\nl # #", deep + "\n" + camera + "\nl # #");
    row("scene, no longer deep", true, false, "c # # 30\n" + old + "\nl # #\n", camera + "\nl # #\n");
    row("scene, no longer deep, CRLF", true, false, old + "\r\nc # # 30\r\n", camera + "\r\n");
    row("scene, both again", true, true, old + "\nl # #\nc # # 30", deep + "\nl # #\n" + camera);
    row("scene with errors", true, false, "o\nc # # 30\n", "o\n" + camera + "\n");
    row("byte order mark", false, true, "\xEF\xBB\xBFv 1 2 3\n", "\xEF\xBB\xBF" + deep + "\nv 1 2 3\n");
    row("byte order mark, again", false, true, "\xEF\xBB\xBF" + old, "\xEF\xBB\xBF" + deep);
    row("empty", true, false, "", camera + "\n");
}

void TestSavedView::savingEditsOnlyWhatItMust()
{
    QFETCH(const QByteArray, before);
    QFETCH(const bool, isSdo);
    QFETCH(const bool, isDeep);
    QFETCH(const QByteArray, after);
    SavedView view;
    view.camera = {{1, 2, 3}, {0, 0, 0}, false, 50, {}};
    if (isDeep) {
        view.place = {0, std::vector<Step>(3, Step{0, 1})};
    }
    const SceneDescription::Camera inWorld{{9, 8, 7}, {0, 0.5, 0}, false, 60, {}};
    const std::string text = before.toStdString();
    const std::string saved = applied(text, editsToSave(view, inWorld, text, isSdo));
    QCOMPARE(QByteArray::fromStdString(saved), after);
    // Once more changes nothing.
    QCOMPARE(applied(saved, editsToSave(view, inWorld, saved, isSdo)), saved);
}

ROMANESCO_TEST(TestSavedView)

#include "testsavedview.moc"
