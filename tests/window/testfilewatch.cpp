// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <functional>
#include <memory>

#include <sys/mman.h>

#include <QTemporaryFile>

#include "app/window/filewatch.h"
#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

struct Sample : Folders {
    FileWatch watch;
    QObject owner;
    QSignalSpy spy{&watch, &FileWatch::changed};

    Sample()
    {
        QVERIFY(m_fence.open());
        watch.setPaths(&m_fence, {m_fence.fileName()});
    }
    /// And until the watch has them: it does what it is asked in turn.
    void setPaths(const QStringList &names)
    {
        QStringList paths;
        for (const QString &name : names) {
            paths += path(name);
        }
        watch.setPaths(&owner, paths);
        awaitWatch();
    }
    void awaitWatch()
    {
        const auto isSeen = [this] { return spy.size() > reports(); };
        QVERIFY(QTest::qWaitFor(
            [&] {
                static_cast<void>(m_fence.write("x"));
                static_cast<void>(m_fence.flush());
                watch.checkNow();
                return QTest::qWaitFor(isSeen, 100);
            },
            patience));
        spy.removeIf([this](const auto &told) { return told.at(0) == fenced(); });
    }
    /// What is told of, each once, by names: as soon as so many are, and it is quiet.
    QStringList told(qsizetype count = 1)
    {
        QStringList names;
        const auto take = [&] {
            for (const QString &path : takeTold()) {
                names += QDir(own.path()).relativeFilePath(path);
            }
            names.sort();
            names.removeDuplicates();
            return names.size() >= count;
        };
        static_cast<void>(QTest::qWaitFor(take, patience));
        QTest::qWait(150);
        static_cast<void>(take());
        return names;
    }
    [[nodiscard]] bool isNothingTold()
    {
        QTest::qWait(250);
        return takeTold().isEmpty();
    }
    [[nodiscard]] qsizetype reports() const
    {
        return std::ranges::count_if(spy, [this](const auto &told) { return told.at(0) != fenced(); });
    }
    [[nodiscard]] QDir folder() const { return QDir(own.path()); }

private:
    static constexpr int patience = 20'000; // milliseconds; on a machine that does other things
    [[nodiscard]] QVariant fenced() const { return QStringList{m_fence.fileName()}; }
    QStringList takeTold()
    {
        QStringList paths;
        while (!spy.isEmpty()) {
            paths += spy.takeFirst().at(0).toStringList();
        }
        paths.removeAll(m_fence.fileName());
        return paths;
    }
    QTemporaryFile m_fence;
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
    QVERIFY(sample.isNothingTold());
    act(sample);
    QCOMPARE(sample.told(), QStringList{file});
    QVERIFY(sample.isNothingTold());
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
    QVERIFY(sample.isNothingTold());
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
    QVERIFY(sample.isNothingTold());
    // Neither are those that were asked for once.
    sample.setPaths({QStringLiteral("b")});
    append(sample, QStringLiteral("a"));
    QVERIFY(sample.isNothingTold());
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
        QVERIFY(sample.isNothingTold());
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
    QTRY_VERIFY(sample.reports() > 0);
    QTest::qWait(300);
    QVERIFY2(sample.reports() <= 2, QByteArray::number(sample.reports()));
    sample.spy.clear();
    // One that never ends is told of nevertheless.
    for (int i = 0; i < 300 && sample.reports() == 0; ++i) {
        append(sample, name);
        QTest::qWait(10);
    }
    QVERIFY(sample.reports() > 0);
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
    QVERIFY(sample.isNothingTold());
    for (const QString &name : names) {
        static_cast<void>(sample.replace(name, "other"));
    }
    names.sort();
    QCOMPARE(sample.told(names.size()), names);
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
    sample.awaitWatch();
    append(sample, QStringLiteral("a"));
    append(sample, QStringLiteral("b"));
    QCOMPARE(sample.told(2), (QStringList{QStringLiteral("a"), QStringLiteral("b")}));
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
    sample.watch.checkNow(); // what others do in the folder above may have led it to look already
    QCOMPARE(sample.told(), QStringList{name});
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
        QVERIFY(sample.isNothingTold());
        const QByteArray theirs = "theirs " + QByteArray::number(i) + "\n";
        static_cast<void>(sample.replace(QStringLiteral("a.fdo"), theirs));
        QTRY_COMPARE(own.text(), theirs);
        QVERIFY(sample.told() == QStringList{QStringLiteral("a.fdo")});
    }
}

QTEST_MAIN(TestFileWatch)
#include "testfilewatch.moc"
