// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <QObject>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTimer>

#include "textmarks.h"

namespace romanesco {

/// What to look for in a text. A match lies within a line.
struct SearchQuery {
    QString words;
    bool isExpression = false;
    bool isCaseSensitive = false;
    bool isWholeWords = false;
    bool operator==(const SearchQuery &) const = default;
};

/// Finds all matches in a document, some milliseconds at a time, from the start on, so that no text and no expression
/// stops the window. Starts again whenever the text changes. An expression that takes too many steps at one place is given
/// up.
class TextSearch : public QObject
{
    Q_OBJECT
public:
    /// document is an editor's and must outlive it.
    explicit TextSearch(QTextDocument &document);

    /// An empty query finds nothing.
    void setQuery(const SearchQuery &query);
    [[nodiscard]] const SearchQuery &query() const { return m_query; }

    /// Those that were found so far, ascending.
    [[nodiscard]] const std::vector<TextStretch> &matches() const { return m_matches; }
    /// All matches that begin before this position are found.
    [[nodiscard]] int foundUpTo() const;
    [[nodiscard]] bool isComplete() const { return !m_line.isValid(); }
    /// What is wrong with the expression, as a sentence that shows where; empty where nothing is.
    [[nodiscard]] const QString &error() const { return m_error; }

    /// What takes the place of a match at a position: in an expression \0 is the match, \1 to \9 are its groups, \n ends
    /// a line and \\ is a backslash. Nothing where none is.
    [[nodiscard]] std::optional<QString> replacement(TextStretch match, const QString &words) const;

    /// Replaces all matches as one undo step, once they are found; a change of the text or of the query before that ends
    /// it.
    void replaceAll(const QString &words);

Q_SIGNALS:
    /// More was found, or all, or there is an error.
    void advanced();
    void replacedAll(int count);

private:
    /// Other words for a part of a line, with all of its matches.
    struct LineEdit {
        TextStretch stretch;
        QString text;
    };

    void start();
    void goOn();
    void searchUntil(std::chrono::steady_clock::time_point end);
    void take(const QRegularExpressionMatch &match);
    void nextLine();
    void fail(const QString &error);
    void collect(const QRegularExpressionMatch &match);
    void replace();

    QTextDocument &m_document;
    SearchQuery m_query;
    QRegularExpression m_expression;
    QString m_error;
    std::vector<TextStretch> m_matches;

    QTimer m_timer;
    /// Where the search goes on: a line, its text, and how far it was read. No line once all is found.
    QTextBlock m_line;
    QString m_text;
    qsizetype m_at = 0;
    std::chrono::steady_clock::time_point m_told;

    std::optional<QString> m_replacement;
    std::vector<LineEdit> m_edits;
    bool m_isReplacing = false;
};

}
