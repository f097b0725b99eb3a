// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>
#include <epoxy/egl.h>

#include "drawing.h"
#include "gldoubles.h"
#include "tests/testmain.h"

using namespace romanesco;
using namespace romanesco::test;

/// What can fail of OpenGL is told in a sentence, and the next picture is drawn.
class TestFailures : public DrawingTest
{
    Q_OBJECT

    std::shared_ptr<const Scene> m_scene = sceneOf("<$>. \"box.obj\"\n");
    View m_view = fittedView(*m_scene);

    /// Why there is no picture.
    std::string failureOf(const std::shared_ptr<const Scene> &scene)
    {
        draw(scene, m_view);
        return m_renderer->error();
    }
    bool remakeRenderer()
    {
        auto made = Renderer::create();
        if (made) {
            m_renderer = std::move(*made);
        }
        return made.has_value();
    }
    bool drawsAgain() { return shareOfBackground(draw(m_scene, m_view)) < 0.9 && m_renderer->error().empty(); }

private Q_SLOTS:
    void anotherOpenGlIsNamed()
    {
        const EGLDisplay display = eglGetCurrentDisplay();
        const EGLContext desktop = eglGetCurrentContext();
        QVERIFY(eglBindAPI(EGL_OPENGL_ES_API));
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
        const EGLContext embedded = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        QVERIFY(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, embedded));
        const auto made = Renderer::create();
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, embedded);
        QVERIFY(eglBindAPI(EGL_OPENGL_API) && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, desktop));
        QVERIFY(!made);
        QVERIFY2(made.error().starts_with("Drawing needs OpenGL 4.5; this system offers OpenGL ES 3"),
                 made.error().c_str());
    }

    void shadersThatDoNotCompileAreTold()
    {
        for (int good = 0; good < 6; ++good) {
            const BrokenShaders broken(good);
            const auto made = Renderer::create();
            QVERIFY(!made);
            QVERIFY2(made.error().contains("A shader does not compile: 0:1"), made.error().c_str());
        }
        // made when it is first wanted
        m_view.appearance.hasWires = true;
        {
            const BrokenShaders broken;
            QVERIFY(failureOf(m_scene).contains("A shader does not compile"));
        }
        QVERIFY(drawsAgain());
        m_view.appearance.hasWires = false;
    }

    void withoutMemoryToBeginWithThereIsNoRenderer()
    {
        for (int good = 0; good < 3; ++good) {
            const NoMemory none(NoMemory::For::Buffers, good, 1);
            const auto made = Renderer::create();
            QVERIFY(!made);
            QVERIFY2(made.error().contains("no room for"), made.error().c_str());
        }
    }

    void aSceneWithoutMemoryIsTold_data()
    {
        QTest::addColumn<int>("good");
        QTest::newRow("vertices") << 0;
        QTest::newRow("faces") << 1;
    }

    void aSceneWithoutMemoryIsTold()
    {
        QFETCH(const int, good);
        const auto other = sceneOf("v 1 0 0\nx. \"box.obj\"\nt.p. (p, #, #)\n<$>. [t.1] x\n");
        {
            const NoMemory none(NoMemory::For::Buffers, good);
            QCOMPARE(failureOf(other),
                     std::string("The graphics driver has no room for the meshes and textures of the scene."));
        }
        QVERIFY(shareOfBackground(draw(other, m_view)) < 0.95);
        QVERIFY(drawsAgain());
    }

    void aPictureWithoutMemoryIsTold()
    {
        m_view.samples = 2;
        for (int good = 0; good < 3; ++good) {
            ++m_view.width; // so that it needs another
            const NoMemory none(NoMemory::For::Textures, good);
            QVERIFY2(failureOf(m_scene).contains("no room for a picture of"), m_renderer->error().c_str());
        }
        QVERIFY(drawsAgain());
        const NoMemory none(NoMemory::For::Textures);
        QVERIFY(m_renderer->read().pixels.empty());
    }

    void drawingWithoutMemoryIsTold()
    {
        {
            const NoMemory none(NoMemory::For::Drawing);
            QCOMPARE(failureOf(m_scene), std::string("The graphics driver ran out of memory."));
        }
        QVERIFY(drawsAgain());
    }

    void aResetIsTold()
    {
        QVERIFY(drawsAgain() && !m_renderer->isLost());
        {
            const DriverReset reset(1);
            QCOMPARE(failureOf(m_scene), std::string("The graphics driver was reset."));
            QVERIFY(m_renderer->isLost());
        }
        QVERIFY(remakeRenderer());
        m_renderer->setScene(m_scene);
        m_renderer->begin(m_view);
        {
            const DriverReset whileItDraws(1, 1);
            m_renderer->step(std::chrono::seconds(60));
            QVERIFY2(m_renderer->isLost() && m_renderer->finishedSamples() == 0, "what was drawn last is nothing");
        }
        QVERIFY(remakeRenderer() && drawsAgain());
        {
            const DriverReset whileItIsRead(1);
            QVERIFY(m_renderer->read().pixels.empty() && m_renderer->isLost());
        }
        const DriverReset again(1);
        const auto made = Renderer::create();
        QVERIFY(!made);
        QCOMPARE(made.error(), std::string("The graphics driver was reset."));
    }
};

ROMANESCO_TEST(TestFailures)
#include "testfailures.moc"
