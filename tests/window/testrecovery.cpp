// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include "app/window/differenceview.h"
#include "app/window/journal.h"
#include "app/window/recoverydialog.h"
#include "core/text/textjournal.h"
#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;
using namespace std::chrono_literals;

namespace {

struct Sample : Folders {
    ResourceFiles files;

    [[nodiscard]] std::filesystem::path folder() const { return home.path().toStdString(); }
    /// As a process leaves it that is killed.
    void leave(const std::string &name, const QString &path, std::string_view onDisk, const std::string &text) const
    {
        TextJournal journal(folder(), name);
        if (!journal.put({QFile::encodeName(path).toStdString(), onDisk.empty() ? 0 : checksum(onDisk), text})) {
            qFatal("cannot write a journal");
        }
    }
    [[nodiscard]] Recovery search() const { return Recovery::search(folder(), files); }
    [[nodiscard]] QStringList journals() const { return QDir(home.path()).entryList(QDir::Files, QDir::Name); }
};

QPushButton *buttonOf(const QDialog &dialog, const QString &words)
{
    for (QPushButton *button : dialog.findChildren<QPushButton *>()) {
        if (button->text().remove(u'&') == words) {
            return button;
        }
    }
    qFatal("no such button");
}

}

class TestRecovery : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatWasTypedIsFound();
    void theLivingAreLeftAlone();
    void oneFindsItAtATime();
    void theNewestThatIsWholeCounts();
    void whatWasSavedInItsLastMomentIsNotOffered();
    void otherFilesAreLeftAlone();
    void aTextIsRestoredAndKeptAgain();
    void theDialogTellsWhatThereIs();
    void discardedIsGoneAndLaterIsNot();
    void differencesAreBounded();
};

void TestRecovery::whatWasTypedIsFound()
{
    const Sample sample;
    const QString same = sample.write(QStringLiteral("same.fdo"), "\xEF\xBB\xBFold\r\n");
    const QString changed = sample.write(QStringLiteral("changed.fdo"), "newer\n");
    sample.leave("a.1", same, "\xEF\xBB\xBFold\r\n", "old\nmore\n");
    sample.leave("a.2", changed, "old\n", "old\nmore\n");
    sample.leave("b.1", sample.path(QStringLiteral("gone.fdo")), "old\n", "gone\n");
    sample.leave("b.2", {}, {}, "untitled\n");
    sample.leave("c.1", QStringLiteral(":/examples/tree.fdo"),
                 Folders::read(QStringLiteral(":/examples/tree.fdo")).toStdString(), "tree\n");
    const Recovery recovery = sample.search();
    QCOMPARE(recovery.texts().size(), std::size_t(5));
    for (const LostText &lost : recovery.texts()) {
        QVERIFY(std::abs(lost.time.secsTo(QDateTime::currentDateTime())) < 60);
        if (lost.path == same) {
            QVERIFY(lost.disk == LostText::Disk::Same && lost.onDisk == "old\n" && lost.text == "old\nmore\n");
        } else if (lost.path == changed) {
            QVERIFY(lost.disk == LostText::Disk::Changed && lost.onDisk == "newer\n");
        } else if (lost.path.isEmpty()) {
            QVERIFY(lost.disk == LostText::Disk::Same && lost.onDisk.empty() && lost.text == "untitled\n");
        } else if (lost.path.startsWith(u':')) {
            QVERIFY(lost.disk == LostText::Disk::Same && !lost.onDisk.empty() && lost.text == "tree\n");
        } else {
            QVERIFY(lost.disk == LostText::Disk::Gone && lost.onDisk.empty() && lost.text == "gone\n");
        }
    }
    // Looking takes nothing away.
    QCOMPARE(sample.journals().filter(QStringLiteral(".1")).size(), 5);
    QVERIFY(Recovery::search(sample.folder() / "none", sample.files).texts().empty());
}

