// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTableView>

#include "app/window/measurecontroller.h"
#include "app/window/measurepane.h"
#include "app/window/measureplot.h"
#include "app/window/physicschoices.h"
#include "windowsample.h"

namespace romanesco::test {

/// A cube, which all ways find fast.
inline constexpr auto cube = "c (0, 0, -12) # 8\no \"cube.obj\" #\n";
/// 2^24 cubes in a row: too many to be written out.
inline constexpr auto row = "v 1 0 0\nv -1 0 0\nhalf 0.5 0.5 0.5\nx. \"cube.obj\"\nt.p. (p, #, half)\n"
                            "z<x>. [t.1, t.2] x\n<$>. z 24\n";

/// The window with its panel of measuring.
struct MeasureSample : WindowSample {
    MeasurePane &panel = *window.findChild<MeasurePane *>();
    MeasureController &controller = *window.findChild<MeasureController *>();
    QDockWidget &dock = *window.findChild<QDockWidget *>(QStringLiteral("measure"));
    QSignalSpy finished{&controller, &MeasureController::finished};

    template<typename Widget>
    Widget &named(const QString &name) const
    {
        for (auto *widget : panel.findChildren<Widget *>()) {
            if (widget->accessibleName() == name) {
                return *widget;
            }
        }
        qFatal("there is no %s", qPrintable(name));
    }
    QPushButton &button(const QString &words) const
    {
        for (auto *found : panel.findChildren<QPushButton *>()) {
            if (found->text().remove(u'&').startsWith(words)) {
                return *found;
            }
        }
        qFatal("there is no %s", qPrintable(words));
    }
    /// By the menu.
    void open() const
    {
        for (const QMenu *menu : window.menuBar()->findChildren<QMenu *>()) {
            for (QAction *action : menu->actions()) {
                if (menu->title() == QLatin1String("&Window") && action->text() == QLatin1String("Measure")) {
                    action->trigger();
                    return;
                }
            }
        }
        qFatal("there is no panel");
    }
    bool begin(const char *text, const QString &name = QStringLiteral("scene.sdo"))
    {
        if (!QFile::exists(path(QStringLiteral("cube.obj")))
            && !QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("cube.obj")))) {
            return false;
        }
        window.resize(1280, 800);
        open();
        return window.openFile(write(name, text)) && waitUntilActive()
            && QTest::qWaitFor([&] { return button(QStringLiteral("Measure")).isEnabled(); }, 60'000);
    }
    void press(QPushButton &button) const { QTest::mouseClick(&button, Qt::LeftButton); }
    bool waitForEnd()
    {
        const auto before = finished.count();
        const bool isDone = QTest::qWaitFor([&] { return finished.count() > before; }, 120'000);
        QCoreApplication::processEvents(); // the plot is drawn soon
        return isDone;
    }
    bool measure()
    {
        press(button(QStringLiteral("Measure")));
        return waitForEnd();
    }
    bool cancel()
    {
        press(button(QStringLiteral("Cancel")));
        return waitForEnd();
    }
    /// For the first time: they come first, and the rest is left out.
    bool measureColliders()
    {
        press(button(QStringLiteral("Measure")));
        return QTest::qWaitFor([&] { return !names().isEmpty(); }, 120'000) && cancel();
    }
    [[nodiscard]] QString words() const { return named<QLabel>(QStringLiteral("What was measured")).text(); }
    [[nodiscard]] QTableView &table() const { return named<QTableView>(QStringLiteral("Figures")); }
    [[nodiscard]] QStringList names() const
    {
        QStringList names;
        for (int i = 0; i < table().model()->rowCount(); ++i) {
            names << cell(i, 0);
        }
        return names;
    }
    [[nodiscard]] QString cell(int line, int column) const
    {
        return table().model()->index(line, column).data().toString();
    }
    [[nodiscard]] QString chosen() const
    {
        const QModelIndexList rows = table().selectionModel()->selectedRows();
        return rows.isEmpty() ? QString() : rows.first().data().toString();
    }
    [[nodiscard]] MeasurePlot &plot() const { return *panel.findChild<MeasurePlot *>(); }
    /// What takes the mouse there.
    [[nodiscard]] QWidget &canvas() const { return *plot().findChild<QWidget *>(); }
    /// Where the point of a row of the trial is.
    [[nodiscard]] QPoint placeOf(std::size_t point) const { return plot().placeOf(point).toPoint(); }
    void show(const QString &part) const { named<QComboBox>(QStringLiteral("What is shown")).setCurrentText(part); }
    [[nodiscard]] const PhysicsChoices &physics() const { return *window.findChild<PhysicsChoices *>(); }
    [[nodiscard]] QString said() const { return window.findChild<QStatusBar *>()->currentMessage(); }
};

}
