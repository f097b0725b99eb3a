// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "turntabledialog.h"

#include <string_view>
#include <utility>

#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/drawing/painter.h"
#include "core/base/atomicfile.h"

namespace romanesco {

namespace {

constexpr int mostFrames = 10'000;
constexpr int largestSide = 16'384;
constexpr int samples = 8;
constexpr int progressInterval = 100;

}

TurntableDialog::TurntableDialog(Turn turn, const QString &proposal, QWidget *parent)
    : QDialog(parent)
    , m_turn(std::move(turn))
    , m_form(new QWidget)
    , m_folder(new QLineEdit)
    , m_name(new QLineEdit)
    , m_count(new QSpinBox)
    , m_width(new QSpinBox)
    , m_height(new QSpinBox)
    , m_words(new QLabel)
    , m_progress(new QProgressBar)
    , m_buttons(new QDialogButtonBox)
    , m_start(m_buttons->addButton(tr("&Save"), QDialogButtonBox::AcceptRole))
    , m_close(m_buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole))
    , m_drawing(*this)
{
    setWindowTitle(tr("Save Turntable"));
    m_turn.view.samples = samples;
    m_turn.view.standsAlone = true;
    buildForm(proposal);
    m_words->setWordWrap(true);
    m_progress->setAccessibleName(tr("How many pictures are there"));
    m_progress->hide();
    auto *column = new QVBoxLayout(this);
    for (QWidget *part : std::initializer_list<QWidget *>{m_form, m_words, m_progress}) {
        column->addWidget(part);
    }
    column->addStretch(1);
    column->addWidget(m_buttons);
    resize(520, sizeHint().height());

    m_start->setDefault(true);
    m_start->setToolTip(tr("Draw the pictures and write them (Enter)"));
    m_close->setAutoDefault(false);
    m_close->setToolTip(tr("Close this window, and stop what is being drawn (Esc)"));
    connect(m_start, &QPushButton::clicked, this, &TurntableDialog::start);
    connect(m_close, &QPushButton::clicked, this, [this] {
        if (isDrawing()) {
            cancel();
        } else {
            reject();
        }
    });
    m_progressTimer.setInterval(progressInterval);
    connect(&m_progressTimer, &QTimer::timeout, this, &TurntableDialog::showProgress);
    showFiles();
}

TurntableDialog::~TurntableDialog()
{
    m_stop.request_stop();
}

void TurntableDialog::buildForm(const QString &proposal)
{
    const QFileInfo first(proposal);
    m_folder->setText(QDir::toNativeSeparators(first.absolutePath()));
    m_folder->setAccessibleName(tr("Folder for the pictures"));
    m_name->setText(first.fileName() + QStringLiteral("-%04d.png"));
    m_name->setToolTip(tr("Of each picture; %d stands for its number, %04d for one of four digits"));
    m_count->setRange(1, mostFrames);
    m_count->setValue(120);
    m_count->setToolTip(tr("Pictures of a full turn"));
    for (QSpinBox *side : {m_width, m_height}) {
        side->setRange(16, largestSide);
        side->setSuffix(tr(" px"));
    }
    m_width->setValue(m_turn.view.width);
    m_height->setValue(m_turn.view.height);
    m_width->setAccessibleName(tr("Width"));
    m_height->setAccessibleName(tr("Height"));

    auto *browseButton = new QPushButton(tr("&Browse…"));
    browseButton->setAutoDefault(false);
    browseButton->setToolTip(tr("Choose the folder in a list"));
    connect(browseButton, &QPushButton::clicked, this, &TurntableDialog::browse);
    auto *folder = new QHBoxLayout;
    folder->addWidget(m_folder, 1);
    folder->addWidget(browseButton);
    auto *size = new QHBoxLayout;
    size->addWidget(m_width);
    size->addWidget(new QLabel(QStringLiteral("×")));
    size->addWidget(m_height);
    size->addStretch(1);
    auto *rows = new QFormLayout(m_form);
    rows->setContentsMargins(0, 0, 0, 0);
    auto *folderLabel = new QLabel(tr("F&older:"));
    folderLabel->setBuddy(m_folder);
    auto *sizeLabel = new QLabel(tr("Si&ze:"));
    sizeLabel->setBuddy(m_width);
    rows->addRow(folderLabel, folder);
    rows->addRow(tr("&Names:"), m_name);
    rows->addRow(tr("&Pictures:"), m_count);
    rows->addRow(sizeLabel, size);
    connect(m_folder, &QLineEdit::textChanged, this, &TurntableDialog::showFiles);
    connect(m_name, &QLineEdit::textChanged, this, &TurntableDialog::showFiles);
    connect(m_count, &QSpinBox::valueChanged, this, &TurntableDialog::showFiles);
}

void TurntableDialog::browse()
{
    auto *dialog = new QFileDialog(this, tr("Folder for the Pictures"), QDir::fromNativeSeparators(m_folder->text()));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString &path) { m_folder->setText(QDir::toNativeSeparators(path)); });
    dialog->open();
}

