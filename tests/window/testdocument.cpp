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

class TestDocument : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void savingKeepsTheFormOfTheFile();
    void savingUnchangedKeepsEveryByte();
    void savingKeepsTheUndoHistory();
    void whatCannotBeSavedStaysModified();
    void whatCannotBeOpenedLeavesTheTextAlone_data();
    void whatCannotBeOpenedLeavesTheTextAlone();
    void examplesOpenButHaveNoFileOfTheirOwn();
    void aTextThatWouldLoseCharactersIsReadOnly();
    void onlyCharactersAreChanges();
    void aNewTextIsEmpty();
    void anotherTextIsNeverModified();

    void aSaveInTheBackgroundIsOfTheTextAsItWas();
    void savesFollowOneAnother();
    void aSaveAfterSaveAsIsOfTheNewFile();
    void noStepBackLeadsToAFileThatIsAnother();
    void whatTakesTheTextsPlaceWaitsForItsSave();
    void theEndOfADocumentWaitsForItsSave();
    void aSaveThatFailsInTheBackgroundIsTold();
    void whatIsNoFileIsNotWrittenOver_data();
    void whatIsNoFileIsNotWrittenOver();

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

    void whatIsRestoredIsAnEdit();
    void whatIsRestoredNeedsNoFile();
    void largeTextsAreSavedAndFollowed();
};

void TestDocument::savingKeepsTheFormOfTheFile()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "\xEF\xBB\xBF# \xC3\xA4\r\n<$>. x");
    QVERIFY(sample.document.open(path).has_value());
    sample.editor.insertPlainText(QStringLiteral("# new\n"));
    QVERIFY(sample.document.isModified());
    QVERIFY(sample.document.saveAs(path).has_value());
    QVERIFY(!sample.document.isModified());
    QCOMPARE(Sample::read(path), QByteArray("\xEF\xBB\xBF# new\r\n# \xC3\xA4\r\n<$>. x"));
}

void TestDocument::savingUnchangedKeepsEveryByte()
{
    Sample sample;
    const QByteArray bytes("a\r\nb\n\rc\xC2\xA0\n\n");
    const QString path = sample.write(QStringLiteral("a.fdo"), bytes);
    QVERIFY(sample.document.open(path).has_value());
    QVERIFY(sample.document.saveAs(path).has_value());
    QCOMPARE(Sample::read(path), bytes);
}

void TestDocument::savingKeepsTheUndoHistory()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    sample.editor.insertPlainText(QStringLiteral("x"));
    QVERIFY(sample.document.saveAs(path).has_value());
    sample.editor.undo();
    QCOMPARE(sample.document.text().bytes(), std::string("old\n"));
    QVERIFY(sample.document.isModified());
}

void TestDocument::whatCannotBeSavedStaysModified()
{
    Sample sample;
    sample.document.startNew();
    sample.editor.insertPlainText(QStringLiteral("x"));
    const auto saved = sample.document.saveAs(sample.path(QStringLiteral("no/such/folder/a.fdo")));
    QVERIFY(!saved.has_value());
    QVERIFY(!saved.error().isEmpty());
    QVERIFY(sample.document.isModified());
    QCOMPARE(sample.document.path(), QString());
}

void TestDocument::whatCannotBeOpenedLeavesTheTextAlone_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("missing") << QStringLiteral("missing.fdo");
    QTest::newRow("not UTF-8") << QStringLiteral("latin.fdo");
    QTest::newRow("a folder") << QStringLiteral(".");
    QTest::newRow("missing example") << QStringLiteral(":/examples/missing.fdo");
}

void TestDocument::whatCannotBeOpenedLeavesTheTextAlone()
{
    QFETCH(const QString, name);
    Sample sample;
    const QByteArray latin("# gr\xF6\xDF"
                           "er\n");
    const QString latinPath = sample.write(QStringLiteral("latin.fdo"), latin);
    QVERIFY(sample.document.open(sample.write(QStringLiteral("good.fdo"), "good\n")).has_value());
    sample.editor.insertPlainText(QStringLiteral("x"));

    const auto opened = sample.document.open(name.startsWith(u':') ? name : sample.path(name));
    QVERIFY(!opened.has_value());
    QVERIFY(!opened.error().isEmpty());
    QCOMPARE(sample.document.text().bytes(), std::string("xgood\n"));
    QCOMPARE(sample.document.name(), QStringLiteral("good.fdo"));
    QVERIFY(sample.document.isModified());
    QCOMPARE(Sample::read(latinPath), latin);
}

void TestDocument::examplesOpenButHaveNoFileOfTheirOwn()
{
    Sample sample;
    QVERIFY(sample.document.open(QStringLiteral(":/examples/romanesco.fdo")).has_value());
    QVERIFY(sample.document.isExample());
    QVERIFY(!sample.document.hasOwnFile());
    QCOMPARE(sample.document.name(), QStringLiteral("romanesco.fdo"));
    QVERIFY(sample.files.read(sample.document.scenePath().parent_path() / "bud.obj").has_value());
}

