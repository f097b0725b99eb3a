// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QPointF>

#include "core/language/writtenplace.h"
#include "editor/liveedit.h"
#include "gizmoshape.h"
#include "pointertool.h"
#include "render/appearance.h"

namespace romanesco {

class TextTab;
class Viewport;

/// Handles at the copy that stands out, or at the object of a scene: what is dragged rewrites the one vector of the text
/// that it comes from, a drag is one undo step, and the picture follows. With Shift numbers get two more decimals.
class GizmoTool : public QObject, public PointerTool
{
    Q_OBJECT
public:
    /// viewport must outlive it.
    explicit GizmoTool(Viewport &viewport, QObject *parent = nullptr);
    ~GizmoTool() override;

    /// From now on the picture is of that text, which it edits only while that is looked at too.
    void follow(TextTab &seen, bool isLookedAt);
    void setKind(GizmoKind kind);

    bool press(const QPointF &place) override;
    void drag(const QPointF &place, Qt::KeyboardModifiers modifiers) override;
    void release() override;
    void hover(const QPointF &place) override;
    void paint(QPainter &painter) const override;

    /// Why there are no handles, or how many places a drag changes; a sentence, or empty.
    [[nodiscard]] QString remark() const;

Q_SIGNALS:
    void remarkChanged();

private:
    struct Target {
        Selection copy;
        WrittenPlace place;
        /// Where the vector of the kind is written.
        WrittenVector vector;
    };
    struct Grip {
        std::size_t handle = 0;
        std::size_t point = 0;
    };
    struct Drag {
        Target target;
        int axis = 0;
        glm::dvec2 speed{0.0};
        QPointF from;
    };
    void look();
    [[nodiscard]] std::optional<WrittenPlace> placeOf(const Selection &copy) const;
    void selectAgain();
    [[nodiscard]] std::optional<GizmoFrame> frame() const;
    [[nodiscard]] std::vector<GizmoHandle> handles() const;
    [[nodiscard]] std::optional<Grip> gripAt(const QPointF &place) const;

    Viewport &m_viewport;
    TextTab *m_seen = nullptr;
    bool m_isLookedAt = false;
    /// Lives as long as this text is followed.
    std::unique_ptr<QObject> m_whileFollowed;
    std::unique_ptr<LiveEdit> m_edit;
    GizmoKind m_kind = GizmoKind::Move;
    std::optional<Selection> m_selection;
    std::optional<Target> m_target;
    QString m_lack;
    std::optional<Drag> m_drag;
    std::optional<std::size_t> m_hovered;
};

}
