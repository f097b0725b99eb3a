// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <vector>

#include <QObject>

#include "liveedit.h"
#include "numberplace.h"

namespace romanesco {

class FdoEditor;

/// Numbers of a text that something beside it moves for as long as it is open. Each is followed wherever its place goes,
/// and forgotten when it is deleted or becomes something else.
class PinnedNumbers : public QObject
{
    Q_OBJECT
public:
    /// editor must outlive it.
    explicit PinnedNumbers(FdoEditor &editor);
    ~PinnedNumbers() override;

    /// The number that a position touches; false where there is none, or it is pinned.
    bool pin(int position);
    void unpin(int id);

    struct Pin {
        /// Its own as long as it is pinned.
        int id = 0;
        /// As written.
        QString number;
        /// What its line begins with: a name, or a letter.
        QString name;
        /// From 1.
        int line = 0;
    };
    /// In the order in which they were pinned.
    [[nodiscard]] std::vector<Pin> pins() const;

    /// Moves a number by so many steps of its last decimal from what it was at beginGesture(), or without that, is; all of a
    /// gesture is one undo step.
    void beginGesture(int id);
    void step(int id, int steps);
    void endGesture(int id);

Q_SIGNALS:
    /// pins() are others.
    void changed();

private:
    struct Entry;
    [[nodiscard]] Entry *find(int id) const;
    [[nodiscard]] std::optional<NumberPlace> placeOf(const Entry &entry) const;
    void track(Entry &entry, const NumberPlace &place);
    void follow();

    FdoEditor &m_editor;
    std::vector<std::unique_ptr<Entry>> m_entries;
    int m_nextId = 0;
    bool m_isStepping = false;
};

}
