// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "parameterspane.h"

#include <algorithm>

#include <QDockWidget>
#include <QLabel>
#include <QVBoxLayout>

#include "core/language/structure.h"
#include "depthcontrol.h"
#include "editor/fdoeditor.h"
#include "pinnedrow.h"

namespace romanesco {

namespace {

/// Nobody drags more, and each is a widget.
constexpr std::size_t mostRows = 100;

}

ParametersPane::ParametersPane(QWidget *parent)
    : QScrollArea(parent)
    , m_hint(
          new QLabel(tr("Numbers of iterations have sliders here; right-click another number in the text to pin it.")))
    , m_pinColumn(new QVBoxLayout)
{
    auto *inside = new QWidget;
    m_column = new QVBoxLayout(inside);
    m_column->addWidget(m_hint);
    m_column->addLayout(m_pinColumn);
    m_column->addStretch(1);
    setWidget(inside);
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setAccessibleName(tr("Parameters"));
}

ParametersPane::~ParametersPane() = default;

void ParametersPane::follow(FdoEditor &editor)
{
    m_editor = &editor;
    m_isDragged = false;
    dropRows(0);
    qDeleteAll(m_pins);
    m_pins.clear();
    m_whileFollowed = std::make_unique<QObject>();
    connect(&editor.pinnedNumbers(), &PinnedNumbers::changed, m_whileFollowed.get(), [this] {
        const std::size_t before = m_pins.size();
        updatePins();
        auto *dock = qobject_cast<QDockWidget *>(parentWidget());
        if (dock && m_pins.size() > before) {
            dock->show();
            dock->raise();
        }
    });
    update();
}

/// From one on.
void ParametersPane::dropRows(std::size_t first)
{
    for (; m_rows.size() > first; m_rows.pop_back()) {
        // Its own signal may have led here.
        m_rows.back().control->setParent(nullptr);
        m_rows.back().control->deleteLater();
    }
}

void ParametersPane::addRow(const QString &name)
{
    Row row{name, new DepthControl(name), std::make_unique<TextNumber>(*m_editor)};
    TextNumber *number = row.number.get();
    connect(row.control, &DepthControl::depthEdited, this, [number](quint64 depth) { number->setValue(depth); });
    connect(row.control, &DepthControl::dragBegan, this, [this, number] {
        m_isDragged = true;
        number->beginGesture();
    });
    connect(row.control, &DepthControl::dragEnded, this, [this, number] {
        m_isDragged = false;
        number->endGesture();
        update();
    });
    m_column->insertWidget(m_column->count() - 2, row.control); // before pins and stretch
    m_rows.push_back(std::move(row));
}

void ParametersPane::update()
{
    if (m_isDragged || !m_editor) {
        return;
    }
    LanguageText &language = m_editor->language();
    const FdoDocument *fdo = language.fdo();
    std::vector<DepthNumber> numbers = fdo ? depthNumbers(*fdo) : std::vector<DepthNumber>();
    numbers.resize(std::min(numbers.size(), mostRows));
    dropRows(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const QString name = QString::fromStdString(numbers[i].name);
        if (i < m_rows.size() && m_rows[i].name != name) {
            dropRows(i);
        }
        if (i == m_rows.size()) {
            addRow(name);
        }
        const SourceRange range = numbers[i].range;
        m_rows[i].number->track(language.position(range.begin), language.position(range.end));
        m_rows[i].control->setDepth(m_editor->isReadOnly() ? std::nullopt : std::optional(numbers[i].value));
    }
    updatePins();
}

void ParametersPane::updatePins()
{
    const std::vector<PinnedNumbers::Pin> pins = m_editor->pinnedNumbers().pins();
    const auto isPinned = [&](int id) { return std::ranges::contains(pins, id, &PinnedNumbers::Pin::id); };
    std::erase_if(m_pins, [&](PinnedRow *row) {
        if (isPinned(row->id())) {
            return false;
        }
        // Its own button may have led here.
        row->setParent(nullptr);
        row->deleteLater();
        return true;
    });
    // New ones come at the end.
    for (std::size_t i = 0; i < pins.size(); ++i) {
        if (i == m_pins.size()) {
            m_pins.push_back(new PinnedRow(m_editor->pinnedNumbers(), pins[i].id));
            m_pinColumn->addWidget(m_pins.back());
        }
        m_pins[i]->setPin(pins[i], !m_editor->isReadOnly());
    }
    m_hint->setVisible(m_rows.empty() && m_pins.empty());
}

}
