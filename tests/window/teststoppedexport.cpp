// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <array>
#include <csignal>

#include <linux/capability.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QMessageBox>

#include "exportsample.h"

using namespace romanesco;
using namespace romanesco::test;
using Sample = romanesco::test::ExportSample;

namespace {

/// Takes from this thread, and those that it starts, what the superuser may do to every file.
class PlainUser
{
public:
    PlainUser()
    {
        ::syscall(SYS_capget, &m_header, m_old.data());
        auto fewer = m_old;
        fewer[0].effective &= ~(1u << CAP_DAC_OVERRIDE | 1u << CAP_DAC_READ_SEARCH);
        ::syscall(SYS_capset, &m_header, fewer.data());
    }
    ~PlainUser() { ::syscall(SYS_capset, &m_header, m_old.data()); }
    PlainUser(const PlainUser &) = delete;
    PlainUser &operator=(const PlainUser &) = delete;

private:
    __user_cap_header_struct m_header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, 2> m_old{};
};

}

/// An export that does not come to its end: it is cancelled, or the file cannot be written.
class TestStoppedExport : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    void cancellingLeavesNoFile();
    void cancellingLeavesTheOldFile();
    void closingCancels();
    void closingAsksAfterAWhile();
    void theQuestionGoesWithTheExport();
    void destroyingCancels();
    void whatCannotBeWrittenIsSaid_data();
    void whatCannotBeWrittenIsSaid();
    void aFullDiskIsSaid();
};

void TestStoppedExport::cancellingLeavesNoFile()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.dialog->isExporting());
    QVERIFY(!sample.file().isEnabled());
    QVERIFY(sample.waitForBytes());
    QVERIFY2(sample.words().contains(QRegularExpression(QStringLiteral("of about .*B, about .* left"))),
             qPrintable(sample.words()));
    QVERIFY(sample.the<QProgressBar>().value() < sample.the<QProgressBar>().maximum());
    sample.button(QStringLiteral("Cancel")).click();
    QVERIFY(sample.waitForEnd());
    QCOMPARE(sample.written(), QStringList());
    QVERIFY(sample.dialog->isVisible());
    QVERIFY2(sample.trouble().contains(QStringLiteral("cancelled")), qPrintable(sample.trouble()));
    QVERIFY(sample.the<QProgressBar>().isHidden());
    QVERIFY(sample.file().isEnabled());
    QVERIFY(sample.button(QStringLiteral("Export")).isEnabled());
    QVERIFY(sample.exported.isEmpty());
}

void TestStoppedExport::cancellingLeavesTheOldFile()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    std::ignore = sample.folders.write(QStringLiteral("out.obj"), "old");
    // it was not there when the forecast was made, and nobody has been told
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(!sample.dialog->isExporting());
    QTRY_VERIFY(sample.words().contains(QStringLiteral("will be replaced")));
    QVERIFY(!sample.dialog->isExporting());
    sample.button(QStringLiteral("Replace")).click();
    QVERIFY(sample.waitForBytes());
    sample.button(QStringLiteral("Cancel")).click();
    QVERIFY(sample.waitForEnd());
    QCOMPARE(Folders::read(sample.path), QByteArray("old"));
    QCOMPARE(sample.written(), QStringList{QStringLiteral("out.obj")});
}

void TestStoppedExport::closingCancels()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForBytes());
    QTest::keyClick(sample.dialog.get(), Qt::Key_Escape);
    QVERIFY(!sample.dialog->findChild<QMessageBox *>());
    QVERIFY(sample.waitForEnd());
    QVERIFY(sample.dialog->isHidden());
    QCOMPARE(sample.dialog->result(), int(QDialog::Rejected));
    QCOMPARE(sample.written(), QStringList());
}

