// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <optional>
#include <set>
#include <span>

#include <epoxy/gl.h>

#include "balllayer.h"
#include "copyring.h"
#include "depthlooks.h"
#include "glresources.h"
#include "gpuscene.h"
#include "sampleplace.h"
#include "scenecut.h"
#include "shownpicture.h"
#include "surfaces.h"

namespace romanesco {

namespace {

using Clock = std::chrono::steady_clock;

/// Of one draw call. In software these take about ten milliseconds, which is how finely a slice can end.
constexpr std::size_t mostFaces = 50'000;

/// The first picture is drawn roughly, then less so, to learn what will be hidden.
constexpr double firstRoughness = 16.0;
constexpr double roughnessStep = 4.0;

constexpr auto wasReset = "The graphics driver was reset.";

/// Of the picture that is shown, what balls are drawn over.
struct BehindBalls {
    GlTexture depths;
    Projector projector;
    std::shared_ptr<const Surroundings> surroundings;
    bool isLit = true;
};

}

/// A picture is made in passes, one for each sample: the cut is walked and drawn in chunks into `pass`, then the pass
/// goes into what is shown.
class Renderer::Private
{
public:
    ~Private() { deleteFence(m_passFence); }

    std::expected<void, std::string> initialise()
    {
        // Of OpenGL ES there is no 4.5.
        const GLubyte *version = glGetString(GL_VERSION);
        if (!version || epoxy_gl_version() < 45) {
            return std::unexpected(std::format("Drawing needs OpenGL 4.5; this system offers {}.",
                                               version ? reinterpret_cast<const char *>(version) : "none"));
        }
        if (glGetGraphicsResetStatus() != GL_NO_ERROR) {
            return std::unexpected(std::string(wasReset));
        }
        static_cast<void>(ranOutOfMemory()); // of whoever used the context before
        if (auto made = m_shown.make(); !made) {
            return made;
        }
        if (auto made = m_surfaces.make(); !made) {
            return made;
        }
        if (!m_ring.make() || ranOutOfMemory()) {
            return std::unexpected(std::string("The graphics driver has no room for the drawing buffers."));
        }
        return {};
    }

    void setScene(std::shared_ptr<const Scene> scene) { m_nextScene = std::move(scene); }

    void begin(const View &view)
    {
        m_view = view;
        m_passes = 0;
        m_error.clear();
        m_statistics = {};
        if (m_scene != m_nextScene) {
            m_cut.reset();
            m_scene = m_nextScene;
            if (!uploadScene()) {
                fail("The graphics driver has no room for the meshes and textures of the scene.");
                m_onCard.set(nullptr, m_ring);
                return;
            }
            if (m_scene) {
                m_cut.emplace(*m_scene);
                m_world = Anchor(m_scene).surroundings();
            }
        }
        const bool isDeep = view.surroundings && view.surroundings->scene == m_scene;
        m_surroundings = isDeep ? view.surroundings : m_world;
        const GLenum format = view.samples == 1 ? GL_SRGB8_ALPHA8 : GL_RGBA16F;
        if (m_pass.width != view.width || m_pass.height != view.height || m_pass.colourFormat != format) {
            auto target = makeTarget(view.width, view.height, format, true);
            if (!target) {
                fail(target.error());
                return;
            }
            m_pass = std::move(*target);
        }
        m_looks.setSize(view.width, view.height);
        if (view.standsAlone) {
            m_looks.forget();
        }
        m_roughness = m_cut && view.leavesOutHidden && m_looks.isFirst() ? firstRoughness : 1.0;
        beginPass();
    }

    bool step(std::chrono::milliseconds budget)
    {
        const Clock::time_point end = Clock::now() + budget;
        noticeReset();
        do {
            if (isFinished()) {
                break;
            }
            m_isDrawn ? waitForPass(end) : drawChunk();
        } while (Clock::now() < end);
        return isFinished();
    }

    [[nodiscard]] bool isFinished() const { return !m_error.empty() || m_passes == m_view.samples; }
    [[nodiscard]] bool isLost() const { return m_isLost; }
    [[nodiscard]] int finishedSamples() const { return m_passes; }
    [[nodiscard]] const std::string &error() const { return m_error; }

