// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QAction>
#include <QLabel>
#include <QStatusBar>
#include <QTableView>

#include "app/window/ballmodel.h"
#include "app/window/physicscontroller.h"
#include "windowsample.h"

namespace romanesco::test {

/// A cube of side 3, seen from the front, and a ball above its top.
inline constexpr auto cubeScene = "c (0, 0, -12) # 8 orthographic\n"
                                  "o \"cube.obj\" #\n"
                                  "p \"ball.obj\" ((0, 2.25, 0), #, (0.25, 0.25, 0.25)) 0.5\n";
inline constexpr auto withoutBalls = "c (0, 0, -12) # 8 orthographic\no \"cube.obj\" #\n";

/// The window with its panel of physics.
struct PhysicsSample : WindowSample {
    BallModel &balls = *window.findChild<BallModel *>();
    QTableView &list = *named<QTableView>(QStringLiteral("Balls"));
    PhysicsController &physics = *window.findChild<PhysicsController *>();

    template<typename Widget>
    Widget *named(const QString &name) const
    {
        for (auto *widget : window.findChildren<Widget *>()) {
            if (widget->accessibleName() == name) {
                return widget;
            }
        }
        qFatal("there is no %s", qPrintable(name));
    }
    QAction *action(const QString &words) const
    {
        for (QAction *found : window.findChildren<QAction *>()) {
            if (found->text().remove(u'&').remove(u'…') == words) {
                return found;
            }
        }
        qFatal("there is no %s", qPrintable(words));
    }
    bool begin(const char *text)
    {
        const bool isThere = QFile::copy(QStringLiteral(":/examples/cube.obj"), path(QStringLiteral("cube.obj")));
        return isThere && begins(text);
    }
    bool begins(const char *text)
    {
        if (QByteArray(text).contains("ball.obj")
            && !QFile::copy(QStringLiteral(":/examples/ball.obj"), path(QStringLiteral("ball.obj")))) {
            return false;
        }
        return openAndWait(write(QStringLiteral("scene.sdo"), text)) && focusViewport();
    }
    void press(int key) { QTest::keyClick(&viewport, Qt::Key(key)); }
    bool waitForBalls(int count) const
    {
        return QTest::qWaitFor([&] { return balls.rowCount() == count; }, 60'000);
    }
    [[nodiscard]] QString figures() const { return named<QLabel>(QStringLiteral("Figures"))->text(); }
    bool waitForFigures(const QString &words) const
    {
        return QTest::qWaitFor([&] { return figures().contains(words); }, 60'000);
    }
    /// "1.25 s, step 300".
    [[nodiscard]] int step() const
    {
        return figures().section(QStringLiteral("step "), 1).section(u'\n', 0, 0).remove(u',').toInt();
    }
    bool waitForStep(int count) const
    {
        return QTest::qWaitFor([&] { return step() >= count; }, 60'000);
    }
    [[nodiscard]] QString state(int row) const
    {
        return balls.data(balls.index(row, BallModel::State), Qt::DisplayRole).toString();
    }
    bool waitForRest(int row) const
    {
        return QTest::qWaitFor([&] { return balls.rowCount() > row && state(row) == QLatin1String("rests"); }, 60'000);
    }
    [[nodiscard]] QString said() const { return window.findChild<QStatusBar *>()->currentMessage(); }
    /// The first ball's own colour.
    [[nodiscard]] int orangePixels() const
    {
        const QImage picture = viewport.grabFramebuffer();
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor c = picture.pixelColor(x, y);
                count += c.red() > 90 && c.red() > 5 * c.blue() && c.red() > c.green() ? 1 : 0;
            }
        }
        return count;
    }
    /// Of the plane through the axes, which the camera looks at along z.
    [[nodiscard]] QPoint pixelOf(double x, double y) const
    {
        return viewport.placeOf(viewport.view().surroundings()->hereFromWorld({x, y, 0.0}))->toPoint();
    }
};

}