void TestDocument::aTextThatWouldLoseCharactersIsReadOnly()
{
    Sample sample;
    QVERIFY(sample.document
                .open(sample.write(QStringLiteral("a.fdo"),
                                   "a\xE2\x80\xA9"
                                   "b\n"))
                .has_value());
    QVERIFY(sample.editor.isReadOnly());
    QVERIFY(!sample.document.hasOwnFile());
    // Not even where somebody asks for its own name.
    const QByteArray before = Sample::read(sample.document.path());
    QVERIFY(!sample.document.saveAs(sample.document.path()).has_value());
    QCOMPARE(Sample::read(sample.document.path()), before);
    QVERIFY(sample.document.open(sample.write(QStringLiteral("b.fdo"), "b\n")).has_value());
    QVERIFY(!sample.editor.isReadOnly());
}

void TestDocument::onlyCharactersAreChanges()
{
    Sample sample;
    QVERIFY(sample.document.open(QStringLiteral(":/examples/tree.fdo")).has_value());
    QCOMPARE(sample.changes.count(), 1);
    QCoreApplication::processEvents();
    sample.editor.setFileName(QStringLiteral("a.obj"));
    QCoreApplication::processEvents();
    QCOMPARE(sample.changes.count(), 1);
    sample.editor.insertPlainText(QStringLiteral("x"));
    QCOMPARE(sample.changes.count(), 2);
    // As many characters as before, in one place and in two.
    sample.editor.moveCursor(QTextCursor::Start);
    sample.editor.moveCursor(QTextCursor::Right, QTextCursor::KeepAnchor);
    sample.editor.insertPlainText(QStringLiteral("y"));
    QCOMPARE(sample.changes.count(), 3);
    QTextCursor cursor(sample.editor.document());
    cursor.beginEditBlock();
    cursor.deleteChar();
    cursor.movePosition(QTextCursor::End);
    cursor.insertText(QStringLiteral("z"));
    cursor.endEditBlock();
    QCOMPARE(sample.changes.count(), 4);
    QCOMPARE(sample.text(), QByteArray::fromStdString(sample.editor.snapshot().bytes()));
}

void TestDocument::aNewTextIsEmpty()
{
    Sample sample;
    QVERIFY(sample.document.open(QStringLiteral(":/examples/tree.fdo")).has_value());
    sample.document.startNew();
    QCOMPARE(sample.document.text().bytes(), std::string());
    QVERIFY(!sample.document.hasOwnFile());
    QVERIFY(!sample.document.isModified());
}

void TestDocument::anotherTextIsNeverModified()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    sample.type(QStringLiteral("x"));
    const QSignalSpy modified(&sample.document, &Document::modifiedChanged);
    QVERIFY(sample.document.open(path).has_value());
    sample.document.startNew();
    QVERIFY(!modified.isEmpty());
    for (const QList<QVariant> &arguments : modified) {
        QCOMPARE(arguments.at(0).toBool(), false);
    }
}

void TestDocument::aSaveInTheBackgroundIsOfTheTextAsItWas()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    const QSignalSpy saved(&sample.document, &Document::saved);
    sample.type(QStringLiteral("one "));
    sample.document.startSaving(path);
    QVERIFY(sample.document.isSaving());
    QVERIFY(sample.document.isModified());
    sample.type(QStringLiteral("two "));
    QTRY_COMPARE(saved.count(), 1);
    QVERIFY(!sample.document.isSaving());
    QCOMPARE(Sample::read(path), QByteArray("one old\n"));
    QVERIFY(sample.document.isModified());
    sample.document.startSaving(path);
    QTRY_COMPARE(saved.count(), 2);
    QVERIFY(!sample.document.isModified());
    QCOMPARE(Sample::read(path), QByteArray("one two old\n"));
    // Typed and taken back meanwhile.
    sample.type(QStringLiteral("three "));
    sample.document.startSaving(path);
    sample.type(QStringLiteral("x"));
    sample.editor.textCursor().deletePreviousChar();
    QTRY_COMPARE(saved.count(), 3);
    QVERIFY(!sample.document.isModified());
}