void TestRecovery::theLivingAreLeftAlone()
{
    const Sample sample;
    DocumentSample document;
    auto session = std::make_unique<JournalSession>(
        [&] { return std::expected<std::filesystem::path, std::string>(sample.folder()); });
    const Journal journal(document.document, *session);
    document.type(QStringLiteral("typed"));
    QVERIFY(journal.waitUntilWritten(1s));
    sample.leave("dead.1", {}, {}, "dead");
    const Recovery recovery = sample.search();
    QCOMPARE(recovery.texts().size(), std::size_t(1));
    QCOMPARE(recovery.texts().front().text, "dead");
    QVERIFY(journal.waitUntilWritten(1s));
    QVERIFY(sample.journals().size() >= 3);
}

void TestRecovery::oneFindsItAtATime()
{
    const Sample sample;
    sample.leave("a.1", {}, {}, "typed");
    {
        const Recovery first = sample.search();
        QCOMPARE(first.texts().size(), std::size_t(1));
        QVERIFY(sample.search().texts().empty());
    }
    QCOMPARE(sample.search().texts().size(), std::size_t(1));
    QCOMPARE(sample.journals(), QStringList{QStringLiteral("a.1.1")});
}

void TestRecovery::theNewestThatIsWholeCounts()
{
    const Sample sample;
    const auto put = [&](const char *generation, const std::string &text) {
        sample.leave("x.1", {}, {}, text);
        QVERIFY(QFile::rename(sample.home.filePath(QStringLiteral("x.1.1")),
                              sample.home.filePath(QLatin1String("a.1.") + QLatin1String(generation))));
    };
    put("9", "older");
    put("10", "newer");
    put("11", "newest");
    QFile torn(sample.home.filePath(QStringLiteral("a.1.11")));
    QVERIFY(torn.resize(torn.size() - 2));
    Recovery recovery = sample.search();
    QCOMPARE(recovery.texts().size(), std::size_t(1));
    QCOMPARE(recovery.texts().front().text, "newer");
    recovery.drop(LostText(recovery.texts().front()));
    QVERIFY(recovery.texts().empty());
    QVERIFY(sample.journals().filter(QStringLiteral("a.1.")).isEmpty());
}

void TestRecovery::whatWasSavedInItsLastMomentIsNotOffered()
{
    const Sample sample;
    sample.leave("a.1", sample.write(QStringLiteral("a.fdo"), "saved\r\n"), "old\n", "saved\n");
    sample.leave("b.1", {}, {}, {});
    QVERIFY(sample.search().texts().empty());
    QVERIFY(sample.journals().isEmpty());
}

