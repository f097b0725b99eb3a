// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/base/atomicfile.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Calls that reach the system but for one of them, which fails with an error of the test's choice. Some can be made
/// to fail always.
class FailingCalls final : public FileCalls
{
public:
    /// The call to fail, from 0; none for -1.
    int failing = -1;
    int error = EIO;
    bool hasUnnamed = true;
    /// At most so many bytes a call.
    std::size_t mostBytes = std::size_t{1} << 30;
    bool isInterrupted = false;
    /// What stands there looks like a device: a true one would be lost where the test fails.
    bool isDevice = false;

    int count = 0;
    QByteArray failed;

    int open(const char *path, int flags) override { return fails("open") ? -1 : FileCalls::open(path, flags); }
    int openat(int folder, const char *name, int flags, mode_t mode) override
    {
        if ((flags & O_TMPFILE) == O_TMPFILE && !hasUnnamed) {
            errno = EOPNOTSUPP;
            return -1;
        }
        return fails("openat") ? -1 : FileCalls::openat(folder, name, flags, mode);
    }
    ssize_t readlinkat(int folder, const char *name, char *buffer, std::size_t size) override
    {
        return fails("readlinkat") ? -1 : FileCalls::readlinkat(folder, name, buffer, size);
    }
    int fstatat(int folder, const char *name, struct stat *status) override
    {
        const int result = fails("fstatat") ? -1 : FileCalls::fstatat(folder, name, status);
        if (isDevice) {
            status->st_mode = S_IFCHR | 0666;
        }
        return result;
    }
    int mayWrite(int folder, const char *name) override
    {
        return fails("faccessat") ? -1 : FileCalls::mayWrite(folder, name);
    }
    int fchown(int file, uid_t owner, gid_t group) override
    {
        return fails("fchown") ? -1 : FileCalls::fchown(file, owner, group);
    }
    int fchmod(int file, mode_t mode) override { return fails("fchmod") ? -1 : FileCalls::fchmod(file, mode); }
    ssize_t write(int file, const void *bytes, std::size_t size) override
    {
        if (isInterrupted && count % 2 == 0) {
            ++count;
            errno = EINTR;
            return -1;
        }
        return fails("write") ? -1 : FileCalls::write(file, bytes, std::min(size, mostBytes));
    }
    int fsync(int file) override { return fails("fsync") ? -1 : FileCalls::fsync(file); }
    int link(int file, int folder, const char *name) override
    {
        return fails("link") ? -1 : FileCalls::link(file, folder, name);
    }
    int renameat(int folder, const char *from, const char *to) override
    {
        return fails("renameat") ? -1 : FileCalls::renameat(folder, from, to);
    }

private:
    bool fails(const char *name)
    {
        if (count++ != failing) {
            return false;
        }
        failed = name;
        errno = error;
        return true;
    }
};

const QByteArray oldBytes("what stood there before");
const QByteArray newBytes(300'000, 'n');

}

class TestAtomicFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void newFilesAppearAtTheCommit();
    void oldFilesAreReplacedAtTheCommit();
    void withoutACommitNothingHappens();
    void permissionsStay();
    void newFilesHaveThePermissionsOfTheUmask();
    void linksStayAndTheirTargetsAreWritten();
    void chainsOfLinksAreFollowed();
    void whatCannotBeWrittenIsToldWithItsReason_data();
    void whatCannotBeWrittenIsToldWithItsReason();
    void devicesAreRefused();
    void readOnlyFilesAreNotWrittenOver();
    void everyCallMayFail_data();
    void everyCallMayFail();
    void reasonsAreInWords_data();
    void reasonsAreInWords();
    void shortAndInterruptedWritesGoOn();
    void aProcessThatIsKilledWhileItWritesLeavesNothing();

