// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <functional>
#include <memory>

#include <sys/mman.h>

#include "app/window/filewatch.h"
#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

struct Sample : Folders {
    FileWatch watch;
    QObject owner;
    QSignalSpy spy{&watch, &FileWatch::changed};

    /// And until the watch has them.
    void setPaths(const QStringList &names)
    {
        QStringList paths;
        for (const QString &name : names) {
            paths += path(name);
        }
        watch.setPaths(&owner, paths);
        QTest::qWait(150);
    }
    /// What was told of, by names, once it is quiet.
    QStringList told()
    {
        QTest::qWait(350);
        QStringList names;
        while (!spy.isEmpty()) {
            for (const QString &path : spy.takeFirst().at(0).toStringList()) {
                names += QDir(own.path()).relativeFilePath(path);
            }
        }
        names.sort();
        return names;
    }
    [[nodiscard]] QDir folder() const { return QDir(own.path()); }
};

const QString file = QStringLiteral("d/a.obj");

using Act = std::function<void(const Sample &)>;

void append(const Sample &sample, const QString &name)
{
    QFile opened(sample.path(name));
    QVERIFY(opened.open(QIODevice::Append) && opened.write("more") == 4);
}

}

Q_DECLARE_METATYPE(Act)

class TestFileWatch : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void whateverHappensToAFileIsTold_data();
    void whateverHappensToAFileIsTold();
    void itIsToldAgainAndAgain();
    void whatIsNotThereYetIsAwaited();
    void foldersGoAndComeBack();
    void othersAreNotToldOf();
    void ownWritesAreNotToldOf();
    void aBurstIsToldOfOnce();
    void aThousandFilesAreWatched();
    void eachAsksForHisOwn();
    void whatIsNotToldIsFoundWhenAsked();
    void documentsFollowByIt();
};

void TestFileWatch::whateverHappensToAFileIsTold_data()
{
    QTest::addColumn<Act>("act");
    QTest::newRow("in place") << Act([](const Sample &s) { append(s, file); });
    QTest::newRow("truncated") << Act([](const Sample &s) { QVERIFY(QFile::resize(s.path(file), 1)); });
    QTest::newRow("replaced") << Act([](const Sample &s) { static_cast<void>(s.replace(file, "other")); });
    QTest::newRow("replaced by as much") << Act([](const Sample &s) { static_cast<void>(s.replace(file, "OLD")); });
    QTest::newRow("removed") << Act([](const Sample &s) { QVERIFY(QFile::remove(s.path(file))); });
    QTest::newRow("removed and made") << Act([](const Sample &s) {
        QVERIFY(QFile::remove(s.path(file)));
        static_cast<void>(s.write(file, "other"));
    });
    QTest::newRow("renamed") << Act([](const Sample &s) { QVERIFY(s.folder().rename(file, QStringLiteral("d/b"))); });
    QTest::newRow("folder removed") << Act(
        [](const Sample &s) { QVERIFY(QDir(s.path(QStringLiteral("d"))).removeRecursively()); });
    QTest::newRow("folder renamed") << Act(
        [](const Sample &s) { QVERIFY(s.folder().rename(QStringLiteral("d"), QStringLiteral("e"))); });
}

void TestFileWatch::whateverHappensToAFileIsTold()
{
    QFETCH(const Act, act);
    Sample sample;
    QVERIFY(sample.folder().mkdir(QStringLiteral("d")));
    static_cast<void>(sample.write(file, "old"));
    sample.setPaths({file});
    QVERIFY(sample.told().isEmpty());
    act(sample);
    QCOMPARE(sample.told(), QStringList{file});
    QVERIFY(sample.told().isEmpty());
}

void TestFileWatch::itIsToldAgainAndAgain()
{
    Sample sample;
    const QString name = QStringLiteral("a.obj");
    static_cast<void>(sample.write(name, "old"));
    sample.setPaths({name});
    for (int i = 0; i < 4; ++i) {
        static_cast<void>(sample.replace(name, QByteArray::number(i)));
        QCOMPARE(sample.told(), QStringList{name});
        append(sample, name);
        QCOMPARE(sample.told(), QStringList{name});
    }
}

