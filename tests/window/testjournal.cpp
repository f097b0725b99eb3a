// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <chrono>
#include <memory>

#include "app/window/journal.h"
#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;
using namespace std::chrono_literals;

namespace {

struct Sample : Folders, DocumentSample {
    JournalSession session{[this] { return folder(); }};
    Journal journal{document, session};
    /// Why there is none.
    std::string reason;

    [[nodiscard]] std::expected<std::filesystem::path, std::string> folder() const
    {
        if (!reason.empty()) {
            return std::unexpected(reason);
        }
        return home.path().toStdString();
    }
    /// The journals' files.
    [[nodiscard]] QStringList kept() const
    {
        return QDir(home.path()).entryList({QStringLiteral("*.1.[0-9]*")}, QDir::Files, QDir::Name);
    }
    [[nodiscard]] std::optional<KeptText> read() const
    {
        return kept().isEmpty() ? std::nullopt
                                : readJournal(Folders::read(home.filePath(kept().constLast())).toStdString());
    }
    [[nodiscard]] std::string keptText() const { return read() ? read()->text : "(nothing)"; }
};

}

class TestJournal : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whatIsTypedIsWrittenAtOnce();
    void untitledTextsToo();
    void itKnowsTheFile();
    void whatIsSavedOrUndoneOrClosedLeavesNothing();
    void whatWasTypedDuringASaveStays();
    void eachTextHasItsOwn();
    void troubleIsToldOnceAndEditingGoesOn();
    void withoutAHomeThereIsAReason();
    void theDataFolderIsTheUsersAlone();
    void inALargeTextOnlyTheEditIsWritten();
    void noKeyWaitsForTheDisk();
};

void TestJournal::whatIsTypedIsWrittenAtOnce()
{
    Sample sample;
    QVERIFY(sample.document.open(sample.write(QStringLiteral("a.fdo"), "old\n")).has_value());
    QVERIFY(sample.journal.waitUntilWritten(1s));
    QVERIFY(sample.kept().isEmpty());
    QString typed;
    for (int i = 0; i < 50; ++i) {
        sample.type(QString::number(i));
        typed += QString::number(i);
        if (i % 10 == 0) {
            QVERIFY(sample.journal.waitUntilWritten(1s));
            QCOMPARE(sample.keptText(), typed.toStdString() + "old\n");
        }
    }
    QVERIFY(sample.journal.waitUntilWritten(1s));
    QCOMPARE(sample.keptText(), typed.toStdString() + "old\n");
    QVERIFY(sample.journal.trouble().isEmpty());
}

void TestJournal::untitledTextsToo()
{
    Sample sample;
    sample.type(QStringLiteral("typed\nää"));
    QVERIFY(sample.journal.waitUntilWritten(1s));
    QVERIFY(sample.read() == (KeptText{{}, 0, "typed\nää"}));
}

void TestJournal::itKnowsTheFile()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("ä.fdo"), "old\r\n");
    QVERIFY(sample.document.open(path).has_value());
    sample.type(QStringLiteral("x"));
    QVERIFY(sample.journal.waitUntilWritten(1s));
    QVERIFY(sample.read() == (KeptText{QFile::encodeName(path).toStdString(), checksum("old\r\n"), "xold\n"}));
    const QString other = sample.path(QStringLiteral("b.fdo"));
    QVERIFY(sample.document.saveAs(other).has_value());
    sample.type(QStringLiteral("y"));
    QVERIFY(sample.journal.waitUntilWritten(1s));
    QVERIFY(sample.read() == (KeptText{QFile::encodeName(other).toStdString(), checksum("xold\r\n"), "xyold\n"}));
}

void TestJournal::whatIsSavedOrUndoneOrClosedLeavesNothing()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    const auto isEmpty = [&] { return sample.journal.waitUntilWritten(1s) && sample.kept().isEmpty(); };
    const auto isFull = [&] { return sample.journal.waitUntilWritten(1s) && sample.kept().size() == 1; };
    QVERIFY(sample.document.open(path).has_value());
    sample.type(QStringLiteral("x"));
    QVERIFY(isFull());
    QVERIFY(sample.document.saveAs(path).has_value());
    QVERIFY(isEmpty());
    sample.type(QStringLiteral("y"));
    QVERIFY(isFull());
    sample.editor.undo();
    QVERIFY(isEmpty());
    sample.editor.redo();
    QVERIFY(isFull());
    // Whoever lets another text take its place was asked.
    sample.document.startNew();
    QVERIFY(isEmpty());
    {
        DocumentSample other;
        const Journal journal(other.document, sample.session);
        other.type(QStringLiteral("x"));
        QVERIFY(journal.waitUntilWritten(1s));
        QCOMPARE(QDir(sample.home.path()).entryList({QStringLiteral("*.2.1")}, QDir::Files).size(), 1);
    }
    QVERIFY(QDir(sample.home.path()).entryList({QStringLiteral("*.2.1")}, QDir::Files).isEmpty());
}

void TestJournal::whatWasTypedDuringASaveStays()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    const QSignalSpy saved(&sample.document, &Document::saved);
    sample.type(QStringLiteral("x"));
    sample.document.startSaving(path);
    sample.type(QStringLiteral("y"));
    QTRY_COMPARE(saved.count(), 1);
    QVERIFY(sample.journal.waitUntilWritten(1s));
    QVERIFY(sample.read() == (KeptText{QFile::encodeName(path).toStdString(), checksum("xold\n"), "xyold\n"}));
}

