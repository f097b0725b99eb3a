// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "document.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QTextDocument>

#include "core/base/file.h"
#include "editor/fdoeditor.h"

namespace romanesco {

namespace {

std::filesystem::path asPath(const QString &name)
{
    return QFile::encodeName(name).toStdString();
}

}

Document::Document(FdoEditor &editor, const FileAccess &files, QObject *parent)
    : QObject(parent)
    , m_editor(editor)
    , m_files(files)
{
    connect(editor.document(), &QTextDocument::contentsChanged, this, &Document::takeText);
    connect(editor.document(), &QTextDocument::modificationChanged, this, &Document::modifiedChanged);
    setPath({});
}

std::expected<void, QString> Document::open(const QString &path)
{
    const std::expected<std::string, std::string> bytes = m_files.read(asPath(path));
    if (!bytes) {
        return std::unexpected(QString::fromStdString(bytes.error()));
    }
    m_isLoading = true;
    const auto form = loadBytes(*m_editor.document(), QByteArray::fromStdString(*bytes));
    m_isLoading = false;
    if (!form) {
        return std::unexpected(form.error());
    }
    startText(path, *form);
    return {};
}

void Document::startNew()
{
    m_isLoading = true;
    const TextFileForm form = loadBytes(*m_editor.document(), {}).value_or(TextFileForm{});
    m_isLoading = false;
    startText({}, form);
}

void Document::startText(const QString &path, const TextFileForm &form)
{
    m_form = form;
    m_editor.setReadOnly(!form.isFaithful);
    m_editor.moveCursor(QTextCursor::Start);
    setPath(path);
    m_text = m_editor.snapshot();
    Q_EMIT replaced();
    Q_EMIT textChanged();
}

std::expected<void, QString> Document::saveAs(const QString &path)
{
    if (path == m_path && !m_form.isFaithful) {
        return std::unexpected(tr("it holds characters that would be lost; choose another name"));
    }
    QSaveFile file(path);
    const QByteArray bytes = toBytes(*m_editor.document(), m_form.hasByteOrderMark);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        return std::unexpected(file.errorString());
    }
    m_editor.document()->setModified(false);
    if (path != m_path) {
        m_form.isFaithful = true;
        m_editor.setReadOnly(false);
        setPath(path);
        // Paths in the text now mean other files.
        Q_EMIT textChanged();
    }
    return {};
}

bool Document::hasOwnFile() const
{
    return !m_path.isEmpty() && !isExample() && m_form.isFaithful;
}

QString Document::name() const
{
    return m_path.isEmpty() ? tr("untitled.fdo") : QFileInfo(m_path).fileName();
}

std::filesystem::path Document::scenePath() const
{
    return asPath(m_path.isEmpty() ? QDir::current().filePath(QStringLiteral("untitled.fdo")) : m_path);
}

bool Document::isModified() const
{
    return m_editor.document()->isModified();
}

void Document::takeText()
{
    if (m_isLoading) {
        return;
    }
    // Colouring the text counts as a change too, but changes no character.
    TextSnapshot text = m_editor.snapshot();
    if (text.bytes() != m_text.bytes()) {
        m_text = std::move(text);
        Q_EMIT textChanged();
    }
}

void Document::setPath(const QString &path)
{
    m_path = path;
    m_editor.setFileName(name());
    Q_EMIT nameChanged();
}

}
