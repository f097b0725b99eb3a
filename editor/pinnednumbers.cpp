// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "pinnednumbers.h"

#include <algorithm>

#include <QTextBlock>

#include "fdoeditor.h"

namespace romanesco {

/// Two cursors, so that what takes the number's place at once, as undoing does, is between them again.
struct PinnedNumbers::Entry {
    int id = 0;
    QTextCursor begin;
    QTextCursor end;
    LiveEdit edit;
    std::optional<NumberPlace> atGestureBegin;
};

PinnedNumbers::PinnedNumbers(FdoEditor &editor)
    : QObject(&editor)
    , m_editor(editor)
{
    connect(&editor, &QPlainTextEdit::textChanged, this, &PinnedNumbers::follow);
}

PinnedNumbers::~PinnedNumbers() = default;

bool PinnedNumbers::pin(int position)
{
    LanguageText &text = m_editor.language();
    const std::optional<NumberPlace> place = numberAt(text, position);
    if (!place) {
        return false;
    }
    const int begin = text.position(place->number.range.begin);
    if (std::ranges::any_of(m_entries, [&](const auto &entry) { return entry->begin.position() == begin; })) {
        return false;
    }
    auto entry = std::make_unique<Entry>(
        Entry{m_nextId++, QTextCursor(m_editor.document()), QTextCursor(m_editor.document()), LiveEdit(m_editor), {}});
    entry->begin.setKeepPositionOnInsert(true);
    track(*entry, *place);
    m_entries.push_back(std::move(entry));
    Q_EMIT changed();
    return true;
}

void PinnedNumbers::unpin(int id)
{
    if (std::erase_if(m_entries, [id](const auto &entry) { return entry->id == id; }) > 0) {
        Q_EMIT changed();
    }
}

std::vector<PinnedNumbers::Pin> PinnedNumbers::pins() const
{
    std::vector<Pin> pins;
    for (const auto &entry : m_entries) {
        const QTextBlock block = entry->begin.block();
        const QString line = block.text();
        const int begin = entry->begin.positionInBlock();
        QString name = line.trimmed().section(u' ', 0, 0);
        while (name.endsWith(u'.')) {
            name.chop(1);
        }
        pins.push_back(
            {entry->id, line.mid(begin, entry->end.positionInBlock() - begin), name, block.blockNumber() + 1});
    }
    return pins;
}

void PinnedNumbers::beginGesture(int id)
{
    if (Entry *entry = find(id)) {
        entry->atGestureBegin = placeOf(*entry);
        entry->edit.beginGesture();
    }
}

void PinnedNumbers::step(int id, int steps)
{
    Entry *entry = find(id);
    const std::optional<NumberPlace> now = entry ? placeOf(*entry) : std::nullopt;
    if (now) {
        entry->edit.track(entry->begin.position(), entry->end.position());
        const NumberPlace &from = entry->atGestureBegin ? *entry->atGestureBegin : *now;
        // An entry that does not outlive its step must not go in the middle of it.
        m_isStepping = true;
        entry->edit.replace(QString::fromStdString(stepped(from, steps, false).text));
        m_isStepping = false;
        follow();
    }
}

void PinnedNumbers::endGesture(int id)
{
    if (Entry *entry = find(id)) {
        entry->atGestureBegin.reset();
        entry->edit.endGesture();
        Q_EMIT changed();
    }
}

PinnedNumbers::Entry *PinnedNumbers::find(int id) const
{
    const auto at = std::ranges::find(m_entries, id, [](const auto &entry) { return entry->id; });
    return at == m_entries.end() ? nullptr : at->get();
}

std::optional<NumberPlace> PinnedNumbers::placeOf(const Entry &entry) const
{
    if (entry.begin.position() >= entry.end.position()) {
        return std::nullopt;
    }
    LanguageText &text = m_editor.language();
    const std::optional<NumberPlace> place = numberAt(text, entry.begin.position());
    return place ? place : numberAt(text, entry.end.position());
}

void PinnedNumbers::track(Entry &entry, const NumberPlace &place)
{
    LanguageText &text = m_editor.language();
    entry.begin.setPosition(text.position(place.number.range.begin));
    entry.end.setPosition(text.position(place.number.range.end));
}

void PinnedNumbers::follow()
{
    if (m_entries.empty() || m_isStepping) {
        return;
    }
    std::erase_if(m_entries, [this](const auto &entry) {
        const std::optional<NumberPlace> place = placeOf(*entry);
        if (place) {
            track(*entry, *place);
        }
        return !place;
    });
    Q_EMIT changed();
}

}
