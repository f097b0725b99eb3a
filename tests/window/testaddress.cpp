// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>

#include "app/window/addresspane.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

/// Two rows of two cubes: the first pick is the row, the second the place in it.
constexpr auto rows = "v -4 0 0\nv 4 0 0\nv 0 -2 0\nv 0 2 0\nx. \"cube.obj\"\nat.p. (p, #, #)\n"
                      "row. [at.1, at.2] x\n<$>. [at.3, at.4] row\n";

void openRows(Sample &sample)
{
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("rows.fdo"), rows)));
    QVERIFY(QTest::qWaitFor([&] { return sample.drawn == 4 && sample.viewport.isPictureFinished(); }, 60'000));
}

QListWidget &listOf(const Sample &sample)
{
    return *sample.window.findChild<AddressPane *>()->findChild<QListWidget *>();
}

QStringList wordsOf(const QListWidget &list)
{
    QStringList words;
    for (int i = 0; i < list.count(); ++i) {
        words << list.item(i)->text();
    }
    return words;
}

std::optional<MapSelection> mapOf(const Sample &sample)
{
    return sample.viewport.appearance().colours.map;
}

}

/// From the picture to the text, and back.
class TestAddress : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void stepsAreListed();
    void aStepLeadsToItsWordsAndItsCopies();
    void wordsAreFoundInADeeperPicture();
    void zoomingFillsTheViewWithACopy();
    void theCursorLetsCopiesStandOut();
    void anotherTextHasNoAddress();
    void theMouseThatRestsTellsTheAddress();
    void whileTheViewMovesNothingIsTold();
    void aRightClickOffersWhatCanBeDone();
    void collapsingEndsTheDepthAtTheStep_data();
    void collapsingEndsTheDepthAtTheStep();
    void whatTheDepthDoesNotCountStays();
};

void TestAddress::stepsAreListed()
{
    Sample sample;
    openRows(sample);
    const QSize size = sample.viewport.size();
    QVERIFY(wordsOf(listOf(sample)).isEmpty());
    sample.viewport.select(Selection{0, {{1, 1}, {0, 0}}});
    Q_EMIT sample.viewport.clicked({});
    const QStringList words = wordsOf(listOf(sample));
    QCOMPARE(words, QStringList({QStringLiteral("<$> at.4"), QStringLiteral("row at.1")}));
    QCOMPARE(sample.window.findChild<QStatusBar *>()->currentMessage(), words.join(QStringLiteral(" › ")));
    QTest::qWait(50);
    QCOMPARE(sample.viewport.size(), size); // the list does not make the picture smaller
    sample.viewport.select(std::nullopt);
    Q_EMIT sample.viewport.clicked({});
    QVERIFY(wordsOf(listOf(sample)).isEmpty());
}

void TestAddress::aStepLeadsToItsWordsAndItsCopies()
{
    Sample sample;
    openRows(sample);
    const Selection copy{0, {{1, 1}, {0, 0}}};
    sample.viewport.select(copy);
    Q_EMIT sample.viewport.clicked({});
    QListWidget &list = listOf(sample);
    list.setCurrentRow(0);
    QCOMPARE(sample.viewport.appearance().colours.selection->steps.size(), std::size_t(1));
    QCOMPARE(sample.editor.textCursor().selectedText(), list.item(0)->text().section(u' ', 1));
    list.setCurrentRow(1);
    QVERIFY(sample.viewport.appearance().colours.selection == copy);
    QCOMPARE(sample.editor.textCursor().selectedText(), list.item(1)->text().section(u' ', 1));
    QCOMPARE(sample.editor.textCursor().blockNumber(), 6);
}

