// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QToolBar>

#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

/// Presses a button of the next question. Whether there was one is found in wasAsked.
void answerNextQuestion(QMessageBox::StandardButton button, bool &wasAsked)
{
    auto *timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, button, &wasAsked] {
        if (auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget())) {
            wasAsked = true;
            timer->deleteLater();
            box->button(button)->click();
        }
    });
    timer->start(10);
}

}

/// The window itself: files, layout, panels and keys.
class TestMainWindow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void viewportKeysNeedTheFocus();
    void unsavedTextIsAskedFor();
    void anUnreadableFileIsAMessage_data();
    void anUnreadableFileIsAMessage();
    void aSavedExampleBringsItsMesh();
    void aFailedSaveIsAMessage();
    void theTitleNamesTheFile();
    void droppedFilesAreOpened();
    void theLayoutIsRemembered();
    void theLayoutIsReset();
    void buttonsTellTheirKeys();
    void keysReachTheText_data();
    void keysReachTheText();
    void aPathLeadsToItsFile();
    void noTwoActionsHaveOneKey();
    void panelsComeForward();
};

void TestMainWindow::viewportKeysNeedTheFocus()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&sample.window));
    sample.editor.setFocus();
    QTest::keyClick(&sample.editor, Qt::Key_5);
    QVERIFY(sample.editor.toPlainText().startsWith(u'5'));
    QCOMPARE(sample.viewport.camera().projection, Projection::Perspective);
    // A widget that has no use for the key does not pass it on to the viewport either.
    sample.problems.setFocus();
    QTest::keyClick(&sample.problems, Qt::Key_5);
    QCOMPARE(sample.viewport.camera().projection, Projection::Perspective);

    sample.viewport.setFocus();
    QTest::keyClick(&sample.viewport, Qt::Key_5);
    QCOMPARE(sample.viewport.camera().projection, Projection::Orthographic);
    QTest::keyClick(&sample.viewport, Qt::Key_1);
    QCOMPARE(sample.viewport.camera().worldFromCamera[2].z, 1.0);
    QVERIFY(sample.editor.toPlainText().startsWith(QStringLiteral("5#")));
}

void TestMainWindow::unsavedTextIsAskedFor()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "# a\r\n");
    QVERIFY(sample.window.openFile(path));
    QTest::keyClicks(&sample.editor, QStringLiteral("x"));
    QVERIFY(sample.window.isWindowModified());

    bool wasAsked = false;
    answerNextQuestion(QMessageBox::Cancel, wasAsked);
    QVERIFY(!sample.window.close());
    QVERIFY(wasAsked && sample.window.isVisible());
    QCOMPARE(Sample::read(path), QByteArray("# a\r\n"));

    wasAsked = false;
    answerNextQuestion(QMessageBox::Save, wasAsked);
    QVERIFY(sample.window.close());
    QVERIFY(wasAsked);
    QCOMPARE(Sample::read(path), QByteArray("x# a\r\n"));
}

void TestMainWindow::anUnreadableFileIsAMessage_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("words");
    QTest::newRow("missing") << QStringLiteral("missing.fdo") << QStringLiteral("no such file");
    QTest::newRow("not UTF-8") << QStringLiteral("latin.fdo") << QStringLiteral("not UTF-8");
}

void TestMainWindow::anUnreadableFileIsAMessage()
{
    QFETCH(const QString, name);
    QFETCH(const QString, words);
    Sample sample;
    const QByteArray latin("# gr\xF6\xDF"
                           "er\n");
    const QString latinPath = sample.write(QStringLiteral("latin.fdo"), latin);
    QVERIFY(!sample.window.openFile(sample.path(name)));
    QVERIFY2(sample.message().contains(words), qPrintable(sample.message()));
    QVERIFY(sample.editor.toPlainText().startsWith(QStringLiteral("# Romanesco")));
    // The program then opens its example, and the message is still to be read.
    sample.window.openExample();
    QVERIFY(sample.message().contains(words));
    QCOMPARE(Sample::read(latinPath), latin);
}

