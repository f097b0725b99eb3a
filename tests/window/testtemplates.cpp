// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QMenu>
#include <QMenuBar>

#include "app/window/broughttexts.h"
#include "app/window/texttab.h"
#include "app/window/texttabs.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

/// The entries of File > New From Template.
QList<QAction *> entries(const MainWindow &window)
{
    for (const QAction *action : window.menuBar()->actions().first()->menu()->actions()) {
        if (action->menu() && action->text().contains(QStringLiteral("Template"))) {
            return action->menu()->actions();
        }
    }
    return {};
}

void addTemplates()
{
    QTest::addColumn<int>("index");
    const QList<BroughtText> texts = broughtTexts(TextTabs::templatesFolder);
    for (int i = 0; i < texts.size(); ++i) {
        QTest::newRow(qPrintable(texts[i].name)) << i;
    }
}

}

/// What a new text may begin with.
class TestTemplates : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void eachIsDrawnWithoutARemark_data() { addTemplates(); }
    void eachIsDrawnWithoutARemark();
    void eachIsSavedWithItsMeshes_data() { addTemplates(); }
    void eachIsSavedWithItsMeshes();
    void eachTimeItIsANewText();
    void theMenuNamesThem();
};

void TestTemplates::eachIsDrawnWithoutARemark()
{
    QFETCH(const int, index);
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.drawn = 0;
    entries(sample.window)[index]->trigger();
    TextTab &tab = sample.window.findChild<TextTabs *>()->current();
    QVERIFY(QTest::qWaitFor([&] { return tab.preview().scene && sample.drawn > 0; }, 60'000));
    QVERIFY(sample.waitForPicture());
    QCOMPARE(sample.problems.topLevelItemCount(), 0);
    QCOMPARE(sample.strip(), QString());
    QCOMPARE(sample.message(), QString());
    // A new text: to be edited, and of no file yet.
    QVERIFY(!tab.editor().isReadOnly());
    QVERIFY(!tab.document().hasOwnFile());
    QVERIFY(!tab.document().isModified());
}

void TestTemplates::eachIsSavedWithItsMeshes()
{
    QFETCH(const int, index);
    Sample sample;
    entries(sample.window)[index]->trigger();
    TextTabs &tabs = *sample.window.findChild<TextTabs *>();
    QVERIFY(QTest::qWaitFor([&] { return tabs.current().preview().scene != nullptr; }, 60'000));
    tabs.current().editor().insertPlainText(QStringLiteral("# Mine\n"));
    const QString path = sample.path(QStringLiteral("mine.") + QFileInfo(tabs.current().document().path()).suffix());
    QVERIFY(sample.window.saveFile(path));
    QVERIFY(tabs.current().document().hasOwnFile());
    QVERIFY(Sample::read(path).startsWith("# Mine\n"));
    // From there it is found whole by another window.
    QVERIFY(sample.window.close());
    MainWindow other;
    QVERIFY(other.openFile(path));
    const TextTab &opened = other.findChild<TextTabs *>()->current();
    QVERIFY(QTest::qWaitFor([&] { return opened.preview().scene != nullptr; }, 60'000));
    QVERIFY(opened.preview().diagnostics.empty());
}

void TestTemplates::eachTimeItIsANewText()
{
    Sample sample;
    TextTabs &tabs = *sample.window.findChild<TextTabs *>();
    entries(sample.window).first()->trigger();
    QCOMPARE(tabs.count(), 1); // in place of the example
    tabs.current().editor().insertPlainText(QStringLiteral("# Mine\n"));
    entries(sample.window).first()->trigger();
    QCOMPARE(tabs.count(), 2);
    QVERIFY(!tabs.current().editor().toPlainText().startsWith(QStringLiteral("# Mine")));
    for (const QString &file : TextTabs::recentFiles()) {
        QVERIFY(!file.startsWith(u':'));
    }
}

void TestTemplates::theMenuNamesThem()
{
    const Sample sample;
    QStringList names;
    for (const QAction *action : entries(sample.window)) {
        names << action->text();
    }
    QCOMPARE(names,
             (QStringList{QStringLiteral("A carpet"), QStringLiteral("A coastline"), QStringLiteral("Dust"),
                          QStringLiteral("A scene"), QStringLiteral("A tree")}));
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestTemplates>(argc, argv);
}
#include "testtemplates.moc"
