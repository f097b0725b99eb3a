// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QCoreApplication>
#include <QList>

class QDockWidget;
class QMainWindow;
class QMenu;
class QWidget;

namespace romanesco {

class AddressPane;
class MeasurePane;
class OutlinePane;
class ParametersPane;
class PhysicsPane;
class ProblemsView;
struct Preview;

/// The panels round text and picture, each in a dock that can float and be closed. Owned by the window.
class Panels
{
    Q_DECLARE_TR_FUNCTIONS(Panels)
public:
    explicit Panels(QMainWindow &window);

    [[nodiscard]] ProblemsView &problems() const { return *m_problems; }
    [[nodiscard]] ParametersPane &parameters() const { return *m_parameters; }
    [[nodiscard]] PhysicsPane &physics() const { return *m_physics; }
    [[nodiscard]] MeasurePane &measure() const { return *m_measure; }
    [[nodiscard]] AddressPane &address() const { return *m_address; }
    [[nodiscard]] OutlinePane &outline() const { return *m_outline; }

    /// An entry for each of them.
    void fill(QMenu &window) const;
    /// As at the first start.
    void layOut();
    /// Gives the keyboard to the next of these and of the panels that are to be seen, from where it is.
    void goToNext(QList<QWidget *> parts, int step) const;
    /// What is wrong with a text of that name, and how much in the dock's title.
    void showProblems(const QString &file, const Preview &preview);

private:
    void open(QDockWidget &dock) const;
    QDockWidget *add(QWidget *panel, const QString &title, const QString &name);

    QMainWindow &m_window;
    ProblemsView *m_problems;
    ParametersPane *m_parameters;
    PhysicsPane *m_physics;
    MeasurePane *m_measure;
    AddressPane *m_address;
    OutlinePane *m_outline;
    /// In the order in which they are listed.
    QList<QDockWidget *> m_docks;
    QDockWidget *m_problemsDock;
    /// Closed until it is wanted.
    QDockWidget *m_measureDock;
};

}
