// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "picture.h"

#include <cassert>
#include <string_view>
#include <utility>

#include <QAction>
#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QImageWriter>
#include <QPainter>
#include <QStandardPaths>

#include "core/base/atomicfile.h"
#include "makeaction.h"

namespace romanesco {

namespace {

/// A screen shows the colours of OpenGL's premultiplied pixels as they are, which is the same as before black.
QImage opaque(const QImage &picture)
{
    QImage result(picture.size(), QImage::Format_RGB32);
    result.fill(Qt::black);
    QPainter(&result).drawImage(result.rect(), picture, picture.rect());
    return result;
}

}

std::expected<void, QString> savePicture(const QImage &picture, const QString &path)
{
    assert(!picture.isNull() && "there is a picture");
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QImageWriter writer(&buffer, "png");
    if (!writer.write(opaque(picture))) {
        return std::unexpected(PictureActions::tr("The picture cannot be made a PNG: %1.").arg(writer.errorString()));
    }
    const std::string_view all(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    return writeWhole(QFile::encodeName(path).toStdString(), all).transform_error([&](const std::string &reason) {
        return PictureActions::tr("“%1” was not written: %2.").arg(path, QString::fromStdString(reason));
    });
}

QString proposedPicture(const QString &textPath)
{
    const QFileInfo text(textPath);
    const bool hasFolder = !textPath.isEmpty() && !textPath.startsWith(QLatin1String(":/"));
    const QDir folder(hasFolder ? text.absolutePath()
                                : QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    const QString name = textPath.isEmpty() ? PictureActions::tr("untitled") : text.completeBaseName();
    QString path;
    int number = 1;
    do {
        path = folder.filePath(QStringLiteral("%1-%2.png").arg(name, QString::number(number++)));
    } while (QFileInfo::exists(path));
    return path;
}

PictureActions::PictureActions(QWidget &window, std::function<QImage()> picture, std::function<QString()> textPath)
    : QObject(&window)
    , m_window(window)
    , m_picture(std::move(picture))
    , m_textPath(std::move(textPath))
    , m_save(makeAction(window, tr("Save &Picture…"), Qt::CTRL | Qt::SHIFT | Qt::Key_P))
    , m_copy(makeAction(window, tr("&Copy Picture"), Qt::CTRL | Qt::SHIFT | Qt::Key_C))
    , m_writing(*this)
{
    connect(m_save, &QAction::triggered, this, &PictureActions::askWhere);
    connect(m_copy, &QAction::triggered, this, &PictureActions::copyNow);
}

/// Null after failed().
QImage PictureActions::grab()
{
    QImage picture = m_picture();
    if (picture.isNull()) {
        Q_EMIT failed(tr("There is no picture yet."));
    }
    return picture;
}

void PictureActions::askWhere()
{
    // as it is now, whatever moves behind the question
    const QImage picture = grab();
    if (picture.isNull()) {
        return;
    }
    auto *dialog = new QFileDialog(&m_window, tr("Save Picture"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Pictures (*.png)"));
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(proposedPicture(m_textPath()));
    connect(dialog, &QFileDialog::fileSelected, this, [this, picture](const QString &path) { write(picture, path); });
    dialog->open();
}

void PictureActions::write(const QImage &picture, const QString &path)
{
    m_writing.finish(); // the one before, if it still goes on
    m_writing.start([picture, path] { return savePicture(picture, path); },
                    [this, path](const std::expected<void, QString> &written) {
                        if (written) {
                            Q_EMIT saved(path);
                        } else {
                            Q_EMIT failed(written.error());
                        }
                    });
}

void PictureActions::copyNow()
{
    if (const QImage picture = grab(); !picture.isNull()) {
        QGuiApplication::clipboard()->setImage(opaque(picture));
        Q_EMIT copied();
    }
}

}
