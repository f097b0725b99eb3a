// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QFile>
#include <QSlider>
#include <QToolBar>

#include "app/window/mainwindow.h"
#include "app/window/messagestrip.h"
#include "app/window/problemsview.h"
#include "app/window/viewport.h"
#include "app/window/viewportpane.h"
#include "editor/fdoeditor.h"
#include "glapplication.h"

namespace romanesco::test {

/// The window with its example, and what tests look at in it.
struct WindowSample {
    QTemporaryDir folder;
    MainWindow window;
    FdoEditor &editor = *window.findChild<FdoEditor *>();
    Viewport &viewport = *window.findChild<Viewport *>();
    ViewportPane &pane = *window.findChild<ViewportPane *>();
    ProblemsView &problems = *window.findChild<ProblemsView *>();
    /// Copies drawn in the last pass over the scene.
    std::uint64_t drawn = 0;

    WindowSample()
    {
        QObject::connect(&viewport, &Viewport::pictureAdvanced, &window,
                         [this](const DrawStatistics &statistics) { drawn = statistics.instances; });
        window.resize(900, 600);
        window.openExample();
        window.show();
    }
    /// Of the text that is looked at.
    [[nodiscard]] FdoEditor &visibleEditor() const
    {
        for (FdoEditor *any : window.findChildren<FdoEditor *>()) {
            if (any->isVisible()) {
                return *any;
            }
        }
        qFatal("no text is looked at");
    }
    /// That of the tool bar.
    [[nodiscard]] QSlider &depthSlider() const { return *window.findChild<QToolBar *>()->findChild<QSlider *>(); }
    /// So that keys come to it; only a window that is there can be active.
    bool waitUntilActive()
    {
        if (!QTest::qWaitForWindowExposed(&window)) {
            return false;
        }
        window.activateWindow();
        return QTest::qWaitForWindowActive(&window);
    }
    bool waitForPicture() const
    {
        return QTest::qWaitFor([&] { return drawn > 0 && viewport.isPictureFinished(); }, 120'000);
    }
    /// Opens a text and waits for the picture of that.
    bool openAndWait(const QString &path)
    {
        const auto before = viewport.view().surroundings();
        const auto isAnother = [&] {
            const auto &now = viewport.view().surroundings();
            return now && (!before || now->scene != before->scene) && viewport.isPictureFinished();
        };
        return window.openFile(path) && QTest::qWaitFor(isAnother, 120'000);
    }
    /// So that its keys are the viewport's.
    bool focusViewport()
    {
        window.activateWindow();
        viewport.setFocus();
        return QTest::qWaitForWindowActive(&window) && viewport.hasFocus();
    }
    bool waitForEmptyPicture() const
    {
        return QTest::qWaitFor([&] { return drawn == 0 && viewport.isPictureFinished(); }, 120'000);
    }
    /// What the strip over the picture says.
    [[nodiscard]] QString strip() const { return pane.strip().isVisible() ? pane.strip().text() : QString(); }
    /// What the strip over the text says.
    [[nodiscard]] QString message() const
    {
        for (const MessageStrip *strip : window.findChildren<MessageStrip *>()) {
            if (strip != &pane.strip() && strip->isVisible()) {
                return strip->text();
            }
        }
        return {};
    }
    bool waitForStrip(bool isThere) const
    {
        return QTest::qWaitFor([&] { return !strip().isEmpty() == isThere; }, 20'000);
    }
    void placeCursorAt(const QString &text)
    {
        const QTextCursor found = editor.document()->find(text);
        QTextCursor cursor = found;
        cursor.setPosition(found.selectionStart());
        editor.setTextCursor(cursor);
    }
    [[nodiscard]] QString path(const QString &name) const { return folder.filePath(name); }
    [[nodiscard]] QString write(const QString &name, const QByteArray &bytes) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        return file.fileName();
    }
    [[nodiscard]] static QByteArray read(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
    }
};

inline int squiggles(const FdoEditor &editor)
{
    int count = 0;
    for (const QTextEdit::ExtraSelection &selection : editor.extraSelections()) {
        count += selection.format.underlineStyle() == QTextCharFormat::WaveUnderline ? 1 : 0;
    }
    return count;
}

}
