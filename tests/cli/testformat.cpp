// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <csignal>

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestFormat : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char *name) const { return m_folder->filePath(QLatin1String(name)); }

    static Outcome format(const QStringList &arguments, const QByteArray &input = {})
    {
        return run(QStringList{QStringLiteral("format")} + arguments, input);
    }

    /// The files there are, temporary ones too.
    QStringList files() const
    {
        return QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void filesAreTidiedInPlace()
    {
        write(path("a.fdo"), "  x.\"a.obj\"   # it \n\n\n<$>.x");
        write(path("b.SDO"), "l##\r\n");
        write(path("c.fdo"), "x. \"a.obj\"\n");
        const Outcome outcome = format({path("a.fdo"), path("b.SDO"), path("c.fdo")});
        QCOMPARE(outcome.out + outcome.err, QByteArray());
        QCOMPARE(outcome.status, 0);
        QCOMPARE(bytesOf(path("a.fdo")), QByteArray("x. \"a.obj\" # it\n\n<$>. x\n"));
        QCOMPARE(bytesOf(path("b.SDO")), QByteArray("l # #\r\n"));
        QCOMPARE(bytesOf(path("c.fdo")), QByteArray("x. \"a.obj\"\n"));
        QCOMPARE(files().size(), 3);
    }

    void aTidyFileIsNotWritten()
    {
        write(path("a.fdo"), "x. y\n");
        QFile file(path("a.fdo"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QDateTime before = QDateTime::fromSecsSinceEpoch(1'000'000'000);
        QVERIFY(file.setFileTime(before, QFileDevice::FileModificationTime));
        file.close();
        QCOMPARE(format({path("a.fdo")}).status, 0);
        QCOMPARE(QFileInfo(path("a.fdo")).lastModified(), before);
    }

    void checkOnlyTells()
    {
        write(path("a.fdo"), "x.y\n");
        write(path("b.fdo"), "x. y\n");
        const Outcome outcome = format({QStringLiteral("--check"), path("a.fdo"), path("b.fdo")});
        QCOMPARE(outcome.out, path("a.fdo").toUtf8() + ": would change\n");
        QCOMPARE(outcome.err, QByteArray());
        QCOMPARE(outcome.status, 1);
        QCOMPARE(bytesOf(path("a.fdo")), QByteArray("x.y\n"));
        QCOMPARE(format({QStringLiteral("--check"), path("b.fdo")}).status, 0);
    }

    void dashGoesToStandardOutput()
    {
        const Outcome outcome = format({QStringLiteral("-")}, "x.y\n");
        QCOMPARE(outcome.out, QByteArray("x. y\n"));
        QCOMPARE(outcome.err, QByteArray());
        QCOMPARE(outcome.status, 0);
        QCOMPARE(format({QStringLiteral("-")}, "x. y\n").out, QByteArray("x. y\n"));
        const Outcome check = format({QStringLiteral("--check"), QStringLiteral("-")}, "x.y\n");
        QCOMPARE(check.out, QByteArray("<stdin>: would change\n"));
        QCOMPARE(check.status, 1);
    }

    /// At the places that they have now, after lines above have gone.
    void linesThatCannotBeReadAreTold()
    {
        write(path("a.fdo"), "\n\nx.  (\ny.x\n");
        const QByteArray name = path("a.fdo").toUtf8();
        const Outcome check = format({QStringLiteral("--check"), path("a.fdo")});
        QVERIFY2(check.err.startsWith(name + ":3:6: error: "), check.err);
        const Outcome outcome = format({path("a.fdo")});
        QVERIFY2(outcome.err.startsWith(name + ":1:6: error: "), outcome.err);
        QCOMPARE(outcome.status, 1);
        QCOMPARE(bytesOf(path("a.fdo")), QByteArray("x.  (\ny. x\n"));
        QCOMPARE(format({path("a.fdo")}).status, 1);
        QCOMPARE(format({QStringLiteral("--check"), path("a.fdo")}).status, 1);
        const Outcome dash = format({QStringLiteral("-")}, "x.  (\ny.x");
        QCOMPARE(dash.out, QByteArray("x.  (\ny. x\n"));
        QCOMPARE(dash.status, 1);
    }

    void whatIsNoTextStays()
    {
        const QByteArray text("\xFF\xFEx\0.\0y\0", 8);
        write(path("a.fdo"), text);
        const Outcome outcome = format({path("a.fdo")});
        QVERIFY2(outcome.err.contains("a.fdo:1:1: error: the file is not UTF-8 text"), outcome.err);
        QCOMPARE(outcome.status, 1);
        QCOMPARE(bytesOf(path("a.fdo")), text);
    }

    void theOthersAreTidiedWhereOneCannotBeRead()
    {
        write(path("b.fdo"), "x.y\n");
        const Outcome outcome = format({path("gone.fdo"), path("b.fdo")});
        QCOMPARE(outcome.err, "romanesco: cannot read " + path("gone.fdo").toUtf8() + ": no such file\n");
        QCOMPARE(outcome.status, 1);
        QCOMPARE(bytesOf(path("b.fdo")), QByteArray("x. y\n"));
    }

    void wrongUsageTouchesNothing()
    {
        write(path("a.fdo"), "x.y\n");
        write(path("b.obj"), triangle);
        const Outcome outcome = format({path("a.fdo"), path("b.obj")});
        QCOMPARE(outcome.err, "romanesco: format takes .fdo and .sdo files, not " + path("b.obj").toUtf8() + '\n');
        QCOMPARE(outcome.status, 2);
        QCOMPARE(bytesOf(path("a.fdo")), QByteArray("x.y\n"));
    }

    void linksStayAndPermissionsToo()
    {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("inside")));
        write(path("inside/a.fdo"), "x.y\n");
        const QFileDevice::Permissions mode =
            QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner | QFileDevice::ReadGroup;
        QVERIFY(QFile::setPermissions(path("inside/a.fdo"), mode));
        QVERIFY(QFile::link(QStringLiteral("inside/a.fdo"), path("first.fdo")));
        QVERIFY(QFile::link(QStringLiteral("first.fdo"), path("second.fdo")));
        QCOMPARE(format({path("second.fdo")}).status, 0);
        QCOMPARE(QFile::symLinkTarget(path("second.fdo")), path("first.fdo"));
        QCOMPARE(QFile::symLinkTarget(path("first.fdo")), path("inside/a.fdo"));
        QVERIFY(!QFileInfo(path("inside/a.fdo")).isSymLink());
        QCOMPARE(bytesOf(path("inside/a.fdo")), QByteArray("x. y\n"));
        const QFileDevice::Permissions user = QFileDevice::ReadUser | QFileDevice::WriteUser | QFileDevice::ExeUser;
        QCOMPARE(QFile::permissions(path("inside/a.fdo")) & ~user, mode);
    }

    void whatCannotBeWrittenStaysWhole_data()
    {
        QTest::addColumn<bool>("isFull");
        QTest::newRow("read-only folder") << false;
        QTest::newRow("no space") << true;
    }

    void whatCannotBeWrittenStaysWhole()
    {
        QFETCH(bool, isFull);
        const QByteArray text = QByteArray("x.y\n").repeated(100'000);
        write(path("a.fdo"), text);
        if (!isFull) {
            QVERIFY(QFile::setPermissions(m_folder->path(), QFileDevice::ReadOwner | QFileDevice::ExeOwner));
        }
        QProcess process;
        process.setChildProcessModifier([isFull] {
            if (isFull) { // a file may not grow beyond, and trying says so
                const rlimit limit{10'000, 10'000};
                ::setrlimit(RLIMIT_FSIZE, &limit);
                std::signal(SIGXFSZ, SIG_IGN);
            } else { // permissions are for root as well, then
                ::prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE);
            }
        });
        process.start(QStringLiteral(ROMANESCO_PROGRAM), {QStringLiteral("format"), path("a.fdo")});
        const Outcome outcome = outcomeOf(process);
        QFile::setPermissions(m_folder->path(),
                              QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
        QVERIFY2(outcome.err.startsWith("romanesco: cannot write " + path("a.fdo").toUtf8() + ": "), outcome.err);
        QCOMPARE(outcome.status, 3);
        QCOMPARE(bytesOf(path("a.fdo")), text);
        QCOMPARE(files(), QStringList{QStringLiteral("a.fdo")});
    }
};

}

ROMANESCO_TEST(romanesco::test::TestFormat)

#include "testformat.moc"
