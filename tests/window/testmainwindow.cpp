// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QSplitter>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include "app/window/statusline.h"
#include "windowsample.h"

using namespace romanesco;
using romanesco::test::squiggles;
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

class TestMainWindow : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theExampleIsDrawn();
    void anErrorIsShownAndThePictureStays();
    void theStripLeadsToTheError();
    void theProblemsListLeadsToTheText();
    void theSliderEditsTheText();
    void undoMovesTheSlider();
    void viewportKeysNeedTheFocus();
    void unsavedTextIsAskedFor();
    void anUnreadableFileIsAMessage_data();
    void anUnreadableFileIsAMessage();
    void aFileWithErrorsHasNoPictureOfTheLastFile();
    void nothingOfAFilesTroubleStaysWithTheNext();
    void thousandsOfProblemsAreCutShort();
    void deepFractalsOfOneSizeLeaveTheWindowAlive();
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
    void renumberingIsOneClickAway();
    void renumberingIsDeclinedByItsCross();
    void noTwoActionsHaveOneKey();
    void panelsComeForward();
};

void TestMainWindow::theExampleIsDrawn()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const QImage picture = sample.viewport.grabFramebuffer();
    const QRgb corner = picture.pixel(2, picture.height() / 2);
    int different = 0;
    for (int x = 0; x < picture.width(); ++x) {
        different += picture.pixel(x, picture.height() / 2) != corner ? 1 : 0;
    }
    QVERIFY(different > picture.width() / 4);
    QCOMPARE(sample.problems.topLevelItemCount(), 0);
    QCOMPARE(sample.strip(), QString());
    const auto hasNumbers = [&] {
        for (const QLabel *label : sample.window.findChild<StatusLine *>()->findChildren<QLabel *>()) {
            if (label->text().contains(QStringLiteral("9,409 distinct"))) {
                return true;
            }
        }
        return false;
    };
    QVERIFY(QTest::qWaitFor(hasNumbers, 20'000));
}

void TestMainWindow::anErrorIsShownAndThePictureStays()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const QImage before = sample.viewport.grabFramebuffer();
    sample.placeCursorAt(QStringLiteral("lean, half"));
    QTest::keyClicks(&sample.editor, QStringLiteral("x"));
    QVERIFY(sample.waitForStrip(true));
    QCOMPARE(sample.strip(),
             QStringLiteral("Showing the last good version — line 14: no vector named xlean is "
                            "declared above"));
    QVERIFY(sample.problems.topLevelItemCount() >= 1);
    QVERIFY(sample.problems.topLevelItem(0)->text(0).startsWith(QStringLiteral("romanesco.fdo:14:")));
    QVERIFY(squiggles(sample.editor) >= 1);
    QVERIFY(sample.waitForPicture());
    QCOMPARE(sample.viewport.grabFramebuffer(), before);

    QTest::keyClick(&sample.editor, Qt::Key_Backspace);
    QVERIFY(sample.waitForStrip(false));
    QCOMPARE(squiggles(sample.editor), 0);
    QCOMPARE(sample.problems.topLevelItemCount(), 0);
}

void TestMainWindow::theStripLeadsToTheError()
{
    Sample sample;
    sample.placeCursorAt(QStringLiteral("lean, half"));
    QTest::keyClicks(&sample.editor, QStringLiteral("x"));
    QVERIFY(sample.waitForStrip(true));
    sample.editor.moveCursor(QTextCursor::Start);
    QTest::mouseClick(&sample.pane.strip(), Qt::LeftButton);
    QTextCursor cursor = sample.editor.textCursor();
    QCOMPARE(cursor.blockNumber(), 13);
    cursor.movePosition(QTextCursor::NextWord, QTextCursor::KeepAnchor);
    QCOMPARE(cursor.selectedText(), QStringLiteral("xlean"));
}

void TestMainWindow::theProblemsListLeadsToTheText()
{
    Sample sample;
    sample.placeCursorAt(QStringLiteral("lean, half"));
    QTest::keyClicks(&sample.editor, QStringLiteral("x"));
    QVERIFY(sample.waitForStrip(true));
    sample.editor.moveCursor(QTextCursor::Start);
    const QRect row = sample.problems.visualItemRect(sample.problems.topLevelItem(0));
    QTest::mouseClick(sample.problems.viewport(), Qt::LeftButton, {}, row.center());
    QCOMPARE(sample.editor.textCursor().blockNumber(), 13);
}

void TestMainWindow::theSliderEditsTheText()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const QString original = sample.editor.toPlainText();
    auto &slider = sample.depthSlider();
    QVERIFY(slider.isEnabled());
    QCOMPARE(slider.value(), 2);
    slider.setSliderDown(true);
    for (const int depth : {3, 4, 1}) {
        slider.setValue(depth);
    }
    slider.setSliderDown(false);
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("<$>. head 1\n")));
    QVERIFY(!sample.viewport.isPictureFinished()
            || QTest::qWaitFor([&] { return !sample.viewport.isPictureFinished(); }, 20'000));
    QVERIFY(sample.waitForPicture());
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText(), original);
}

