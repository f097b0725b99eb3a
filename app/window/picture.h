// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <expected>
#include <functional>

#include <QImage>
#include <QObject>
#include <QString>

#include "backgroundtask.h"

class QAction;

namespace romanesco {

/// Writes a picture as PNG, as it looks on the screen, without transparency; whole or not at all (see AtomicFile). Not a null
/// picture. The error is a sentence. Any thread.
[[nodiscard]] std::expected<void, QString> savePicture(const QImage &picture, const QString &path);

/// A name for a picture of a text that no file has yet: "menger-2.png" beside "menger.fdo"; among the user's pictures where
/// the text has no folder of its own.
[[nodiscard]] QString proposedPicture(const QString &textPath);

/// What can be done with the picture that a window shows, as actions of that window.
class PictureActions : public QObject
{
    Q_OBJECT
public:
    /// picture gives what is shown, null for nothing; textPath that of the text it is of, empty for one without a file.
    PictureActions(QWidget &window, std::function<QImage()> picture, std::function<QString()> textPath);

    /// Asks for a name and writes a PNG in the background: saved() or failed() follows.
    [[nodiscard]] QAction *save() const { return m_save; }
    /// To the clipboard: copied() follows, or failed().
    [[nodiscard]] QAction *copy() const { return m_copy; }

Q_SIGNALS:
    void saved(const QString &path);
    void copied();
    /// A sentence.
    void failed(const QString &words);

private:
    [[nodiscard]] QImage grab();
    void askWhere();
    void write(const QImage &picture, const QString &path);
    void copyNow();

    QWidget &m_window;
    std::function<QImage()> m_picture;
    std::function<QString()> m_textPath;
    QAction *m_save;
    QAction *m_copy;
    BackgroundTask<std::expected<void, QString>> m_writing;
};

}
