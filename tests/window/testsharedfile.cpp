// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <sys/stat.h>

#include <memory>

#include <QTextBlock>
#include <QThread>

#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

struct Sample : Folders, DocumentSample { };

using State = Document::FileState;

}

/// The file of a document, which other programs write and other windows open.
class TestSharedFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aChangeByAnotherProgramIsNotWrittenOver();
    void anUnmodifiedTextFollowsItsFile();
    void theCursorStaysWhereItsLineIs();
    void lineEndsAndTheByteOrderMarkFollow();
    void ofTwoChangesOneIsChosen();
    void aFileThatIsRemovedLeavesItsText();
    void aFileThatCannotBeReadLeavesItsText();
    void whatIsSavedHereIsNoChange();
    void aLookDuringASaveComesAfterIt();

    void anotherWindowOnlyReads();
    void locksAreOfFilesAndNotOfTheirNames();
    void withoutAPlaceForLocksTextsAreEdited();

    void largeTextsAreSavedAndFollowed();
};

void TestSharedFile::aChangeByAnotherProgramIsNotWrittenOver()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    sample.type(QStringLiteral("mine "));
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), "theirs\n"));
    const auto saved = sample.document.saveAs(path);
    QVERIFY(!saved.has_value() && !saved.error().isEmpty());
    QCOMPARE(Sample::read(path), QByteArray("theirs\n"));
    QVERIFY(sample.document.isModified());
    QCOMPARE(sample.document.fileState(), State::Changed);
    QCOMPARE(sample.document.bytesOnDisk(), QByteArray("theirs\n"));
    sample.document.keepText();
    QCOMPARE(sample.document.fileState(), State::Same);
    QVERIFY(sample.document.isModified());
    QVERIFY(sample.document.saveAs(path).has_value());
    QCOMPARE(Sample::read(path), QByteArray("mine old\n"));
    // Another name was asked for already.
    static_cast<void>(sample.write(QStringLiteral("b.fdo"), "there\n"));
    QVERIFY(sample.document.saveAs(sample.path(QStringLiteral("b.fdo"))).has_value());
    // Gone, there is nothing to write over.
    QVERIFY(QFile::remove(sample.document.path()));
    QVERIFY(sample.document.saveAs(sample.document.path()).has_value());
    QCOMPARE(Sample::read(sample.path(QStringLiteral("b.fdo"))), QByteArray("mine old\n"));
}

void TestSharedFile::anUnmodifiedTextFollowsItsFile()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "one\ntwo\nthree\n");
    QVERIFY(sample.document.open(path).has_value());
    const QSignalSpy reloaded(&sample.document, &Document::reloaded);
    sample.document.checkFile();
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), "zero\none\n2\nthree\nfour"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.text(), QByteArray("zero\none\n2\nthree\nfour"));
    QCOMPARE(reloaded.count(), 1);
    QVERIFY(!sample.document.isModified());
    QCOMPARE(sample.document.fileState(), State::Same);
    // Nothing is lost by it either.
    sample.editor.undo();
    QCOMPARE(sample.text(), QByteArray("one\ntwo\nthree\n"));
    QVERIFY(!sample.editor.document()->isUndoAvailable());
    QVERIFY(sample.document.isModified());
    sample.editor.redo();
    QVERIFY(!sample.document.isModified());
}

void TestSharedFile::theCursorStaysWhereItsLineIs()
{
    Sample sample;
    QByteArray text;
    for (int i = 0; i < 100; ++i) {
        text += "line " + QByteArray::number(i) + "\n";
    }
    const QString path = sample.write(QStringLiteral("a.fdo"), text);
    QVERIFY(sample.document.open(path).has_value());
    QTextCursor cursor(sample.editor.document()->findBlockByNumber(50));
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, 5);
    cursor.movePosition(QTextCursor::Right, QTextCursor::KeepAnchor, 2);
    sample.editor.setTextCursor(cursor);
    QByteArray other = text;
    other.replace("line 3\n", "line three\nline 3b\n").replace("line 90\n", "");
    static_cast<void>(sample.write(QStringLiteral("a.fdo"), other));
    sample.document.checkFile();
    QTRY_COMPARE(sample.text(), other);
    QCOMPARE(sample.editor.textCursor().selectedText(), QStringLiteral("50"));
    QCOMPARE(sample.editor.textCursor().blockNumber(), 51);
}

void TestSharedFile::lineEndsAndTheByteOrderMarkFollow()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "one\ntwo\nthree\n");
    QVERIFY(sample.document.open(path).has_value());
    const QByteArray other = "\xEF\xBB\xBFone\r\n2\r\nthree\rfour\n";
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), other));
    sample.document.checkFile();
    QTRY_COMPARE(sample.text(), QByteArray("one\n2\nthree\nfour\n"));
    QVERIFY(sample.document.hasOwnFile());
    QVERIFY(sample.document.saveAs(path).has_value());
    QCOMPARE(Sample::read(path), other);
    // Line ends alone.
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), "one\n2\nthree\nfour\n"));
    const QSignalSpy reloaded(&sample.document, &Document::reloaded);
    sample.document.checkFile();
    QTRY_COMPARE(reloaded.count(), 1);
    QVERIFY(sample.document.saveAs(path).has_value());
    QCOMPARE(Sample::read(path), QByteArray("one\n2\nthree\nfour\n"));
}

