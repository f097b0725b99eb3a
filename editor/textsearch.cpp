// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textsearch.h"

#include <algorithm>
#include <utility>

#include <QTextCursor>
#include <QTextDocument>

namespace romanesco {

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto slice = 8ms;
constexpr auto tellEvery = 100ms;

/// PCRE2 gives up after so many steps, which take some milliseconds.
const QString stepLimit = QStringLiteral("(*LIMIT_MATCH=100000)");

QString patternOf(const SearchQuery &query)
{
    const QString words = query.isExpression ? query.words : QRegularExpression::escape(query.words);
    // Not \b, which asks for a letter at the end of what is sought.
    return query.isWholeWords ? QStringLiteral("(?<!\\w)(?:%1)(?!\\w)").arg(words) : words;
}

QRegularExpression::PatternOptions optionsOf(const SearchQuery &query)
{
    QRegularExpression::PatternOptions options = QRegularExpression::UseUnicodePropertiesOption;
    options.setFlag(QRegularExpression::CaseInsensitiveOption, !query.isCaseSensitive);
    return options;
}

/// A text in which every surrogate has its other need not be looked through again at each match.
QRegularExpression::MatchOptions optionsFor(const QString &text)
{
    return text.isValidUtf16() ? QRegularExpression::DontCheckSubjectStringMatchOption
                               : QRegularExpression::NoMatchOption;
}

/// \1 and such, put in their places.
QString expanded(const QString &words, const QRegularExpressionMatch &match)
{
    QString text;
    for (qsizetype i = 0; i < words.size(); ++i) {
        const QChar next = words[i] == u'\\' && i + 1 < words.size() ? words[++i] : QChar();
        if (next.isNull()) {
            text += words[i];
        } else if (next >= u'0' && next <= u'9') {
            text += match.capturedView(next.digitValue());
        } else if (next == u'n') {
            text += u'\n';
        } else if (next == u't') {
            text += u'\t';
        } else {
            text += next;
        }
    }
    return text;
}

}

TextSearch::TextSearch(QTextDocument &document)
    : m_document(document)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(0);
    connect(&m_timer, &QTimer::timeout, this, &TextSearch::goOn);
    connect(&document, &QTextDocument::contentsChange, this, [this] {
        if (!m_isReplacing) {
            m_replacement.reset();
            start();
        }
    });
}

void TextSearch::setQuery(const SearchQuery &query)
{
    m_query = query;
    m_replacement.reset();
    m_error.clear();
    // As it was typed first, so that the place of an error counts from its start.
    const QRegularExpression typed(query.words);
    if (query.isExpression && !typed.isValid()) {
        fail(tr("%1, after “%2”").arg(typed.errorString(), query.words.first(typed.patternErrorOffset())));
        return;
    }
    m_expression = QRegularExpression(stepLimit + patternOf(query), optionsOf(query));
    if (!m_expression.isValid()) {
        fail(m_expression.errorString());
        return;
    }
    start();
}

int TextSearch::foundUpTo() const
{
    return isComplete() ? m_document.characterCount() : m_line.position() + static_cast<int>(m_at);
}

std::optional<QString> TextSearch::replacement(TextStretch match, const QString &words) const
{
    const QTextBlock line = m_document.findBlock(match.begin);
    const QString text = line.text();
    const QRegularExpressionMatch found =
        m_expression.match(text, match.begin - line.position(), QRegularExpression::NormalMatch,
                           optionsFor(text) | QRegularExpression::AnchorAtOffsetMatchOption);
    if (m_query.words.isEmpty() || !found.hasMatch() || found.capturedLength() != match.end - match.begin) {
        return std::nullopt;
    }
    return m_query.isExpression ? expanded(words, found) : words;
}

void TextSearch::replaceAll(const QString &words)
{
    m_replacement = words;
    start();
}

void TextSearch::start()
{
    m_matches.clear();
    m_edits.clear();
    m_line = m_query.words.isEmpty() || !m_error.isEmpty() ? QTextBlock() : m_document.begin();
    m_text = m_line.text();
    m_at = 0;
    m_told = {};
    m_timer.start();
}

void TextSearch::goOn()
{
    searchUntil(Clock::now() + slice);
    if (!isComplete()) {
        m_timer.start();
    } else if (m_replacement) {
        replace();
        return;
    }
    if (isComplete() || Clock::now() - m_told >= tellEvery) {
        m_told = Clock::now();
        Q_EMIT advanced();
    }
}

void TextSearch::searchUntil(Clock::time_point end)
{
    auto options = optionsFor(m_text);
    while (m_line.isValid() && Clock::now() < end) {
        const QRegularExpressionMatch match =
            m_expression.match(m_text, m_at, QRegularExpression::NormalMatch, options);
        if (!match.isValid()) {
            fail(tr("This expression takes too long in line %1; nothing more was looked for.")
                     .arg(m_line.blockNumber() + 1));
        } else if (match.hasMatch()) {
            take(match);
        } else {
            nextLine();
            options = optionsFor(m_text);
        }
    }
}

void TextSearch::take(const QRegularExpressionMatch &match)
{
    const auto begin = static_cast<int>(match.capturedStart());
    const auto end = static_cast<int>(match.capturedEnd());
    m_matches.push_back({m_line.position() + begin, m_line.position() + end});
    if (m_replacement) {
        collect(match);
    }
    m_at = end;
    if (begin == end) {
        // The next begins behind the next character.
        m_at += m_at < m_text.size() && m_text[m_at].isHighSurrogate() ? 2 : 1;
    }
    if (m_at > m_text.size()) {
        nextLine();
    }
}

void TextSearch::nextLine()
{
    m_line = m_line.next();
    m_text = m_line.text();
    m_at = 0;
}

void TextSearch::fail(const QString &error)
{
    m_error = error;
    m_replacement.reset();
    m_matches.clear();
    m_line = QTextBlock();
    m_timer.start();
}

void TextSearch::collect(const QRegularExpressionMatch &match)
{
    const TextStretch stretch = m_matches.back();
    const QString words = m_query.isExpression ? expanded(*m_replacement, match) : *m_replacement;
    const bool isSameLine = !m_edits.empty() && m_edits.back().stretch.begin >= m_line.position();
    if (!isSameLine) {
        m_edits.push_back({stretch, words});
        return;
    }
    LineEdit &edit = m_edits.back();
    const int between = edit.stretch.end - m_line.position();
    edit.text += QStringView(m_text).sliced(between, match.capturedStart() - between);
    edit.text += words;
    edit.stretch.end = stretch.end;
}

void TextSearch::replace()
{
    const auto count = static_cast<int>(m_matches.size());
    const std::vector<LineEdit> edits = std::exchange(m_edits, {});
    m_replacement.reset();
    m_isReplacing = true;
    QTextCursor cursor(&m_document);
    cursor.beginEditBlock();
    // From the end, so that the places of the others stay what they are.
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        cursor.setPosition(edit->stretch.begin);
        cursor.setPosition(edit->stretch.end, QTextCursor::KeepAnchor);
        cursor.insertText(edit->text);
    }
    cursor.endEditBlock();
    m_isReplacing = false;
    start();
    Q_EMIT replacedAll(count);
}

}