void TestJournal::eachTextHasItsOwn()
{
    Sample sample;
    DocumentSample other;
    const Journal journal(other.document, sample.session);
    sample.type(QStringLiteral("one"));
    QVERIFY(sample.journal.waitUntilWritten(1s));
    other.type(QStringLiteral("two"));
    QVERIFY(journal.waitUntilWritten(1s));
    std::vector<std::string> texts;
    const QDir folder(sample.home.path());
    for (const QString &name : folder.entryList({QStringLiteral("*.[12].1")}, QDir::Files, QDir::Name)) {
        texts.push_back(readJournal(Folders::read(folder.filePath(name)).toStdString()).value().text);
    }
    QVERIFY((texts == std::vector<std::string>{"one", "two"}));
}

void TestJournal::troubleIsToldOnceAndEditingGoesOn()
{
    Sample sample;
    sample.reason = "disk full";
    const QSignalSpy told(&sample.journal, &Journal::troubleChanged);
    for (int i = 0; i < 20; ++i) {
        sample.type(QStringLiteral("x"));
        QVERIFY(!sample.journal.waitUntilWritten(100ms));
        QCoreApplication::processEvents();
    }
    QCOMPARE(told.count(), 1);
    QCOMPARE(told.at(0).at(0).toString(), QStringLiteral("disk full"));
    QCOMPARE(sample.text(), QByteArray(20, 'x'));
    sample.reason.clear();
    sample.type(QStringLiteral("y"));
    QVERIFY(sample.journal.waitUntilWritten(1s));
    QTRY_COMPARE(told.count(), 2);
    QVERIFY(sample.journal.trouble().isEmpty());
    QCOMPARE(sample.keptText(), std::string(20, 'x') + "y");
}

void TestJournal::withoutAHomeThereIsAReason()
{
    const Folders folders;
    const QByteArray home = qgetenv("HOME");
    const auto troubleOf = [] {
        DocumentSample sample;
        JournalSession session;
        const Journal journal(sample.document, session);
        sample.type(QStringLiteral("x"));
        return QTest::qWaitFor([&] { return !journal.trouble().isEmpty(); }, 2'000) ? journal.trouble() : QString();
    };
    qunsetenv("HOME");
    qunsetenv("XDG_DATA_HOME");
    QCOMPARE(troubleOf(), QStringLiteral("there is no home directory"));
    qputenv("XDG_DATA_HOME", "relative"); // the standard: as if it were not there
    QCOMPARE(troubleOf(), QStringLiteral("there is no home directory"));
    // No folder can be made there.
    qputenv("XDG_DATA_HOME", QFile::encodeName(folders.write(QStringLiteral("file"), "x")));
    QVERIFY(!troubleOf().isEmpty());
    qputenv("HOME", home);
}

void TestJournal::theDataFolderIsTheUsersAlone()
{
    const Folders folders;
    DocumentSample sample;
    JournalSession session;
    const Journal journal(sample.document, session);
    sample.type(QStringLiteral("x"));
    QVERIFY(journal.waitUntilWritten(1s));
    const QDir folder(folders.home.filePath(QStringLiteral("data/romanesco/journals")));
    const QFileInfoList files = folder.entryInfoList(QDir::Files);
    QCOMPARE(files.size(), 2); // and the lock
    const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    for (const QFileInfo &file : files) {
        QVERIFY(!(file.permissions() & others));
    }
    QVERIFY(!(QFileInfo(folder.path()).permissions() & others));
}

/// 100,000 lines, and a line of a million characters.
void TestJournal::inALargeTextOnlyTheEditIsWritten()
{
    for (const QByteArray &text : {QByteArray("v 1 2 3\n").repeated(100'000), QByteArray(1'000'000, 'x')}) {
        Sample sample;
        QVERIFY(sample.document.open(sample.write(QStringLiteral("a.txt"), text)).has_value());
        for (int i = 0; i < 20; ++i) {
            sample.type(QStringLiteral("y"));
            QVERIFY(sample.journal.waitUntilWritten(1s));
        }
        QCOMPARE(sample.kept().size(), 1);
        QVERIFY(QFileInfo(sample.home.filePath(sample.kept().constFirst())).size() < text.size() + 2'000);
        QCOMPARE(sample.keptText(), std::string(20, 'y') + text.toStdString());
    }
}

/// The folder is found on the writer's thread, as all that may take long.
void TestJournal::noKeyWaitsForTheDisk()
{
    DocumentSample sample;
    const QTemporaryDir folder;
    std::mutex gate;
    JournalSession session([&]() -> std::expected<std::filesystem::path, std::string> {
        const std::lock_guard guard(gate);
        return folder.path().toStdString();
    });
    const Journal journal(sample.document, session);
    gate.lock();
    for (int i = 0; i < 100; ++i) {
        sample.type(QStringLiteral("x"));
    }
    QVERIFY(!journal.waitUntilWritten(10ms));
    gate.unlock();
    QVERIFY(journal.waitUntilWritten(1s));
}

QTEST_MAIN(TestJournal)
#include "testjournal.moc"
