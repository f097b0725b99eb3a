// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QAction>
#include <QLineEdit>
#include <QTreeWidget>

#include "app/window/keylist.h"
#include "tests/sourcetree.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

/// The words of all rows that are to be seen, with their keys; what is said twice has those of both.
QHash<QString, QString> shownKeys(const KeyList &list)
{
    QHash<QString, QString> keys;
    const QTreeWidget &tree = *list.findChild<QTreeWidget *>();
    for (int i = 0; i < tree.topLevelItemCount(); ++i) {
        const QTreeWidgetItem &group = *tree.topLevelItem(i);
        for (int j = 0; j < group.childCount() && !group.isHidden(); ++j) {
            const QTreeWidgetItem &row = *group.child(j);
            if (!row.isHidden()) {
                keys[row.text(0)] += row.text(1) + u' ';
            }
        }
    }
    return keys;
}

/// The list as a page of the documentation.
QByteArray pageOf(const KeyList &list)
{
    QString page = QStringLiteral("# Keys\n\nThe list that F1 shows, where a line above it narrows it.\n");
    const QTreeWidget &tree = *list.findChild<QTreeWidget *>();
    for (int i = 0; i < tree.topLevelItemCount(); ++i) {
        const QTreeWidgetItem &group = *tree.topLevelItem(i);
        if (group.childCount() > 0) {
            page += QStringLiteral("\n## %1\n\n| | |\n|---|---|\n").arg(group.text(0));
        }
        for (int j = 0; j < group.childCount(); ++j) {
            page += QStringLiteral("| %1 | %2 |\n").arg(group.child(j)->text(0), group.child(j)->text(1));
        }
    }
    return page.toUtf8();
}

}

/// All keys, by F1.
class TestKeyList : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyActionsKeyIsListed();
    void wordsNarrow();
    void escapeCloses();
    void oneIsEnough();
    void thePageHasThem();

private:
    static KeyList *opened(Sample &sample)
    {
        if (!sample.waitUntilActive()) {
            return nullptr;
        }
        QTest::keyClick(&sample.editor, Qt::Key_F1);
        return sample.window.findChild<KeyList *>();
    }
};

void TestKeyList::everyActionsKeyIsListed()
{
    Sample sample;
    const KeyList *list = opened(sample);
    QVERIFY(list && list->isVisible());
    const QHash<QString, QString> keys = shownKeys(*list);
    int found = 0;
    for (const QAction *action : sample.window.findChildren<QAction *>()) {
        // Others belong to lines that are typed in.
        const QString words = action->text().remove(u'&').remove(u'…');
        if (action->shortcuts().isEmpty()
            || (action->parent() != &sample.window && action->parent() != &sample.viewport)) {
            continue;
        }
        for (const QKeySequence &key : action->shortcuts()) {
            QVERIFY2(keys.value(words).contains(key.toString(QKeySequence::NativeText)), qPrintable(words));
        }
        ++found;
    }
    QVERIFY(found > 30);
    QCOMPARE(keys.value(QStringLiteral("Export")), QStringLiteral("Ctrl+E, F6 "));
    QCOMPARE(keys.value(QStringLiteral("Front")), QStringLiteral("1 "));
    QVERIFY(keys.contains(QStringLiteral("Fly")));
}

void TestKeyList::wordsNarrow()
{
    Sample sample;
    const KeyList *list = opened(sample);
    QVERIFY(list);
    QLineEdit *line = list->findChild<QLineEdit *>();
    QVERIFY(QTest::qWaitFor([&] { return line->hasFocus(); }));
    const auto all = shownKeys(*list).size();
    QTest::keyClicks(line, QStringLiteral("find shift+f"));
    QVERIFY(shownKeys(*list).isEmpty());
    line->clear();
    QTest::keyClicks(line, QStringLiteral("prev ctrl+shift+g"));
    QCOMPARE(shownKeys(*list).keys(), QStringList{QStringLiteral("Find Previous")});
    line->clear();
    QCOMPARE(shownKeys(*list).size(), all);
}

void TestKeyList::escapeCloses()
{
    Sample sample;
    const QPointer<KeyList> list = opened(sample);
    QVERIFY(list);
    QTest::keyClick(list->findChild<QLineEdit *>(), Qt::Key_Escape);
    QVERIFY(QTest::qWaitFor([&] { return list.isNull(); }));
    QVERIFY(sample.window.isVisible());
}

void TestKeyList::oneIsEnough()
{
    Sample sample;
    QVERIFY(opened(sample));
    QTest::keyClick(&sample.editor, Qt::Key_F1);
    QCOMPARE(sample.window.findChildren<KeyList *>().size(), 1);
}

void TestKeyList::thePageHasThem()
{
    Sample sample;
    const KeyList *list = opened(sample);
    QVERIFY(list);
    const QByteArray expected = pageOf(*list);
    QFile page(test::sourcePath("docs/keys.md"));
    if (qEnvironmentVariableIsSet("ROMANESCO_ACCEPT")) {
        QVERIFY(page.open(QIODevice::WriteOnly) && page.write(expected) == expected.size());
        return;
    }
    QVERIFY(page.open(QIODevice::ReadOnly));
    QVERIFY2(page.readAll() == expected, "tests/golden/accept writes it anew");
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestKeyList>(argc, argv);
}
#include "testkeylist.moc"
