// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QObject>
#include <QTimer>

#include "fdoreading.h"

namespace romanesco {

class AddressPane;
class TextTab;
class Viewport;

/// Between picture and text, both ways: a click on a copy lists the steps that lead to it, a step selects its words and
/// lets all that it leads to stand out, and what the use at the cursor has made stands out.
class AddressLink : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    AddressLink(AddressPane &pane, Viewport &viewport, QObject *parent = nullptr);

    /// From now on the picture is of that text; the cursor tells only while that text is looked at too.
    void follow(TextTab &seen, bool isLookedAt);
    /// The picture is another: nothing of what was said holds.
    void clear();
    /// The picture is of a newer text.
    void update();

Q_SIGNALS:
    /// The way to the copy that was clicked, in one line; empty where there is none.
    void told(const QString &words);

private:
    void tell();
    void choose(std::size_t count);
    void showMapAtCursor();

    AddressPane &m_pane;
    Viewport &m_viewport;
    TextTab *m_seen = nullptr;
    /// Lives as long as this text is followed, for what is connected to it.
    std::unique_ptr<QObject> m_whileFollowed;
    bool m_isLookedAt = false;
    /// Of the copy that was clicked.
    std::vector<AddressStep> m_steps;
    std::vector<Step> m_wholeWay;
    /// The cursor rests.
    QTimer m_cursorRest;
};

}
