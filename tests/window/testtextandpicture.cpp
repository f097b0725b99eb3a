// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include "app/window/statusline.h"
#include "windowsample.h"

using namespace romanesco;
using romanesco::test::squiggles;
using Sample = romanesco::test::WindowSample;

/// What is seen beside the text follows it: the picture, the problems, the slider.
class TestTextAndPicture : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theExampleIsDrawn();
    void anErrorIsShownAndThePictureStays();
    void theStripLeadsToTheError();
    void theProblemsListLeadsToTheText();
    void theSliderEditsTheText();
    void undoMovesTheSlider();
    void aFileWithErrorsHasNoPictureOfTheLastFile();
    void nothingOfAFilesTroubleStaysWithTheNext();
    void thousandsOfProblemsAreCutShort();
    void deepFractalsOfOneSizeLeaveTheWindowAlive();
    void renumberingIsOneClickAway();
    void renumberingIsDeclinedByItsCross();
};

void TestTextAndPicture::theExampleIsDrawn()
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

void TestTextAndPicture::anErrorIsShownAndThePictureStays()
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

void TestTextAndPicture::theStripLeadsToTheError()
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

void TestTextAndPicture::theProblemsListLeadsToTheText()
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

void TestTextAndPicture::theSliderEditsTheText()
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

void TestTextAndPicture::undoMovesTheSlider()
{
    Sample sample;
    QVERIFY(sample.waitForPicture());
    auto &slider = sample.depthSlider();
    slider.setValue(1);
    sample.editor.undo();
    QVERIFY(QTest::qWaitFor([&] { return slider.value() == 2; }, 20'000));
}

void TestTextAndPicture::aFileWithErrorsHasNoPictureOfTheLastFile()
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
void TestTextAndPicture::nothingOfAFilesTroubleStaysWithTheNext()
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

void TestTextAndPicture::thousandsOfProblemsAreCutShort()
{
    Sample sample;
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("a.fdo"), QByteArray("1,2,3\n").repeated(20'000))));
    QVERIFY(sample.waitForStrip(true));
    QCOMPARE(sample.problems.topLevelItemCount(), 1'001);
    QVERIFY(sample.problems.topLevelItem(1'000)->text(1).contains(QStringLiteral("19001")));
    QCOMPARE(squiggles(sample.editor), 1'000);
}

/// 2^60000 copies of one size, nearly all out of sight: the walk has no end, but the text can still be changed.
void TestTextAndPicture::deepFractalsOfOneSizeLeaveTheWindowAlive()
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

void TestTextAndPicture::renumberingIsOneClickAway()
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

void TestTextAndPicture::renumberingIsDeclinedByItsCross()
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

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestTextAndPicture>(argc, argv);
}
#include "testtextandpicture.moc"
