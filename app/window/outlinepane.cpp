// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "outlinepane.h"

#include <algorithm>

#include <QHeaderView>

#include "core/language/sceneoutline.h"
#include "core/language/structure.h"
#include "editor/fdoeditor.h"

namespace romanesco {

namespace {

/// More than anybody reads; each row is made anew when a name changes.
constexpr std::size_t mostRows = 1'000;

QString wordsFor(SymbolKind kind)
{
    switch (kind) {
    case SymbolKind::Vector:
        return OutlinePane::tr("Vector");
    case SymbolKind::Transformation:
        return OutlinePane::tr("Transformation");
    case SymbolKind::Object:
        return OutlinePane::tr("Object");
    case SymbolKind::Recursive:
        return OutlinePane::tr("Recursive");
    default:
        return OutlinePane::tr("Unknown");
    }
}

QString wordsFor(SceneKind kind)
{
    switch (kind) {
    case SceneKind::Camera:
        return OutlinePane::tr("Camera");
    case SceneKind::Object:
        return OutlinePane::tr("Mesh");
    case SceneKind::Fractal:
        return OutlinePane::tr("Fractal");
    case SceneKind::Ball:
        return OutlinePane::tr("Ball");
    case SceneKind::Light:
        break;
    }
    return OutlinePane::tr("Light");
}

}

OutlinePane::OutlinePane(QWidget *parent)
    : QTreeWidget(parent)
{
    setAccessibleName(tr("Outline"));
    setHeaderHidden(true);
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(NoFrame);
    setColumnCount(2);
    header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_rest.setSingleShot(true);
    m_rest.setInterval(100);
    connect(&m_rest, &QTimer::timeout, this, &OutlinePane::update);
    connect(this, &QTreeWidget::itemPressed, this, [this] { m_hasTicked = false; });
    connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem *item) {
        if (!m_hasTicked) {
            go(item);
        }
    });
    connect(this, &QTreeWidget::itemActivated, this, &OutlinePane::go);
    connect(this, &QTreeWidget::itemChanged, this, &OutlinePane::changeVisibility);
}

OutlinePane::~OutlinePane() = default;

void OutlinePane::follow(FdoEditor &editor)
{
    m_editor = &editor;
    m_whileFollowed = std::make_unique<QObject>();
    connect(&editor, &QPlainTextEdit::textChanged, m_whileFollowed.get(), [this] { m_rest.start(); });
    connect(&editor, &QPlainTextEdit::cursorPositionChanged, m_whileFollowed.get(), [this] { markCurrent(); });
    update();
}

void OutlinePane::showEvent(QShowEvent *event)
{
    QTreeWidget::showEvent(event);
    update();
}

std::vector<OutlinePane::Entry> OutlinePane::entries() const
{
    std::vector<Entry> entries;
    if (const FdoDocument *fdo = m_editor->language().fdo()) {
        for (const OutlineEntry &entry : outline(*fdo)) {
            entries.push_back({QString::fromStdString(entry.name), wordsFor(entry.kind), entry.range, entry.line});
        }
    } else if (const SdoSyntax *sdo = m_editor->language().sdo()) {
        for (const SceneEntry &entry : outline(*sdo)) {
            const QString kind = wordsFor(entry.kind);
            entries.push_back({entry.name.empty() ? kind : QString::fromStdString(entry.name), kind, entry.range,
                               entry.line, !entry.name.empty(), entry.isShown});
        }
    }
    entries.resize(std::min(entries.size(), mostRows));
    return entries;
}

void OutlinePane::update()
{
    m_rest.stop();
    if (!m_editor || !isVisible()) {
        return;
    }
    std::vector<Entry> now = entries();
    const bool isSame = isShowing(now) && m_canEdit != m_editor->isReadOnly();
    m_entries = std::move(now);
    if (!isSame) {
        m_canEdit = !m_editor->isReadOnly();
        fill();
    }
    markCurrent();
}

bool OutlinePane::isShowing(const std::vector<Entry> &entries) const
{
    return std::ranges::equal(m_entries, entries, [](const Entry &a, const Entry &b) {
        return a.name == b.name && a.kind == b.kind && a.canHide == b.canHide && a.isShown == b.isShown;
    });
}

void OutlinePane::fill()
{
    const QSignalBlocker blocker(this);
    clear();
    for (const Entry &entry : m_entries) {
        auto *item = new QTreeWidgetItem(this, {entry.name, entry.kind});
        item->setForeground(1, palette().placeholderText());
        if (entry.canHide) {
            item->setCheckState(0, entry.isShown ? Qt::Checked : Qt::Unchecked);
            item->setToolTip(0, tr("Without its tick its line is a comment, and it is not shown"));
        }
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable
                       | (entry.canHide && m_canEdit ? Qt::ItemIsUserCheckable : Qt::NoItemFlags));
    }
}

/// That of the cursor's line.
void OutlinePane::markCurrent()
{
    if (m_rest.isActive() || !isVisible()) {
        return; // what is known is of another text
    }
    const auto line = static_cast<std::size_t>(m_editor->textCursor().blockNumber());
    const auto at = std::ranges::find(m_entries, line, &Entry::line);
    QTreeWidgetItem *item = at == m_entries.end() ? nullptr : topLevelItem(static_cast<int>(at - m_entries.begin()));
    clearSelection();
    if (item) {
        setCurrentItem(item);
        scrollToItem(item);
    }
}

void OutlinePane::go(QTreeWidgetItem *item)
{
    const auto row = static_cast<std::size_t>(indexOfTopLevelItem(item));
    update(); // places may have moved
    if (row < m_entries.size()) {
        m_editor->goTo(m_entries[row].range, m_editor->language().snapshot());
    }
}

void OutlinePane::changeVisibility(QTreeWidgetItem *item)
{
    const auto row = static_cast<std::size_t>(indexOfTopLevelItem(item));
    const bool isShown = item->checkState(0) == Qt::Checked;
    m_hasTicked = true;
    // Places may have moved.
    std::vector<Entry> now = entries();
    const bool isSame = isShowing(now);
    m_entries = std::move(now);
    const SdoSyntax *sdo = m_editor->language().sdo();
    if (!isSame || !sdo || row >= m_entries.size()) {
        fill();
        return;
    }
    // First, so that the rows stay while one of them is pressed.
    m_entries[row].isShown = isShown;
    m_editor->apply(withVisibility(*sdo, m_entries[row].line, isShown), m_editor->language().snapshot());
    update();
}

}