void TestDocument::savesFollowOneAnother()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    const QSignalSpy started(&sample.document, &Document::savingStarted);
    const QSignalSpy ended(&sample.document, &Document::savingEnded);
    const QSignalSpy saved(&sample.document, &Document::saved);
    for (int i = 0; i < 5; ++i) {
        sample.type(QString::number(i));
        sample.document.startSaving(path);
    }
    QTRY_COMPARE(saved.count(), 2);
    QVERIFY(!sample.document.isSaving() && !sample.document.isModified());
    QCOMPARE(Sample::read(path), QByteArray("01234old\n"));
    QCOMPARE(started.count(), 2);
    QCOMPARE(ended.count(), 2);
    // One that waits is not forgotten for one that is waited for.
    sample.type(QStringLiteral("a"));
    sample.document.startSaving(path);
    sample.document.startSaving(path);
    sample.type(QStringLiteral("b"));
    QVERIFY(sample.document.saveAs(sample.path(QStringLiteral("b.fdo"))).has_value());
    QCOMPARE(Sample::read(path), QByteArray("01234aold\n"));
    QCOMPARE(Sample::read(sample.path(QStringLiteral("b.fdo"))), QByteArray("01234abold\n"));
}

void TestDocument::aSaveAfterSaveAsIsOfTheNewFile()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    const QString other = sample.path(QStringLiteral("b.fdo"));
    const QSignalSpy saved(&sample.document, &Document::saved);
    QVERIFY(sample.document.open(path).has_value());
    sample.type(QStringLiteral("x"));
    sample.document.startSaving(other);
    sample.type(QStringLiteral("y"));
    sample.document.startSaving(sample.document.path()); // as a key asks for at once
    QTRY_COMPARE(saved.count(), 2);
    QCOMPARE(Sample::read(path), QByteArray("old\n"));
    QCOMPARE(Sample::read(other), QByteArray("xyold\n"));
    QCOMPARE(sample.document.path(), other);
}

void TestDocument::noStepBackLeadsToAFileThatIsAnother()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    QVERIFY(sample.document.open(path).has_value());
    sample.type(QStringLiteral("x"));
    QVERIFY(QFile::remove(path));
    sample.document.checkFile();
    QTRY_COMPARE(sample.document.fileState(), Document::FileState::Removed);
    sample.editor.undo();
    QVERIFY2(sample.document.isModified(), "the text is nowhere else");

    // What was typed while it was saved is not on the disk, nor is what was before.
    const QString slow = sample.write(QStringLiteral("b.fdo"), "old\n");
    const QSignalSpy saved(&sample.document, &Document::saved);
    QVERIFY(sample.document.open(slow).has_value());
    sample.type(QStringLiteral("x"));
    sample.document.startSaving(slow);
    sample.editor.moveCursor(QTextCursor::End);
    sample.type(QStringLiteral("y"));
    QTRY_COMPARE(saved.count(), 1);
    while (sample.editor.document()->isUndoAvailable()) {
        sample.editor.undo();
    }
    QVERIFY(sample.document.isModified());
}

void TestDocument::whatTakesTheTextsPlaceWaitsForItsSave()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "old\n");
    const QString other = sample.write(QStringLiteral("b.fdo"), "other\n");
    const QSignalSpy saved(&sample.document, &Document::saved);
    QVERIFY(sample.document.open(path).has_value());
    sample.type(QStringLiteral("x"));
    sample.document.startSaving(path);
    sample.document.startSaving(path);
    QVERIFY(sample.document.open(other).has_value());
    QCOMPARE(Sample::read(path), QByteArray("xold\n"));
    QCOMPARE(saved.count(), 1);
    sample.type(QStringLiteral("y"));
    sample.document.startSaving(other);
    sample.document.startNew();
    QCoreApplication::processEvents();
    QCOMPARE(Sample::read(other), QByteArray("yother\n"));
    QCOMPARE(sample.document.path(), QString());
    QCOMPARE(sample.text(), QByteArray());
    QVERIFY(!sample.document.isSaving());
}

void TestDocument::theEndOfADocumentWaitsForItsSave()
{
    const Folders folders;
    const QString path = folders.path(QStringLiteral("a.fdo"));
    {
        DocumentSample sample;
        sample.type(QString(1'000'000, u'x'));
        sample.document.startSaving(path);
    }
    QCOMPARE(Folders::read(path).size(), 1'000'000);
}

void TestDocument::aSaveThatFailsInTheBackgroundIsTold()
{
    Sample sample;
    const QSignalSpy failed(&sample.document, &Document::saveFailed);
    const QSignalSpy ended(&sample.document, &Document::savingEnded);
    sample.type(QStringLiteral("x"));
    sample.document.startSaving(sample.path(QStringLiteral("no/a.fdo")));
    QTRY_COMPARE(failed.count(), 1);
    QCOMPARE(failed.at(0).at(0).toString(), sample.path(QStringLiteral("no/a.fdo")));
    QCOMPARE(failed.at(0).at(1).toString(), QStringLiteral("no such folder"));
    QCOMPARE(ended.count(), 1);
    QVERIFY(sample.document.isModified());
    QCOMPARE(sample.document.path(), QString());
}

