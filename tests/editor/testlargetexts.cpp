// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>

#include <QElapsedTimer>
#include <QTest>
#include <QTextBlock>

#include "editor/fdoeditor.h"

using namespace romanesco;

namespace {

/// 100,000 vectors and transformations that use them by number.
QString manyLines()
{
    QString text;
    for (int i = 1; i <= 50'000; ++i) {
        text += QStringLiteral("v %1 0.5 -0.25 # größe\nt%1. (%1, #, #)\n").arg(i);
    }
    return text;
}

/// Of some keys the one in the middle, until what it wrote is drawn.
qint64 millisecondsAKey(QPlainTextEdit &editor)
{
    QList<qint64> times;
    for (const char key : {'#', ' ', 'a', 'b', 'c', '\b', 'd'}) {
        QElapsedTimer timer;
        timer.start();
        key == '\b' ? QTest::keyClick(&editor, Qt::Key_Backspace) : QTest::keyClick(&editor, key);
        editor.viewport()->repaint();
        times += timer.elapsed();
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

QString longLine()
{
    return QStringLiteral("x. \"a.obj\"\nt. (#, #, #)\ny. [") + QStringLiteral("t, ").repeated(330'000)
        + QStringLiteral("#] x\n");
}

}

/// Typing in texts of any size. What it costs is printed, not judged.
class TestLargeTexts : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void typingShowsAtOnce_data();
    void typingShowsAtOnce();
};

void TestLargeTexts::typingShowsAtOnce_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("problems");
    QTest::newRow("an empty text") << QString() << 1 << 0;
    QTest::newRow("100,000 lines, at the start") << manyLines() << 1 << 0;
    QTest::newRow("100,000 lines, in the middle") << manyLines() << 50'000 << 0;
    QTest::newRow("100,000 lines, 10,000 problems") << manyLines() << 50'000 << 10'000;
    QTest::newRow("above a line of 1 MB") << longLine() << 1 << 0;
    QTest::newRow("a line of 1 MB, in it") << longLine() << 3 << 0;
}

void TestLargeTexts::typingShowsAtOnce()
{
    QFETCH(const QString, text);
    QFETCH(const int, line);
    QFETCH(const int, problems);
    FdoEditor editor;
    editor.resize(600, 800);
    editor.setFileName(QStringLiteral("a.fdo"));
    editor.setPlainText(text);
    editor.show();
    QVERIFY(QTest::qWaitForWindowExposed(&editor));
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < static_cast<std::size_t>(problems); ++i) {
        diagnostics.push_back({DiagnosticCode::UnknownName, {40 * i, 40 * i + 3}, {"something"}});
    }
    editor.setDiagnostics(diagnostics, editor.snapshot());
    editor.goToLine(line);
    editor.moveCursor(QTextCursor::EndOfBlock);
    QCoreApplication::processEvents();

    const int begin = editor.textCursor().position();
    const qint64 ours = millisecondsAKey(editor);
    QPlainTextEdit plain(text);
    plain.resize(editor.size());
    plain.show();
    plain.setTextCursor(QTextCursor(plain.document()->findBlockByNumber(line - 1)));
    plain.moveCursor(QTextCursor::EndOfBlock);
    qInfo("%s: a key takes %lld ms, in a plain QPlainTextEdit %lld", QTest::currentDataTag(), ours,
          millisecondsAKey(plain));
    QCOMPARE(editor.document()->toPlainText().sliced(begin, 5), QStringLiteral("# abd"));
    QCOMPARE(editor.language().snapshot().bytes().size(), std::size_t(QString(text).toUtf8().size()) + 5);
}

QTEST_MAIN(TestLargeTexts)
#include "testlargetexts.moc"
