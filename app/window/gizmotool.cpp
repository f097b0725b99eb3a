// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "gizmotool.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "core/fractal/statetable.h"
#include "editor/fdoeditor.h"
#include "texttab.h"
#include "viewmarks.h"
#include "viewport.h"

namespace romanesco {

namespace {

/// In pixels.
constexpr double handleSize = 90.0;
constexpr double reachOfHandle = 8.0;
/// A handle that is seen so short, end on, cannot be aimed at.
constexpr double leastLength = 14.0;
/// Of a ring, for a degree.
constexpr double leastSpeed = 0.2;
/// Scales by whole numbers are too coarse for a hand.
constexpr int decimalsOfScales = 2;
constexpr int finerDecimals = 2;
/// Larger units of a place can be told in the world's coordinates.
constexpr double leastUnitExponent = -40.0;

double distanceToSegment(const QPointF &place, const QPointF &from, const QPointF &to)
{
    const QPointF along = to - from;
    const double squared = QPointF::dotProduct(along, along);
    const double t = squared > 0.0 ? std::clamp(QPointF::dotProduct(place - from, along) / squared, 0.0, 1.0) : 0.0;
    const QPointF away = place - (from + t * along);
    return std::hypot(away.x(), away.y());
}

AffineMap below(AffineMap map, const Surroundings &here, std::size_t item, std::span<const Step> steps)
{
    for (const Step &step : steps) {
        map = map * here.scene->items[item].model->graph.set(step.set).maps[step.map];
    }
    return map;
}

AffineMap hereFromWorld(const Surroundings &here)
{
    const double unit = std::exp2(here.unitExponent);
    return {glm::dmat3(1.0 / unit), -here.origin / unit};
}

/// To where some steps lead; nothing for what is too large to be told from so deep.
std::optional<AffineMap> hereFromSteps(const Surroundings &here, std::size_t item, std::span<const Step> steps)
{
    for (const Surroundings::Node &node : here.nodes) {
        const std::size_t count = node.sharedSteps + node.steps.size();
        if (node.item == item && count <= steps.size()
            && std::ranges::equal(std::span(here.path).first(node.sharedSteps), steps.first(node.sharedSteps))
            && std::ranges::equal(node.steps, steps.subspan(node.sharedSteps, node.steps.size()))) {
            return below(node.hereFromNode, here, item, steps.subspan(count));
        }
    }
    if (here.unitExponent < leastUnitExponent) {
        return std::nullopt;
    }
    return below(hereFromWorld(here) * here.scene->items[item].worldFromModel, here, item, steps);
}

}

GizmoTool::GizmoTool(Viewport &viewport, QObject *parent)
    : QObject(parent)
    , m_viewport(viewport)
{
    connect(&m_viewport, &Viewport::viewMoved, this, [this] {
        if (m_viewport.appearance().colours.selection != m_selection && !m_drag) {
            look();
        }
    });
    connect(&m_viewport, &Viewport::sceneChanged, this, [this](bool isNewer) {
        if (isNewer && m_viewport.tool() == this) {
            selectAgain();
        }
    });
}

GizmoTool::~GizmoTool() = default;

void GizmoTool::follow(TextTab &seen, bool isLookedAt)
{
    m_seen = &seen;
    m_isLookedAt = isLookedAt;
    m_drag.reset();
    m_edit = std::make_unique<LiveEdit>(seen.editor());
    m_whileFollowed = std::make_unique<QObject>();
    connect(&seen, &TextTab::previewed, m_whileFollowed.get(), [this] {
        if (!m_drag) {
            look();
        }
    });
    look();
}

void GizmoTool::setKind(GizmoKind kind)
{
    m_kind = kind;
    m_hovered.reset();
    look();
}

/// In the scene that has just come, as far as the way to it is still there.
void GizmoTool::selectAgain()
{
    const auto &here = m_viewport.view().surroundings();
    if (!m_selection || !here || m_selection->item >= here->scene->items.size()) {
        return;
    }
    StateTable table(here->scene->items[m_selection->item].model->graph);
    if (addressOf(table, m_selection->steps)) {
        m_viewport.select(m_selection);
    }
}

// ---- What the text says

/// Of what stands out: how it is placed, and where that is written.
void GizmoTool::look()
{
    m_selection = m_viewport.appearance().colours.selection;
    m_target.reset();
    m_lack.clear();
    const std::optional<WrittenPlace> place = m_selection ? placeOf(*m_selection) : std::nullopt;
    if (!m_selection) {
        m_lack = tr("Click a copy or an object to take hold of it.");
    } else if (!m_isLookedAt || m_seen->editor().isReadOnly()) {
        m_lack = tr("This text cannot be edited here.");
    } else if (!place) {
        m_lack = tr("No transformation of this text places this.");
    } else if (const auto &vector = place->vectors[static_cast<std::size_t>(m_kind)]) {
        m_target = Target{*m_selection, *place, *vector};
    } else {
        m_lack = tr("The text says # here, or no single vector: there is nothing to drag.");
    }
    m_viewport.updateTool();
    Q_EMIT remarkChanged();
}

std::optional<WrittenPlace> GizmoTool::placeOf(const Selection &copy) const
{
    LanguageText &text = m_seen->editor().language();
    const auto &here = m_viewport.view().surroundings();
    // Of a text that is not built yet, places mean nothing.
    if (!here || m_seen->preview().text.bytes() != text.snapshot().bytes()) {
        return std::nullopt;
    }
    if (const SdoSyntax *scene = text.sdo()) {
        return placeOfItem(*scene, copy.item);
    }
    const FdoDocument *document = text.fdo();
    if (!document || copy.steps.empty()) {
        return std::nullopt;
    }
    const std::vector<AddressStep> steps =
        addressSteps(*here->scene, copy, m_seen->preview().reading.get(), text.snapshot().bytes());
    return steps.back().use ? placeOfUse(*document, steps.back().use->begin) : std::nullopt;
}

QString GizmoTool::remark() const
{
    if (m_target && m_target->vector.uses > 1) {
        return tr("This vector is used in %1 places: a drag changes all of them.").arg(m_target->vector.uses);
    }
    return m_lack;
}

// ---- Handles

std::optional<GizmoFrame> GizmoTool::frame() const
{
    const auto &here = m_viewport.view().surroundings();
    if (!m_target || !here || m_target->copy.item >= here->scene->items.size()) {
        return std::nullopt;
    }
    const bool isObject = m_seen->editor().language().sdo() != nullptr;
    const std::span<const Step> steps(m_target->copy.steps);
    const auto parent = isObject ? std::optional(hereFromWorld(*here))
                                 : hereFromSteps(*here, m_target->copy.item, steps.first(steps.size() - 1));
    return parent ? std::optional(GizmoFrame{*parent, m_target->place.parts}) : std::nullopt;
}

std::vector<GizmoHandle> GizmoTool::handles() const
{
    const std::optional<GizmoFrame> at = frame();
    if (!at) {
        return {};
    }
    const double height = heightAt(m_viewport.camera(), at->hereFromParent(at->parts.position));
    return height > 0.0 ? gizmoHandles(m_kind, *at, handleSize / std::max(1, m_viewport.height()) * height)
                        : std::vector<GizmoHandle>();
}

namespace {

/// Empty where a part of it is behind the camera, or it cannot be aimed at.
QPolygonF seenLine(const Viewport &viewport, const GizmoHandle &handle)
{
    QPolygonF line;
    for (const glm::dvec3 &point : handle.line) {
        const auto place = viewport.placeOf(point);
        if (!place) {
            return {};
        }
        line << *place;
    }
    const QPointF way = line.last() - line.first();
    return line.size() == 2 && std::hypot(way.x(), way.y()) < leastLength ? QPolygonF() : line;
}

}

std::optional<GizmoTool::Grip> GizmoTool::gripAt(const QPointF &place) const
{
    std::optional<Grip> found;
    double nearest = reachOfHandle;
    const std::vector<GizmoHandle> all = handles();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const QPolygonF line = seenLine(m_viewport, all[i]);
        for (qsizetype k = 0; k < line.size(); ++k) {
            const qsizetype next = std::min(k + 1, line.size() - 1);
            const double distance = distanceToSegment(place, line[k], line[next]);
            // what stands in the middle goes before what begins there
            const bool isMiddle = all[i].axis == GizmoHandle::all;
            if (distance < (isMiddle ? reachOfHandle : nearest)) {
                nearest = distance;
                found = Grip{i, static_cast<std::size_t>(next)};
            }
        }
    }
    return found;
}