void TestDocument::whatIsNoFileIsNotWrittenOver_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("words");
    QTest::newRow("device") << QStringLiteral("/dev/full") << QStringLiteral("it is not a regular file");
    QTest::newRow("pipe") << QStringLiteral("pipe") << QStringLiteral("it is not a regular file");
    QTest::newRow("folder") << QStringLiteral(".") << QStringLiteral("it is a directory");
    QTest::newRow("example") << QStringLiteral(":/examples/tree.fdo") << QStringLiteral("no such folder");
}

void TestDocument::whatIsNoFileIsNotWrittenOver()
{
    QFETCH(const QString, path);
    QFETCH(const QString, words);
    Sample sample;
    QCOMPARE(::mkfifo(QFile::encodeName(sample.path(QStringLiteral("pipe"))).constData(), 0600), 0);
    sample.type(QStringLiteral("x"));
    const bool isWhole = path.startsWith(u'/') || path.startsWith(u':');
    const auto saved = sample.document.saveAs(isWhole ? path : sample.path(path));
    QVERIFY(!saved.has_value());
    QCOMPARE(saved.error(), words);
    QVERIFY(sample.document.isModified());
    QCOMPARE(sample.document.path(), QString());
    QVERIFY(QFileInfo::exists(QStringLiteral("/dev/full")) && !QFileInfo(QStringLiteral("/dev/full")).isFile());
}

void TestDocument::aChangeByAnotherProgramIsNotWrittenOver()
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

void TestDocument::anUnmodifiedTextFollowsItsFile()
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

void TestDocument::theCursorStaysWhereItsLineIs()
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

void TestDocument::lineEndsAndTheByteOrderMarkFollow()
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

void TestDocument::ofTwoChangesOneIsChosen()
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

void TestDocument::aFileThatIsRemovedLeavesItsText()
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

void TestDocument::aFileThatCannotBeReadLeavesItsText()
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

void TestDocument::whatIsSavedHereIsNoChange()
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

void TestDocument::aLookDuringASaveComesAfterIt()
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

void TestDocument::anotherWindowOnlyReads()
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

void TestDocument::locksAreOfFilesAndNotOfTheirNames()
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

void TestDocument::withoutAPlaceForLocksTextsAreEdited()
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

void TestDocument::whatIsRestoredIsAnEdit()
{
    Sample sample;
    const QString path = sample.write(QStringLiteral("a.fdo"), "\xEF\xBB\xBFone\r\ntwo\r\nthree\r\n");
    sample.document.restore(path, "one\n2\n2b\nthree\n");
    QCOMPARE(sample.text(), QByteArray("one\n2\n2b\nthree\n"));
    QCOMPARE(sample.document.path(), path);
    QVERIFY(sample.document.isModified());
    QCOMPARE(Sample::read(path), QByteArray("\xEF\xBB\xBFone\r\ntwo\r\nthree\r\n"));
    sample.editor.undo();
    QCOMPARE(sample.text(), QByteArray("one\ntwo\nthree\n"));
    QVERIFY(!sample.document.isModified());
    sample.editor.redo();
    QVERIFY(sample.document.saveAs(path).has_value());
    QCOMPARE(Sample::read(path), QByteArray("\xEF\xBB\xBFone\r\n2\r\n2b\r\nthree\r\n"));
}

void TestDocument::whatIsRestoredNeedsNoFile()
{
    Sample sample;
    sample.document.restore({}, "typed\n");
    QCOMPARE(sample.text(), QByteArray("typed\n"));
    QVERIFY(sample.document.isModified() && sample.document.path().isEmpty());
    // Gone, but its name is known.
    const QString gone = sample.path(QStringLiteral("gone.fdo"));
    sample.document.restore(gone, "typed\n");
    QCOMPARE(sample.document.path(), gone);
    QCOMPARE(sample.document.fileState(), State::Removed);
    QVERIFY(sample.document.isModified());
    QVERIFY(sample.document.saveAs(gone).has_value());
    QCOMPARE(Sample::read(gone), QByteArray("typed\n"));
    QCOMPARE(sample.document.fileState(), State::Same);
    // What stands there now is not to be written over.
    const QString latin = sample.write(QStringLiteral("latin.fdo"), "gr\xF6\xDF");
    sample.document.restore(latin, "typed\n");
    QCOMPARE(sample.document.path(), QString());
    QCOMPARE(sample.text(), QByteArray("typed\n"));
    sample.document.restore(QStringLiteral(":/examples/none.fdo"), "typed\n");
    QCOMPARE(sample.document.path(), QString());
    sample.document.restore(QStringLiteral(":/examples/tree.fdo"), "typed\n");
    QVERIFY(sample.document.isExample() && sample.document.isModified());
}

/// 100,000 lines, and a line of a million characters.
void TestDocument::largeTextsAreSavedAndFollowed()
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

QTEST_MAIN(TestDocument)
#include "testdocument.moc"
