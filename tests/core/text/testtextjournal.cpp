// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/text/textjournal.h"

#include <cerrno>
#include <csignal>
#include <format>
#include <memory>
#include <random>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// A disk that is full after so many bytes, takes them in pieces, and may refuse to settle.
class FullDisk final : public FileCalls
{
public:
    std::size_t free = std::size_t{1} << 40;
    std::size_t mostBytes = std::size_t{1} << 30;
    bool failsToSync = false;
    bool failsToOpen = false;
    int syncs = 0;
    std::size_t written = 0;

    int openat(int folder, const char *name, int flags, mode_t mode) override
    {
        errno = EMFILE;
        return failsToOpen ? -1 : FileCalls::openat(folder, name, flags, mode);
    }
    ssize_t write(int file, const void *bytes, std::size_t size) override
    {
        if (free == 0) {
            errno = ENOSPC;
            return -1;
        }
        const ssize_t count = FileCalls::write(file, bytes, std::min({size, free, mostBytes}));
        free -= static_cast<std::size_t>(count);
        written += static_cast<std::size_t>(count);
        return count;
    }
    int fsync(int file) override
    {
        ++syncs;
        errno = EIO;
        return failsToSync || file < 0 ? -1 : 0; // of true disks it takes its time
    }
};

/// Somewhere a stretch is replaced.
void edit(std::string &text, std::mt19937_64 &random)
{
    const std::size_t at = random() % (text.size() + 1);
    const std::size_t removed = random() % 4 == 0 ? random() % (text.size() - at + 1) % 50 : random() % 2;
    const std::string added(random() % 3 == 0 ? random() % 60 : 1, static_cast<char>(random() % 256));
    text.replace(at, std::min(removed, text.size() - at), added);
}

}

class TestTextJournal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }
    void whatIsPutIsReadAgain();
    void severalAppendOnlyWhatIsNew();
    void aTornEndIsIgnored();
    void noBrokenByteIsBelieved();
    void longJournalsAreCompacted();
    void whatIsReplacedStaysUntilTheNewIsOnTheDisk();
    void aFullDiskLosesNothingThatWasWritten();
    void aFileThatMayGrowNoMoreIsToldWithItsReason();
    void whatCannotBeCompactedGrows();
    void shortWritesGoOn();
    void whatCannotSettleIsTold();
    void nothingStaysOfWhatIsRemoved();
    void withoutAFolderThereIsAReason();

