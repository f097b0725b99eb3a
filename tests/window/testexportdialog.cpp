// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <array>
#include <csignal>

#include <linux/capability.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

#include "app/window/exportdialog.h"
#include "app/window/exportwords.h"
#include "app/window/messagestrip.h"
#include "core/scene/sceneloader.h"
#include "tests/window/documentsample.h"

using namespace romanesco;
using namespace romanesco::test;

namespace {

const QByteArray triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Each level doubles the copies, and none coincide.
QByteArray dust(int depth)
{
    return "v 0 0 0\nv 3 0 0\nsmall 0.4 0.4 0.4\nx. \"triangle.obj\"\nt.p. (p, #, small)\n"
           "z<x>. [t.1, t.2] x\n<$>. z "
        + QByteArray::number(depth) + '\n';
}

struct Sample {
    Folders folders;
    std::unique_ptr<ExportDialog> dialog;
    QString path;
    QStringList exported;
    QStringList before;

    explicit Sample(int depth, const QString &name = QStringLiteral("out.obj"))
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

/// Takes from this thread, and those that it starts, what the superuser may do to every file.
class PlainUser
{
public:
    PlainUser()
    {
        ::syscall(SYS_capget, &m_header, m_old.data());
        auto fewer = m_old;
        fewer[0].effective &= ~(1u << CAP_DAC_OVERRIDE | 1u << CAP_DAC_READ_SEARCH);
        ::syscall(SYS_capset, &m_header, fewer.data());
    }
    ~PlainUser() { ::syscall(SYS_capset, &m_header, m_old.data()); }
    PlainUser(const PlainUser &) = delete;
    PlainUser &operator=(const PlainUser &) = delete;

private:
    __user_cap_header_struct m_header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, 2> m_old{};
};

/// The lines of a text that start so.
qsizetype lines(const QByteArray &text, const QByteArray &start)
{
    return text.count('\n' + start);
}

}

class TestExportDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    void eachFormatIsWritten_data();
    void eachFormatIsWritten();
    void theEndingChoosesTheFormat();
    void theFormatChoosesTheEnding_data();
    void theFormatChoosesTheEnding();
    void onlyAnObjHasDigitsAndGroups();
    void choicesReachTheFile();
    void theForecastComesTrue_data();
    void theForecastComesTrue();
    void theForecastFollowsTheChoices();
    void sizesAndTimesAreTold_data();
    void sizesAndTimesAreTold();
    void tooManyFacesCannotBeStarted_data();
    void tooManyFacesCannotBeStarted();
    void cancellingLeavesNoFile();
    void cancellingLeavesTheOldFile();
    void closingCancels();
    void closingAsksAfterAWhile();
    void theQuestionGoesWithTheExport();
    void destroyingCancels();
    void whatCannotBeWrittenIsSaid_data();
    void whatCannotBeWrittenIsSaid();
    void aFullDiskIsSaid();
    void whatTheSceneIsMadeFromStays();
    void anOldFileIsReplacedOnlyKnowingly();
    void keysAreEnough();
};

void TestExportDialog::eachFormatIsWritten_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("start");
    QTest::newRow("obj") << "out.obj" << QByteArray("# Romanesco: dust.fdo, depth 3, 8 faces\n");
    QTest::newRow("ply") << "out.ply" << QByteArray("ply\n");
    QTest::newRow("stl") << "OUT.STL" << QByteArray("Romanesco");
    QTest::newRow("glb") << "out.glb" << QByteArray("glTF");
    // the format is that which is chosen, where the name does not tell
    QTest::newRow("none") << "out.txt" << QByteArray("# Romanesco: dust.fdo, depth 3, 8 faces\n");
}

void TestExportDialog::eachFormatIsWritten()
{
    QFETCH(const QString, name);
    QFETCH(const QByteArray, start);
    Sample sample(3, name);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEnd());
    QVERIFY2(sample.dialog->isHidden(), qPrintable(sample.trouble()));
    const QByteArray bytes = Folders::read(sample.path);
    QVERIFY2(bytes.startsWith(start), bytes.first(20));
    QCOMPARE(sample.exported, QStringList({sample.path, QString::number(bytes.size()), QString()}));
    QCOMPARE(sample.written(), QStringList{name});
}