void TestFileWatch::whatIsNotThereYetIsAwaited()
{
    Sample sample;
    const QString name = QStringLiteral("x/y/z/a.obj");
    sample.setPaths({name});
    QVERIFY(sample.folder().mkdir(QStringLiteral("x")));
    QVERIFY(sample.told().isEmpty());
    QVERIFY(sample.folder().mkpath(QStringLiteral("x/y/z")));
    static_cast<void>(sample.write(name, "new"));
    QCOMPARE(sample.told(), QStringList{name});
    append(sample, name);
    QCOMPARE(sample.told(), QStringList{name});
}

void TestFileWatch::foldersGoAndComeBack()
{
    Sample sample;
    const QString name = QStringLiteral("x/y/a.obj");
    QVERIFY(sample.folder().mkpath(QStringLiteral("x/y")));
    static_cast<void>(sample.write(name, "old"));
    sample.setPaths({name});
    // Away and back, as it was.
    QVERIFY(sample.folder().rename(QStringLiteral("x"), QStringLiteral("away")));
    QCOMPARE(sample.told(), QStringList{name});
    QVERIFY(sample.folder().rename(QStringLiteral("away"), QStringLiteral("x")));
    QCOMPARE(sample.told(), QStringList{name});
    append(sample, name);
    QCOMPARE(sample.told(), QStringList{name});
    // Another in its place at once.
    QVERIFY(sample.folder().mkpath(QStringLiteral("other/y")));
    static_cast<void>(sample.write(QStringLiteral("other/y/a.obj"), "other"));
    QVERIFY(sample.folder().rename(QStringLiteral("x"), QStringLiteral("away")));
    QVERIFY(sample.folder().rename(QStringLiteral("other"), QStringLiteral("x")));
    QCOMPARE(sample.told(), QStringList{name});
    static_cast<void>(sample.replace(name, "newer"));
    QCOMPARE(sample.told(), QStringList{name});
    // Removed and made again.
    QVERIFY(QDir(sample.path(QStringLiteral("x"))).removeRecursively());
    QVERIFY(sample.folder().mkpath(QStringLiteral("x/y")));
    static_cast<void>(sample.write(name, "again"));
    QCOMPARE(sample.told(), QStringList{name});
    append(sample, name);
    QCOMPARE(sample.told(), QStringList{name});
}

void TestFileWatch::othersAreNotToldOf()
{
    Sample sample;
    static_cast<void>(sample.write(QStringLiteral("a"), "a"));
    static_cast<void>(sample.write(QStringLiteral("b"), "b"));
    sample.setPaths({QStringLiteral("a")});
    append(sample, QStringLiteral("b"));
    static_cast<void>(sample.write(QStringLiteral("c"), "c"));
    QVERIFY(sample.told().isEmpty());
    // Neither are those that were asked for once.
    sample.setPaths({QStringLiteral("b")});
    append(sample, QStringLiteral("a"));
    QVERIFY(sample.told().isEmpty());
    append(sample, QStringLiteral("b"));
    QCOMPARE(sample.told(), QStringList{QStringLiteral("b")});
    // What a link leads to is its own, and may be replaced where it is.
    QVERIFY(sample.folder().mkdir(QStringLiteral("far")));
    const QString far = sample.write(QStringLiteral("far/c"), "c");
    QVERIFY(QFile::link(far, sample.path(QStringLiteral("link"))));
    sample.setPaths({QStringLiteral("link")});
    QVERIFY(QFile::remove(far));
    QCOMPARE(sample.told(), QStringList{QStringLiteral("link")});
}

void TestFileWatch::ownWritesAreNotToldOf()
{
    Sample sample;
    const QString name = QStringLiteral("a");
    const QString path = sample.write(name, "a");
    sample.setPaths({name});
    for (int i = 0; i < 3; ++i) {
        sample.watch.beginOwnWrite(path);
        static_cast<void>(sample.replace(name, QByteArray::number(i)));
        QTest::qWait(i * 150); // a slow disk
        sample.watch.endOwnWrite(path);
        QVERIFY(sample.told().isEmpty());
    }
    static_cast<void>(sample.replace(name, "other"));
    QCOMPARE(sample.told(), QStringList{name});
}

