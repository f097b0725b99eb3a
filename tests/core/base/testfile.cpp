// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/base/file.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>

#include "tests/testmain.h"

namespace romanesco::test {

/// Every kind of thing a path can lead to. Nothing here may wait: a hang is caught by the test's time limit.
class TestFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void regularFilesAreReadWhole_data();
    void regularFilesAreReadWhole();
    void linksToFilesAreFollowed();
    void filesOfNoStatedSizeAreReadWhole();
    void allElseIsRefusedWithItsReason_data();
    void allElseIsRefusedWithItsReason();
    void unreadableFilesAreRefused();
    void pathsWithNulAreNotCutShort();

private:
    [[nodiscard]] std::filesystem::path path(const char *name) const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / name;
    }
    void write(const char *name, const QByteArray &bytes) const
    {
        QFile file(QString::fromStdString(path(name).string()));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    DiskFiles m_files;
};

void TestFile::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
}

void TestFile::regularFilesAreReadWhole_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("one byte") << QByteArray("x");
    QTest::newRow("NUL and high bytes") << QByteArray("a\0b\xFF\r\n", 6);
    QTest::newRow("3 MB") << QByteArray(3'000'000, 'q');
}

void TestFile::regularFilesAreReadWhole()
{
    QFETCH(QByteArray, bytes);
    write("file", bytes);
    const auto read = m_files.read(path("file"));
    QVERIFY(read.has_value());
    QVERIFY(QByteArray::fromStdString(*read) == bytes);
    QVERIFY(m_files.check(path("file")).has_value());
}

void TestFile::linksToFilesAreFollowed()
{
    write("file", "content");
    QCOMPARE(::symlink("file", path("link").c_str()), 0);
    const auto read = m_files.read(path("link"));
    QVERIFY(read.has_value());
    QCOMPARE(QByteArray::fromStdString(*read), QByteArray("content"));
}

void TestFile::filesOfNoStatedSizeAreReadWhole()
{
    // The kernel says 0 bytes of these and then gives more.
    const auto read = m_files.read("/proc/self/maps");
    QVERIFY(read.has_value());
    QVERIFY(read->size() > 1'000);
    QVERIFY(read->ends_with('\n'));
}

void TestFile::allElseIsRefusedWithItsReason_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("reason");
    QTest::newRow("missing") << "missing" << "no such file";
    QTest::newRow("folder missing") << "missing/file" << "no such file";
    QTest::newRow("directory") << "directory" << "it is a directory";
    QTest::newRow("pipe without a writer") << "pipe" << "it is not a regular file";
    QTest::newRow("endless device") << "/dev/zero" << "it is not a regular file";
    QTest::newRow("null device") << "/dev/null" << "it is not a regular file";
    QTest::newRow("link to a device") << "device link" << "it is not a regular file";
    QTest::newRow("link to itself") << "loop" << "too many symbolic links";
    QTest::newRow("dangling link") << "dangling" << "no such file";
    QTest::newRow("below a file") << "file/below" << "Not a directory";
    QTest::newRow("empty path") << "" << "no such file";
}

void TestFile::allElseIsRefusedWithItsReason()
{
    QFETCH(QString, kind);
    write("file", "content");
    QCOMPARE(::mkdir(path("directory").c_str(), 0700), 0);
    QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
    QCOMPARE(::symlink("/dev/zero", path("device link").c_str()), 0);
    QCOMPARE(::symlink("loop", path("loop").c_str()), 0);
    QCOMPARE(::symlink("nowhere", path("dangling").c_str()), 0);
    const auto place = kind.isEmpty() ? std::filesystem::path() : path(kind.toUtf8().constData());
    const auto read = m_files.read(place);
    QVERIFY(!read.has_value());
    QTEST(QString::fromStdString(read.error()), "reason");
    const auto check = m_files.check(place);
    QVERIFY(!check.has_value());
    QTEST(QString::fromStdString(check.error()), "reason");
}

void TestFile::unreadableFilesAreRefused()
{
    if (::geteuid() == 0) {
        QSKIP("root may read everything");
    }
    write("secret", "content");
    QCOMPARE(::chmod(path("secret").c_str(), 0), 0);
    const auto read = m_files.read(path("secret"));
    QVERIFY(!read.has_value());
    QCOMPARE(QString::fromStdString(read.error()), "permission denied");
}

void TestFile::pathsWithNulAreNotCutShort()
{
    write("file", "content");
    const std::string name = path("file").string() + std::string("\0.obj", 5);
    QVERIFY(!m_files.read(name).has_value());
}

}

ROMANESCO_TEST(romanesco::test::TestFile)

#include "testfile.moc"
