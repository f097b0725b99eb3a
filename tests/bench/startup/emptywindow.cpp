// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QApplication>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
#include <QSurfaceFormat>

namespace {

/// The least that a program with a view of OpenGL can be.
class EmptyView : public QOpenGLWidget
{
protected:
    void paintGL() override
    {
        QOpenGLFunctions *gl = context()->functions();
        gl->glClearColor(0.2F, 0.3F, 0.4F, 1.0F);
        gl->glClear(GL_COLOR_BUFFER_BIT);
    }
};

}

int main(int argc, char *argv[])
{
    QSurfaceFormat format;
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication application(argc, argv);
    EmptyView view;
    view.resize(1280, 800);
    view.show();
    return QApplication::exec();
}