void TestExportDialog::theEndingChoosesTheFormat()
{
    Sample sample(3);
    QCOMPARE(sample.dialog->options().format, ExportFormat::Obj);
    sample.file().setText(QStringLiteral("other.PLY"));
    QCOMPARE(sample.dialog->options().format, ExportFormat::Ply);
    QCOMPARE(sample.dialog->path(), sample.folders.path(QStringLiteral("other.PLY")));
    sample.file().setText(QStringLiteral("other"));
    QCOMPARE(sample.dialog->options().format, ExportFormat::Ply);
    sample.file().setText(QStringLiteral("/other.glb"));
    QCOMPARE(sample.dialog->options().format, ExportFormat::Glb);
    QCOMPARE(sample.dialog->path(), QStringLiteral("/other.glb"));
}

void TestExportDialog::theFormatChoosesTheEnding_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("becomes");
    QTest::newRow("known") << "tree.obj" << "tree.stl";
    QTest::newRow("upper") << "tree.OBJ" << "tree.stl";
    QTest::newRow("other") << "tree.v2" << "tree.v2.stl";
    QTest::newRow("none") << "tree" << "tree.stl";
    QTest::newRow("two") << "tree.obj.ply" << "tree.obj.stl";
    QTest::newRow("empty") << "" << "";
}

void TestExportDialog::theFormatChoosesTheEnding()
{
    QFETCH(const QString, typed);
    Sample sample(3);
    sample.file().setText(typed);
    QComboBox &formats = sample.the<QComboBox>();
    formats.setCurrentIndex(formats.findText(QStringLiteral("STL"), Qt::MatchStartsWith));
    QTEST(sample.file().text(), "becomes");
    QCOMPARE(sample.dialog->options().format, ExportFormat::Stl);
}

void TestExportDialog::onlyAnObjHasDigitsAndGroups()
{
    Sample sample(3);
    sample.box(QStringLiteral("group")).setChecked(true);
    sample.the<QSpinBox>().setValue(4);
    QCOMPARE(sample.dialog->options().digits, std::optional(4));
    QVERIFY(sample.dialog->options().isGrouped);
    sample.file().setText(QStringLiteral("a.stl"));
    QVERIFY(!sample.box(QStringLiteral("group")).isEnabled());
    QVERIFY(!sample.the<QSpinBox>().isEnabled());
    QCOMPARE(sample.dialog->options().digits, std::nullopt);
    QVERIFY(!sample.dialog->options().isGrouped);
    sample.the<QSpinBox>().setValue(0);
    sample.file().setText(QStringLiteral("a.obj"));
    QCOMPARE(sample.dialog->options().digits, std::nullopt);
}

void TestExportDialog::choicesReachTheFile()
{
    Sample sample(3);
    sample.box(QStringLiteral("group")).setChecked(true);
    sample.box(QStringLiteral("coincide")).setChecked(true);
    sample.the<QSpinBox>().setValue(2);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEnd());
    const QByteArray bytes = Folders::read(sample.path);
    QCOMPARE(lines(bytes, "f "), 8);
    QCOMPARE(lines(bytes, "g dust"), 2);
    QVERIFY2(bytes.contains("\nv 0.064 0 0\n"), bytes); // 0.4 cubed
    QVERIFY2(!bytes.contains("0.06400"), bytes);
    // a triangle is open on each side
    QVERIFY2(sample.exported.at(2).contains(QStringLiteral("24 edges are open")), qPrintable(sample.exported.at(2)));
}

