// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QMenu>
#include <QMenuBar>
#include <QSet>

#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

/// The active window, of which keys are all that is known.
struct KeyboardSample : Sample {
    bool isActive = false;

    KeyboardSample()
    {
        window.activateWindow();
        isActive = QTest::qWaitForWindowActive(&window) && waitForPicture();
    }
    static void press(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key(key), modifiers);
    }
    static void type(const QString &text) { QTest::keyClicks(QApplication::focusWidget(), text); }
};

bool isWaitingForKeys(const QWidget &widget)
{
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.isEnabled() && !widget.focusProxy()
        && !widget.visibleRegion().isEmpty();
}

}

/// Nothing needs a mouse.
class TestKeyboard : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void partsGoRound();
    void everythingIsReached();
    void aFractalIsWrittenAndLookedAt();
    void everyActionIsInAMenu();
};

void TestKeyboard::partsGoRound()
{
    const KeyboardSample sample;
    QVERIFY(sample.isActive);
    QCOMPARE(QApplication::focusWidget(), &sample.editor);
    KeyboardSample::press(Qt::Key_F7);
    QCOMPARE(QApplication::focusWidget(), &sample.viewport);
    KeyboardSample::press(Qt::Key_F7);
    QCOMPARE(QApplication::focusWidget(), &sample.problems);
    KeyboardSample::press(Qt::Key_F7, Qt::ShiftModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.viewport);
    KeyboardSample::press(Qt::Key_F7, Qt::ShiftModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.editor);
    KeyboardSample::press(Qt::Key_F7, Qt::ShiftModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.problems);
    KeyboardSample::press(Qt::Key_F7);
    QCOMPARE(QApplication::focusWidget(), &sample.editor);
}

/// In the editor Tab is a character, everywhere else it leads on.
void TestKeyboard::everythingIsReached()
{
    KeyboardSample sample;
    QVERIFY(sample.isActive);
    QSet<const QWidget *> reached;
    for (int i = 0; i < 100; ++i) {
        const QWidget *now = QApplication::focusWidget();
        QVERIFY(now);
        reached << now;
        KeyboardSample::press(now == &sample.editor ? Qt::Key_F7 : Qt::Key_Tab);
    }
    for (const QWidget *widget : sample.window.findChildren<QWidget *>()) {
        if (isWaitingForKeys(*widget)) {
            QVERIFY2(
                reached.contains(widget),
                qPrintable(QString::fromLatin1(widget->metaObject()->className()) + u' ' + widget->accessibleName()));
        }
    }
}

/// From a new text to a picture that has been turned, with a slip that is put right on the way.
void TestKeyboard::aFractalIsWrittenAndLookedAt()
{
    KeyboardSample sample;
    QVERIFY(sample.isActive);
    QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), sample.path(QStringLiteral("cube.obj"))));
    QVERIFY(
        sample.window.openFile(sample.write(QStringLiteral("keys.fdo"), "v 3 0 0\nx. \"cube.obj\"\nt.p. (p, #, #)\n")));
    KeyboardSample::press(Qt::Key_End, Qt::ControlModifier);
    KeyboardSample::type(QStringLiteral("<$>. [t.1, #] xx"));
    KeyboardSample::press(Qt::Key_Escape); // no completion
    QVERIFY(sample.waitForStrip(true));
    KeyboardSample::press(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.editor);
    KeyboardSample::press(Qt::Key_End);
    KeyboardSample::press(Qt::Key_Backspace);
    KeyboardSample::press(Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return sample.drawn == 2 && sample.viewport.isPictureFinished(); }, 60'000));
    QCOMPARE(sample.strip(), QString());
    KeyboardSample::press(Qt::Key_F7);
    const Camera before = sample.viewport.camera();
    KeyboardSample::press(Qt::Key_Right);
    QVERIFY(!(sample.viewport.camera() == before));
    KeyboardSample::press(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(QTest::qWaitFor([&] { return !sample.window.isWindowModified(); }, 20'000));
    QVERIFY(Sample::read(sample.path(QStringLiteral("keys.fdo"))).endsWith("[t.1, #] x"));
}

/// Where F10 and Alt lead.
void TestKeyboard::everyActionIsInAMenu()
{
    const KeyboardSample sample;
    QSet<const QAction *> listed;
    QList<QMenu *> menus = sample.window.menuBar()->findChildren<QMenu *>();
    for (const QAction *top : sample.window.menuBar()->actions()) {
        QVERIFY2(top->text().contains(u'&'), qPrintable(top->text()));
        menus << top->menu();
    }
    for (const QMenu *menu : menus) {
        for (const QAction *action : menu->actions()) {
            listed << action;
        }
    }
    const auto own = sample.window.findChildren<QAction *>(Qt::FindDirectChildrenOnly);
    QVERIFY(own.size() > 40);
    for (const QAction *action : own + sample.viewport.actions()) {
        QVERIFY2(listed.contains(action), qPrintable(action->text()));
    }
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestKeyboard>(argc, argv);
}
#include "testkeyboard.moc"
