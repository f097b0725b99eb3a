// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QObject>
#include <QTimer>

#include "fdoreading.h"
#include "hoverpick.h"

class QAction;

namespace romanesco {

class AddressPane;
class TextTab;
class Viewport;

/// Between picture and text, both ways: a click on a copy lists the steps that lead to it, a step selects its words and
/// lets all that it leads to stand out or ends the depth there, what the mouse rests on is named, and what the use at the
/// cursor has made stands out.
class AddressLink : public QObject
{
    Q_OBJECT
public:
    /// Both must outlive it.
    AddressLink(AddressPane &pane, Viewport &viewport, QObject *parent = nullptr);

    /// Actions of the window that do what the buttons of the pane do.
    void use(QAction &zoom, QAction &collapse);

    /// From now on the picture is of that text; the cursor tells only while that text is looked at too.
    void follow(TextTab &seen, bool isLookedAt);
    /// The picture is another: nothing of what was said holds.
    void clear();
    /// The picture is of a newer text.
    void update();

    /// The way to a copy, in one line.
    [[nodiscard]] QString wordsOf(const Selection &copy) const;
    /// The way to the copy of an item with that address.
    [[nodiscard]] QString wordsOf(std::size_t item, const Address &address) const;

Q_SIGNALS:
    /// The way to the copy that the mouse rests on, or else that was clicked, in one line; empty where there is none.
    void told(const QString &words);

private:
    [[nodiscard]] std::vector<AddressStep> stepsTo(const Selection &copy) const;
    void list();
    void tell();
    void offer();
    [[nodiscard]] std::optional<quint64> collapsedDepth() const;
    void collapse();
    void choose(std::size_t count);
    void showMapAtCursor();

    AddressPane &m_pane;
    Viewport &m_viewport;
    HoverPick m_hover;
    QAction *m_zoomAction = nullptr;
    QAction *m_collapseAction = nullptr;
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