private:
    [[nodiscard]] QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }
    [[nodiscard]] std::filesystem::path target(const char *name = "target") const { return path(name).toStdString(); }
    void put(const char *name, const QByteArray &bytes) const
    {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    [[nodiscard]] QByteArray bytes(const char *name = "target") const
    {
        QFile file(path(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
    }
    [[nodiscard]] QStringList names() const
    {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }
    /// Writes newBytes in two pieces.
    [[nodiscard]] std::expected<void, std::string> save(FileCalls &calls = FileCalls::system(),
                                                        const char *name = "target") const;

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestAtomicFile::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
}

std::expected<void, std::string> TestAtomicFile::save(FileCalls &calls, const char *name) const
{
    auto file = AtomicFile::create(target(name), calls);
    if (!file) {
        return std::unexpected(file.error());
    }
    const std::string_view all(newBytes.data(), static_cast<std::size_t>(newBytes.size()));
    for (const std::string_view piece : {all.substr(0, 1'000), all.substr(1'000)}) {
        if (auto written = file->write(piece); !written) {
            return written;
        }
    }
    return file->commit();
}

void TestAtomicFile::newFilesAppearAtTheCommit()
{
    for (const bool hasUnnamed : {true, false}) {
        init();
        FailingCalls calls;
        calls.hasUnnamed = hasUnnamed;
        auto file = AtomicFile::create(target(), calls);
        QVERIFY(file);
        QVERIFY(file->write("all of it"));
        QVERIFY(!QFile::exists(path("target")));
        QCOMPARE(names().size(), hasUnnamed ? 0 : 1);
        QVERIFY(file->commit());
        QCOMPARE(bytes(), QByteArray("all of it"));
        QCOMPARE(names(), QStringList("target"));
    }
}

void TestAtomicFile::oldFilesAreReplacedAtTheCommit()
{
    for (const bool hasUnnamed : {true, false}) {
        init();
        put("target", oldBytes);
        FailingCalls calls;
        calls.hasUnnamed = hasUnnamed;
        auto file = AtomicFile::create(target(), calls);
        QVERIFY(file);
        QVERIFY(file->write("all of it"));
        QCOMPARE(bytes(), oldBytes);
        QVERIFY(file->commit());
        QCOMPARE(bytes(), QByteArray("all of it"));
        QCOMPARE(names(), QStringList("target"));
    }
}

void TestAtomicFile::withoutACommitNothingHappens()
{
    for (const bool hasUnnamed : {true, false}) {
        FailingCalls calls;
        calls.hasUnnamed = hasUnnamed;
        put("target", oldBytes);
        {
            auto file = AtomicFile::create(target(), calls);
            QVERIFY(file);
            QVERIFY(file->write("half of"));
        }
        QCOMPARE(bytes(), oldBytes);
        QCOMPARE(names(), QStringList("target"));
    }
}

void TestAtomicFile::permissionsStay()
{
    for (const mode_t mode : {0600, 0640, 0755, 0666}) {
        put("target", oldBytes);
        QCOMPARE(::chmod(target().c_str(), mode), 0);
        QVERIFY(save());
        struct stat status{};
        QCOMPARE(::stat(target().c_str(), &status), 0);
        QCOMPARE(status.st_mode & 07777, mode);
    }
}

void TestAtomicFile::newFilesHaveThePermissionsOfTheUmask()
{
    for (const mode_t mask : {mode_t{0027}, mode_t{0077}, mode_t{0002}}) {
        init();
        const mode_t before = ::umask(mask);
        const bool isSaved = save().has_value();
        ::umask(before);
        QVERIFY(isSaved);
        struct stat status{};
        QCOMPARE(::stat(target().c_str(), &status), 0);
        QCOMPARE(status.st_mode & 07777, 0666u & ~mask);
    }
}

void TestAtomicFile::linksStayAndTheirTargetsAreWritten()
{
    QVERIFY(QDir(m_folder->path()).mkdir("elsewhere"));
    for (const char *aim : {"elsewhere/real", "../target/../elsewhere/new"}) {
        // the second one leads nowhere yet, by a path that means something only seen from the link's own folder
        init();
        QVERIFY(QDir(m_folder->path()).mkpath("elsewhere"));
        QVERIFY(QDir(m_folder->path()).mkpath("target"));
        QVERIFY(QDir(m_folder->path()).mkpath("links"));
        const std::string link = target("links/link");
        const std::string aimed = std::string(aim).starts_with("..") ? aim : target(aim).string();
        QCOMPARE(::symlink(aimed.c_str(), link.c_str()), 0);
        QVERIFY(save(FileCalls::system(), "links/link"));
        QVERIFY(QFileInfo(path("links/link")).isSymLink());
        QCOMPARE(bytes("links/link"), newBytes);
        QCOMPARE(QDir(path("elsewhere")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(), 1);
    }
}

void TestAtomicFile::chainsOfLinksAreFollowed()
{
    put("end", oldBytes);
    std::string before = "end";
    for (int i = 0; i < 30; ++i) {
        const std::string name = "link" + std::to_string(i);
        QCOMPARE(::symlink(before.c_str(), target(name.c_str()).c_str()), 0);
        before = name;
    }
    QVERIFY(save(FileCalls::system(), "link29"));
    QCOMPARE(bytes("end"), newBytes);
    QCOMPARE(names().size(), 31);
}

void TestAtomicFile::whatCannotBeWrittenIsToldWithItsReason_data()
{
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char *name, const char *to, const char *reason) {
        QTest::newRow(name) << QString::fromLatin1(to) << QString::fromLatin1(reason);
    };
    row("folder", "folder", "it is a directory");
    row("folder with a slash", "folder/", "it is a directory");
    row("the folder itself", "folder/.", "it is a directory");
    row("pipe", "pipe", "it is not a regular file");
    row("link to a pipe", "linktopipe", "it is not a regular file");
    row("missing folder", "gone/file", "no such folder");
    row("a file as folder", "file/file", "Not a directory");
    row("loop of links", "loop", "too many symbolic links");
    row("nothing", "", "it is a directory");
    row("name too long", "long", "the name is too long");
}

void TestAtomicFile::whatCannotBeWrittenIsToldWithItsReason()
{
    QFETCH(QString, to);
    QFETCH(const QString, reason);
    QVERIFY(QDir(m_folder->path()).mkdir("folder"));
    put("file", oldBytes);
    QCOMPARE(::mkfifo(target("pipe").c_str(), 0600), 0);
    QCOMPARE(::symlink("pipe", target("linktopipe").c_str()), 0);
    QCOMPARE(::symlink("loop", target("loop").c_str()), 0);
    if (to == QLatin1String("long")) {
        to = QString(300, QLatin1Char('n'));
    }
    const QStringList before = names();
    const bool isInFolder = !to.isEmpty() && !to.startsWith(QLatin1Char('/'));
    const std::string whole = (isInFolder ? m_folder->path() + QLatin1Char('/') + to : to).toStdString();
    const auto result = writeWhole(whole, "bytes");
    QVERIFY(!result);
    QCOMPARE(QString::fromStdString(result.error()), reason);
    QCOMPARE(names(), before);
    QCOMPARE(bytes("file"), oldBytes);
}

void TestAtomicFile::devicesAreRefused()
{
    put("target", oldBytes);
    FailingCalls calls;
    calls.isDevice = true;
    const auto result = save(calls);
    QVERIFY(!result);
    QCOMPARE(QString::fromStdString(result.error()), QStringLiteral("it is not a regular file"));
    QCOMPARE(bytes(), oldBytes);
}

void TestAtomicFile::readOnlyFilesAreNotWrittenOver()
{
    // as for the system, the superuser is not asked
    FailingCalls calls;
    put("target", oldBytes);
    QCOMPARE(::chmod(target().c_str(), 0444), 0);
    const auto result = save(calls);
    QCOMPARE(result.has_value(), ::access(target().c_str(), W_OK) == 0);
    QCOMPARE(bytes(), result ? newBytes : oldBytes);
}

void TestAtomicFile::everyCallMayFail_data()
{
    QTest::addColumn<bool>("isOld");
    QTest::addColumn<bool>("hasUnnamed");
    QTest::newRow("new file") << false << true;
    QTest::newRow("old file") << true << true;
    QTest::newRow("new file, by a hidden one") << false << false;
    QTest::newRow("old file, by a hidden one") << true << false;
}

/// Whatever fails, the target is the old file or the new one, and nothing stands beside it. A failure that is not told
/// is one that does not matter: the new file is there.
void TestAtomicFile::everyCallMayFail()
{
    QFETCH(const bool, isOld);
    QFETCH(const bool, hasUnnamed);
    QByteArrayList told;
    for (int failing = 0;; ++failing) {
        init();
        if (isOld) {
            put("target", oldBytes);
        }
        FailingCalls calls;
        calls.hasUnnamed = hasUnnamed;
        calls.failing = failing;
        const auto result = save(calls);
        if (calls.failed.isEmpty()) {
            QVERIFY(result);
            break;
        }
        if (result) {
            QVERIFY2(calls.failed == "fchown" || calls.failed == "openat", calls.failed);
        } else {
            QCOMPARE(QString::fromStdString(result.error()), QStringLiteral("the disk reports an error"));
            told.append(calls.failed);
        }
        const bool isNew = QFile::exists(path("target")) && bytes() == newBytes;
        // the last call puts the folder on the disk, when the file has its place
        QCOMPARE(isNew, result.has_value() || told.count("fsync") == 2);
        if (!isNew) {
            QCOMPARE(QFile::exists(path("target")), isOld);
            QVERIFY(!isOld || bytes() == oldBytes);
        }
        QCOMPARE(names().size(), isOld || isNew ? 1 : 0);
    }
    QVERIFY(told.contains("write") && told.contains("open") && told.contains("fsync"));
    QVERIFY(!isOld || (told.contains("renameat") && told.contains("fchmod") && told.contains("faccessat")));
    QCOMPARE(told.contains("link"), hasUnnamed);
}

void TestAtomicFile::reasonsAreInWords_data()
{
    QTest::addColumn<int>("error");
    QTest::addColumn<QString>("words");
    QTest::newRow("ENOSPC") << ENOSPC << QStringLiteral("disk full");
    QTest::newRow("EDQUOT") << EDQUOT << QStringLiteral("disk quota exceeded");
    QTest::newRow("EROFS") << EROFS << QStringLiteral("read-only file system");
    QTest::newRow("EFBIG") << EFBIG << QStringLiteral("larger than a file may be here");
    QTest::newRow("EACCES") << EACCES << QStringLiteral("permission denied");
}

void TestAtomicFile::reasonsAreInWords()
{
    QFETCH(const int, error);
    QFETCH(const QString, words);
    FailingCalls calls;
    calls.error = error;
    calls.failing = 4; // open, readlinkat, fstatat, openat, write
    const auto result = save(calls);
    QCOMPARE(calls.failed, QByteArray("write"));
    QVERIFY(!result);
    QCOMPARE(QString::fromStdString(result.error()), words);
}

void TestAtomicFile::shortAndInterruptedWritesGoOn()
{
    FailingCalls calls;
    calls.mostBytes = 1'000;
    calls.isInterrupted = true;
    QVERIFY(save(calls));
    QCOMPARE(bytes(), newBytes);
}

void TestAtomicFile::aProcessThatIsKilledWhileItWritesLeavesNothing()
{
    put("target", oldBytes);
    int pipe[2];
    QCOMPARE(::pipe(pipe), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        auto file = AtomicFile::create(target());
        const bool isHalf = file && file->write({newBytes.data(), static_cast<std::size_t>(newBytes.size())});
        const ssize_t told = ::write(pipe[1], isHalf ? "y" : "n", 1);
        ::pause();
        ::_exit(told == 1 ? 0 : 1);
    }
    char word = 0;
    QCOMPARE(::read(pipe[0], &word, 1), 1);
    QCOMPARE(word, 'y');
    QCOMPARE(::kill(child, SIGKILL), 0);
    QCOMPARE(::waitpid(child, nullptr, 0), child);
    ::close(pipe[0]);
    ::close(pipe[1]);
    QCOMPARE(bytes(), oldBytes);
    QCOMPARE(names(), QStringList("target"));
}

}

ROMANESCO_TEST(romanesco::test::TestAtomicFile)
#include "testatomicfile.moc"
