// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>

#include "app/window/texttab.h"
#include "app/window/texttabs.h"
#include "windowsample.h"

using namespace romanesco;
using romanesco::test::squiggles;
using Sample = romanesco::test::WindowSample;

namespace {

TextTabs &tabsOf(const Sample &sample)
{
    return *sample.window.findChild<TextTabs *>();
}

bool hasNames(const TextTabs &tabs, const QStringList &names)
{
    QStringList found;
    for (int i = 0; i < tabs.count(); ++i) {
        found << tabs.tabText(i);
    }
    if (found != names) {
        qWarning() << found;
    }
    return found == names;
}

/// Texts with meshes of their own.
QString writeCube(const Sample &sample, const QString &name)
{
    const QString cube = sample.path(QStringLiteral("cube.obj"));
    if (!QFile::exists(cube) && !QFile::copy(QStringLiteral(":/examples/cube.obj"), cube)) {
        qFatal("no cube");
    }
    return sample.write(name, "# " + name.toUtf8() + "\n<$>. \"cube.obj\"\n");
}

QString writeBad(const Sample &sample, const QString &name)
{
    return sample.write(name, "<$>. nothing\n");
}

}

/// Several texts in one window.
class TestTextTabs : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { QFile::remove(qEnvironmentVariable("XDG_STATE_HOME") + QStringLiteral("/romanesco/window.ini")); }
    void theExampleMakesRoom();
    void eachTextHasItsOwnPictureAndView();
    void eachTextHasItsOwnProblemsAndUndo();
    void aFileIsOpenOnce();
    void onlyWhatIsLookedAtIsBuilt();
    void theLastTabBecomesAnEmptyText();
    void unsavedTextIsAskedForInItsOwnTab();
    void whatWasOpenIsOpenedAgain();
    void recentFilesAreTheNewestFirst();
    void keysGoRound();
    void whatIsSavedHereIsSeenThere();
    void twoTabsOfOneFileAreRefused();
};

void TestTextTabs::theExampleMakesRoom()
{
    Sample sample;
    const TextTabs &tabs = tabsOf(sample);
    QVERIFY(hasNames(tabs, {QStringLiteral("romanesco.fdo")}));
    QVERIFY(tabs.tabBar()->isHidden());
    MainWindow &window = sample.window;
    QVERIFY(window.openFile(writeCube(sample, QStringLiteral("a.fdo"))));
    QVERIFY(hasNames(tabs, {QStringLiteral("a.fdo")}));
    // A file of one's own does not.
    QVERIFY(window.openFile(writeCube(sample, QStringLiteral("b & c.fdo"))));
    QVERIFY(hasNames(tabs, {QStringLiteral("a.fdo"), QStringLiteral("b && c.fdo")}));
    QVERIFY(tabs.tabBar()->isVisible());
    QVERIFY(!window.openFile(sample.path(QStringLiteral("missing.fdo"))));
    QCOMPARE(tabs.count(), 2);
    QVERIFY2(sample.message().contains(QStringLiteral("no such file")), qPrintable(sample.message()));
}

