// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSet>
#include <QSignalSpy>
#include <QTableView>
#include <QWindow>

#include "app/window/addresspane.h"
#include "app/window/ballmodel.h"
#include "app/window/exportdialog.h"
#include "app/window/measurecontroller.h"
#include "app/window/measureview.h"
#include "app/window/preferences.h"
#include "editor/completionpopup.h"
#include "windowsample.h"

using namespace romanesco;
using romanesco::test::squiggles;
using Sample = romanesco::test::WindowSample;

namespace {

/// The window as it is seen at first, and what its states look like on the screen.
struct Scenery : Sample {
    Scenery()
    {
        window.move(0, 0);
        window.resize(1280, 800);
        window.activateWindow();
        waits = QTest::qWaitForWindowActive(&window) && waitForPicture();
    }
    bool waits = false;

    void trigger(const QString &words) const
    {
        for (QAction *action : window.findChildren<QAction *>()) {
            if (action->text().remove(u'&') == words) {
                action->trigger();
                return;
            }
        }
        qFatal("there is no %s", qPrintable(words));
    }

    /// By the menu.
    void openPanel(const QString &name) const
    {
        for (const QMenu *menu : window.menuBar()->findChildren<QMenu *>()) {
            for (QAction *action : menu->actions()) {
                if (menu->title() == QLatin1String("&Window") && action->text() == name) {
                    action->trigger();
                    return;
                }
            }
        }
        qFatal("there is no panel %s", qPrintable(name));
    }

    /// All of the screen that the window covers, as PNG where ROMANESCO_SCREENSHOTS names a folder.
    [[nodiscard]] bool keep(const QString &name) const
    {
        QTest::qWait(300); // for what fades in
        const QPixmap seen = window.screen()->grabWindow(0, 0, 0, 1280, 800);
        const QString kept = qEnvironmentVariable("ROMANESCO_SCREENSHOTS");
        if (!kept.isEmpty() && !seen.save(QDir(kept).filePath(name + QStringLiteral(".png")))) {
            qWarning("cannot write %s", qPrintable(name));
            return false;
        }
        return hasContent(seen.toImage());
    }

    /// Neither empty nor of one colour.
    [[nodiscard]] static bool hasContent(const QImage &image)
    {
        QSet<QRgb> colours;
        for (int y = 0; y < image.height(); y += 3) {
            for (int x = 0; x < image.width(); x += 3) {
                colours.insert(image.pixel(x, y));
            }
        }
        return colours.size() > 200;
    }
};

}

/// The main states of the window, as they are kept in docs/window (HACKING says how).
class TestScreenshots : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void first();
    void error();
    void completion();
    void address();
    void exporting();
    void scene();
    void physics();
    void measure();
    void dark();
};

void TestScreenshots::first()
{
    const Scenery scenery;
    QVERIFY(scenery.waits);
    QVERIFY(scenery.keep(QStringLiteral("first")));
}

void TestScreenshots::error()
{
    Scenery scenery;
    QVERIFY(scenery.waits);
    scenery.placeCursorAt(QStringLiteral("lean, half"));
    QTest::keyClicks(&scenery.editor, QStringLiteral("x"));
    QVERIFY(scenery.waitForStrip(true));
    QVERIFY(squiggles(scenery.editor) >= 1);
    scenery.trigger(QStringLiteral("Put Right…"));
    QVERIFY(scenery.keep(QStringLiteral("error")));
}

void TestScreenshots::completion()
{
    Scenery scenery;
    QVERIFY(scenery.waits);
    scenery.placeCursorAt(QStringLiteral("lean, half"));
    scenery.trigger(QStringLiteral("Complete"));
    const auto *popup = scenery.editor.findChild<CompletionPopup *>();
    QVERIFY(popup);
    QVERIFY(scenery.keep(QStringLiteral("completion")));
}