void TestSharedFile::ofTwoChangesOneIsChosen()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    const QSignalSpy told(&sample.document, &Document::fileStateChanged);
    sample.type(QStringLiteral("mine "));
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), "theirs\n"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Changed);
    QVERIFY(told.count() > 0);
    QCOMPARE(sample.text(), QByteArray("mine old\n"));
    sample.document.reload();
    QCOMPARE(sample.text(), QByteArray("theirs\n"));
    QVERIFY(!sample.document.isModified());
    QCOMPARE(sample.document.fileState(), State::Same);
    sample.editor.undo();
    QCOMPARE(sample.text(), QByteArray("mine old\n"));
    // Made what is there already: no question is left.
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), "new\n"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Changed);
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), "mine old\n"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Same);
    QVERIFY(!sample.document.isModified());
}

void TestSharedFile::aFileThatIsRemovedLeavesItsText()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    QVERIFY(QFile::remove(path));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Removed);
    QCOMPARE(sample.text(), QByteArray("old\n"));
    QVERIFY(sample.document.isModified());
    // As it was.
    static_cast<void>(sample.write(QStringLiteral("a.fdo"), "old\n"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Same);
    QVERIFY(!sample.document.isModified());
    // Another: the text that was without a file is not given up for it.
    QVERIFY(QFile::remove(path));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Removed);
    static_cast<void>(sample.write(QStringLiteral("a.fdo"), "theirs\n"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Changed);
    QCOMPARE(sample.text(), QByteArray("old\n"));
}

void TestSharedFile::aFileThatCannotBeReadLeavesItsText()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"),
                                     "gr\xF6\xDF"
                                     "er\n"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), State::Unreadable);
    QCOMPARE(sample.document.fileTrouble(), QStringLiteral("it is not UTF-8 text"));
    QVERIFY(sample.document.isModified());
    QVERIFY(QFile::remove(path));
    QCOMPARE(::mkfifo(QFile::encodeName(path).constData(), 0600), 0);
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileTrouble(), QStringLiteral("it is not a regular file"));
    QCOMPARE(sample.document.fileState(), State::Unreadable);
    QCOMPARE(sample.text(), QByteArray("old\n"));
    QVERIFY(sample.document.isModified());
}

void TestSharedFile::whatIsSavedHereIsNoChange()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    const QSignalSpy reloaded(&sample.document, &Document::reloaded);
    for (int i = 0; i < 5; ++i) {
        sample.type(QStringLiteral("x"));
        QVERIFY(sample.document.saveAs(path).has_value());
        sample.type(QStringLiteral("y"));
        sample.document.checkFile();
        QTest::qWait(20);
        QCOMPARE(sample.document.fileState(), State::Same);
    }
    QCOMPARE(reloaded.count(), 0);
    QVERIFY(sample.document.isModified());
}

void TestSharedFile::aLookDuringASaveComesAfterIt()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    const QSignalSpy saved(&sample.document, &Document::saved);
    const QSignalSpy reloaded(&sample.document, &Document::reloaded);
    for (int i = 1; i <= 20; ++i) {
        sample.type(QStringLiteral("x"));
        sample.document.checkFile();
        sample.document.startSaving(path);
        sample.document.checkFile();
        sample.type(QStringLiteral("y"));
        QTRY_COMPARE(saved.count(), i);
        QTest::qWait(10);
        QCOMPARE(sample.document.fileState(), State::Same);
    }
    QCOMPARE(reloaded.count(), 0);
    // One that began before the save is of no use after it.
    for (int i = 0; i < 10; ++i) {
        sample.type(QStringLiteral("z"));
        const QByteArray text = sample.text();
        sample.document.checkFile();
        QThread::msleep(5);
        QVERIFY(sample.document.saveAs(path).has_value());
        QTest::qWait(20);
        QCOMPARE(sample.text(), text);
        QCOMPARE(sample.document.fileState(), State::Same);
    }
    QCOMPARE(reloaded.count(), 0);
    // And is not forgotten.
    QVERIFY(sample.document.saveAs(path).has_value());
    sample.document.startSaving(path);
    sample.document.checkFile();
    QTRY_COMPARE(saved.count(), 32);
    static_cast<void>(sample.replace(QStringLiteral("a.fdo"), "theirs\n"));
    sample.document.checkFile();
    QTRY_COMPARE(sample.text(), QByteArray("theirs\n"));
}

