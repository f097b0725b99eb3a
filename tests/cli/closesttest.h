// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <charconv>
#include <cmath>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"

namespace romanesco::test {

inline const QByteArray header = "distance\tx\ty\tz\tnx\tny\tnz\tface_tests\tnode_visits\tlower\tpromise\n";

/// The cells of each line after the header.
inline QList<QList<QByteArray>> rowsOf(const QByteArray &out)
{
    QList<QList<QByteArray>> rows;
    if (!out.startsWith(header) || !out.endsWith('\n')) {
        return rows;
    }
    for (const QByteArray &line : out.sliced(header.size()).split('\n')) {
        if (!line.isEmpty()) {
            rows.push_back(line.split('\t'));
        }
    }
    return rows;
}

inline double number(const QByteArray &cell)
{
    double value = std::nan("");
    const auto [end, status] = std::from_chars(cell.begin(), cell.end(), value);
    return end == cell.end() ? value : std::nan("");
}

/// Three times the most digits that differ.
inline QByteArray pointText(double x, double y, double z)
{
    return QByteArray::number(x, 'g', 17) + ' ' + QByteArray::number(y, 'g', 17) + ' ' + QByteArray::number(z, 'g', 17)
        + '\n';
}

/// A test class that asks `romanesco closest`, in a folder of meshes, fractals and scenes.
class ClosestTest : public QObject
{
    Q_OBJECT

protected:
    QTemporaryDir m_folder;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    static Outcome ask(const QString &file, const QByteArray &points, const QStringList &more = {})
    {
        return run(QStringList{"closest", file, "--points", "-"} + more, points);
    }

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        write(path("triangle.obj"), triangle);
        write(path("box.obj"),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
              "f 1 2 4 3\nf 5 6 8 7\nf 1 2 6 5\nf 3 4 8 7\nf 1 3 7 5\nf 2 4 8 6\n");
        write(path("row.fdo"), "v 1 0 0\nx. \"triangle.obj\"\nt.p. (p, #, #)\nz<x>. [#, t.1] x\n<$>. z 3\n");
        write(path("boxes.fdo"), "v 2 0 0\nx. \"box.obj\"\nt.p. (p, #, #)\nz<x>. [#, t.1] x\n<$>. z 4\n");
        write(path("bad.fdo"), "v 1 0 0\n<$>. nothing\n");
        write(path("empty.sdo"), "p \"box.obj\" ((3, 0, 0), #, #) 0.5\n");
        write(path("places.sdo"),
              "o \"box.obj\" #\n"
              "o \"box.obj\" ((-2, 0, 0), #, (-1, 1, 1))\n"
              "f \"boxes.fdo\" ((0, 5, 0), #, (1, 3, 0.5))\n"
              "f \"boxes.fdo\" ((0, -5, 0), #, (1, 0, 1))\n"
              "o \"box.obj\" ((0, 0, 7), #, (0, 0, 0))\n"
              "p \"box.obj\" ((30, 0, 0), #, #) 0.5\n");
        QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("folder")));
    }
};

}