void TestExportDialog::theForecastComesTrue_data()
{
    QTest::addColumn<QString>("name");
    for (const char *name : {"out.obj", "out.ply", "out.stl", "out.glb"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

void TestExportDialog::theForecastComesTrue()
{
    QFETCH(const QString, name);
    Sample sample(18, name);
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.words().contains(QStringLiteral("262,144 faces")), qPrintable(sample.words()));
    const QRegularExpression size(QStringLiteral("about ([0-9.]+) MB"));
    const QRegularExpressionMatch match = size.match(sample.words());
    QVERIFY2(match.hasMatch(), qPrintable(sample.words()));
    QVERIFY(sample.words().contains(QRegularExpression(QStringLiteral("in (about|less than) .*second"))));
    QVERIFY(sample.words().contains(QRegularExpression(QStringLiteral("The disk has [0-9.]+ .B free"))));
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEnd());
    const double megabytes = static_cast<double>(Folders::read(sample.path).size()) / 1e6;
    QVERIFY2(std::abs(match.captured(1).toDouble() / megabytes - 1.0) < 0.03, qPrintable(match.captured()));
}

void TestExportDialog::theForecastFollowsTheChoices()
{
    Sample sample(16);
    QVERIFY(sample.waitForEstimate());
    const QString first = sample.words();
    sample.the<QSpinBox>().setValue(2);
    QVERIFY(!sample.dialog->isEstimated());
    QVERIFY(sample.waitForEstimate());
    const QString rounded = sample.words();
    QVERIFY(rounded != first);
    sample.box(QStringLiteral("coincide")).setChecked(true);
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.words().contains(QStringLiteral("65,536 faces before welding")), qPrintable(sample.words()));
}

void TestExportDialog::sizesAndTimesAreTold_data()
{
    QTest::addColumn<QString>("told");
    QTest::addColumn<QString>("words");
    QTest::newRow("bytes") << sizeText(Count(12)) << "12 bytes";
    QTest::newRow("kB") << sizeText(Count(12'340)) << "12.3 kB";
    QTest::newRow("GB") << sizeText(Count(12'340'000'000)) << "12.3 GB";
    QTest::newRow("beyond") << sizeText(power(Count(10), 40)) << "1.00 × 10⁴⁰ bytes";
    QTest::newRow("at once") << durationText(0.0) << "less than a second";
    QTest::newRow("a second") << durationText(1.4) << "a second";
    QTest::newRow("seconds") << durationText(89.4) << "89 seconds";
    QTest::newRow("minutes") << durationText(91.0) << "2 minutes";
    QTest::newRow("hours") << durationText(7'300.0) << "2 hours";
}

void TestExportDialog::sizesAndTimesAreTold()
{
    QFETCH(const QString, told);
    QTEST(told, "words");
}

void TestExportDialog::tooManyFacesCannotBeStarted_data()
{
    QTest::addColumn<int>("depth");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("words");
    QTest::newRow("disk") << 133 << "out.obj" << "bytes free on the disk";
    QTest::newRow("format") << 133 << "out.stl" << "4294967295 faces";
    // nothing is known of a disk
    QTest::newRow("anywhere") << 133 << "missing/folder/out.obj" << "too many faces";
}

void TestExportDialog::tooManyFacesCannotBeStarted()
{
    QFETCH(const QString, words);
    QFETCH(const QString, name);
    QFETCH(const int, depth);
    Sample sample(depth, name);
    // even by one who is faster than the forecast
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.words().contains(QStringLiteral("1.08 × 10⁴⁰ faces")), qPrintable(sample.words()));
    QVERIFY2(sample.trouble().contains(words), qPrintable(sample.trouble()));
    QVERIFY(!sample.button(QStringLiteral("Export")).isEnabled());
    QVERIFY(!sample.dialog->isExporting());
    QCOMPARE(sample.written(), QStringList());
}

void TestExportDialog::cancellingLeavesNoFile()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.dialog->isExporting());
    QVERIFY(!sample.file().isEnabled());
    QVERIFY(sample.waitForBytes());
    QVERIFY2(sample.words().contains(QRegularExpression(QStringLiteral("of about .*B, about .* left"))),
             qPrintable(sample.words()));
    QVERIFY(sample.the<QProgressBar>().value() < sample.the<QProgressBar>().maximum());
    sample.button(QStringLiteral("Cancel")).click();
    QVERIFY(sample.waitForEnd());
    QCOMPARE(sample.written(), QStringList());
    QVERIFY(sample.dialog->isVisible());
    QVERIFY2(sample.trouble().contains(QStringLiteral("cancelled")), qPrintable(sample.trouble()));
    QVERIFY(sample.the<QProgressBar>().isHidden());
    QVERIFY(sample.file().isEnabled());
    QVERIFY(sample.button(QStringLiteral("Export")).isEnabled());
    QVERIFY(sample.exported.isEmpty());
}

void TestExportDialog::cancellingLeavesTheOldFile()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    std::ignore = sample.folders.write(QStringLiteral("out.obj"), "old");
    // it was not there when the forecast was made, and nobody has been told
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(!sample.dialog->isExporting());
    QTRY_VERIFY(sample.words().contains(QStringLiteral("will be replaced")));
    QVERIFY(!sample.dialog->isExporting());
    sample.button(QStringLiteral("Replace")).click();
    QVERIFY(sample.waitForBytes());
    sample.button(QStringLiteral("Cancel")).click();
    QVERIFY(sample.waitForEnd());
    QCOMPARE(Folders::read(sample.path), QByteArray("old"));
    QCOMPARE(sample.written(), QStringList{QStringLiteral("out.obj")});
}

void TestExportDialog::closingCancels()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForBytes());
    QTest::keyClick(sample.dialog.get(), Qt::Key_Escape);
    QVERIFY(!sample.dialog->findChild<QMessageBox *>());
    QVERIFY(sample.waitForEnd());
    QVERIFY(sample.dialog->isHidden());
    QCOMPARE(sample.dialog->result(), int(QDialog::Rejected));
    QCOMPARE(sample.written(), QStringList());
}