void TestMainWindow::aSavedExampleBringsItsMesh()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.window.saveFile(sample.path(QStringLiteral("mine.fdo"))));
    QVERIFY(QFile::exists(sample.path(QStringLiteral("bud.obj"))));
    QVERIFY(sample.window.windowTitle().startsWith(QStringLiteral("mine.fdo")));
    QVERIFY(sample.waitForPicture());
    QTest::qWait(0);
    QCOMPARE(sample.strip(), QString());
}

void TestMainWindow::aFailedSaveIsAMessage()
{
    Sample sample;
    QTest::keyClicks(&sample.editor, QStringLiteral("# "));
    QVERIFY(!sample.window.saveFile(sample.path(QStringLiteral("no/such/folder/a.fdo"))));
    QVERIFY(sample.message().startsWith(QStringLiteral("Cannot save")));
    QVERIFY(sample.window.isWindowModified());
    bool wasAsked = false;
    answerNextQuestion(QMessageBox::Discard, wasAsked);
    QVERIFY(sample.window.close());
}

void TestMainWindow::theTitleNamesTheFile()
{
    Sample sample;
    QCOMPARE(sample.window.windowTitle(), QStringLiteral("romanesco.fdo[*] — Romanesco"));
    QVERIFY(!sample.window.isWindowModified());
    QTest::keyClicks(&sample.editor, QStringLiteral("#"));
    QVERIFY(sample.window.isWindowModified());
    sample.editor.undo();
    QVERIFY(!sample.window.isWindowModified());
}

void TestMainWindow::droppedFilesAreOpened()
{
    Sample sample;
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(sample.write(QStringLiteral("a.fdo"), "# dropped\n"))});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &files, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&sample.window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &files, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&sample.window, &drop);
    QCOMPARE(sample.editor.toPlainText(), QStringLiteral("# dropped\n"));
}

void TestMainWindow::theLayoutIsRemembered()
{
    {
        Sample sample;
        sample.window.resize(800, 450);
        QVERIFY(QTest::qWaitForWindowExposed(&sample.window));
        QVERIFY(sample.window.close());
    }
    MainWindow again;
    QCOMPARE(again.size(), QSize(800, 450));
}

void TestMainWindow::theLayoutIsReset()
{
    Sample sample;
    QVERIFY(QTest::qWaitForWindowExposed(&sample.window));
    const auto actionNamed = [&](const QString &text) -> QAction * {
        for (QAction *action : sample.window.findChildren<QAction *>()) {
            if (action->text() == text) {
                return action;
            }
        }
        return nullptr;
    };
    QAction *reset = actionNamed(QStringLiteral("&Reset Layout"));
    QVERIFY(reset);
    reset->trigger();
    const QList<QDockWidget *> docks = sample.window.findChildren<QDockWidget *>();
    QSplitter &splitter = *sample.window.findChild<QSplitter *>();
    QCoreApplication::processEvents();
    const QList<int> sizes = splitter.sizes();
    // The one that lies uppermost, over all the width.
    const QDockWidget &problems = *sample.window.findChild<QDockWidget *>(QStringLiteral("problems"));
    const auto isAcross = [&] { return problems.width() == sample.window.width(); };
    QVERIFY2(QTest::qWaitFor(isAcross), qPrintable(QString::number(problems.width())));
    const int height = problems.height();

    docks[0]->setFloating(true);
    docks[1]->hide();
    sample.window.addDockWidget(Qt::LeftDockWidgetArea, docks[2]);
    sample.window.findChild<QToolBar *>()->hide();
    splitter.setSizes({100, 700});
    QCoreApplication::processEvents();
    reset->trigger();
    QCoreApplication::processEvents();
    // All are tabs below, but for the one that is closed until it is wanted, and is one then.
    QDockWidget *closed = sample.window.findChild<QDockWidget *>(QStringLiteral("measure"));
    for (QDockWidget *dock : docks) {
        QVERIFY(!dock->isFloating());
        QCOMPARE(dock->isHidden(), dock == closed);
        QCOMPARE(sample.window.dockWidgetArea(dock), Qt::BottomDockWidgetArea);
    }
    closed->show();
    QCOMPARE(sample.window.tabifiedDockWidgets(closed).size(), docks.size() - 1);
    closed->hide();
    QVERIFY(sample.window.findChild<QToolBar *>()->isVisible());
    QVERIFY(QTest::qWaitFor(isAcross));
    QCOMPARE(problems.height(), height);
    QCOMPARE(splitter.sizes(), sizes);
}

