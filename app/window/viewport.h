// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>

#include "app/drawing/turn.h"
#include "livepicture.h"
#include "render/sceneview.h"
#include "surfacefinder.h"
#include "tooloverlay.h"
#include "viewgestures.h"

namespace romanesco {

class PointerTool;

/// The picture of a scene, which the mouse and the keyboard look at from all sides (see ViewGestures).
class Viewport : public LivePicture
{
    Q_OBJECT
public:
    explicit Viewport(QWidget *parent = nullptr);
    ~Viewport() override;

    /// Null shows nothing but the background. The camera stays where it is, unless the scene's own camera is another
    /// than the last scene's: then the view starts anew from that.
    void setScene(std::shared_ptr<const Scene> scene);

    /// Another scene, from where it was looked at before, or from where it begins: nothing of the last one stays.
    void startScene(std::shared_ptr<const Scene> scene, const std::optional<SceneView> &view);

    /// The view of the beginning: from where it was saved, from the scene's own camera, or all of the scene in it. A scene
    /// that comes before the first picture waits for it.
    void resetView();
    /// All of the scene, from where the camera looks now.
    void fit();
    enum class Side { Front, Right, Top };
    void lookFrom(Side side);
    /// The copy that stands out fills the view, as far as there is one.
    void zoomToSelection();
    void setProjection(Projection projection);

    /// See ViewGestures.
    void setWalk(ViewGestures::Walk walk) { m_gestures.setWalk(std::move(walk)); }

    /// Goes along with something that moves, so far in the world.
    void shift(const glm::dvec3 &way);

    /// As SceneView's.
    void setTrail(std::optional<std::size_t> trail);

    /// The copies that stand out, as a click lets one.
    void select(const std::optional<Selection> &selection);
    /// The copies that a map made of the only item stand out.
    void selectMap(const std::optional<Step> &map);

    /// How far from its place a tolerance of one pixel can let anything be drawn, in pixels: more in the corners of a wide
    /// view than in its middle.
    [[nodiscard]] double shiftOfTolerance() const;

    /// What has the left button and draws over the picture from now on; null for nothing but the view. It must live until
    /// another takes its place.
    void setTool(PointerTool *tool);
    [[nodiscard]] const PointerTool *tool() const { return m_tool; }
    /// A button or a key that moves the view is held.
    [[nodiscard]] bool isHeld() const { return m_gestures.isActive() || m_isToolDragged; }
    /// What the tool draws is another.
    void updateTool() { m_overlay->update(); }

    /// The copy that is seen at a place; nothing while surfaces are still sought, or beside them.
    [[nodiscard]] std::optional<Selection> copyAt(const QPointF &place) const;
    /// The surface under a place, each copy by itself however small; nothing while it is still sought, or beside it.
    [[nodiscard]] std::optional<SceneView::Picked> surfaceAt(const QPointF &place) const;
    /// Where a point is seen, counted as the camera is.
    [[nodiscard]] std::optional<QPointF> placeOf(const glm::dvec3 &point) const;
    /// Keeps a place of the scene (see SceneView::mark()).
    void mark(const glm::dvec3 &point, double error) { m_view.mark(point, error); }
    void clearMarks() { m_view.clearMarks(); }

    /// A turn round what is looked at, from here, as large as here, nothing standing out; nothing before the first view.
    [[nodiscard]] std::optional<Turn> turn() const;

    /// How surfaces are drawn; the copy that was clicked stands out.
    void setAppearance(const Appearance &appearance);
    [[nodiscard]] const Appearance &appearance() const { return m_appearance; }

    [[nodiscard]] const SceneView &view() const { return m_view; }
    /// Whether somebody can have seen anything from there.
    [[nodiscard]] bool isViewStarted() const { return drawnScene() && !m_resetsView; }
    /// Where from, counted from the node that is near (see SceneView).
    [[nodiscard]] const Camera &camera() const { return m_view.camera(); }

Q_SIGNALS:
    void projectionChanged(romanesco::Projection projection);
    /// A press and release of the left button in one place, which is not the begin of a drag.
    void clicked(const QPoint &place);
    /// What can be done with the copy that stands out, or with the view, is asked for at a place of the screen.
    void menuRequested(const QPoint &globalPlace);
    /// Another scene has come: what was found in the last one holds no more.
    void sceneChanged(bool isNewerOfSameText);
    /// The tool is not wanted any more (Esc).
    void toolDismissed();

protected:
    [[nodiscard]] View shownView() const override;
    [[nodiscard]] bool isStartDue() const override { return (m_resetsView || m_followsCamera) && drawnScene(); }
    void startView() override;
    void enterEvent(QEnterEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void takeScene(std::shared_ptr<const Scene> scene);
    void findSurfaces();
    void selectAt(const QPointF &place);

    bool m_resetsView = false;
    /// The scene's camera was edited: the view goes there, wherever the saved one is.
    bool m_followsCamera = false;
    SceneView m_view;
    Appearance m_appearance;
    ViewGestures m_gestures;
    PointerTool *m_tool = nullptr;
    bool m_isToolDragged = false;
    ToolOverlay *m_overlay;
    SurfaceFinder m_surfaceFinder;
};

}
