// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QTabWidget>

#include "filewatch.h"
#include "journal.h"
#include "preferences.h"
#include "resourcefiles.h"
#include "unsavedtexts.h"

namespace romanesco {

class FdoEditor;
class TextTab;
struct LostText;

/// The texts that are open, one of which is looked at: opened, saved, closed; there is always one. Questions are asked
/// where changes would be lost, and nowhere else.
class TextTabs : public QTabWidget
{
    Q_OBJECT
public:
    explicit TextTabs(QWidget *parent = nullptr);
    ~TextTabs() override;

    [[nodiscard]] TextTab &current() const;
    [[nodiscard]] TextTab &tab(int index) const;

    /// In a tab of its own, unless the text that is looked at may be replaced, or the file is open already. Where it cannot
    /// be opened, the tab that was looked at says so.
    bool openFile(const QString &path);
    void startNew();
    /// One of the templates as a new text, which can be edited and is saved elsewhere.
    void startFrom(const QString &path);
    /// In the background; a text without a file of its own is asked where to.
    void save();
    void saveAs();
    /// Waits; false where it failed.
    bool saveFile(const QString &path);
    /// Puts a text that was lost where it was, as an edit; whether it is in a journal again.
    bool restoreLost(const LostText &text);
    /// Whether it may: it is saved, or need not be. The last tab becomes an empty text.
    bool closeTab(int index);
    /// Whether they may all; where one may not, none is closed.
    [[nodiscard]] bool mayCloseAll();
    void goToNext(int step);
    /// Of all texts, also those to come.
    void setPreferences(const Preferences &preferences);

    /// The picture stays with the current text while others are looked at, or no more.
    void setPinned(bool isPinned);
    /// The one whose picture is seen.
    [[nodiscard]] TextTab &seen() const;
    [[nodiscard]] bool isPinned() const { return m_pinned; }

    /// Looks whether other programs have changed something, where no system tells.
    void lookForChanges() { m_watch.checkNow(); }

    /// The files that are open, and which of them is looked at.
    void remember() const;
    /// False where nothing was, or nothing of it is there.
    bool restore();
    /// The files that were opened last, the newest first.
    [[nodiscard]] static QStringList recentFiles();

    static const QString examplesFolder;
    static const QString templatesFolder;

Q_SIGNALS:
    /// Another one is looked at, or seen.
    void currentTabChanged();
    /// Its name, or whether it is modified.
    void currentNamed();
    void saved(const QString &path);

private:
    TextTab &addText();
    void applyTo(FdoEditor &editor) const;
    [[nodiscard]] QString askWhereTo();
    [[nodiscard]] bool isFree(const QString &path);
    void updateName(const TextTab &tab);
    void updateCurrent();
    void updateUnsaved(const TextTab &tab);
    void tellOthers(const TextTab *tab, const QStringList &changed);
    void remove(TextTab &tab);
    [[nodiscard]] bool mayDrop(TextTab &tab);
    [[nodiscard]] bool saveNow(TextTab &tab);
    [[nodiscard]] int indexOfFile(const QString &path) const;

    Preferences m_preferences = Preferences::read();
    FileWatch m_watch;
    JournalSession m_journals;
    ResourceFiles m_files;
    UnsavedTexts m_unsaved{m_files};
    /// Null where the picture is that of the current one.
    TextTab *m_pinned = nullptr;
};

}
