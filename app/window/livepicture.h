// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include "render/dragtolerance.h"
#include "render/renderer.h"

namespace romanesco {

/// A picture of a scene that changes. Draws in slices, so that it never holds up the window: coarsely while the view moves,
/// then finely, then smoothly. What is seen, and from where, is told by who derives from it.
class LivePicture : public QOpenGLWidget
{
    Q_OBJECT
public:
    explicit LivePicture(QWidget *parent = nullptr);
    ~LivePicture() override;

    /// Of a picture at rest, in pixels of the screen, above 0 (see View::pixelTolerance).
    void setPixelTolerance(double pixels);

    /// Balls over the picture, in place of the scene's own; nothing for these.
    void setBalls(std::optional<std::vector<BallSprite>> balls);

    /// Whether what is seen is the newest scene from the newest view, at its best.
    [[nodiscard]] bool isPictureFinished() const;

Q_SIGNALS:
    /// From another place, another scene, or otherwise to be drawn anew.
    void viewMoved();
    /// One or more passes over the scene have come into the picture.
    void pictureAdvanced(const romanesco::DrawStatistics &statistics, double pixelTolerance);
    void pictureFinished();
    /// Drawing works from now on. system names the version of OpenGL and what implements it.
    void ready(const QString &system);
    /// There can be no pictures on this system; a sentence or two.
    void unavailable(const QString &reason);
    /// This picture could not be drawn; another may be. A sentence; empty once one could.
    void pictureFailed(const QString &reason);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int width, int height) override;
    void showEvent(QShowEvent *event) override;

    /// From where the scene is seen now, and how its surfaces look; how large and how exact that is drawn is not asked.
    [[nodiscard]] virtual View shownView() const = 0;
    /// The view is to start anew before more is drawn, which startView() does.
    [[nodiscard]] virtual bool isStartDue() const = 0;
    virtual void startView() = 0;

    /// Null for nothing but the background.
    [[nodiscard]] const std::shared_ptr<const Scene> &drawnScene() const { return m_scene; }
    /// What is drawn from the next slice on.
    void drawScene(std::shared_ptr<const Scene> scene);
    /// That scene came from the same text. Such are followed coarsely where a fine picture takes its time, and sooner while
    /// they go on coming.
    void paceText();
    /// To be drawn anew; counts as a movement.
    void moved();
    /// There is something to draw.
    void wake() { m_drawing.start(); }

    /// In pixels of the screen.
    [[nodiscard]] QSize pixelSize() const;
    [[nodiscard]] double pixelTolerance() const { return m_tolerance; }
    [[nodiscard]] double aspect() const;

private:
    /// What a picture is of, the scene apart: equal requests make equal pictures.
    struct Request {
        quint64 revision;
        QSize size;
        /// While the view moves: as exact as there is time for.
        bool isCoarse;
        int samples;
        /// At rest.
        double pixelTolerance;
        bool leavesOutBalls;
        bool operator==(const Request &) const = default;
    };

    void startDrawing();
    [[nodiscard]] bool makeRenderer();
    void recover();
    void release();
    void reportWhetherAvailable();
    void drawOn();
    [[nodiscard]] bool hasNothingToDraw() const;
    void beginPictureIfDue();
    void begin(const Request &wanted);
    [[nodiscard]] bool isNothingSeenYet() const;
    [[nodiscard]] double drawnFor() const;
    void announceProgress();
    [[nodiscard]] Request request() const;
    [[nodiscard]] bool isMoving() const;

    std::unique_ptr<Renderer> m_renderer;
    /// There is a context, and a renderer as soon as the window was seen.
    bool m_isRendererDue = false;
    QString m_lack;
    std::shared_ptr<const Scene> m_scene;
    bool m_isSceneNew = false;

    std::optional<std::vector<BallSprite>> m_balls;
    quint64 m_revision = 0;
    /// Runs while the view counts as moving.
    QTimer m_rest;
    /// Runs while the picture is not finished.
    QTimer m_drawing;

    std::optional<Request> m_begun;
    double m_begunTolerance = 0.0;
    double m_tolerance = 1.0;
    QElapsedTimer m_sinceBegun;
    /// It came from the text.
    QElapsedTimer m_sinceScene;
    DragTolerance m_dragTolerance;
    int m_announcedSamples = 0;
    bool m_isFinishAnnounced = false;
    /// How long one pass of the last fine picture took.
    double m_fineMilliseconds = 0.0;
};

}
