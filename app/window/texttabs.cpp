// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "texttabs.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QTabBar>

#include "editor/fdoeditor.h"
#include "messagestrip.h"
#include "recovery.h"
#include "texttab.h"
#include "windowstate.h"

namespace romanesco {

namespace {

constexpr qsizetype mostRecent = 12;

QString fileFilter()
{
    return TextTabs::tr("Fractals and scenes (*.fdo *.sdo);;Fractals (*.fdo);;Scenes (*.sdo);;All files (*)");
}

void addRecent(const QString &path)
{
    QStringList files = TextTabs::recentFiles();
    files.removeAll(path);
    files.prepend(path);
    WindowState().setValue("recent", files.first(std::min(files.size(), mostRecent)));
}

}

const QString TextTabs::examplesFolder = QStringLiteral(":/examples");
const QString TextTabs::templatesFolder = QStringLiteral(":/templates");

TextTabs::TextTabs(QWidget *parent)
    : QTabWidget(parent)
{
    setDocumentMode(true);
    setMovable(true);
    setTabsClosable(true);
    setTabBarAutoHide(true);
    tabBar()->setAccessibleName(tr("Open texts"));
    connect(this, &QTabWidget::tabCloseRequested, this, &TextTabs::closeTab);
    addText();
    connect(this, &QTabWidget::currentChanged, this, &TextTabs::updateCurrent);
    updateCurrent();
}

/// The texts use what is here. Who listens may be gone.
TextTabs::~TextTabs()
{
    const QSignalBlocker blocker(this);
    while (count() > 0) {
        const QWidget *last = widget(count() - 1);
        removeTab(count() - 1);
        delete last;
    }
}

TextTab &TextTabs::current() const
{
    return tab(currentIndex());
}

TextTab &TextTabs::tab(int index) const
{
    return *qobject_cast<TextTab *>(widget(index));
}

TextTab &TextTabs::addText()
{
    auto *tab = new TextTab(m_journals, m_watch, m_unsaved);
    addTab(tab, tab->document().name());
    applyTo(tab->editor());
    connect(&tab->document(), &Document::nameChanged, this, [this, tab] { updateName(*tab); });
    connect(&tab->document(), &Document::modifiedChanged, this, [this, tab] { updateName(*tab); });
    for (const auto change : {&Document::nameChanged, &Document::textChanged}) {
        connect(&tab->document(), change, this, [this, tab] { updateUnsaved(*tab); });
    }
    connect(&tab->document(), &Document::modifiedChanged, this, [this, tab] { updateUnsaved(*tab); });
    connect(tab, &TextTab::saved, this, [this, tab](const QString &path) {
        addRecent(path);
        tellOthers(tab, {path}); // nobody else tells of what is written here
        Q_EMIT saved(path);
    });
    updateName(*tab);
    return *tab;
}

void TextTabs::tellOthers(const TextTab *tab, const QStringList &changed)
{
    for (int i = 0; i < count() && !changed.isEmpty(); ++i) {
        if (widget(i) != tab) {
            this->tab(i).takeChanges(changed);
        }
    }
}

void TextTabs::updateUnsaved(const TextTab &tab)
{
    const Document &document = tab.document();
    const bool isAhead = document.isModified() && document.hasOwnFile();
    tellOthers(&tab, m_unsaved.set(&tab, isAhead ? document.path() : QString(), document.text()));
}

void TextTabs::updateName(const TextTab &tab)
{
    const int index = indexOf(&tab);
    const Document &document = tab.document();
    // Without it a name with & would have a key.
    const QString name = document.name().replace(u'&', QStringLiteral("&&"));
    setTabText(index, document.isModified() ? name + QStringLiteral(" •") : name);
    const QString kind = document.path().startsWith(templatesFolder) ? tr("New text") : tr("Example");
    setTabToolTip(index, document.isExample() ? kind : QDir::toNativeSeparators(document.path()));
    if (index == currentIndex()) {
        Q_EMIT currentNamed();
    }
}

void TextTabs::updateCurrent()
{
    if (count() == 0) {
        return; // while it is built or taken apart
    }
    Q_EMIT currentTabChanged();
    for (int i = 0; i < count(); ++i) {
        tab(i).setWatched(&tab(i) == &current() || &tab(i) == m_pinned);
    }
}

void TextTabs::setPinned(bool isPinned)
{
    m_pinned = isPinned ? &current() : nullptr;
    updateCurrent();
}

TextTab &TextTabs::seen() const
{
    return m_pinned ? *m_pinned : current();
}

/// What it had to say is no more.
void TextTabs::remove(TextTab &tab)
{
    if (m_pinned == &tab) {
        setPinned(false);
    }
    removeTab(indexOf(&tab));
    tellOthers(&tab, m_unsaved.set(&tab, {}, {}));
    tab.deleteLater();
}

int TextTabs::indexOfFile(const QString &path) const
{
    const QString file = QFileInfo(path).canonicalFilePath();
    for (int i = 0; i < count() && !file.isEmpty(); ++i) {
        const Document &document = tab(i).document();
        if (!document.path().isEmpty() && QFileInfo(document.path()).canonicalFilePath() == file) {
            return i;
        }
    }
    return -1;
}

bool TextTabs::openFile(const QString &path)
{
    const bool isOurs = path.startsWith(QLatin1String(":/"));
    const QString whole = isOurs ? path : QFileInfo(path).absoluteFilePath();
    TextTab &before = current();
    if (const int open = indexOfFile(whole); open >= 0 && !(isOurs && before.isUntouched())) {
        setCurrentIndex(open);
        return true;
    }
    if (before.isUntouched()) {
        if (!before.open(whole)) {
            return false;
        }
    } else {
        TextTab &made = addText();
        if (!made.open(whole)) {
            before.strip().say(made.strip().text());
            remove(made);
            return false;
        }
        setCurrentWidget(&made);
    }
    if (!isOurs) {
        addRecent(whole);
    }
    return true;
}

void TextTabs::startNew()
{
    TextTab &before = current();
    TextTab &tab = before.isUntouched() ? before : addText();
    tab.document().startNew();
    setCurrentWidget(&tab);
    tab.editor().setFocus();
}

void TextTabs::startFrom(const QString &path)
{
    TextTab &before = current();
    TextTab &tab = before.isUntouched() ? before : addText();
    if (tab.open(path)) {
        setCurrentWidget(&tab);
        tab.editor().setFocus();
    }
}

void TextTabs::save()
{
    const Document &document = current().document();
    if (document.hasOwnFile()) {
        current().startSavingTo(document.path());
    } else {
        saveAs();
    }
}

void TextTabs::saveAs()
{
    if (const QString path = askWhereTo(); !path.isEmpty() && isFree(path)) {
        current().startSavingTo(path);
    }
}

/// Empty where the user would rather not.
QString TextTabs::askWhereTo()
{
    const Document &document = current().document();
    const bool hasPlace = !document.path().isEmpty() && !document.isExample();
    const QString proposal = hasPlace ? document.path() : document.name();
    QFileDialog dialog(this, tr("Save As"), QString(), fileFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QFileInfo(proposal).suffix());
    dialog.selectFile(proposal);
    const bool isChosen = dialog.exec() == QDialog::Accepted;
    return isChosen ? QFileInfo(dialog.selectedFiles().constFirst()).absoluteFilePath() : QString();
}

/// For the current text: two tabs of one file would write over one another.
bool TextTabs::isFree(const QString &path)
{
    const int open = indexOfFile(path);
    if (open < 0 || open == currentIndex()) {
        return true;
    }
    current().strip().say(
        tr("“%1” is open in another tab. Close it there, or choose another name.").arg(QFileInfo(path).fileName()));
    return false;
}

bool TextTabs::saveFile(const QString &path)
{
    return isFree(path) && current().saveTo(QFileInfo(path).absoluteFilePath());
}

bool TextTabs::restoreLost(const LostText &text)
{
    const int open = indexOfFile(text.path);
    if (open >= 0 && tab(open).document().isModified()) {
        setCurrentIndex(open);
        current().strip().say(
            tr("This text has changes that are not saved: save them, or go back, before another version "
               "is restored here."));
        return false;
    }
    TextTab &place = open >= 0 ? tab(open) : current().isUntouched() ? current() : addText();
    place.document().restore(text.path, text.text);
    setCurrentWidget(&place);
    return place.journal().waitUntilWritten(std::chrono::seconds(5));
}

bool TextTabs::saveNow(TextTab &tab)
{
    Document &document = tab.document();
    document.waitForSave();
    if (!document.isModified()) {
        return true;
    }
    const QString path = document.hasOwnFile() ? document.path() : askWhereTo();
    return !path.isEmpty() && isFree(path) && tab.saveTo(path);
}

bool TextTabs::mayDrop(TextTab &tab)
{
    if (!tab.document().isModified()) {
        return true;
    }
    setCurrentWidget(&tab);
    const auto answer = QMessageBox::warning(
        this, tr("Unsaved changes"), tr("“%1” has changes that are not saved.").arg(tab.document().name()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && saveNow(tab));
}

bool TextTabs::closeTab(int index)
{
    TextTab &closing = tab(index);
    if (!mayDrop(closing)) {
        return false;
    }
    if (count() == 1) {
        closing.document().startNew();
    } else {
        remove(closing);
    }
    return true;
}

bool TextTabs::mayCloseAll()
{
    for (int i = 0; i < count(); ++i) {
        if (!mayDrop(tab(i))) {
            return false;
        }
    }
    return true;
}

void TextTabs::setPreferences(const Preferences &preferences)
{
    m_preferences = preferences;
    for (int i = 0; i < count(); ++i) {
        applyTo(tab(i).editor());
    }
}

void TextTabs::applyTo(FdoEditor &editor) const
{
    editor.setUsualFont(m_preferences.editorFont());
    editor.setLineWrapMode(m_preferences.wrapsLines ? QPlainTextEdit::WidgetWidth : QPlainTextEdit::NoWrap);
}

void TextTabs::goToNext(int step)
{
    setCurrentIndex((currentIndex() + step + count()) % count());
}

void TextTabs::remember() const
{
    QStringList files;
    QString looked;
    for (int i = 0; i < count(); ++i) {
        const Document &document = tab(i).document();
        if (!document.path().isEmpty() && !document.isExample()) {
            files << document.path();
        }
    }
    if (!current().document().isExample()) {
        looked = current().document().path();
    }
    WindowState state;
    state.setValue("open", files);
    state.setValue("current", looked);
}

bool TextTabs::restore()
{
    const WindowState state;
    const QString looked = state.value("current").toString();
    bool isAny = false;
    for (const QString &file : state.value("open").toStringList()) {
        // What is gone in the meantime is not missed.
        isAny = (QFileInfo::exists(file) && openFile(file)) || isAny;
    }
    if (const int index = indexOfFile(looked); index >= 0) {
        setCurrentIndex(index);
    }
    return isAny;
}

QStringList TextTabs::recentFiles()
{
    return WindowState().value("recent").toStringList();
}

}
