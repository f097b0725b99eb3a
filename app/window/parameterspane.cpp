// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "parameterspane.h"

#include <algorithm>

#include <QLabel>
#include <QVBoxLayout>

#include "core/language/structure.h"
#include "depthcontrol.h"
#include "editor/fdoeditor.h"

namespace romanesco {

namespace {

/// Nobody drags more, and each is a widget.
constexpr std::size_t mostRows = 100;

}

ParametersPane::ParametersPane(QWidget *parent)
    : QScrollArea(parent)
    , m_hint(new QLabel(tr("No number of iterations in this text.")))
{
    auto *inside = new QWidget;
    m_column = new QVBoxLayout(inside);
    m_column->addWidget(m_hint);
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
    m_column->insertWidget(m_column->count() - 1, row.control);
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
    m_hint->setVisible(m_rows.empty());
}

}