bool GizmoTool::press(const QPointF &place)
{
    const std::optional<Grip> grip = gripAt(place);
    const std::optional<GizmoFrame> at = frame();
    if (!grip || !at || m_seen->preview().text.bytes() != m_seen->editor().language().snapshot().bytes()) {
        return false;
    }
    const GizmoHandle handle = handles()[grip->handle];
    const glm::dvec2 speed = gizmoSpeed(m_kind, *at, handle, grip->point, m_viewport.camera());
    if (m_kind == GizmoKind::Rotate && glm::length(speed) * m_viewport.height() < leastSpeed) {
        return false;
    }
    m_drag = Drag{*m_target, handle.axis, speed, place};
    const TextSnapshot &text = m_seen->editor().language().snapshot();
    m_edit->track(text.position(m_target->vector.range.begin), text.position(m_target->vector.range.end));
    m_edit->beginGesture();
    return true;
}

void GizmoTool::drag(const QPointF &place, Qt::KeyboardModifiers modifiers)
{
    const double height = std::max(1, m_viewport.height());
    const QPointF way = place - m_drag->from;
    const WrittenVector &vector = m_drag->target.vector;
    const glm::dvec3 value = gizmoDragged(m_kind, m_drag->target.place.parts, m_drag->axis, m_drag->speed,
                                          glm::dvec2(way.x(), -way.y()) / height);
    int decimals = m_kind == GizmoKind::Scale ? decimalsOfScales : 0;
    if (modifiers & Qt::ShiftModifier) {
        for (const WrittenNumber &number : vector.numbers) {
            decimals = std::max(decimals, number.decimals + finerDecimals);
        }
    }
    m_edit->replace(QString::fromStdString(vector.with(value, decimals)));
    TransformParts &parts = m_target->place.parts;
    (m_kind == GizmoKind::Move ? parts.position : m_kind == GizmoKind::Rotate ? parts.rotation : parts.scale) = value;
    m_viewport.updateTool();
}

