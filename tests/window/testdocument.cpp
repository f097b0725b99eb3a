// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <sys/stat.h>

#include "documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

struct Sample : Folders, DocumentSample { };

using State = Document::FileState;

}

/// A text of a file, or of none: how it is opened, edited, saved and restored.
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

    void whatIsRestoredIsAnEdit();
    void whatIsRestoredNeedsNoFile();
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

QTEST_MAIN(TestDocument)
#include "testdocument.moc"