void TestMainWindow::undoMovesTheSlider()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    auto &slider = sample.depthSlider();
    slider.setValue(1);
    sample.editor.undo();
    QVERIFY(QTest::qWaitFor([&] { return slider.value() == 2; }, 20'000));
}

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

void TestMainWindow::aFileWithErrorsHasNoPictureOfTheLastFile()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), "<$>. rigt\n")));
    QVERIFY(sample.waitForStrip(true));
    QVERIFY(sample.strip().startsWith(QStringLiteral("No picture yet — line 1:")));
    QVERIFY(!sample.depthSlider().isEnabled());
    QVERIFY(sample.waitForEmptyPicture());
    const QImage picture = sample.viewport.grabFramebuffer();
    QVERIFY(qGray(picture.pixel(picture.rect().center())) < 60);
}

/// At once, not when the next file is built.
void TestMainWindow::nothingOfAFilesTroubleStaysWithTheNext()
{
    Sample sample;
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), "<$>. rigt\n")));
    QVERIFY(sample.waitForStrip(true));
    QCOMPARE(squiggles(sample.editor), 1);
    QCOMPARE(sample.problems.topLevelItemCount(), 1);
    sample.window.openExample();
    QCOMPARE(sample.strip(), QString());
    QCOMPARE(squiggles(sample.visibleEditor()), 0);
    QCOMPARE(sample.problems.topLevelItemCount(), 0);
}

void TestMainWindow::thousandsOfProblemsAreCutShort()
{
    Sample sample;
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), QByteArray("1,2,3\n").repeated(20'000))));
    QVERIFY(sample.waitForStrip(true));
    QCOMPARE(sample.problems.topLevelItemCount(), 1'001);
    QVERIFY(sample.problems.topLevelItem(1'000)->text(1).contains(QStringLiteral("19001")));
    QCOMPARE(squiggles(sample.editor), 1'000);
}

/// 2^60000 copies of one size, nearly all out of sight: the walk has no end, but the text can still be changed.
void TestMainWindow::deepFractalsOfOneSizeLeaveTheWindowAlive()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    const QByteArray text = "v 1 0 0\nv 0 1 0\nx. \"cube.obj\"\nk.p. (p, #, #)\nz<x>. [k.1, k.2] x\n<$>. z 60000\n";
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), text)));
    QVERIFY(QTest::qWaitFor([&] { return sample.depthSlider().isEnabled(); }, 20'000));
    for (int i = 0; i < 50; ++i) {
        QCoreApplication::processEvents();
    }
    QVERIFY(!sample.viewport.isPictureFinished());
    // In one edit, so that the only picture that can be finished is that of the new text.
    sample.editor.setTextCursor(sample.editor.document()->find(QStringLiteral("60000")));
    QTest::keyClicks(&sample.editor, QStringLiteral("2"));
    QVERIFY(sample.waitForPicture());
    sample.viewport.resetView();
    QVERIFY(QTest::qWaitFor([&] { return sample.drawn == 4 && sample.viewport.isPictureFinished(); }, 60'000));
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

void TestMainWindow::renumberingIsOneClickAway()
{
    Sample sample;
    const QByteArray text = "v 1 0 0\nv 2 0 0\nx. \"cube.obj\"\nt.p. (p, #, #)\n<$>. [t.2] x\n";
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), text)));
    QTextCursor cursor(sample.editor.document());
    cursor.insertText(QStringLiteral("v 0 5 0\n"));
    QVERIFY(QTest::qWaitFor([&] { return sample.message().contains(QStringLiteral("Ctrl+Shift+R")); }, 20'000));
    for (MessageStrip *strip : sample.window.findChildren<MessageStrip *>()) {
        if (strip->isVisible() && strip != &sample.pane.strip()) {
            QTest::mouseClick(strip, Qt::LeftButton);
        }
    }
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("[t.3] x")));
    QCOMPARE(sample.message(), QString());
    sample.editor.undo();
    QCOMPARE(sample.editor.toPlainText().toUtf8(), text);
}

void TestMainWindow::renumberingIsDeclinedByItsCross()
{
    Sample sample;
    const QByteArray text = "v 1 0 0\nv 2 0 0\nx. \"cube.obj\"\nt.p. (p, #, #)\n<$>. [t.2] x\n";
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), text)));
    QTextCursor(sample.editor.document()).insertText(QStringLiteral("v 0 5 0\n"));
    QVERIFY(QTest::qWaitFor([&] { return sample.message().contains(QStringLiteral("Ctrl+Shift+R")); }, 20'000));
    QCOMPARE(sample.editor.renumberingCount(), 1);
    for (const MessageStrip *strip : sample.window.findChildren<MessageStrip *>()) {
        if (strip->isVisible() && strip != &sample.pane.strip()) {
            QTest::mouseClick(strip->findChild<QToolButton *>(), Qt::LeftButton);
        }
    }
    QCOMPARE(sample.editor.renumberingCount(), 0);
    QCOMPARE(sample.message(), QString());
    QTest::keyClick(&sample.editor, Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(sample.editor.toPlainText().contains(QStringLiteral("[t.2] x")));
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