void TestScreenshots::address()
{
    Scenery scenery;
    QVERIFY(scenery.waits);
    QTest::mouseClick(&scenery.viewport, Qt::LeftButton, {}, scenery.viewport.rect().center());
    QListWidget &list = *scenery.window.findChild<AddressPane *>()->findChild<QListWidget *>();
    QVERIFY(QTest::qWaitFor([&] { return list.count() > 0; }, 20'000));
    scenery.window.findChild<QDockWidget *>(QStringLiteral("address"))->raise();
    QVERIFY(scenery.waitForPicture());
    QVERIFY(scenery.keep(QStringLiteral("address")));
}

void TestScreenshots::exporting()
{
    qputenv("HOME", "/tmp"); // a picture of nobody's folders
    Scenery scenery;
    QVERIFY(scenery.waits);
    scenery.trigger(QStringLiteral("Export…"));
    const auto *dialog = scenery.window.findChild<ExportDialog *>();
    QVERIFY(dialog);
    QVERIFY(QTest::qWaitFor([&] { return dialog->isEstimated(); }, 20'000));
    QVERIFY(scenery.keep(QStringLiteral("export")));
}

void TestScreenshots::scene()
{
    Scenery scenery;
    QVERIFY(scenery.window.openFile(QStringLiteral(":/examples/terrain.sdo")));
    scenery.drawn = 0;
    QVERIFY(scenery.waitForPicture());
    QVERIFY(scenery.keep(QStringLiteral("scene")));
}

void TestScreenshots::physics()
{
    Scenery scenery;
    QVERIFY(scenery.window.openFile(QStringLiteral(":/examples/terrain.sdo")));
    scenery.drawn = 0;
    QVERIFY(scenery.waitForPicture());
    scenery.window.findChild<QDockWidget *>(QStringLiteral("physics"))->raise();
    scenery.trigger(QStringLiteral("Rain"));
    scenery.trigger(QStringLiteral("Rain"));
    const auto *balls = scenery.window.findChild<BallModel *>();
    QVERIFY(QTest::qWaitFor([&] { return balls->rowCount() == 204; }, 20'000));
    // a while later they are everywhere
    QTest::qWait(1'000);
    scenery.trigger(QStringLiteral("Play"));
    QVERIFY(scenery.waitForPicture());
    QVERIFY(scenery.keep(QStringLiteral("physics")));
}

void TestScreenshots::measure()
{
    Scenery scenery;
    QVERIFY(scenery.window.openFile(QStringLiteral(":/examples/tree.fdo")));
    scenery.drawn = 0;
    QVERIFY(scenery.waitForPicture());
    scenery.openPanel(QStringLiteral("Measure"));
    QSignalSpy finished(scenery.window.findChild<MeasureController *>(), &MeasureController::finished);
    auto *view = scenery.window.findChild<MeasureView *>();
    Q_EMIT view->measureRequested();
    auto *table = view->findChild<QTableView *>();
    // the colliders come first, and the rest is not seen here
    QVERIFY(QTest::qWaitFor([&] { return table->model()->rowCount() > 0; }, 240'000));
    Q_EMIT view->cancelRequested();
    QVERIFY(!finished.isEmpty() || finished.wait(60'000));
    table->selectRow(5);
    QVERIFY(scenery.waitForPicture());
    QVERIFY(scenery.keep(QStringLiteral("measure")));
}

void TestScreenshots::dark()
{
    applyAppearance(Preferences::Appearance::Dark);
    {
        const Scenery scenery;
        QVERIFY(scenery.waits);
        scenery.window.findChild<QDockWidget *>(QStringLiteral("parameters"))->raise();
        QVERIFY(scenery.editor.palette().color(QPalette::Base).lightness() < 80);
        QVERIFY(scenery.keep(QStringLiteral("dark")));
    }
    applyAppearance(Preferences::Appearance::System);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestScreenshots>(argc, argv);
}
#include "testscreenshots.moc"