    void present(GLuint framebuffer, int width, int height) const
    {
        m_shown.present(framebuffer, width, height, m_view.backgroundTop, m_view.backgroundBottom);
    }

    std::expected<void, std::string> presentBalls(GLuint framebuffer, int width, int height,
                                                  std::span<const BallSprite> balls)
    {
        if (!m_behindBalls || m_shown.isEmpty()) {
            return {};
        }
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        const BallLayer::Picture picture{m_behindBalls->projector, *m_behindBalls->surroundings, m_behindBalls->isLit,
                                         m_behindBalls->depths};
        return m_balls.draw(balls, picture, width, height);
    }

    Picture read(std::span<const BallSprite> balls)
    {
        if (m_shown.isEmpty()) {
            return {};
        }
        auto target = makeTarget(m_shown.width(), m_shown.height(), GL_RGBA8, false);
        if (!target) {
            return {};
        }
        present(target->framebuffer, target->width, target->height);
        if (const auto drawn = presentBalls(target->framebuffer, target->width, target->height, balls); !drawn) {
            fail(drawn.error());
            return {};
        }
        Picture picture{target->width, target->height, {}};
        const std::size_t rowBytes = static_cast<std::size_t>(picture.width) * 3;
        std::vector<std::uint8_t> pixels(rowBytes * static_cast<std::size_t>(picture.height));
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, picture.width, picture.height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
        noticeReset();
        if (m_isLost) {
            return {};
        }

        // The card counts rows from the bottom.
        picture.pixels.reserve(pixels.size());
        for (std::size_t end = pixels.size(); end > 0; end -= rowBytes) {
            const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(end - rowBytes);
            picture.pixels.insert(picture.pixels.end(), row, row + static_cast<std::ptrdiff_t>(rowBytes));
        }
        return picture;
    }

    [[nodiscard]] DrawStatistics statistics() const
    {
        DrawStatistics statistics = m_statistics;
        statistics.bufferBytes = CopyRing::bytes() + m_onCard.bytes() + m_looks.memoryUse();
        statistics.graphBytes = m_cut ? m_cut->memoryUse() + m_graphBytes : 0;
        return statistics;
    }

private:
    void fail(std::string words)
    {
        m_error = std::move(words);
        m_cut.reset();
        m_scene.reset();
    }

    void noticeReset()
    {
        if (glGetGraphicsResetStatus() != GL_NO_ERROR) {
            m_isLost = true;
            fail(wasReset);
        }
    }

    // ---- Resources

    /// Whether the driver has room for it.
    bool uploadScene()
    {
        static_cast<void>(ranOutOfMemory()); // of whoever used the context before
        m_onCard.set(m_scene.get(), m_ring);
        m_graphBytes = 0;
        std::set<const Model *> models;
        for (std::size_t i = 0; m_scene && i < m_scene->items.size(); ++i) {
            const Model *model = m_scene->items[i].model.get();
            m_graphBytes += models.insert(model).second ? model->graph.memoryUse() : 0;
        }
        return !ranOutOfMemory();
    }

    // ---- Passes

    void beginPass()
    {
        m_passStart = Clock::now();
        m_isDrawn = false;
        m_faces = 0;
        if (m_cut) {
            m_projector.emplace(m_view.camera, m_surroundings->nearby, m_surroundings->reach, m_view.width,
                                m_view.height);
            const auto [x, y] = samplePlace(m_passes, m_view.samples);
            m_projector->jitter = {2.0 * x / m_view.width, 2.0 * y / m_view.height};
            m_looks.begin();
            m_cut->setDepths(m_view.leavesOutHidden ? &m_looks.depths() : nullptr);
            m_cut->begin(*m_projector, m_surroundings,
                         m_roughness > 1.0 ? m_roughness * std::max(1.0, m_view.pixelTolerance) : m_view.pixelTolerance,
                         m_view.appearance.colours, m_view.leavesOutBalls);
        }
        if (m_cut) {
            const Surfaces::Pass pass{*m_projector, static_cast<unsigned>(m_passes)};
            m_surfaces.beginPass(pass, *m_surroundings, m_view.appearance);
        }
        const GLfloat nothing[] = {0.0f, 0.0f, 0.0f, 0.0f};
        const GLfloat farthest = 0.0f;
        glClearNamedFramebufferfv(m_pass.framebuffer, GL_COLOR, 0, nothing);
        glClearNamedFramebufferfv(m_pass.framebuffer, GL_DEPTH, 0, &farthest);
    }

