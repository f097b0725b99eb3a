// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <QTest>

namespace romanesco::test {

/// Runs a test class as the program runs, with OpenGL 4.5, and with its state and settings in a folder of its own. With "embedded" in the
/// environment's ROMANESCO_TEST_OPENGL, with OpenGL ES.
template<typename Class>
int runWithGl(int argc, char **argv)
{
    const QTemporaryDir home;
    qputenv("XDG_STATE_HOME", QFile::encodeName(home.path()));
    qputenv("XDG_CONFIG_HOME", QFile::encodeName(home.path()));
    QSurfaceFormat format;
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setOption(QSurfaceFormat::ResetNotification);
    if (qgetenv("ROMANESCO_TEST_OPENGL") == "embedded") {
        format = QSurfaceFormat();
        format.setRenderableType(QSurfaceFormat::OpenGLES);
    }
    QSurfaceFormat::setDefaultFormat(format);
    const QApplication application(argc, argv);
    Class test;
    return QTest::qExec(&test, argc, argv);
}

}