/// The text that an endless picture is of has another depth, whose digits move what follows.
void TestAddress::wordsAreFoundInADeeperPicture()
{
    Sample sample;
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    const QByteArray text = "v 1 0 0\nv -1 0 0\nh 0.3 0.3 0.3\nx. \"cube.obj\"\nat.p. (p, #, h)\nz<x>. [at.1, at.2] x\n"
                            "y. z 2\n<$>. [at.2] y\n";
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("deep.fdo"), text)));
    QVERIFY(sample.waitForPicture());
    for (QAction *action : sample.viewport.actions()) {
        if (action->text().remove(u'&') == QStringLiteral("Endless")) {
            action->trigger();
        }
    }
    QVERIFY(QTest::qWaitFor([&] {
        const auto &all = sample.viewport.view().surroundings();
        return all && all->scene->items[0].model->graph.levels().levelCount() > 100;
    }));
    sample.viewport.select(Selection{0, {{1, 0}, {0, 1}}});
    Q_EMIT sample.viewport.clicked({});
    QListWidget &list = listOf(sample);
    QVERIFY(list.count() > 0);
    for (int row = 0; row < list.count(); ++row) {
        list.setCurrentRow((row + 1) % list.count());
        list.setCurrentRow(row);
        QCOMPARE(sample.editor.textCursor().selectedText(), list.item(row)->text().section(u' ', 1));
    }
}

void TestAddress::zoomingFillsTheViewWithACopy()
{
    Sample sample;
    openRows(sample);
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, {2, 2});
    QVERIFY(QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }, 20'000));
    const Camera before = sample.viewport.view().cameraInWorld();
    sample.viewport.select(Selection{0, {{1, 1}, {0, 0}}});
    Q_EMIT sample.viewport.clicked({});
    QTest::mouseClick(sample.window.findChild<AddressPane *>()->findChild<QPushButton *>(), Qt::LeftButton);
    const Camera after = sample.viewport.view().cameraInWorld();
    QVERIFY(after.worldFromCamera == before.worldFromCamera);
    QVERIFY(sample.waitForPicture());
    const auto middle = sample.viewport.view().pick({0.0, 0.0}, 1e-3);
    QVERIFY(middle && middle->steps == std::vector<Step>({{1, 1}, {0, 0}}));
}

