// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>

#include <QWidget>

#include "document.h"
#include "editor/textnumber.h"
#include "filewatch.h"
#include "journal.h"
#include "previewcontroller.h"
#include "render/sceneview.h"
#include "resourcefiles.h"

namespace romanesco {

class FdoEditor;
class FindBar;
class MessageStrip;

/// A text that is open: its editor, a strip above it for what concerns its file, and what its preview has come to.
class TextTab : public QWidget
{
    Q_OBJECT
public:
    /// All must outlive it; scenes are made of files.
    TextTab(JournalSession &journals, FileWatch &watch, const FileAccess &files, QWidget *parent = nullptr);
    ~TextTab() override;

    [[nodiscard]] FdoEditor &editor() { return *m_editor; }
    [[nodiscard]] Document &document() { return m_document; }
    [[nodiscard]] const Document &document() const { return m_document; }
    [[nodiscard]] MessageStrip &strip() { return *m_strip; }
    [[nodiscard]] FindBar &findBar() { return *m_findBar; }
    [[nodiscard]] const Journal &journal() const { return m_journal; }
    /// The depth of <$> in the text.
    [[nodiscard]] TextNumber &depth() { return m_depth; }

    /// Of an example, or a text of nobody's without words: another may take its place.
    [[nodiscard]] bool isUntouched() const;

    /// Where the file cannot be opened, the strip says so, and the text stays.
    bool open(const QString &path);
    /// Where this fails, the strip says so, else saved() follows. An example takes the files along that it names. Waits.
    bool saveTo(const QString &path);
    /// The same in the background.
    void startSavingTo(const QString &path);

    /// Other tabs or other programs have written these files.
    void takeChanges(const QStringList &paths);

    /// Only who looks at a text has it built: from now on, or no more.
    void setWatched(bool isWatched);
    /// The files that it names may be others, where no system tells of that.
    void rebuild() { build(); }
    /// Scenes are shown as if their depth had no end.
    void setEndless(bool isEndless);
    [[nodiscard]] bool isEndless() const { return m_preview.isEndless(); }

    /// Of the newest text that was built.
    [[nodiscard]] const Preview &preview() const { return m_newest; }
    /// Of the newest text without errors: what is to be seen, and whether it is deeper than the text says.
    [[nodiscard]] const std::shared_ptr<const Scene> &shown() const { return m_shown; }
    [[nodiscard]] bool isShownEndless() const { return m_isShownEndless; }
    [[nodiscard]] const std::optional<Summary> &summary() const { return m_summary; }

    /// What the strip over the picture has to say, and the place that it leads to if it is about the text.
    struct Trouble {
        QString words;
        bool isOfText = false;
        SourceRange place;
        TextSnapshot text;
    };
    [[nodiscard]] const Trouble &trouble() const { return m_trouble; }

    /// Where it was looked at from; none before its first picture.
    std::optional<SceneView> view;

Q_SIGNALS:
    /// Another text: nothing of what was known holds.
    void restarted();
    void saved(const QString &path);
    void previewed();
    void counted();

private:
    void restart();
    void build();
    void takePreview(const Preview &preview);
    void connectFile();
    void sayNotSaved(const QString &path, const QString &reason);
    void watchFiles();
    void takeFilesAlong(const QString &textPath);
    [[nodiscard]] std::vector<std::string> filesBeside() const;
    void offerRenumbering(int count);

    FdoEditor *m_editor;
    MessageStrip *m_strip;
    FindBar *m_findBar;
    ResourceFiles m_files;
    Document m_document;
    Journal m_journal;
    FileWatch &m_watch;
    TextNumber m_depth;
    PreviewController m_preview;
    QString m_offer;
    bool m_isWatched = false;
    bool m_isStale = true;

    Preview m_newest;
    std::shared_ptr<const Scene> m_shown;
    bool m_isShownEndless = false;
    bool m_isFirstScene = true;
    std::optional<Summary> m_summary;
    Trouble m_trouble;
};

}