void TestMainWindow::buttonsTellTheirKeys()
{
    Sample sample;
    for (const QAction *action : sample.window.findChild<QToolBar *>()->actions()) {
        const bool isButton = !action->isSeparator() && !action->text().isEmpty();
        QVERIFY2(!isButton || action->toolTip().contains(u'('), qPrintable(action->text()));
    }
}

void TestMainWindow::keysReachTheText_data()
{
    QTest::addColumn<QKeySequence>("key");
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("after");
    const QString vectors = QStringLiteral("v 1 0 0\nv  2 0 0\n");
    QTest::newRow("comment") << QKeySequence(Qt::CTRL | Qt::Key_Slash) << vectors << "# v 1 0 0\nv  2 0 0\n";
    QTest::newRow("duplicate") << QKeySequence(Qt::CTRL | Qt::Key_D) << vectors << "v 1 0 0\nv 1 0 0\nv  2 0 0\n";
    QTest::newRow("tidy") << QKeySequence(Qt::CTRL | Qt::Key_I) << "v  2 0 0\n" << "v 2 0 0\n";
}

void TestMainWindow::keysReachTheText()
{
    QFETCH(const QKeySequence, key);
    QFETCH(const QString, before);
    QFETCH(const QString, after);
    Sample sample;
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), before.toUtf8())));
    sample.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&sample.window));
    sample.editor.setFocus();
    QTest::keySequence(&sample.editor, key);
    QCOMPARE(sample.editor.toPlainText(), after);
    QTest::keySequence(&sample.editor, QKeySequence::Undo);
    QCOMPARE(sample.editor.toPlainText(), before);
}

void TestMainWindow::aPathLeadsToItsFile()
{
    Sample sample;
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    (void)sample.write(QStringLiteral("a.fdo"), "<$>. \"cube.obj\"\n");
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("s.sdo"), "f \"a.fdo\" #\n")));
    sample.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&sample.window));
    sample.editor.setFocus();
    sample.placeCursorAt(QStringLiteral("a.fdo"));
    QTest::keyClick(&sample.editor, Qt::Key_F12);
    QVERIFY(sample.window.windowTitle().startsWith(QStringLiteral("a.fdo")));
    QVERIFY(sample.visibleEditor().toPlainText().startsWith(QStringLiteral("<$>. ")));
}

void TestMainWindow::noTwoActionsHaveOneKey()
{
    const Sample sample;
    QHash<QString, QString> owners;
    for (const QAction *action : sample.window.findChildren<QAction *>()) {
        for (const QKeySequence &key : action->shortcuts()) {
            const QString name = key.toString();
            QVERIFY2(!owners.contains(name), qPrintable(name + u' ' + action->text() + u' ' + owners.value(name)));
            owners.insert(name, action->text());
        }
    }
    QVERIFY(owners.size() > 30);
}

/// One that is behind another is not closed when it is asked for.
void TestMainWindow::panelsComeForward()
{
    const Sample sample;
    QVERIFY(sample.waitForPicture());
    const auto entry = [&](const QString &name) {
        for (QAction *action : sample.window.findChildren<QAction *>()) {
            if (action->text() == name && action->isCheckable() && qobject_cast<QMenu *>(action->parent())) {
                return action;
            }
        }
        qFatal("there is no such entry");
    };
    const auto *dock = sample.window.findChild<QDockWidget *>(QStringLiteral("address"));
    QAction *address = entry(QStringLiteral("Address"));
    const QAction *problems = entry(QStringLiteral("Problems"));
    QVERIFY(!address->isChecked() && problems->isChecked());
    address->trigger();
    QVERIFY(QTest::qWaitFor([&] { return !dock->visibleRegion().isEmpty(); }));
    QVERIFY(address->isChecked() && !problems->isChecked());
    address->trigger();
    QVERIFY(QTest::qWaitFor([&] { return !address->isChecked(); }));
    QVERIFY(!dock->isVisible());
    address->trigger();
    QVERIFY(QTest::qWaitFor([&] { return !dock->visibleRegion().isEmpty(); }));
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestMainWindow>(argc, argv);
}
#include "testmainwindow.moc"
