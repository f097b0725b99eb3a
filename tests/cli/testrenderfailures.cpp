// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cstdio>
#include <memory>

#include <QTemporaryDir>
#include <QTest>
#include <epoxy/egl.h>

#include <unistd.h>

#include "app/cli/commandline.h"
#include "program.h"
#include "tests/render/gldoubles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Only OpenGL ES is offered.
class EmbeddedAlone
{
    using Bind = Double<epoxy_eglBindAPI>;

    static EGLBoolean bind(EGLenum api) { return api == EGL_OPENGL_API ? EGL_FALSE : Bind::real(api); }

    Bind m_bind{bind};
};

using Failure = std::shared_ptr<void>;

template<typename Kind, typename... Arguments>
std::function<Failure()> failing(Arguments... arguments)
{
    return [arguments...] { return std::make_shared<Kind>(arguments...); };
}

}

/// What can fail of OpenGL, within the process: `romanesco render` says what, and leaves no file.
class TestRenderFailures : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    /// As the program would end, with what stands on stderr in between.
    Outcome render(const QString &output)
    {
        const QString words = m_folder.filePath(QStringLiteral("words"));
        std::fflush(stderr);
        const int before = dup(STDERR_FILENO);
        std::FILE *file = std::fopen(words.toUtf8().constData(), "w");
        dup2(fileno(file), STDERR_FILENO);
        const int status = cli::runRender({examples + QStringLiteral("menger.fdo"), QStringLiteral("-o"), output,
                                           QStringLiteral("--size"), QStringLiteral("64x48")});
        std::fflush(stderr);
        dup2(before, STDERR_FILENO);
        close(before);
        std::fclose(file);
        return {status, false, {}, bytesOf(words)};
    }

private Q_SLOTS:
    void whatFailsIsToldAndNoFileIsLeft_data()
    {
        QTest::addColumn<std::function<Failure()>>("fail");
        QTest::addColumn<QByteArray>("words");
        using For = NoMemory::For;
        QTest::newRow("OpenGL ES alone") << failing<EmbeddedAlone>() << QByteArray("Drawing needs OpenGL 4.5");
        QTest::newRow("a shader does not compile")
            << failing<BrokenShaders>() << QByteArray("A shader does not compile");
        QTest::newRow("no memory for the buffers")
            << failing<NoMemory>(For::Buffers, 0) << QByteArray("no room for the drawing buffers");
        QTest::newRow("no memory for the scene")
            << failing<NoMemory>(For::Buffers, 3) << QByteArray("no room for the meshes");
        for (int good = 0; good < 4; ++good) { // the last is for reading
            QTest::addRow("no memory for the picture, %d", good)
                << failing<NoMemory>(For::Textures, good) << QByteArray("no room for a picture of 64x48");
        }
        QTest::newRow("no memory to draw with") << failing<NoMemory>(For::Drawing) << QByteArray("out of memory");
        QTest::newRow("reset while it draws")
            << failing<DriverReset>(100, 1) << QByteArray("The graphics driver was reset");
        QTest::newRow("reset") << failing<DriverReset>(100) << QByteArray("The graphics driver was reset");
    }

    void whatFailsIsToldAndNoFileIsLeft()
    {
        QFETCH(const std::function<Failure()>, fail);
        QFETCH(const QByteArray, words);
        const QString output = m_folder.filePath(QStringLiteral("picture.png"));
        {
            const Failure failure = fail();
            const Outcome outcome = render(output);
            QCOMPARE(outcome.status, 3);
            QVERIFY2(outcome.err.contains(words), outcome.err);
            QVERIFY(!QFile::exists(output));
        }
        QCOMPARE(render(output).status, 0);
        QVERIFY(QFile::remove(output));
    }
};

}

ROMANESCO_TEST(romanesco::test::TestRenderFailures)
#include "testrenderfailures.moc"