void TestFileWatch::aBurstIsToldOfOnce()
{
    Sample sample;
    const QString name = QStringLiteral("a");
    static_cast<void>(sample.write(name, "a"));
    sample.setPaths({name});
    for (int i = 0; i < 30; ++i) {
        append(sample, name);
        QTest::qWait(10);
    }
    QTRY_VERIFY(sample.spy.count() > 0);
    QTest::qWait(300);
    QVERIFY2(sample.spy.count() <= 2, QByteArray::number(sample.spy.count()));
    sample.spy.clear();
    // One that never ends is told of nevertheless.
    for (int i = 0; i < 300 && sample.spy.isEmpty(); ++i) {
        append(sample, name);
        QTest::qWait(10);
    }
    QVERIFY(!sample.spy.isEmpty());
}

void TestFileWatch::aThousandFilesAreWatched()
{
    Sample sample;
    QStringList names;
    for (int i = 0; i < 1'000; ++i) {
        const QString folder = QStringLiteral("d%1").arg(i / 10);
        QVERIFY(sample.folder().mkpath(folder));
        names += folder + QStringLiteral("/f%1").arg(i);
        if (i % 2 == 0) {
            static_cast<void>(sample.write(names.constLast(), "x"));
        }
    }
    sample.setPaths(names);
    QTest::qWait(2'000);
    QVERIFY(sample.told().isEmpty());
    for (const QString &name : names) {
        static_cast<void>(sample.replace(name, "other"));
    }
    QTest::qWait(2'000);
    names.sort();
    QStringList told = sample.told();
    told.removeDuplicates();
    QCOMPARE(told, names);
    append(sample, names.at(500));
    QCOMPARE(sample.told(), QStringList{names.at(500)});
}

void TestFileWatch::eachAsksForHisOwn()
{
    Sample sample;
    static_cast<void>(sample.write(QStringLiteral("a"), "a"));
    static_cast<void>(sample.write(QStringLiteral("b"), "b"));
    auto first = std::make_unique<QObject>();
    QObject second;
    sample.watch.setPaths(first.get(), {sample.path(QStringLiteral("a"))});
    sample.watch.setPaths(&second, {sample.path(QStringLiteral("b"))});
    QTest::qWait(150);
    append(sample, QStringLiteral("a"));
    append(sample, QStringLiteral("b"));
    QCOMPARE(sample.told(), (QStringList{QStringLiteral("a"), QStringLiteral("b")}));
    first.reset();
    append(sample, QStringLiteral("a"));
    append(sample, QStringLiteral("b"));
    QCOMPARE(sample.told(), QStringList{QStringLiteral("b")});
}

/// As on a network disk: nothing tells of it, but somebody asks. What is written through a mapping is such a change.
void TestFileWatch::whatIsNotToldIsFoundWhenAsked()
{
    Sample sample;
    const QString name = QStringLiteral("a");
    QFile file(sample.write(name, "old"));
    sample.setPaths({name});
    QVERIFY(file.open(QIODevice::ReadWrite));
    uchar *bytes = file.map(0, 3);
    QVERIFY(bytes != nullptr);
    bytes[0] = 'O';
    QCOMPARE(::msync(bytes, 3, MS_SYNC), 0);
    if (QFileInfo(file.fileName()).lastModified() == file.fileTime(QFileDevice::FileBirthTime)) {
        QSKIP("this file system does not tell when a mapping was written");
    }
    QStringList told = sample.told();
    // What others do in the folder above may have led it to look already.
    if (told.isEmpty()) {
        sample.watch.checkNow();
        told = sample.told();
    }
    QCOMPARE(told, QStringList{name});
}

void TestFileWatch::documentsFollowByIt()
{
    Sample sample;
    DocumentSample own;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    connect(&sample.watch, &FileWatch::changed, &own.document, &Document::checkFile);
    connect(&own.document, &Document::savingStarted, &sample.watch, &FileWatch::beginOwnWrite);
    connect(&own.document, &Document::savingEnded, &sample.watch, &FileWatch::endOwnWrite);
    QVERIFY(own.document.open(path).has_value());
    sample.setPaths({QStringLiteral("a.fdo")});
    for (int i = 0; i < 3; ++i) {
        own.type(QStringLiteral("x"));
        own.document.startSaving(path);
        QTRY_VERIFY(!own.document.isSaving());
        QVERIFY(sample.told().isEmpty());
        const QByteArray theirs = "theirs " + QByteArray::number(i) + "\n";
        static_cast<void>(sample.replace(QStringLiteral("a.fdo"), theirs));
        QTRY_COMPARE(own.text(), theirs);
        QVERIFY(!sample.told().isEmpty());
    }
}

QTEST_MAIN(TestFileWatch)
#include "testfilewatch.moc"
