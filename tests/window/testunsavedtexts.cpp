// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QMessageBox>
#include <QPushButton>

#include "app/window/namedfiles.h"
#include "app/window/resourcefiles.h"
#include "app/window/texttab.h"
#include "app/window/texttabs.h"
#include "app/window/unsavedtexts.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

constexpr auto oneCube = "v 3 0 0\nx. \"cube.obj\"\nt.p. (p, #, #)\n<$>. x\n";
constexpr auto twoCubes = "v 3 0 0\nx. \"cube.obj\"\nt.p. (p, #, #)\n<$>. [t.1, #] x\n";

/// A scene of one fractal, in the first tab, and the fractal, in the second, which is looked at.
struct SceneAndPart : Sample {
    TextTabs &tabs = *window.findChild<TextTabs *>();

    void open()
    {
        QVERIFY(QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("cube.obj"))));
        const QString part = write(QStringLiteral("part.fdo"), oneCube);
        QVERIFY(window.openFile(write(QStringLiteral("scene.sdo"), "f \"part.fdo\" #\n")));
        QVERIFY(waitForCopies(1));
        QVERIFY(window.openFile(part));
        QVERIFY(waitForCopies(1));
    }
    [[nodiscard]] bool waitForCopies(std::uint64_t count) const
    {
        return QTest::qWaitFor([&] { return drawn == count && viewport.isPictureFinished(); }, 60'000);
    }
    /// As typing would, in the text that is looked at.
    void retype(const QString &text) const
    {
        QTextCursor cursor(visibleEditor().document());
        cursor.select(QTextCursor::Document);
        cursor.insertText(text);
    }
    void pin() const
    {
        for (QAction *action : window.actions() + window.findChildren<QAction *>()) {
            if (action->text().remove(u'&') == QStringLiteral("Pin Picture")) {
                action->trigger();
                return;
            }
        }
        qFatal("there is no such action");
    }
    void discardAndClose(int index)
    {
        QTimer::singleShot(0, &window,
                           [this] { window.findChild<QMessageBox *>()->button(QMessageBox::Discard)->click(); });
        QVERIFY(tabs.closeTab(index));
    }
};

}

/// Texts that are open and modified stand in for their files, in the scenes of other texts and in one that is pinned.
class TestUnsavedTexts : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void standInsAreFoundByAnyPath();
    void thoseWhoChangeAreTold();
    void otherTextsAreMadeOfThem();
    void discardingLeadsBackToTheFile();
    void aPinnedPictureStaysAndFollows();
    void aPinnedPictureIsLetGo();
    void closingLetsGo();
    void theViewGoesIntoItsOwnText();
};

void TestUnsavedTexts::standInsAreFoundByAnyPath()
{
    const QTemporaryDir folder;
    const ResourceFiles disk;
    UnsavedTexts texts(disk);
    const QTextDocument document(QStringLiteral("typed"));
    const QString path = folder.filePath(QStringLiteral("a.fdo"));
    const std::filesystem::path asked = folder.path().toStdString();
    QVERIFY(!texts.read(asked / "a.fdo") && !texts.check(asked / "a.fdo"));
    texts.set(this, path, TextSnapshot(document));
    QCOMPARE(texts.read(asked / "a.fdo").value(), std::string("typed"));
    QCOMPARE(texts.read(asked / "b" / ".." / "." / "a.fdo").value(), std::string("typed"));
    QVERIFY(texts.check(asked / "a.fdo"));
    QVERIFY(!texts.read(asked / "b.fdo"));
    QVERIFY(texts.read(":/examples/cube.obj"));
    texts.set(this, {}, {});
    QVERIFY(!texts.read(asked / "a.fdo"));
}

void TestUnsavedTexts::thoseWhoChangeAreTold()
{
    const ResourceFiles disk;
    UnsavedTexts texts(disk);
    const int other = 0;
    const QString a = QStringLiteral("/a.fdo");
    const QString b = QStringLiteral("/b.fdo");
    QCOMPARE(texts.set(this, {}, {}), QStringList());
    QCOMPARE(texts.set(this, a, {}), QStringList{a});
    QCOMPARE(texts.set(&other, b, {}), QStringList{b});
    QCOMPARE(texts.set(this, a, {}), QStringList{a});
    QCOMPARE(texts.set(this, QStringLiteral("/c.fdo"), {}), QStringList({a, QStringLiteral("/c.fdo")}));
    QCOMPARE(texts.set(this, {}, {}), QStringList{QStringLiteral("/c.fdo")});
    QVERIFY(texts.check("/b.fdo"));
}

