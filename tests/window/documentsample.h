// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/window/document.h"
#include "app/window/resourcefiles.h"
#include "editor/fdoeditor.h"

// Qt's QTRY_ macros make an int of milliseconds.
#pragma GCC diagnostic ignored "-Wconversion"

namespace romanesco::test {

/// A folder of the user's files, and others for what the program keeps, in place of his.
struct Folders {
    QTemporaryDir own;
    QTemporaryDir home;

    Folders()
    {
        qputenv("XDG_STATE_HOME", QFile::encodeName(home.filePath(QStringLiteral("state"))));
        qputenv("XDG_CONFIG_HOME", QFile::encodeName(home.filePath(QStringLiteral("config"))));
        qputenv("XDG_DATA_HOME", QFile::encodeName(home.filePath(QStringLiteral("data"))));
    }
    [[nodiscard]] QString path(const QString &name) const { return own.filePath(name); }
    [[nodiscard]] QString write(const QString &name, const QByteArray &bytes) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        return file.fileName();
    }
    /// As most programs save: another file takes its place.
    [[nodiscard]] QString replace(const QString &name, const QByteArray &bytes) const
    {
        QSaveFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        return file.fileName();
    }
    [[nodiscard]] static QByteArray read(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
    }
    /// All that lies beside the user's files.
    [[nodiscard]] QStringList names() const
    {
        return QDir(own.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }
};

struct DocumentSample {
    ResourceFiles files;
    FdoEditor editor;
    Document document{editor, files};
    QSignalSpy changes{&document, &Document::textChanged};

    void type(const QString &text) { editor.insertPlainText(text); }
    [[nodiscard]] QByteArray text() const { return QByteArray::fromStdString(document.text().bytes()); }
};

}
