// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QDir>
#include <QLabel>
#include <QListWidget>

#include "app/window/examplegallery.h"
#include "app/window/texttabs.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

/// The examples in pictures, by keys and mouse.
class TestGallery : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyExampleHasAPictureAndASentence();
    void keysChooseAndOpen();
    void aDoubleClickOpens();
    void escapeOpensNothing();

private:
    static QListWidget *opened(Sample &sample)
    {
        if (!sample.waitUntilActive()) {
            return nullptr;
        }
        QTest::keyClick(&sample.editor, Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        auto *gallery = sample.window.findChild<ExampleGallery *>();
        return gallery ? gallery->findChild<QListWidget *>() : nullptr;
    }
    static bool isClosed(const Sample &sample)
    {
        return QTest::qWaitFor([&] { return !sample.window.findChild<ExampleGallery *>(); });
    }
    static void goTo(QListWidget &list, const QString &name)
    {
        QTest::keyClick(&list, Qt::Key_Home);
        for (int i = 0; i < list.count() && list.currentItem()->text() != name; ++i) {
            QTest::keyClick(&list, Qt::Key_Right);
        }
    }
};

void TestGallery::everyExampleHasAPictureAndASentence()
{
    Sample sample;
    const QListWidget *list = opened(sample);
    QVERIFY(list && list->isVisible());
    const QStringList kinds{QStringLiteral("*.fdo"), QStringLiteral("*.sdo")};
    QCOMPARE(list->count(), QDir(TextTabs::examplesFolder).entryList(kinds).size());
    for (int i = 0; i < list->count(); ++i) {
        const QListWidgetItem &item = *list->item(i);
        QVERIFY2(item.icon().availableSizes().contains(QSize(192, 144)), qPrintable(item.text()));
        QVERIFY2(item.toolTip().size() > 20, qPrintable(item.text()));
    }
}

void TestGallery::keysChooseAndOpen()
{
    Sample sample;
    QListWidget *list = opened(sample);
    QVERIFY(list);
    goTo(*list, QStringLiteral("tree"));
    const QLabel &words = *sample.window.findChild<ExampleGallery *>()->findChild<QLabel *>();
    QCOMPARE(words.text(), QStringLiteral("A tree whose branches are trees."));
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(isClosed(sample));
    QVERIFY(sample.visibleEditor().toPlainText().startsWith(QStringLiteral("# A tree whose branches are trees.")));
    QVERIFY(!sample.visibleEditor().isReadOnly());
}

void TestGallery::aDoubleClickOpens()
{
    Sample sample;
    QListWidget *list = opened(sample);
    QVERIFY(list);
    const QList<QListWidgetItem *> found = list->findItems(QStringLiteral("menger"), Qt::MatchExactly);
    QCOMPARE(found.size(), 1);
    list->scrollToItem(found.first());
    const QPoint place = list->visualItemRect(found.first()).center();
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, place);
    QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, place);
    QVERIFY(isClosed(sample));
    QVERIFY(sample.visibleEditor().toPlainText().startsWith(QStringLiteral("# Menger sponge")));
}

void TestGallery::escapeOpensNothing()
{
    Sample sample;
    const QString before = sample.editor.toPlainText();
    QListWidget *list = opened(sample);
    QVERIFY(list);
    goTo(*list, QStringLiteral("tree"));
    QTest::keyClick(list, Qt::Key_Escape);
    QVERIFY(isClosed(sample));
    QCOMPARE(sample.visibleEditor().toPlainText(), before);
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestGallery>(argc, argv);
}
#include "testgallery.moc"