private:
    [[nodiscard]] std::filesystem::path folder() const { return m_folder->path().toStdString(); }
    [[nodiscard]] QStringList names() const { return QDir(m_folder->path()).entryList(QDir::Files, QDir::Name); }
    [[nodiscard]] std::string bytes(const QString &name) const
    {
        QFile file(m_folder->filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : "cannot be read";
    }
    /// By the newest of the files.
    [[nodiscard]] std::optional<KeptText> read() const { return readJournal(bytes(names().constLast())); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestTextJournal::whatIsPutIsReadAgain()
{
    std::mt19937_64 random(seed(1));
    TextJournal journal(folder(), "j");
    KeptText kept{"/a b/ü\n.fdo", 0xfedcba9876543210, "one\ntwo\n"};
    QVERIFY(names().isEmpty());
    for (int i = 0; i < 900; ++i) {
        QVERIFY(journal.put(kept));
        QCOMPARE(names(), QStringList{QStringLiteral("j.1")});
        QVERIFY(read() == kept);
        edit(kept.text, random);
        if (i % 100 == 99) {
            kept.onDisk = random();
        }
        if (i % 200 == 199) {
            kept.path += 'x';
        }
    }
    QVERIFY(journal.put(KeptText{}));
    QVERIFY(read() == KeptText{});
}

void TestTextJournal::severalAppendOnlyWhatIsNew()
{
    FullDisk disk;
    TextJournal journal(folder(), "j", disk);
    KeptText kept{"f", 1, std::string(4'000'000, 'x')};
    QVERIFY(journal.put(kept));
    const std::size_t whole = disk.written;
    for (int i = 0; i < 100; ++i) {
        kept.text.insert(2'000'000, "y");
        QVERIFY(journal.put(kept));
        QVERIFY(journal.put(kept)); // nothing
    }
    QVERIFY(disk.written - whole < 100 * 60);
    QVERIFY(read() == kept);
}

/// Cut anywhere, it is what was put before.
void TestTextJournal::aTornEndIsIgnored()
{
    std::mt19937_64 random(seed(2));
    TextJournal journal(folder(), "j");
    std::vector<std::pair<std::size_t, KeptText>> puts;
    KeptText kept{"f", 1, "one\n"};
    for (int i = 0; i < 40; ++i) {
        QVERIFY(journal.put(kept));
        puts.emplace_back(bytes(QStringLiteral("j.1")).size(), kept);
        edit(kept.text, random);
    }
    const std::string all = bytes(QStringLiteral("j.1"));
    for (std::size_t length = 0; length <= all.size(); ++length) {
        const std::optional<KeptText> found = readJournal(std::string_view(all).substr(0, length));
        std::optional<KeptText> expected;
        for (const auto &[end, text] : puts) {
            if (end <= length) {
                expected = text;
            }
        }
        QVERIFY2(found == expected, QByteArray::number(quint64(length)));
    }
}

/// With one byte another it is what was put at some time before, and never anything else.
void TestTextJournal::noBrokenByteIsBelieved()
{
    std::mt19937_64 random(seed(3));
    TextJournal journal(folder(), "j");
    std::vector<KeptText> puts;
    KeptText kept{"f", 1, "one\n"};
    for (int i = 0; i < 20; ++i) {
        QVERIFY(journal.put(kept));
        puts.push_back(kept);
        edit(kept.text, random);
    }
    const std::string all = bytes(QStringLiteral("j.1"));
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (const int change : {1, 16, 128, 255}) {
            std::string broken = all;
            broken[i] = static_cast<char>(broken[i] ^ change);
            const std::optional<KeptText> found = readJournal(broken);
            QVERIFY(!found || std::ranges::find(puts, *found) != puts.end());
        }
    }
    // No length and no place is believed beyond what is there.
    for (const char *line : {"text 0 18446744073709551615 ", "edit 5 1 0 ", "edit 0 9 0 ", "\n", "x"}) {
        const std::string head = "text 0 4 ";
        const std::string start = head + std::format("{:016x}\nbase\n", checksum("base", checksum(head)));
        const std::string rest = line + std::format("{:016x}\n\n", checksum("", checksum(line)));
        QVERIFY(readJournal(start + rest) == (KeptText{{}, 0, "base"}));
        QVERIFY(!readJournal(rest));
    }
}

void TestTextJournal::longJournalsAreCompacted()
{
    FullDisk disk;
    TextJournal journal(folder(), "j", disk);
    KeptText kept{"f", 1, {}};
    // Keys.
    for (int i = 0; i < 5'000; ++i) {
        kept.text += "x";
        QVERIFY(journal.put(kept));
        QVERIFY(journal.settle());
    }
    QVERIFY(read() == kept);
    QCOMPARE(names().size(), 1);
    QVERIFY(bytes(names().constLast()).size() < 100'000);
    // Pages.
    for (int i = 0; i < 100; ++i) {
        kept.text = std::string(10'000, static_cast<char>('a' + i % 26));
        QVERIFY(journal.put(kept));
        QVERIFY(journal.settle());
    }
    QVERIFY(read() == kept);
    QCOMPARE(names().size(), 1);
    QVERIFY(bytes(names().constLast()).size() < 120'000);
}

void TestTextJournal::whatIsReplacedStaysUntilTheNewIsOnTheDisk()
{
    FullDisk disk;
    TextJournal journal(folder(), "j", disk);
    KeptText kept{"f", 1, {}};
    for (int i = 0; i < 1'100; ++i) {
        kept.text += "x";
        QVERIFY(journal.put(kept));
    }
    QCOMPARE(names(), (QStringList{QStringLiteral("j.1"), QStringLiteral("j.2")}));
    QVERIFY(readJournal(bytes(QStringLiteral("j.1"))));
    disk.failsToSync = true;
    QVERIFY(!journal.settle());
    QCOMPARE(names().size(), 2);
    disk.failsToSync = false;
    QVERIFY(journal.settle());
    QCOMPARE(names(), QStringList{QStringLiteral("j.2")});
    QVERIFY(read() == kept);
}

void TestTextJournal::aFullDiskLosesNothingThatWasWritten()
{
    for (std::size_t free = 0; free < 400; ++free) {
        init();
        FullDisk disk;
        disk.free = free;
        TextJournal journal(folder(), "j", disk);
        KeptText kept{"f", 1, "one\n"};
        std::optional<KeptText> last;
        int failures = 0;
        for (int i = 0; i < 8; ++i) {
            kept.text += "more and more ";
            const auto put = journal.put(kept);
            if (put) {
                last = kept;
            } else {
                QCOMPARE(put.error(), "disk full");
                ++failures;
            }
            QVERIFY((names().isEmpty() ? std::nullopt : read()) == last);
        }
        QVERIFY(failures > 0 || free > 300);
        // Room again: the next edit makes up for it.
        disk.free = 10'000;
        kept.text += "!";
        QVERIFY(journal.put(kept));
        QVERIFY(read() == kept);
        QVERIFY(journal.settle());
        QCOMPARE(names().size(), 1);
        QVERIFY(read() == kept);
    }
}

/// The system's own refusal, in a process that may write so much and no more.
void TestTextJournal::aFileThatMayGrowNoMoreIsToldWithItsReason()
{
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1'000, 1'000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        TextJournal journal(folder(), "j");
        KeptText kept{"f", 1, {}};
        for (int i = 0; i < 100; ++i) {
            kept.text += std::string(20, static_cast<char>('a' + i % 26));
            if (const auto put = journal.put(kept); !put) {
                ::_exit(put.error() == "larger than a file may be here" ? 0 : 1);
            }
        }
        ::_exit(2);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    QVERIFY(WIFEXITED(status));
    QCOMPARE(WEXITSTATUS(status), 0);
    QVERIFY(read() && read()->text.size() > 100);
}

void TestTextJournal::whatCannotBeCompactedGrows()
{
    FullDisk disk;
    TextJournal journal(folder(), "j", disk);
    KeptText kept{"f", 1, {}};
    for (int i = 0; i < 3'000; ++i) {
        disk.failsToOpen = i > 0;
        kept.text += "x";
        QVERIFY(journal.put(kept));
    }
    QVERIFY(read() == kept);
    QCOMPARE(names().size(), 1);
}

void TestTextJournal::shortWritesGoOn()
{
    FullDisk disk;
    disk.mostBytes = 3;
    TextJournal journal(folder(), "j", disk);
    KeptText kept{"f", 1, "one\n"};
    QVERIFY(journal.put(kept));
    kept.text += "two\n";
    QVERIFY(journal.put(kept));
    QVERIFY(read() == kept);
}

void TestTextJournal::whatCannotSettleIsTold()
{
    FullDisk disk;
    disk.failsToSync = true;
    TextJournal journal(folder(), "j", disk);
    QVERIFY(journal.settle()); // nothing was put
    QCOMPARE(disk.syncs, 0);
    QVERIFY(journal.put({"f", 1, "one\n"}));
    const auto settled = journal.settle();
    QVERIFY(!settled);
    QCOMPARE(settled.error(), "the disk reports an error");
}

void TestTextJournal::nothingStaysOfWhatIsRemoved()
{
    TextJournal journal(folder(), "j");
    journal.remove();
    KeptText kept{"f", 1, {}};
    for (int i = 0; i < 2'500; ++i) {
        kept.text += "x";
        QVERIFY(journal.put(kept));
    }
    QCOMPARE(names().size(), 3);
    journal.remove();
    QVERIFY(names().isEmpty());
    QVERIFY(journal.put(kept));
    QVERIFY(read() == kept);
    QCOMPARE(names().size(), 1);
}

void TestTextJournal::withoutAFolderThereIsAReason()
{
    TextJournal journal(folder() / "none", "j");
    const auto put = journal.put({"f", 1, "x"});
    QVERIFY(!put);
    QCOMPARE(put.error(), "no such file");
    std::filesystem::create_directory(folder() / "none");
    QVERIFY(journal.put({"f", 1, "x"}));
}

}

ROMANESCO_TEST(romanesco::test::TestTextJournal)

#include "testtextjournal.moc"
