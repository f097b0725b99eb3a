// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QListWidget>
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

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestAddress>(argc, argv);
}
#include "testaddress.moc"