void TestAddress::theCursorLetsCopiesStandOut()
{
    Sample sample;
    openRows(sample);
    const QImage plain = sample.viewport.grabFramebuffer();
    sample.placeCursorAt(QStringLiteral("at.2"));
    QVERIFY(QTest::qWaitFor([&] { return mapOf(sample).has_value(); }, 20'000));
    const Step second = mapOf(sample)->map;
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.viewport.grabFramebuffer() != plain);
    sample.placeCursorAt(QStringLiteral("at.1"));
    QVERIFY(QTest::qWaitFor([&] { return mapOf(sample) && !(mapOf(sample)->map == second); }, 20'000));
    QCOMPARE(mapOf(sample)->map.set, second.set);
    sample.placeCursorAt(QStringLiteral("cube"));
    QVERIFY(QTest::qWaitFor([&] { return !mapOf(sample); }, 20'000));
}

void TestAddress::anotherTextHasNoAddress()
{
    Sample sample;
    openRows(sample);
    sample.viewport.select(Selection{0, {{1, 1}, {0, 0}}});
    Q_EMIT sample.viewport.clicked({});
    QCOMPARE(wordsOf(listOf(sample)).size(), 2);
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/menger.fdo")));
    QVERIFY(wordsOf(listOf(sample)).isEmpty());
    QVERIFY(!sample.viewport.appearance().colours.selection);
}

namespace {

QString said(const Sample &sample)
{
    return sample.window.findChild<QStatusBar *>()->currentMessage();
}

/// Where a copy is seen, once surfaces are known.
std::optional<QPoint> placeOfACopy(const Sample &sample)
{
    QTest::mouseMove(&sample.viewport, {2, 2});
    QTest::mouseMove(&sample.viewport, {3, 2});
    QEnterEvent enter(QPointF(1, 1), QPointF(1, 1), QPointF(1, 1));
    QCoreApplication::sendEvent(&sample.viewport, &enter);
    if (!QTest::qWaitFor([&] { return sample.viewport.view().hasRayWalk(); }, 20'000)) {
        return std::nullopt;
    }
    for (int y = 0; y < sample.viewport.height(); y += 3) {
        for (int x = 100; x < sample.viewport.width(); x += 3) {
            if (sample.viewport.copyAt(QPointF(x, y))) {
                return QPoint(x + 1, y + 1);
            }
        }
    }
    return std::nullopt;
}

/// With the status bar's words that of its steps.
QString wordsAt(const Sample &sample, QPoint place)
{
    const std::optional<Selection> copy = sample.viewport.copyAt(place);
    return copy ? QStringLiteral("<$> at.%1 › row at.%2").arg(copy->steps[0].map + 3).arg(copy->steps[1].map + 1)
                : QString();
}

QAction &actionOf(const Sample &sample, const QString &words)
{
    for (QAction *action : sample.window.findChildren<QAction *>()) {
        if (action->text().remove(u'&') == words) {
            return *action;
        }
    }
    qFatal("no such action");
}

}

void TestAddress::theMouseThatRestsTellsTheAddress()
{
    Sample sample;
    openRows(sample);
    QVERIFY(sample.waitForPicture());
    const std::optional<QPoint> place = placeOfACopy(sample);
    QVERIFY(place);
    const QString before = said(sample);
    QTest::mouseMove(&sample.viewport, *place);
    QVERIFY(QTest::qWaitFor([&] { return said(sample) == wordsAt(sample, *place); }, 20'000));
    QVERIFY(!sample.viewport.appearance().colours.selection);
    QVERIFY(wordsOf(listOf(sample)).isEmpty());
    // Beside the copies, and beside the picture, there is nothing to tell.
    QTest::mouseMove(&sample.viewport, {2, 2});
    QCOMPARE(said(sample), before);
    QTest::mouseMove(&sample.viewport, *place);
    QVERIFY(QTest::qWaitFor([&] { return said(sample) == wordsAt(sample, *place); }, 20'000));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&sample.viewport, &leave);
    QCOMPARE(said(sample), before);
    // A copy that was clicked is told again once nothing else is.
    QTest::mouseClick(&sample.viewport, Qt::LeftButton, {}, *place);
    QVERIFY(!wordsOf(listOf(sample)).isEmpty());
    const QString clicked = said(sample);
    QTest::mouseMove(&sample.viewport, *place + QPoint(1, 0));
    QTest::mouseMove(&sample.viewport, {2, 2});
    QCOMPARE(said(sample), clicked);
}

void TestAddress::whileTheViewMovesNothingIsTold()
{
    Sample sample;
    openRows(sample);
    QVERIFY(sample.waitForPicture());
    const std::optional<QPoint> place = placeOfACopy(sample);
    QVERIFY(place);
    const QString before = said(sample);
    QTest::mouseMove(&sample.viewport, *place);
    QVERIFY(QTest::qWaitFor([&] { return said(sample) != before; }, 20'000));
    QTest::mousePress(&sample.viewport, Qt::LeftButton, {}, *place);
    QCOMPARE(said(sample), before);
    QTest::qWait(600);
    QCOMPARE(said(sample), before);
    QTest::mouseMove(&sample.viewport, *place + QPoint(30, 0));
    QTest::mouseRelease(&sample.viewport, Qt::LeftButton, {}, *place + QPoint(30, 0));
    QCOMPARE(said(sample), before);
}

void TestAddress::aRightClickOffersWhatCanBeDone()
{
    Sample sample;
    openRows(sample);
    QVERIFY(sample.waitForPicture());
    const std::optional<QPoint> place = placeOfACopy(sample);
    QVERIFY(place);
    const auto menu = [&] { return qobject_cast<QMenu *>(QApplication::activePopupWidget()); };
    QTest::mouseClick(&sample.viewport, Qt::RightButton, {}, *place);
    QVERIFY(menu() && menu()->actions().contains(&actionOf(sample, QStringLiteral("Zoom Into This Copy"))));
    QVERIFY(actionOf(sample, QStringLiteral("Zoom Into This Copy")).isEnabled());
    QCOMPARE(wordsOf(listOf(sample)).size(), 2);
    menu()->close();
    QTest::mouseClick(&sample.viewport, Qt::RightButton, {}, {3, 3});
    QVERIFY(menu());
    QVERIFY(!actionOf(sample, QStringLiteral("Zoom Into This Copy")).isEnabled());
    QVERIFY(!actionOf(sample, QStringLiteral("Collapse to Here")).isEnabled());
    menu()->close();
    // A drag is none.
    QTest::mousePress(&sample.viewport, Qt::RightButton, {}, *place);
    QTest::mouseMove(&sample.viewport, *place + QPoint(20, 0));
    QTest::mouseRelease(&sample.viewport, Qt::RightButton, {}, *place + QPoint(20, 0));
    QVERIFY(!menu());
}

void TestAddress::collapsingEndsTheDepthAtTheStep_data()
{
    QTest::addColumn<bool>("isEndless");
    QTest::newRow("as written") << false;
    QTest::newRow("endless") << true;
}

void TestAddress::collapsingEndsTheDepthAtTheStep()
{
    QFETCH(const bool, isEndless);
    Sample sample;
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    const QByteArray text = "v 1 0 0\nv -1 0 0\nh 0.3 0.3 0.3\nx. \"cube.obj\"\nat.p. (p, #, h)\nz<x>. [at.1, at.2] x\n"
                            "y. z 5\n<$>. [at.2] y\n";
    QVERIFY(sample.openAndWait(sample.write(QStringLiteral("deep.fdo"), text)));
    if (isEndless) {
        actionOf(sample, QStringLiteral("Endless")).trigger();
        QVERIFY(QTest::qWaitFor([&] {
            const auto &all = sample.viewport.view().surroundings();
            return all && all->scene->items[0].model->graph.levels().levelCount() > 100;
        }));
    }
    // <$> at.2, then z[1] to z[4]
    const std::uint32_t outer = 1;
    sample.viewport.select(Selection{0, {{outer, 0}, {0, 0}, {0, 1}, {0, 0}, {0, 1}}});
    Q_EMIT sample.viewport.clicked({});
    QListWidget &list = listOf(sample);
    QCOMPARE(wordsOf(list).size(), 5);
    QVERIFY(list.item(3)->text().startsWith(QStringLiteral("z[3]")));
    list.setCurrentRow(3);
    auto &collapse = actionOf(sample, QStringLiteral("Collapse to Here"));
    QVERIFY(collapse.isEnabled());
    QVERIFY(sample.focusViewport());
    QTest::keyClick(&sample.viewport, Qt::Key_C);
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("y. z 3\n")));
    QVERIFY(QTest::qWaitFor([&] {
        const auto &all = sample.viewport.view().surroundings();
        return all && all->scene->items[0].model->graph.levels().levelCount() == 4;
    }));
    QVERIFY(!actionOf(sample, QStringLiteral("Endless")).isChecked());
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText().toUtf8(), text);
}

void TestAddress::whatTheDepthDoesNotCountStays()
{
    Sample sample;
    openRows(sample);
    sample.viewport.select(Selection{0, {{1, 1}, {0, 0}}});
    Q_EMIT sample.viewport.clicked({});
    QVERIFY(!actionOf(sample, QStringLiteral("Collapse to Here")).isEnabled());
    QVERIFY(actionOf(sample, QStringLiteral("Zoom Into This Copy")).isEnabled());
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestAddress>(argc, argv);
}
#include "testaddress.moc"
