// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

#include "app/window/exportdialog.h"
#include "app/window/messagestrip.h"
#include "core/scene/sceneloader.h"
#include "documentsample.h"

namespace romanesco::test {

inline const QByteArray triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Each level doubles the copies, and none coincide.
inline QByteArray dust(int depth)
{
    return "v 0 0 0\nv 3 0 0\nsmall 0.4 0.4 0.4\nx. \"triangle.obj\"\nt.p. (p, #, small)\n"
           "z<x>. [t.1, t.2] x\n<$>. z "
        + QByteArray::number(depth) + '\n';
}

/// The dialog over a scene of so many levels.
struct ExportSample {
    Folders folders;
    std::unique_ptr<ExportDialog> dialog;
    QString path;
    QStringList exported;
    QStringList before;

    explicit ExportSample(int depth, const QString &name = QStringLiteral("out.obj"))
        : path(folders.path(name))
    {
        const QString mesh = folders.write(QStringLiteral("triangle.obj"), triangle);
        const QString text = folders.write(QStringLiteral("dust.fdo"), dust(depth));
        before = folders.names();
        const DiskFiles files;
        const std::string file = text.toStdString();
        auto scene = SceneLoader(files).load(file, dust(depth).toStdString()).scene;
        if (!scene) {
            qFatal("the text has errors");
        }
        dialog = std::make_unique<ExportDialog>(ExportSource{scene, QStringLiteral("dust.fdo"), {mesh, text}}, path);
        QObject::connect(dialog.get(), &ExportDialog::exported, dialog.get(),
                         [this](const QString &to, quint64 bytes, const QString &remarks) {
                             exported += {to, QString::number(bytes), remarks};
                         });
        dialog->show();
    }

    template<typename Widget>
    [[nodiscard]] Widget &the() const
    {
        return *dialog->findChild<Widget *>();
    }
    [[nodiscard]] QPushButton &button(const QString &start) const
    {
        for (QPushButton *each : dialog->findChildren<QPushButton *>()) {
            if (each->text().remove(u'&').startsWith(start)) {
                return *each;
            }
        }
        qFatal("there is no such button");
    }
    [[nodiscard]] QCheckBox &box(const QString &word) const
    {
        for (QCheckBox *each : dialog->findChildren<QCheckBox *>()) {
            if (each->text().contains(word)) {
                return *each;
            }
        }
        qFatal("there is no such box");
    }
    [[nodiscard]] QLineEdit &file() const
    {
        for (QLineEdit *each : dialog->findChildren<QLineEdit *>()) {
            if (!qobject_cast<QSpinBox *>(each->parentWidget())) {
                return *each;
            }
        }
        qFatal("there is no field");
    }
    [[nodiscard]] QString trouble() const { return the<MessageStrip>().text(); }
    /// All that the dialog says in words.
    [[nodiscard]] QString words() const
    {
        QStringList all;
        for (const QLabel *label : dialog->findChildren<QLabel *>()) {
            all += label->text();
        }
        return all.join(u'\n');
    }
    [[nodiscard]] bool waitForEstimate() const
    {
        return QTest::qWaitFor([this] { return dialog->isEstimated(); }, 10'000);
    }
    [[nodiscard]] bool waitForEnd() const
    {
        return QTest::qWaitFor([this] { return !dialog->isExporting(); }, 60'000);
    }
    [[nodiscard]] bool waitForBytes() const
    {
        return QTest::qWaitFor([this] { return the<QProgressBar>().value() > 0; }, 10'000);
    }
    /// Beside the files that were there before.
    [[nodiscard]] QStringList written() const
    {
        QStringList names = folders.names();
        names.removeIf([this](const QString &name) { return before.contains(name); });
        return names;
    }
};

}
