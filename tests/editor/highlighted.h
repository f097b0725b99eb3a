// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <KSyntaxHighlighting/AbstractHighlighter>
#include <KSyntaxHighlighting/Definition>
#include <KSyntaxHighlighting/Format>
#include <KSyntaxHighlighting/State>
#include <QDir>
#include <QFile>
#include <QList>
#include <QStringList>

#include "tests/sourcetree.h"

namespace romanesco::test {

/// A part of a line that is coloured alike.
struct Run {
    QString attribute;
    QString text;
};

/// Colours one line after another as an editor would.
class LineHighlighter : private KSyntaxHighlighting::AbstractHighlighter
{
public:
    explicit LineHighlighter(const KSyntaxHighlighting::Definition &definition) { setDefinition(definition); }

    QList<Run> runs(const QString &line)
    {
        m_line = line;
        m_runs.clear();
        m_state = highlightLine(m_line, m_state);
        return m_runs;
    }

    /// In the form of the goldens: `Number{1} Operator{,}`, without the blanks at the ends of runs.
    QString described(const QString &line)
    {
        QStringList words;
        for (const Run &run : runs(line)) {
            if (!run.text.trimmed().isEmpty()) {
                words += run.attribute + QLatin1Char('{') + run.text.trimmed() + QLatin1Char('}');
            }
        }
        return words.join(QLatin1Char(' '));
    }

private:
    void applyFormat(int offset, int length, const KSyntaxHighlighting::Format &format) override
    {
        if (length > 0) {
            m_runs.append({format.name(), m_line.mid(offset, length)});
        }
    }

    QString m_line;
    QList<Run> m_runs;
    KSyntaxHighlighting::State m_state;
};

/// The lines of a text that have something in them, by their numbers.
inline QString highlighted(const KSyntaxHighlighting::Definition &definition, const QStringList &lines)
{
    LineHighlighter highlighter(definition);
    QString out;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString line = highlighter.described(lines[i]);
        if (!line.isEmpty()) {
            out += QString::number(i + 1) + QLatin1String(": ") + line + QLatin1Char('\n');
        }
    }
    return out;
}

inline QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline QStringList linesOf(const QString &path)
{
    return QString::fromUtf8(bytesOf(path)).split(QLatin1Char('\n'));
}

/// The paths of the golden samples of a language, "fdo" or "sdo"; of both where none is named.
inline QStringList samples(const QString &language = QStringLiteral("?do"))
{
    QStringList paths;
    const QDir folder(test::sourcePath("tests/golden/highlighting"));
    for (const QString &name : folder.entryList({QStringLiteral("*.") + language}, QDir::Files, QDir::Name)) {
        paths += folder.filePath(name);
    }
    return paths;
}

}