    void drawChunk()
    {
        if (!m_cut || m_cut->isComplete()) {
            if (m_cut && m_view.leavesOutHidden) {
                m_looks.finish(*m_cut, m_pass.framebuffer);
            }
            m_isDrawn = true;
            deleteFence(m_passFence);
            m_passFence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
            glFlush();
            return;
        }
        if (m_view.leavesOutHidden) {
            m_looks.lookIfDue(*m_cut, m_pass.framebuffer);
        }
        const Model &model = m_cut->model();
        const std::size_t faces = model.mesh->faces.size();
        const std::size_t copiesPerDraw = std::clamp<std::size_t>(mostFaces / (faces + 1), 1, CopyRing::chunkSize);
        const std::span<const Instance> copies = m_cut->next(copiesPerDraw);
        const std::span<const Tint> tints = m_cut->tints();
        if (copies.empty()) {
            return;
        }
        bindForDrawing();
        for (std::size_t at = 0; at < copies.size(); at += copiesPerDraw) {
            const std::size_t count = std::min(copiesPerDraw, copies.size() - at);
            const bool hasTints = !tints.empty();
            const GLuint first =
                m_ring.put(copies.subspan(at, count), hasTints ? tints.subspan(at, count) : std::span<const Tint>());
            const auto drawn = m_surfaces.draw(m_onCard, model, first, count, hasTints);
            m_ring.sent();
            if (!drawn) {
                glDisable(GL_FRAMEBUFFER_SRGB);
                fail(drawn.error());
                return;
            }
        }
        glDisable(GL_FRAMEBUFFER_SRGB);
        m_looks.sent(copies.size() * faces);
        m_faces += copies.size() * faces;
        glFlush();
    }

    void bindForDrawing() const
    {
        glBindFramebuffer(GL_FRAMEBUFFER, m_pass.framebuffer);
        glViewport(0, 0, m_pass.width, m_pass.height);
        glDisable(GL_BLEND);
        glDisable(GL_CULL_FACE);
        glDisable(GL_SCISSOR_TEST);
        glEnable(GL_FRAMEBUFFER_SRGB); // which is for formats that have it
        // Reversed depth in floats: as fine far away as near.
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDepthMask(GL_TRUE);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    }

    void waitForPass(Clock::time_point end)
    {
        const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(end - Clock::now()).count();
        const GLenum state = glClientWaitSync(m_passFence, GL_SYNC_FLUSH_COMMANDS_BIT,
                                              static_cast<GLuint64>(std::max<std::int64_t>(left, 0)));
        if (state != GL_TIMEOUT_EXPIRED) {
            finishPass();
        }
    }

    void finishPass()
    {
        noticeReset();
        if (m_isLost) {
            return;
        }
        if (ranOutOfMemory()) {
            fail("The graphics driver ran out of memory.");
            return;
        }
        if (m_roughness > 1.0) {
            const bool isDense = !m_looks.depths().before.isEmpty();
            m_roughness = isDense ? m_roughness / roughnessStep : 1.0;
            beginPass();
            return;
        }
        if (m_passes == 0) {
            keepDepths();
        }
        if (m_view.samples == 1) {
            m_shown.take(m_pass);
        } else if (const auto added = m_shown.add(m_pass, m_passes == 0); !added) {
            fail(added.error());
            return;
        }
        endPass();
    }