std::optional<FramePattern> TurntableDialog::names() const
{
    const QDir folder(QDir::fromNativeSeparators(m_folder->text()));
    auto pattern = FramePattern::parse(m_name->text());
    // a folder's own name may hold a %
    if (!pattern || m_folder->text().contains(u'%') || m_name->text().contains(u'/')) {
        return std::nullopt;
    }
    return FramePattern::parse(folder.absoluteFilePath(m_name->text())).value();
}

/// What would be written, and what is in the way of it.
void TurntableDialog::showFiles()
{
    const std::optional<FramePattern> files = names();
    const bool isFolder = QFileInfo(QDir::fromNativeSeparators(m_folder->text())).isDir();
    int replaced = 0;
    for (int frame = 0; files && isFolder && frame < m_count->value(); ++frame) {
        replaced += QFileInfo::exists(files->name(frame)) ? 1 : 0;
    }
    m_start->setEnabled(files && isFolder);
    m_start->setText(replaced > 0 ? tr("&Replace") : tr("&Save"));
    if (!isFolder) {
        m_words->setText(tr("There is no such folder."));
    } else if (!files) {
        m_words->setText(tr("The names need one %d or %04d for the number of the picture, and no other % or /, in the "
                            "folder's name neither."));
    } else if (replaced > 0) {
        m_words->setText(
            tr("%1 to %2. Files of such names are there, which will be replaced: %3.")
                .arg(QFileInfo(files->name(0)).fileName(), QFileInfo(files->name(m_count->value() - 1)).fileName())
                .arg(replaced));
    } else {
        m_words->setText(
            tr("%1 to %2")
                .arg(QFileInfo(files->name(0)).fileName(), QFileInfo(files->name(m_count->value() - 1)).fileName()));
    }
}

void TurntableDialog::start()
{
    const std::optional<FramePattern> files = names();
    if (!files || isDrawing()) {
        return;
    }
    m_turn.count = m_count->value();
    m_turn.view.width = m_width->value();
    m_turn.view.height = m_height->value();
    m_stop = std::stop_source();
    m_isClosing = false;
    m_finished = 0;
    m_form->setEnabled(false);
    m_start->setEnabled(false);
    m_close->setText(tr("&Cancel"));
    m_close->setFocus();
    m_progress->setRange(0, m_turn.count);
    m_progress->show();
    m_progressTimer.start();
    m_drawing.start(
        [this, turn = m_turn, files = *files, stop = m_stop.get_token()] { return draw(turn, files, stop); },
        [this](const std::expected<int, QString> &drawn) { finish(drawn); });
    showProgress();
}

/// On a thread of its own. How many pictures are there; the error is a sentence.
std::expected<int, QString> TurntableDialog::draw(const Turn &turn, const FramePattern &names,
                                                  const std::stop_token &stop)
{
    auto painter = Painter::create(turn.scene);
    if (!painter) {
        return std::unexpected(QString::fromStdString(painter.error()));
    }
    for (int frame = 0; frame < turn.count; ++frame) {
        const auto picture = painter->draw(turn.at(frame), [&](int) { return !stop.stop_requested(); });
        if (stop.stop_requested()) {
            return frame;
        }
        if (!picture) {
            return std::unexpected(QString::fromStdString(picture.error()));
        }
        const QByteArray bytes = pngOf(*picture);
        const QString path = names.name(frame);
        const auto written = writeWhole(QFile::encodeName(path).toStdString(),
                                        std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
        if (!written) {
            return std::unexpected(tr("“%1” was not written: %2.").arg(path, QString::fromStdString(written.error())));
        }
        ++m_finished;
    }
    return turn.count;
}

void TurntableDialog::showProgress()
{
    const int finished = m_finished;
    m_progress->setValue(finished);
    m_words->setText(m_stop.stop_requested() ? tr("Stopping…")
                                             : tr("%1 of %2 pictures are there").arg(finished).arg(m_turn.count));
}

void TurntableDialog::finish(const std::expected<int, QString> &drawn)
{
    m_progressTimer.stop();
    m_progress->hide();
    m_form->setEnabled(true);
    m_close->setText(tr("&Close"));
    const int finished = m_finished;
    if (drawn && *drawn == m_turn.count) {
        accept();
        Q_EMIT saved(finished, QDir::fromNativeSeparators(m_folder->text()));
        return;
    }
    if (m_isClosing) {
        QDialog::reject();
        return;
    }
    showFiles();
    const QString ending = drawn ? tr("Cancelled.") : drawn.error();
    m_words->setText(tr("%1 Pictures that are there: %2.").arg(ending).arg(finished));
}

void TurntableDialog::cancel()
{
    m_stop.request_stop();
    showProgress();
}

void TurntableDialog::reject()
{
    if (!isDrawing()) {
        QDialog::reject();
        return;
    }
    m_isClosing = true;
    cancel();
}

}