void TestTextTabs::eachTextHasItsOwnPictureAndView()
{
    Sample sample;
    TextTabs &tabs = tabsOf(sample);
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("a.fdo"))));
    QVERIFY(sample.waitForPicture());
    QTest::keyClick(&sample.viewport, Qt::Key_Right);
    QVERIFY(sample.waitForPicture());
    const Camera turned = sample.viewport.camera();
    QVERIFY(sample.window.openFile(QStringLiteral(":/examples/sierpinski.fdo")));
    QVERIFY(QTest::qWaitFor([&] { return sample.drawn > 100 && sample.viewport.isPictureFinished(); }, 60'000));
    QVERIFY(!(sample.viewport.camera() == turned));
    const Camera other = sample.viewport.camera();
    tabs.setCurrentIndex(0);
    QVERIFY(sample.viewport.camera() == turned);
    QVERIFY(QTest::qWaitFor([&] { return sample.drawn == 1 && sample.viewport.isPictureFinished(); }, 60'000));
    QCOMPARE(sample.window.windowTitle(), QStringLiteral("a.fdo[*] — Romanesco"));
    tabs.setCurrentIndex(1);
    QVERIFY(sample.viewport.camera() == other);
    QVERIFY(QTest::qWaitFor([&] { return sample.drawn > 100 && sample.viewport.isPictureFinished(); }, 60'000));
}

void TestTextTabs::eachTextHasItsOwnProblemsAndUndo()
{
    Sample sample;
    TextTabs &tabs = tabsOf(sample);
    QVERIFY(sample.window.openFile(writeBad(sample, QStringLiteral("a.fdo"))));
    QVERIFY(sample.waitForStrip(true));
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("b.fdo"))));
    QCOMPARE(sample.strip(), QString());
    QCOMPARE(sample.problems.topLevelItemCount(), 0);
    QVERIFY(sample.waitForPicture());
    QTest::keyClicks(&sample.visibleEditor(), QStringLiteral("# "));
    QVERIFY(hasNames(tabs, {QStringLiteral("a.fdo"), QStringLiteral("b.fdo •")}));
    QVERIFY(sample.window.isWindowModified());
    tabs.setCurrentIndex(0);
    QVERIFY(!sample.window.isWindowModified());
    QVERIFY(sample.waitForStrip(true));
    QCOMPARE(sample.problems.topLevelItemCount(), 1);
    QCOMPARE(squiggles(sample.visibleEditor()), 1);
    // What is typed here does not reach the other.
    QTest::keyClicks(&sample.visibleEditor(), QStringLiteral("#"));
    sample.visibleEditor().undo();
    QVERIFY(!tabs.tab(0).document().isModified() && tabs.tab(1).document().isModified());
    tabs.setCurrentIndex(1);
    sample.visibleEditor().undo();
    QVERIFY(!sample.window.isWindowModified());
}

void TestTextTabs::aFileIsOpenOnce()
{
    Sample sample;
    TextTabs &tabs = tabsOf(sample);
    const QString a = writeCube(sample, QStringLiteral("a.fdo"));
    QVERIFY(sample.window.openFile(a));
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("b.fdo"))));
    QTest::keyClicks(&tabs.tab(0).editor(), QStringLiteral("x"));
    QVERIFY(QFile::link(a, sample.path(QStringLiteral("link.fdo"))));
    QVERIFY(sample.window.openFile(sample.path(QStringLiteral("link.fdo"))));
    QCOMPARE(tabs.count(), 2);
    QCOMPARE(tabs.currentIndex(), 0);
    QVERIFY(sample.visibleEditor().toPlainText().startsWith(u'x'));
    sample.visibleEditor().undo();
}

void TestTextTabs::onlyWhatIsLookedAtIsBuilt()
{
    Sample sample;
    TextTabs &tabs = tabsOf(sample);
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("a.fdo"))));
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("b.fdo"))));
    QVERIFY(sample.waitForPicture());
    const quint64 revision = tabs.tab(0).preview().revision;
    QTest::keyClicks(&tabs.tab(0).editor(), QStringLiteral("# more"));
    QTest::qWait(200);
    QCOMPARE(tabs.tab(0).preview().revision, revision);
    tabs.setCurrentIndex(0);
    QVERIFY(QTest::qWaitFor([&] { return tabs.tab(0).preview().revision > revision; }, 20'000));
    QVERIFY(tabs.tab(0).preview().text.bytes().starts_with("# more"));
    tabs.tab(0).editor().undo();
}

void TestTextTabs::theLastTabBecomesAnEmptyText()
{
    Sample sample;
    TextTabs &tabs = tabsOf(sample);
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("a.fdo"))));
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("b.fdo"))));
    QVERIFY(tabs.closeTab(0));
    QVERIFY(hasNames(tabs, {QStringLiteral("b.fdo")}));
    QVERIFY(sample.waitForPicture());
    QVERIFY(tabs.closeTab(0));
    QVERIFY(hasNames(tabs, {QStringLiteral("untitled.fdo")}));
    QCOMPARE(sample.visibleEditor().toPlainText(), QString());
    QVERIFY(sample.waitForEmptyPicture());
}

void TestTextTabs::unsavedTextIsAskedForInItsOwnTab()
{
    Sample sample;
    TextTabs &tabs = tabsOf(sample);
    const QString a = writeCube(sample, QStringLiteral("a.fdo"));
    QVERIFY(sample.window.openFile(a));
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("b.fdo"))));
    QTest::keyClicks(&tabs.tab(0).editor(), QStringLiteral("x"));
    QString question;
    int shown = -1;
    auto *timer = new QTimer(&sample.window);
    connect(timer, &QTimer::timeout, timer, [&, timer] {
        if (auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget())) {
            question = box->text();
            shown = tabs.currentIndex();
            timer->stop();
            box->button(QMessageBox::Save)->click();
        }
    });
    timer->start(10);
    QVERIFY(sample.window.close());
    QVERIFY2(question.contains(QStringLiteral("a.fdo")), qPrintable(question));
    QCOMPARE(shown, 0);
    QVERIFY(Sample::read(a).startsWith('x'));
}

