// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <functional>

#include <QTest>

#include "editor/syntax.h"
#include "highlighted.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

/// As often as makes a million characters.
QString manyTimes(const char *text)
{
    return QString::fromLatin1(text).repeated(1'000'000 / qsizetype(qstrlen(text)));
}

}

/// Lines of a megabyte that are made to be hard on a rule.
class TestLongLines : public QObject
{
    Q_OBJECT
public:
    /// Compiled expressions come to the end of what costs the square of the line, interpreted ones do not; and not
    /// every processor has compiled ones.
    static void initMain() { qputenv("QT_ENABLE_REGEXP_JIT", "0"); }

private Q_SLOTS:
    void longLinesAreColouredToTheirEnd_data();
    void longLinesAreColouredToTheirEnd();
};

void TestLongLines::longLinesAreColouredToTheirEnd_data()
{
    QTest::addColumn<QString>("fileName");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("last");
    using Text = const char *;
    const auto add = [](Text language, Text name, Text begin, Text middle, Text end, Text last) {
        QTest::addRow("%s: %s", language, name)
            << QLatin1String("a.") + QLatin1String(language)
            << QLatin1String(begin) + manyTimes(middle) + QLatin1String(end) << QString::fromLatin1(last);
    };
    const auto fdo = std::bind_front(add, "fdo");
    const auto sdo = std::bind_front(add, "sdo");
    fdo("a name", "", "a", ". \"a.obj\"", "String{\"a.obj\"}");
    fdo("no name", "a", "1", "- # c", "Comment{# c}");
    fdo("blanks", "x", " ", ". y", "Object{y}");
    fdo("blanks in the result", "<", " ", "# c", "Comment{# c}");
    fdo("parameters", "t", ".a", ". (# c", "Comment{# c}");
    fdo("dots", "t", ".", "# c", "Normal{c}");
    fdo("recursives", "z", "<", "x>. y", "Object{y}");
    fdo("a number", "v ", "1", " # c", "Comment{# c}");
    fdo("a bad number", "v ", "1", "a # c", "Comment{# c}");
    fdo("points", "v 0 ", ".", " # c", "Comment{# c}");
    fdo("exponents", "v ", "1e", " # c", "Comment{# c}");
    fdo("signs", "v ", "+", "1 # c", "Comment{# c}");
    fdo("numbers", "v", " 1.5", " # c", "Comment{# c}");
    fdo("bad numbers", "v", " 1.5a", " # c", "Comment{# c}");
    fdo("parts", "t. (", "5,", "5) # c", "Comment{# c}");
    fdo("a bad part", "t. (", "5", "a) # c", "Comment{# c}");
    fdo("brackets", "y. ", "[", "t] x", "Object{x}");
    fdo("sets", "y. ", "[t]", " x", "Object{x}");
    fdo("uses", "y. [", "t.1, ", "#] x", "Object{x}");
    fdo("an index", "y. [t.", "1", "] x", "Object{x}");
    fdo("a bad index", "y. [t.", "1", "a] x", "Object{x}");
    fdo("arguments", "y. [t", ".1", "] x", "Object{x}");
    fdo("a depth", "y. x ", "1", " # c", "Comment{# c}");
    fdo("a string", "x. \"", "a ", "\" # c", "Comment{# c}");
    fdo("an open string", "x. \"", "a ", "# c", "");
    fdo("quotes", "x. y ", "\"", " # c", "Comment{# c}");
    fdo("words in a comment", "# ", "a ", "", "");
    fdo("a word in a comment", "# ", "a", "", "");
    sdo("a word", "", "c", " # c", "Comment{# c}");
    sdo("blanks", "c", " ", "# # 60 # c", "Comment{# c}");
    sdo("parentheses", "c ", "(", "1, 2, 3) # 60", "Number{60}");
    sdo("vectors", "c ", "(1, 2, 3) ", "# c", "Comment{# c}");
    sdo("a number", "c (", "1", ", 2, 3) # 60", "Number{60}");
    sdo("a bad number", "c (", "1", "a, 2, 3) # 60", "Number{60}");
    sdo("points", "c (", ".", ", 2, 3) # 60", "Number{60}");
    sdo("an angle", "c # # ", "6", " perspective", "Keyword{perspective}");
    sdo("projections", "c # # 60 ", "aperspective", " orthographic", "Keyword{orthographic}");
    sdo("a string", "o \"", "a ", "\" #", "Identity{#}");
    sdo("parts", "o \"a.obj\" (", "#, ", "#) # c", "Comment{# c}");
    sdo("vectors in parts", "p \"a.obj\" (", "(1, 2, 3), ", "#) 0.5 # c", "Comment{# c}");
    sdo("a velocity", "p \"a.obj\" # 0.5 (", "1, ", "1) # c", "Comment{# c}");
}

/// A rule that costs the square of the line would not come to the end of any of these. One that meets a limit of the
/// expressions would, but not in the right colours.
void TestLongLines::longLinesAreColouredToTheirEnd()
{
    QFETCH(const QString, fileName);
    QFETCH(const QString, line);
    QFETCH(const QString, last);
    const QList<Run> runs = LineHighlighter(syntaxFor(fileName)).runs(line);
    qsizetype length = 0;
    for (const Run &run : runs) {
        length += run.text.size();
    }
    QCOMPARE(length, line.size());
    if (!last.isEmpty()) {
        QCOMPARE(runs.last().attribute + QLatin1Char('{') + runs.last().text.trimmed() + QLatin1Char('}'), last);
    }
}

QTEST_GUILESS_MAIN(TestLongLines)

#include "testlonglines.moc"
