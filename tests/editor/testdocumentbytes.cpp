// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>

#include "editor/documentbytes.h"

using namespace romanesco;

class TestDocumentBytes : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyByteComesBack_data();
    void everyByteComesBack();
    void aNewLineEndsAsTheLineItIsSplitFrom();
    void lineEndsSurviveUndo();
    void loadingIsNoEdit();
    void whatIsNotUtf8IsRefused_data();
    void whatIsNotUtf8IsRefused();
    void lossIsAnnounced();
};

void TestDocumentBytes::everyByteComesBack_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("nothing") << QByteArray("");
    QTest::newRow("lf") << QByteArray("a\nb\n");
    QTest::newRow("cr lf") << QByteArray("a\r\nb\r\n\r\n");
    QTest::newRow("cr") << QByteArray("a\rb\r");
    QTest::newRow("mixed") << QByteArray("a\nb\r\nc\rd\r\r\ne\n\r\n");
    QTest::newRow("no end at the end") << QByteArray("a\r\nb");
    QTest::newRow("byte order mark") << QByteArray("\xEF\xBB\xBF"
                                                   "a\r\n");
    QTest::newRow("only a byte order mark") << QByteArray("\xEF\xBB\xBF");
    QTest::newRow("two byte order marks") << QByteArray("\xEF\xBB\xBF\xEF\xBB\xBF"
                                                        "a");
    QTest::newRow("no-break space") << QByteArray("v\xC2\xA0"
                                                  "1 2 3\n");
    QTest::newRow("line separator") << QByteArray("a\xE2\x80\xA8"
                                                  "b\n");
    QTest::newRow("beyond the basic plane") << QByteArray("# \xF0\x9F\x8C\xB2\r\n");
    QTest::newRow("nul") << QByteArray("a\0b\n", 4);
}

void TestDocumentBytes::everyByteComesBack()
{
    QFETCH(const QByteArray, bytes);
    QTextDocument document;
    const auto form = loadBytes(document, bytes);
    QVERIFY(form.has_value());
    QCOMPARE(toBytes(document, form->hasByteOrderMark), bytes);
    QVERIFY(form->isFaithful);
}

void TestDocumentBytes::aNewLineEndsAsTheLineItIsSplitFrom()
{
    QTextDocument document;
    QVERIFY(loadBytes(document, "a\r\nb\nc\r\nd").has_value());
    QTextCursor cursor(document.findBlockByNumber(0));
    cursor.insertText(QStringLiteral("1\n2\n"));
    cursor = QTextCursor(document.findBlockByNumber(3));
    cursor.insertText(QStringLiteral("3\n"));
    cursor.movePosition(QTextCursor::End);
    cursor.insertText(QStringLiteral("\ne"));
    QCOMPARE(toBytes(document, false), QByteArray("1\r\n2\r\na\r\n3\nb\nc\r\nd\r\ne"));
}

void TestDocumentBytes::lineEndsSurviveUndo()
{
    const QByteArray bytes("a\r\nb\nc\rd");
    QTextDocument document;
    QVERIFY(loadBytes(document, bytes).has_value());
    QTextCursor all(&document);
    all.select(QTextCursor::Document);
    all.insertText(QStringLiteral("x\ny"));
    QVERIFY(toBytes(document, false) != bytes);
    document.undo();
    QCOMPARE(toBytes(document, false), bytes);
}

void TestDocumentBytes::loadingIsNoEdit()
{
    QTextDocument document;
    QVERIFY(loadBytes(document, "a\r\nb").has_value());
    QVERIFY(!document.isModified());
    QVERIFY(!document.isUndoAvailable());
}

void TestDocumentBytes::whatIsNotUtf8IsRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("latin 1") << QByteArray("# gr\xF6\xDF"
                                           "er\n");
    QTest::newRow("utf-16") << QByteArray("\xFF\xFE"
                                          "a\0",
                                          4);
    QTest::newRow("cut off") << QByteArray("# \xE6\x9C");
    QTest::newRow("overlong") << QByteArray("\xC0\xAF");
    QTest::newRow("surrogate") << QByteArray("\xED\xA0\x80");
}

void TestDocumentBytes::whatIsNotUtf8IsRefused()
{
    QFETCH(const QByteArray, bytes);
    QTextDocument document;
    document.setPlainText(QStringLiteral("old"));
    const auto form = loadBytes(document, bytes);
    QVERIFY(!form.has_value());
    QCOMPARE(document.toPlainText(), QStringLiteral("old"));
}

void TestDocumentBytes::lossIsAnnounced()
{
    QTextDocument document;
    const auto form = loadBytes(document,
                                "a\xE2\x80\xA9"
                                "b\n");
    QVERIFY(form.has_value());
    QVERIFY(!form->isFaithful);
}

QTEST_MAIN(TestDocumentBytes)
#include "testdocumentbytes.moc"