void TestSharedFile::anotherWindowOnlyReads()
{
    const Folders folders;
    const QString path = folders.write(QStringLiteral("a.fdo"), "old\n");
    auto first = std::make_unique<DocumentSample>();
    DocumentSample second;
    QVERIFY(first->document.open(path).has_value());
    QVERIFY(!first->document.isHeldElsewhere() && !first->editor.isReadOnly());
    const QSignalSpy told(&second.document, &Document::fileStateChanged);
    QVERIFY(second.document.open(path).has_value());
    QVERIFY(second.document.isHeldElsewhere() && second.editor.isReadOnly());
    QVERIFY(second.document.isFaithful() && told.count() > 0);
    // It follows what the other saves.
    first->type(QStringLiteral("x"));
    QVERIFY(first->document.saveAs(path).has_value());
    second.document.checkFile();
    QTRY_COMPARE(second.text(), QByteArray("xold\n"));
    QVERIFY(second.editor.isReadOnly());
    second.document.editAnyway();
    QVERIFY(!second.document.isHeldElsewhere() && !second.editor.isReadOnly());
    // Closed there, it is free; opened again here, it stays so.
    first.reset();
    QVERIFY(second.document.open(path).has_value());
    QVERIFY(!second.document.isHeldElsewhere());
    QVERIFY(second.document.open(path).has_value());
    QVERIFY(!second.document.isHeldElsewhere());
    DocumentSample third;
    QVERIFY(third.document.open(path).has_value());
    QVERIFY(third.document.isHeldElsewhere());
    // With another text the lock goes too.
    second.document.startNew();
    QVERIFY(third.document.open(path).has_value());
    QVERIFY(!third.document.isHeldElsewhere());
    // Nothing lies beside the file.
    QCOMPARE(folders.names(), QStringList{QStringLiteral("a.fdo")});
}

void TestSharedFile::locksAreOfFilesAndNotOfTheirNames()
{
    const Folders folders;
    const QString path = folders.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(QFile::link(path, folders.path(QStringLiteral("link.fdo"))));
    DocumentSample first;
    DocumentSample second;
    QVERIFY(first.document.open(path).has_value());
    QVERIFY(second.document.open(folders.path(QStringLiteral("link.fdo"))).has_value());
    QVERIFY(second.document.isHeldElsewhere());
    QVERIFY(second.document.open(folders.write(QStringLiteral("b.fdo"), "b\n")).has_value());
    QVERIFY(!second.document.isHeldElsewhere());
    // Examples are nobody's.
    DocumentSample third;
    QVERIFY(first.document.open(QStringLiteral(":/examples/tree.fdo")).has_value());
    QVERIFY(third.document.open(QStringLiteral(":/examples/tree.fdo")).has_value());
    QVERIFY(!third.document.isHeldElsewhere());
    // Save As takes the new file, and leaves the old.
    QVERIFY(third.document.saveAs(folders.path(QStringLiteral("c.fdo"))).has_value());
    QVERIFY(first.document.open(folders.path(QStringLiteral("c.fdo"))).has_value());
    QVERIFY(first.document.isHeldElsewhere());
    QVERIFY(third.document.saveAs(folders.path(QStringLiteral("d.fdo"))).has_value());
    QVERIFY(first.document.open(folders.path(QStringLiteral("c.fdo"))).has_value());
    QVERIFY(!first.document.isHeldElsewhere());
}

void TestSharedFile::withoutAPlaceForLocksTextsAreEdited()
{
    const Folders folders;
    const QString path = folders.write(QStringLiteral("a.fdo"), "old\n");
    qputenv("XDG_STATE_HOME", QFile::encodeName(path)); // no folder, and none can be made in it
    DocumentSample sample;
    QVERIFY(sample.document.open(path).has_value());
    QVERIFY(!sample.document.isHeldElsewhere() && !sample.editor.isReadOnly());
    sample.type(QStringLiteral("x"));
    QVERIFY(sample.document.saveAs(path).has_value());
}

/// 100,000 lines, and a line of a million characters.
void TestSharedFile::largeTextsAreSavedAndFollowed()
{
    for (const QByteArray &text : {QByteArray("v 1 2 3\n").repeated(100'000), QByteArray(1'000'000, 'x')}) {
        Sample sample;
        const QString path = sample.write(QStringLiteral("a.txt"), text);
        QVERIFY(sample.document.open(path).has_value());
        sample.type(QStringLiteral("# mine\n"));
        QVERIFY(sample.document.saveAs(path).has_value());
        QCOMPARE(Sample::read(path), "# mine\n" + text);
        static_cast<void>(sample.replace(QStringLiteral("a.txt"), text + "# theirs"));
        sample.document.checkFile();
        QTRY_COMPARE(sample.text(), text + "# theirs");
    }
}

QTEST_MAIN(TestSharedFile)
#include "testsharedfile.moc"