void TestExportDialog::closingAsksAfterAWhile()
{
    Sample sample(22);
    sample.dialog->setPatience(std::chrono::milliseconds(-1));
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForBytes());
    sample.dialog->close();
    QPointer<QMessageBox> question = sample.dialog->findChild<QMessageBox *>();
    QVERIFY(question);
    question->reject();
    QVERIFY(sample.dialog->isExporting());
    QVERIFY(sample.dialog->isVisible());
    QTRY_VERIFY(!question);
    sample.dialog->close();
    question = sample.dialog->findChild<QMessageBox *>();
    QVERIFY(question);
    sample.button(QStringLiteral("Stop and Close")).click();
    QVERIFY(sample.waitForEnd());
    QVERIFY(sample.dialog->isHidden());
    QCOMPARE(sample.written(), QStringList());
}

void TestExportDialog::theQuestionGoesWithTheExport()
{
    Sample sample(18);
    sample.dialog->setPatience(std::chrono::milliseconds(-1));
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    sample.dialog->close();
    const QPointer<QMessageBox> question = sample.dialog->findChild<QMessageBox *>();
    QVERIFY(question);
    QVERIFY(sample.waitForEnd());
    QTRY_VERIFY(!question);
    QVERIFY(sample.dialog->isHidden());
    QCOMPARE(sample.exported.size(), 3);
}

void TestExportDialog::destroyingCancels()
{
    Sample sample(22);
    QVERIFY(sample.waitForEstimate());
    sample.button(QStringLiteral("Export")).click();
    QVERIFY(sample.waitForBytes());
    sample.dialog.reset();
    QCOMPARE(sample.written(), QStringList());
}

void TestExportDialog::whatCannotBeWrittenIsSaid_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reason");
    QTest::newRow("pipe") << "pipe" << "it is not a regular file";
    QTest::newRow("device") << "device" << "it is not a regular file";
    QTest::newRow("folder") << "folder" << "it is a directory";
    QTest::newRow("no folder") << "missing/out.obj" << "no such folder";
    QTest::newRow("read-only") << "locked/out.obj" << "permission denied";
}

void TestExportDialog::whatCannotBeWrittenIsSaid()
{
    QFETCH(const QString, name);
    QFETCH(const QString, reason);
    Sample sample(3);
    QCOMPARE(::mkfifo(QFile::encodeName(sample.folders.path(QStringLiteral("pipe"))).constData(), 0600), 0);
    // by a link, so that no fault can harm the device itself
    QVERIFY(QFile::link(QStringLiteral("/dev/full"), sample.folders.path(QStringLiteral("device"))));
    QVERIFY(QDir(sample.folders.own.path()).mkdir(QStringLiteral("folder")));
    QVERIFY(QDir(sample.folders.own.path()).mkdir(QStringLiteral("locked")));
    QCOMPARE(::chmod(QFile::encodeName(sample.folders.path(QStringLiteral("locked"))).constData(), 0500), 0);
    const QStringList before = sample.folders.names();
    sample.file().setText(name);
    QVERIFY(sample.waitForEstimate());
    const PlainUser user;
    sample.button(QFileInfo::exists(sample.dialog->path()) ? QStringLiteral("Replace") : QStringLiteral("Export"))
        .click();
    QVERIFY(sample.waitForEnd());
    QVERIFY(sample.dialog->isVisible());
    QVERIFY2(sample.trouble().contains(QStringLiteral("was not written: ") + reason), qPrintable(sample.trouble()));
    QVERIFY(sample.trouble().contains(sample.dialog->path()));
    QCOMPARE(sample.folders.names(), before);
}