void TestUnsavedTexts::otherTextsAreMadeOfThem()
{
    SceneAndPart sample;
    sample.open();
    sample.retype(QString::fromLatin1(twoCubes));
    QVERIFY(sample.waitForCopies(2));
    QCOMPARE(Sample::read(sample.path(QStringLiteral("part.fdo"))), QByteArray(oneCube));
    sample.tabs.setCurrentIndex(0);
    QVERIFY(sample.waitForCopies(2));
    sample.tabs.setCurrentIndex(1);
    sample.visibleEditor().undo();
    QVERIFY(!sample.window.isWindowModified());
    sample.tabs.setCurrentIndex(0);
    QVERIFY(sample.waitForCopies(1));
}

void TestUnsavedTexts::discardingLeadsBackToTheFile()
{
    SceneAndPart sample;
    sample.open();
    sample.retype(QString::fromLatin1(twoCubes));
    sample.tabs.setCurrentIndex(0);
    QVERIFY(sample.waitForCopies(2));
    sample.discardAndClose(1);
    QVERIFY(sample.waitForCopies(1));
    QVERIFY(!sample.window.isWindowModified());
}

void TestUnsavedTexts::aPinnedPictureStaysAndFollows()
{
    SceneAndPart sample;
    sample.open();
    sample.tabs.setCurrentIndex(0);
    QVERIFY(sample.waitForCopies(1));
    QTest::keyClick(&sample.viewport, Qt::Key_Right);
    const Camera turned = sample.viewport.camera();
    sample.pin();
    sample.tabs.setCurrentIndex(1);
    QVERIFY(sample.viewport.camera() == turned);
    QVERIFY2(sample.strip().contains(QStringLiteral("scene.sdo")), qPrintable(sample.strip()));
    sample.retype(QString::fromLatin1(twoCubes));
    QVERIFY(sample.waitForCopies(2));
    QVERIFY(sample.viewport.camera() == turned);
    // each error where it is
    sample.retype(QStringLiteral("<$>. nothing\n"));
    QVERIFY(QTest::qWaitFor([&] { return sample.strip().contains(QStringLiteral("part.fdo")); }, 20'000));
    QVERIFY(QTest::qWaitFor([&] { return sample.problems.topLevelItemCount() == 1; }, 20'000));
    QCOMPARE(sample.problems.topLevelItem(0)->text(0), QStringLiteral("part.fdo:1:6"));
    QCOMPARE(sample.drawn, 2u);
}

void TestUnsavedTexts::aPinnedPictureIsLetGo()
{
    SceneAndPart sample;
    sample.open();
    sample.pin();
    sample.tabs.setCurrentIndex(0);
    QVERIFY(&sample.tabs.seen() == &sample.tabs.tab(1));
    Q_EMIT sample.pane.strip().followed();
    QVERIFY(&sample.tabs.seen() == &sample.tabs.tab(0));
    QVERIFY(!sample.tabs.isPinned());
    QCOMPARE(sample.strip(), QString());
    sample.pin();
    QVERIFY(&sample.tabs.seen() == &sample.tabs.tab(0) && sample.tabs.isPinned());
}

void TestUnsavedTexts::closingLetsGo()
{
    SceneAndPart sample;
    sample.open();
    sample.retype(QString::fromLatin1(twoCubes));
    QVERIFY(sample.waitForCopies(2));
    sample.pin();
    sample.tabs.setCurrentIndex(0);
    sample.discardAndClose(1);
    QVERIFY(!sample.tabs.isPinned());
    QVERIFY(sample.waitForCopies(1));
    QCOMPARE(sample.strip(), QString());
}

void TestUnsavedTexts::theViewGoesIntoItsOwnText()
{
    SceneAndPart sample;
    sample.open();
    sample.tabs.setCurrentIndex(0);
    QVERIFY(sample.waitForCopies(1));
    sample.pin();
    sample.tabs.setCurrentIndex(1);
    for (QAction *action : sample.window.findChildren<QAction *>()) {
        if (action->text().remove(u'&') == QStringLiteral("Save View in Text")) {
            action->trigger();
        }
    }
    QCOMPARE(sample.tabs.currentIndex(), 0);
    QVERIFY(sample.tabs.tab(0).document().isModified());
    QVERIFY(!sample.tabs.tab(1).document().isModified());
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestUnsavedTexts>(argc, argv);
}
#include "testunsavedtexts.moc"