void TestRecovery::otherFilesAreLeftAlone()
{
    const Sample sample;
    const QStringList names{QStringLiteral("README"), QStringLiteral("a.1"), QStringLiteral("a.b.c"),
                            QStringLiteral("b.1.1")};
    for (const QString &name : names) {
        QFile file(sample.home.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    }
    QVERIFY(sample.search().texts().empty());
    QCOMPARE(sample.journals(), names);
}

void TestRecovery::aTextIsRestoredAndKeptAgain()
{
    const Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    sample.leave("a.1", path, "old\n", "old\nmore\n");
    DocumentSample document;
    JournalSession session([&] { return std::expected<std::filesystem::path, std::string>(sample.folder()); });
    const Journal journal(document.document, session);
    RecoveryDialog dialog(sample.search());
    connect(&dialog, &RecoveryDialog::restoreRequested, &dialog, [&](const LostText &text, bool *isRestored) {
        document.document.restore(text.path, text.text);
        *isRestored = journal.waitUntilWritten(5s);
    });
    buttonOf(dialog, QStringLiteral("Restore"))->click();
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
    QCOMPARE(document.text(), QByteArray("old\nmore\n"));
    QVERIFY(document.document.isModified());
    QCOMPARE(Folders::read(path), QByteArray("old\n"));
    QVERIFY(!sample.journals().contains(QStringLiteral("a.1.1")));
    QCOMPARE(sample.journals().filter(QStringLiteral(".1.1")).size(), 1);
}

void TestRecovery::theDialogTellsWhatThereIs()
{
    const Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "newer\n");
    sample.leave("a.1", path, "old\n", "old\nmore\n");
    {
        const RecoveryDialog dialog(sample.search());
        const auto labels = dialog.findChildren<QLabel *>();
        QVERIFY(std::ranges::any_of(labels, [&](const QLabel *label) {
            return label->text().contains(path) && label->text().contains(QStringLiteral("changed the file since"));
        }));
        QVERIFY(dialog.findChild<QListWidget *>()->isHidden());
        const QString shown = dialog.findChild<DifferenceView *>()->toPlainText();
        QCOMPARE(shown, QStringLiteral("line 1\n− newer\n+ old\n+ more\n  "));
    }
    sample.leave("a.2", {}, {}, "untitled\n");
    const RecoveryDialog dialog(sample.search());
    auto *list = dialog.findChild<QListWidget *>();
    QVERIFY(!list->isHidden());
    QCOMPARE(list->count(), 2);
    for (int row = 0; row < 2; ++row) {
        list->setCurrentRow(row);
        const bool isUntitled = list->item(row)->text() == QStringLiteral("untitled.fdo");
        QCOMPARE(dialog.findChild<DifferenceView *>()->toPlainText().contains(QStringLiteral("+ untitled")),
                 isUntitled);
    }
}

void TestRecovery::discardedIsGoneAndLaterIsNot()
{
    const Sample sample;
    sample.leave("a.1", {}, {}, "one");
    sample.leave("a.2", {}, {}, "two");
    sample.leave("a.3", {}, {}, "three");
    {
        RecoveryDialog dialog(sample.search());
        // Nobody restores it.
        buttonOf(dialog, QStringLiteral("Restore"))->click();
        QCOMPARE(dialog.findChild<QListWidget *>()->count(), 3);
        dialog.findChild<QListWidget *>()->setCurrentRow(1);
        buttonOf(dialog, QStringLiteral("Discard"))->click();
        QCOMPARE(dialog.findChild<QListWidget *>()->count(), 2);
        QCOMPARE(sample.journals().filter(QStringLiteral(".1")).size(), 2);
        buttonOf(dialog, QStringLiteral("Later"))->click();
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
    }
    const Recovery rest = sample.search();
    QCOMPARE(rest.texts().size(), std::size_t(2));
}

void TestRecovery::differencesAreBounded()
{
    DifferenceView view;
    view.setTexts("a\n", "a\n");
    QCOMPARE(view.toPlainText(), QStringLiteral("The texts are alike."));
    std::string before;
    std::string after;
    for (int i = 0; i < 100; ++i) {
        before += "line " + std::to_string(i) + "\n";
        after += (i == 10 || i == 12 || i == 80 ? "LINE " : "line ") + std::to_string(i) + "\n";
    }
    view.setTexts(before, after);
    QCOMPARE(
        view.toPlainText().section(u'\n', 0, 12),
        QStringLiteral("line 8\n  line 7\n  line 8\n  line 9\n− line 10\n+ LINE 10\n  line 11\n− line 12\n+ LINE 12\n"
                       "  line 13\n  line 14\n  line 15\nline 78"));
    const std::string huge(1'000'000, 'x');
    view.setTexts(huge, huge + "y");
    QVERIFY(view.toPlainText().size() < 1'100);
    std::string many;
    for (int i = 0; i < 100'000; ++i) {
        many += std::to_string(i) + "\n";
    }
    view.setTexts({}, many);
    QVERIFY(view.document()->blockCount() < 5'010);
    QVERIFY(view.toPlainText().endsWith(QStringLiteral("… and more")));
}

QTEST_MAIN(TestRecovery)
#include "testrecovery.moc"