/// As near as a test comes to it without one.
void TestExportDialog::aFullDiskIsSaid()
{
    Sample sample(18);
    QVERIFY(sample.waitForEstimate());
    std::signal(SIGXFSZ, SIG_IGN); // as the program does
    rlimit old{};
    QCOMPARE(::getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{1'000'000, old.rlim_max};
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &small), 0);
    sample.button(QStringLiteral("Export")).click();
    const bool hasEnded = sample.waitForEnd();
    QCOMPARE(::setrlimit(RLIMIT_FSIZE, &old), 0);
    QVERIFY(hasEnded);
    QVERIFY2(sample.trouble().contains(QStringLiteral("larger than a file may be")), qPrintable(sample.trouble()));
    QCOMPARE(sample.written(), QStringList());
}

void TestExportDialog::whatTheSceneIsMadeFromStays()
{
    Sample sample(3, QStringLiteral("triangle.obj"));
    QVERIFY(sample.waitForEstimate());
    QVERIFY2(sample.trouble().contains(QStringLiteral("made from")), qPrintable(sample.trouble()));
    QVERIFY(!sample.button(QStringLiteral("Replace")).isEnabled());
    sample.file().setText(QStringLiteral("other.obj"));
    QVERIFY(sample.waitForEstimate());
    QVERIFY(sample.trouble().isEmpty());
    QVERIFY(sample.button(QStringLiteral("Export")).isEnabled());
}

void TestExportDialog::anOldFileIsReplacedOnlyKnowingly()
{
    Sample sample(3, QStringLiteral("other.obj"));
    std::ignore = sample.folders.write(QStringLiteral("out.obj"), "old");
    sample.file().setText(QStringLiteral("out.obj"));
    // before anything could be told
    QTest::keyClick(sample.dialog.get(), Qt::Key_Return);
    QVERIFY(sample.waitForEstimate());
    QVERIFY(!sample.dialog->isExporting());
    QCOMPARE(Folders::read(sample.folders.path(QStringLiteral("out.obj"))), QByteArray("old"));
    QVERIFY2(sample.words().contains(QStringLiteral("will be replaced")), qPrintable(sample.words()));
    QTest::keyClick(sample.dialog.get(), Qt::Key_Return);
    QVERIFY(sample.waitForEnd());
    QVERIFY(Folders::read(sample.folders.path(QStringLiteral("out.obj"))).startsWith("# Romanesco"));
}

/// A name, a format and two choices, and Enter before the forecast is there.
void TestExportDialog::keysAreEnough()
{
    Sample sample(3);
    QVERIFY(QTest::qWaitForWindowActive(sample.dialog.get()));
    const auto type = [&](const QString &text) { QTest::keyClicks(QApplication::focusWidget(), text); };
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QTest::keyClick(QApplication::focusWidget(), key, with);
    };
    press(Qt::Key_I, Qt::AltModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.file());
    press(Qt::Key_A, Qt::ControlModifier);
    type(QStringLiteral("keys.ply"));
    press(Qt::Key_F, Qt::AltModifier);
    QCOMPARE(QApplication::focusWidget(), &sample.the<QComboBox>());
    press(Qt::Key_Up);
    QCOMPARE(sample.file().text(), QStringLiteral("keys.obj"));
    press(Qt::Key_D, Qt::AltModifier);
    type(QStringLiteral("5"));
    press(Qt::Key_M, Qt::AltModifier);
    QTRY_VERIFY(sample.dialog->options().isWelded); // the key shows the button as pressed for an instant
    press(Qt::Key_Return);
    QVERIFY(QTest::qWaitFor([&] { return sample.dialog->isHidden(); }, 10'000));
    QCOMPARE(sample.dialog->options().digits, std::optional(5));
    QCOMPARE(lines(Folders::read(sample.folders.path(QStringLiteral("keys.obj"))), "f "), 8);
}

QTEST_MAIN(TestExportDialog)
#include "testexportdialog.moc"