void TestStoppedExport::closingAsksAfterAWhile()
{
    Sample sample(22);
    sample.dialog->setPatience(std::chrono::milliseconds(-1));
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForBytes());
    sample.dialog->close();
    QPointer<QMessageBox> question = sample.dialog->findChild<QMessageBox *>();
    QVERIFY(question);
    question->reject();
    QVERIFY(sample.dialog->isExporting());
    QVERIFY(sample.dialog->isVisible());
    QTRY_VERIFY(!question);
    sample.dialog->close();
    question = sample.dialog->findChild<QMessageBox *>();
    QVERIFY(question);
    sample.button(QStringLiteral("Stop and Close")).click();
    QVERIFY(sample.waitForEnd());
    QVERIFY(sample.dialog->isHidden());
    QCOMPARE(sample.written(), QStringList());
}

void TestStoppedExport::theQuestionGoesWithTheExport()
{
    Sample sample(18);
    sample.dialog->setPatience(std::chrono::milliseconds(-1));
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    sample.dialog->close();
    const QPointer<QMessageBox> question = sample.dialog->findChild<QMessageBox *>();
    QVERIFY(question);
    QVERIFY(sample.waitForEnd());
    QTRY_VERIFY(!question);
    QVERIFY(sample.dialog->isHidden());
    QCOMPARE(sample.exported.size(), 3);
}

void TestStoppedExport::destroyingCancels()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForBytes());
    sample.dialog.reset();
    QCOMPARE(sample.written(), QStringList());
}

void TestStoppedExport::whatCannotBeWrittenIsSaid_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("pipe") << "pipe" << "it is not a regular file";
    QTest::newRow("device") << "device" << "it is not a regular file";
    QTest::newRow("folder") << "folder" << "it is a directory";
    QTest::newRow("no folder") << "missing/out.obj" << "no such folder";
    QTest::newRow("read-only") << "locked/out.obj" << "permission denied";
}

void TestStoppedExport::whatCannotBeWrittenIsSaid()
{
    QFETCH(const QString, name);
    QFETCH(const QString, reason);
    Sample sample(3);
    QCOMPARE(::mkfifo(QFile::encodeName(sample.folders.path(QStringLiteral("pipe"))).constData(), 0600), 0);
    // by a link, so that no fault can harm the device itself
    QVERIFY(QFile::link(QStringLiteral("/dev/full"), sample.folders.path(QStringLiteral("device"))));
    QVERIFY(QDir(sample.folders.own.path()).mkdir(QStringLiteral("folder")));
    QVERIFY(QDir(sample.folders.own.path()).mkdir(QStringLiteral("locked")));
    QCOMPARE(::chmod(QFile::encodeName(sample.folders.path(QStringLiteral("locked"))).constData(), 0500), 0);
    const QStringList before = sample.folders.names();
    sample.file().setText(name);
    QVERIFY(sample.waitForEstimate());
    const PlainUser user;
    sample.button(QFileInfo::exists(sample.dialog->path()) ? QStringLiteral("Replace") : QStringLiteral("Export"))
        .click();
    QVERIFY(sample.waitForEnd());
    QVERIFY(sample.dialog->isVisible());
    QVERIFY2(sample.trouble().contains(QStringLiteral("was not written: ") + reason), qPrintable(sample.trouble()));
    QVERIFY(sample.trouble().contains(sample.dialog->path()));
    QCOMPARE(sample.folders.names(), before);
}

/// As near as a test comes to it without one.
void TestStoppedExport::aFullDiskIsSaid()
{
    Sample sample(18);
    QVERIFY(sample.waitForEstimate());
    std::signal(SIGXFSZ, SIG_IGN); // as the program does
    rlimit old{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{1'000'000, old.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
    sample.button(QStringLiteral("Export")).click();
    const bool hasEnded = sample.waitForEnd();
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &old), 0);
    QVERIFY(hasEnded);
    QVERIFY2(sample.trouble().contains(QStringLiteral("larger than a file may be")), qPrintable(sample.trouble()));
    QCOMPARE(sample.written(), QStringList());
}

QTEST_MAIN(TestStoppedExport)
#include "teststoppedexport.moc"
