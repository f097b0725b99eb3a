// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "scrubber.h"

#include <cstdlib>

#include <QApplication>
#include <QMouseEvent>

#include "fdoeditor.h"

namespace romanesco {

namespace {

constexpr int pixelsAStep = 4;

}

Scrubber::Scrubber(FdoEditor &editor)
    : m_editor(editor)
    , m_edit(editor)
{
}

bool Scrubber::press(const QMouseEvent &event)
{
    m_number.reset();
    const bool isAsked = event.button() == Qt::LeftButton && (event.modifiers() & Qt::ControlModifier);
    if (!isAsked || m_editor.isReadOnly()) {
        return false;
    }
    m_pressed = event.position().toPoint();
    if (const std::optional<int> position = m_editor.positionAt(m_pressed)) {
        m_number = numberAt(m_editor.language(), *position);
    }
    return m_number.has_value();
}

bool Scrubber::move(const QMouseEvent &event)
{
    if (!m_number || !(event.buttons() & Qt::LeftButton)) {
        return false;
    }
    const int distance = event.position().toPoint().x() - m_pressed.x();
    if (!m_isDragging && std::abs(distance) >= QApplication::startDragDistance()) {
        m_isDragging = true;
        track(*m_number);
        m_edit.beginGesture();
        m_editor.viewport()->setCursor(Qt::SizeHorCursor);
    }
    if (m_isDragging) {
        const TextEdit edit = stepped(*m_number, distance / pixelsAStep, event.modifiers() & Qt::ShiftModifier);
        m_edit.replace(QString::fromStdString(edit.text));
    }
    return true;
}

bool Scrubber::release(const QMouseEvent &event)
{
    if (event.button() != Qt::LeftButton || !m_number) {
        return false;
    }
    m_number.reset();
    if (!m_isDragging) {
        return false;
    }
    m_isDragging = false;
    m_edit.endGesture();
    m_editor.viewport()->setCursor(Qt::IBeamCursor);
    return true;
}

void Scrubber::step(int steps, bool isFiner)
{
    LanguageText &text = m_editor.language();
    const std::optional<NumberPlace> place = numberAt(text, m_editor.textCursor().position());
    if (!place || m_isDragging) {
        return;
    }
    const bool isSame = m_isStepping && m_edit.begin() == text.position(place->number.range.begin);
    track(*place);
    if (!isSame) {
        m_edit.beginGesture();
        m_isStepping = true;
    }
    m_edit.replace(QString::fromStdString(stepped(*place, steps, isFiner).text));
}

void Scrubber::endSteps()
{
    if (m_isStepping) {
        m_isStepping = false;
        m_edit.endGesture();
    }
}

void Scrubber::track(const NumberPlace &place)
{
    LanguageText &text = m_editor.language();
    m_edit.track(text.position(place.number.range.begin), text.position(place.number.range.end));
}

}