    /// Those of the first pass do for all: a pass has its pixels shifted by less than one.
    void keepDepths()
    {
        if (!m_view.leavesOutBalls || !m_cut) {
            m_behindBalls.reset();
            return;
        }
        if (!m_behindBalls || m_behindBalls->projector.width != m_pass.width
            || m_behindBalls->projector.height != m_pass.height) {
            m_behindBalls.emplace();
            m_behindBalls->depths = makeDepths(m_pass.width, m_pass.height);
        }
        glCopyImageSubData(m_pass.depth, GL_TEXTURE_2D, 0, 0, 0, 0, m_behindBalls->depths, GL_TEXTURE_2D, 0, 0, 0, 0,
                           m_pass.width, m_pass.height, 1);
        m_behindBalls->projector = *m_projector;
        m_behindBalls->projector.jitter = {0.0, 0.0};
        m_behindBalls->surroundings = m_surroundings;
        m_behindBalls->isLit = m_view.appearance.isLit;
    }

    void endPass()
    {
        ++m_passes;
        m_statistics.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - m_passStart).count();
        m_statistics.instances = m_cut ? m_cut->instanceCount() : 0;
        m_statistics.faces = m_faces;
        m_statistics.statesVisited = m_cut ? m_cut->statesVisited() : 0;
        if (!isFinished()) {
            beginPass();
        }
    }

    std::shared_ptr<const Scene> m_scene;
    std::shared_ptr<const Scene> m_nextScene;
    std::shared_ptr<const Surroundings> m_world;
    std::shared_ptr<const Surroundings> m_surroundings;
    std::optional<SceneCut> m_cut;
    std::optional<Projector> m_projector;
    View m_view;
    std::string m_error;
    bool m_isLost = false;

    int m_passes = 0;
    bool m_isDrawn = false;
    /// Times the tolerance; above 1 the pass is for its depth alone.
    double m_roughness = 1.0;
    Clock::time_point m_passStart;
    /// Of the pass under way.
    std::uint64_t m_faces = 0;
    DrawStatistics m_statistics;

    CopyRing m_ring;
    GpuScene m_onCard;
    Surfaces m_surfaces;
    std::size_t m_graphBytes = 0;
    DepthLooks m_looks;
    GLsync m_passFence = nullptr;
    std::optional<BehindBalls> m_behindBalls;
    BallLayer m_balls;
    Target m_pass;
    ShownPicture m_shown;
};

Renderer::Renderer(std::unique_ptr<Private> p)
    : d(std::move(p))
{
}

Renderer::~Renderer() = default;

std::expected<std::unique_ptr<Renderer>, std::string> Renderer::create()
{
    auto p = std::make_unique<Private>();
    if (auto made = p->initialise(); !made) {
        return std::unexpected(made.error());
    }
    return std::unique_ptr<Renderer>(new Renderer(std::move(p)));
}

void Renderer::setScene(std::shared_ptr<const Scene> scene)
{
    d->setScene(std::move(scene));
}

void Renderer::begin(const View &view)
{
    d->begin(view);
}

bool Renderer::step(std::chrono::milliseconds budget)
{
    return d->step(budget);
}

bool Renderer::isFinished() const
{
    return d->isFinished();
}

bool Renderer::isLost() const
{
    return d->isLost();
}

int Renderer::finishedSamples() const
{
    return d->finishedSamples();
}

const std::string &Renderer::error() const
{
    return d->error();
}

void Renderer::present(unsigned framebuffer, int width, int height)
{
    d->present(framebuffer, width, height);
}

std::expected<void, std::string> Renderer::presentBalls(unsigned framebuffer, int width, int height,
                                                        std::span<const BallSprite> balls)
{
    return d->presentBalls(framebuffer, width, height, balls);
}

Picture Renderer::read(std::span<const BallSprite> balls)
{
    return d->read(balls);
}

DrawStatistics Renderer::statistics() const
{
    return d->statistics();
}

std::string Renderer::description() const
{
    const auto text = [](GLenum name) { return reinterpret_cast<const char *>(glGetString(name)); };
    return std::format("OpenGL {}, {}", text(GL_VERSION), text(GL_RENDERER));
}

}