void TestTextTabs::whatWasOpenIsOpenedAgain()
{
    Sample sample;
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("a.fdo"))));
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("b.fdo"))));
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("c.fdo"))));
    tabsOf(sample).setCurrentIndex(1);
    QVERIFY(sample.window.close());
    QVERIFY(QFile::remove(sample.path(QStringLiteral("c.fdo"))));

    MainWindow again;
    QVERIFY(again.openSession());
    const TextTabs &tabs = *again.findChild<TextTabs *>();
    QVERIFY(hasNames(tabs, {QStringLiteral("a.fdo"), QStringLiteral("b.fdo")}));
    QCOMPARE(tabs.currentIndex(), 1);
    QVERIFY(again.close());

    QVERIFY(QFile::remove(sample.path(QStringLiteral("a.fdo"))));
    QVERIFY(QFile::remove(sample.path(QStringLiteral("b.fdo"))));
    MainWindow empty;
    QVERIFY(!empty.openSession());
}

void TestTextTabs::recentFilesAreTheNewestFirst()
{
    Sample sample;
    const QString a = writeCube(sample, QStringLiteral("a.fdo"));
    const QString b = writeCube(sample, QStringLiteral("b.fdo"));
    QVERIFY(sample.window.openFile(a));
    QVERIFY(sample.window.openFile(b));
    QCOMPARE(TextTabs::recentFiles(), QStringList({b, a}));
    QVERIFY(sample.window.saveFile(sample.path(QStringLiteral("c.fdo"))));
    QCOMPARE(TextTabs::recentFiles().first(), sample.path(QStringLiteral("c.fdo")));
    for (int i = 0; i < 20; ++i) {
        QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("%1.fdo").arg(i))));
    }
    QCOMPARE(TextTabs::recentFiles().size(), 12);
}

void TestTextTabs::keysGoRound()
{
    Sample sample;
    const TextTabs &tabs = tabsOf(sample);
    for (const char *name : {"a.fdo", "b.fdo", "c.fdo"}) {
        QVERIFY(sample.window.openFile(writeCube(sample, QString::fromLatin1(name))));
    }
    sample.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&sample.window));
    const auto press = [&](int key, Qt::KeyboardModifiers modifiers) {
        QTest::keyClick(&sample.visibleEditor(), Qt::Key(key), modifiers);
        return tabs.currentIndex();
    };
    QCOMPARE(press(Qt::Key_Tab, Qt::ControlModifier), 0);
    QCOMPARE(press(Qt::Key_Tab, Qt::ControlModifier), 1);
    QCOMPARE(press(Qt::Key_Tab, Qt::ControlModifier | Qt::ShiftModifier), 0);
    QCOMPARE(press(Qt::Key_Tab, Qt::ControlModifier | Qt::ShiftModifier), 2);
    press(Qt::Key_W, Qt::ControlModifier);
    QCOMPARE(tabs.count(), 2);
    press(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(hasNames(tabs, {QStringLiteral("a.fdo"), QStringLiteral("b.fdo"), QStringLiteral("untitled.fdo")}));
}

void TestTextTabs::whatIsSavedHereIsSeenThere()
{
    Sample sample;
    TextTabs &tabs = tabsOf(sample);
    const QString part = writeCube(sample, QStringLiteral("a.fdo"));
    QVERIFY(sample.window.openFile(sample.write(QStringLiteral("s.sdo"), "f \"a.fdo\" #\n")));
    QVERIFY(sample.waitForPicture());
    QVERIFY(sample.window.openFile(part));
    QVERIFY(sample.waitForPicture());
    const quint64 revision = tabs.tab(0).preview().revision;
    tabs.current().editor().setPlainText(QStringLiteral("<$>. nothing\n"));
    QVERIFY(sample.window.saveFile(part));
    tabs.setCurrentIndex(0);
    QVERIFY(QTest::qWaitFor([&] { return tabs.tab(0).preview().revision > revision; }, 20'000));
    QVERIFY2(sample.strip().contains(QStringLiteral("a.fdo")), qPrintable(sample.strip()));
}

void TestTextTabs::twoTabsOfOneFileAreRefused()
{
    Sample sample;
    const QString a = writeCube(sample, QStringLiteral("a.fdo"));
    const QByteArray bytes = Sample::read(a);
    QVERIFY(sample.window.openFile(a));
    QVERIFY(sample.window.openFile(writeCube(sample, QStringLiteral("b.fdo"))));
    QVERIFY(!sample.window.saveFile(a));
    QVERIFY2(sample.message().contains(QStringLiteral("another tab")), qPrintable(sample.message()));
    QCOMPARE(Sample::read(a), bytes);
    QCOMPARE(tabsOf(sample).currentIndex(), 1);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestTextTabs>(argc, argv);
}
#include "testtexttabs.moc"
