// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "recordings.h"

#include <QFile>
#include <QFileDialog>
#include <QPointer>

#include "core/base/atomicfile.h"
#include "core/base/file.h"
#include "core/physics/livesimulation.h"

namespace romanesco {

namespace {

QFileDialog *makeDialog(QWidget &window, const QString &title, QFileDialog::AcceptMode mode)
{
    auto *dialog = new QFileDialog(&window, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(mode);
    dialog->setFileMode(mode == QFileDialog::AcceptSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    dialog->setNameFilter(Recordings::tr("Recordings (*.recording)"));
    dialog->setDefaultSuffix(QStringLiteral("recording"));
    return dialog;
}

}

Recordings::Recordings(QWidget &window, LiveSimulation &simulation, QObject *parent)
    : QObject(parent)
    , m_window(window)
    , m_simulation(simulation)
    , m_reading(*this)
{
}

void Recordings::save()
{
    QFileDialog *dialog = makeDialog(m_window, tr("Save Recording"), QFileDialog::AcceptSave);
    connect(dialog, &QFileDialog::fileSelected, this, &Recordings::write);
    dialog->open();
}

/// By the simulation's thread, which nobody waits for.
void Recordings::write(const QString &path)
{
    m_simulation.record([this, path](const std::expected<Recording, std::string> &recording) {
        const auto written = recording.and_then(
            [&](const Recording &whole) { return writeWhole(QFile::encodeName(path).toStdString(), textOf(whole)); });
        const QString words = written ? tr("Saved %1").arg(path)
                                      : tr("There is no recording: %1").arg(QString::fromStdString(written.error()));
        QMetaObject::invokeMethod(this, [this, words] { Q_EMIT told(words); }, Qt::QueuedConnection);
    });
}

void Recordings::open()
{
    QFileDialog *dialog = makeDialog(m_window, tr("Replay Recording"), QFileDialog::AcceptOpen);
    connect(dialog, &QFileDialog::fileSelected, this, &Recordings::read);
    dialog->open();
}

void Recordings::read(const QString &path)
{
    m_reading.finish(); // the one before, if it still goes on
    m_reading.start(
        [path] {
            return DiskFiles()
                .read(QFile::encodeName(path).toStdString())
                .and_then([](const std::string &text) { return recordingFromText(text); })
                .transform_error([&](const std::string &why) {
                    return tr("%1 cannot be replayed: %2").arg(path, QString::fromStdString(why));
                });
        },
        [this](std::expected<Recording, QString> recording) {
            if (recording) {
                m_simulation.replay(std::move(*recording));
            } else {
                Q_EMIT told(recording.error());
            }
        });
}

}
