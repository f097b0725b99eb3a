// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>
#include <memory>

#include <QObject>
#include <QPointF>
#include <QTimer>

#include "core/physics/livesimulation.h"
#include "core/physics/scenephysics.h"

namespace romanesco {

class Viewport;

/// Tells what a ball touches that the mouse rests on: not while balls move.
class ContactInspector : public QObject
{
    Q_OBJECT
public:
    /// viewport must outlive it.
    explicit ContactInspector(Viewport &viewport, QObject *parent = nullptr);

    /// How the copy of an item with that address is called.
    using Naming = std::function<QString(std::size_t item, const Address &address)>;
    void setNaming(Naming naming) { m_naming = std::move(naming); }

    void setFrame(std::shared_ptr<const LiveSimulation::Frame> frame) { m_frame = std::move(frame); }

    /// The ball at a place of the viewport, the nearest where there are several; null where there is none.
    [[nodiscard]] const LiveSimulation::BallFrame *ballAt(const QPointF &place) const;
    /// What there is to tell of a ball.
    [[nodiscard]] QString wordsOf(const LiveSimulation::BallFrame &ball) const;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void look();

    Viewport &m_viewport;
    Naming m_naming;
    std::shared_ptr<const LiveSimulation::Frame> m_frame = std::make_shared<LiveSimulation::Frame>();
    QPointF m_place;
    QTimer m_rest;
};

}