void GizmoTool::release()
{
    m_edit->endGesture();
    m_edit->clear();
    m_drag.reset();
    // Where the text is not built yet, that will tell.
    if (m_seen->preview().text.bytes() == m_seen->editor().language().snapshot().bytes()) {
        look();
    }
}

void GizmoTool::hover(const QPointF &place)
{
    const std::optional<Grip> grip = gripAt(place);
    const auto hovered = grip ? std::optional(grip->handle) : std::nullopt;
    if (hovered != m_hovered) {
        m_hovered = hovered;
        m_viewport.setCursor(hovered ? Qt::PointingHandCursor : Qt::ArrowCursor);
        m_viewport.updateTool();
    }
}

void GizmoTool::paint(QPainter &painter) const
{
    const std::vector<GizmoHandle> all = handles();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const QPolygonF line = seenLine(m_viewport, all[i]);
        if (line.isEmpty()) {
            continue;
        }
        const bool isHeld = m_drag ? m_drag->axis == all[i].axis : m_hovered == i;
        const QColor colour = all[i].axis == GizmoHandle::all ? QColor(Qt::white) : axisColour(all[i].axis);
        drawMarkLine(painter, line, colour, isHeld ? 4.0 : 2.5);
        if (m_kind != GizmoKind::Rotate) {
            const double half = isHeld ? 6.0 : 5.0;
            const QRectF end(line.last() - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half));
            painter.setPen(QPen(markRim(), 1.5));
            painter.setBrush(colour);
            if (m_kind == GizmoKind::Move) {
                painter.drawEllipse(end);
            } else {
                painter.drawRect(end);
            }
        }
    }
}

}
