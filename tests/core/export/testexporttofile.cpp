// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <malloc.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/core/export/exported.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// A triangle with a material.
std::shared_ptr<const Scene> painted()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces = {{0, 1, 2}};
    mesh.materials.resize(1);
    mesh.materials[0].name = "paint";
    mesh.parts = {{0, 0, Mesh::none, 0}};
    return std::make_shared<const Scene>(sceneOf(modelOfMesh(std::make_shared<const Mesh>(std::move(mesh)))));
}

}

class TestExportToFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void theFileHoldsWhatIsStreamed();
    void materialsStandInAFileBesideIt();
    void otherFormatsHaveNoFileBeside();
    void whatFailsLeavesBothFilesAsTheyWere_data();
    void whatFailsLeavesBothFilesAsTheyWere();
    void aStopLeavesNothing();
    void progressIsTold();
    void memoryDoesNotGrowWithTheCopies();

private:
    [[nodiscard]] std::filesystem::path path(const char *name) const
    {
        return m_folder->filePath(QLatin1String(name)).toStdString();
    }
    [[nodiscard]] QByteArray bytes(const char *name) const
    {
        QFile file(m_folder->filePath(QLatin1String(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
    }
    void put(const char *name, const QByteArray &text) const
    {
        QFile file(m_folder->filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    [[nodiscard]] QStringList names() const
    {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestExportToFile::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
}

void TestExportToFile::theFileHoldsWhatIsStreamed()
{
    for (const char *name : {"out.obj", "out.ply", "out.stl"}) {
        const ExportOptions options{.format = exportFormat(name).value(), .source = "x.fdo"};
        const auto report = exportToFile(*menger(2), options, path(name));
        QVERIFY(report);
        QCOMPARE(bytes(name).toStdString(), exported(*menger(2), options));
        QCOMPARE(report->bytes, static_cast<std::uint64_t>(bytes(name).size()));
        QCOMPARE(report->faces, 4800u);
    }
    QVERIFY(bytes("out.obj").startsWith("# Romanesco: x.fdo, depth 2, 4800 faces\n"));
    QVERIFY(bytes("out.ply").contains("\ncomment Romanesco: x.fdo, depth 2, 4800 faces\n"));
    QVERIFY(bytes("out.stl").startsWith("Romanesco: x.fdo, depth 2, 4800 faces "));
}

void TestExportToFile::materialsStandInAFileBesideIt()
{
    QVERIFY(exportToFile(*painted(), {}, path("a picture.obj")));
    QCOMPARE(names(), (QStringList{"a picture.mtl", "a picture.obj"}));
    QVERIFY(bytes("a picture.obj").contains("\nmtllib a picture.mtl\n"));
    QVERIFY(bytes("a picture.obj").contains("\nusemtl paint\n"));
    QVERIFY(bytes("a picture.mtl").contains("newmtl paint\nKd 0.8 0.8 0.8\n"));
}

void TestExportToFile::otherFormatsHaveNoFileBeside()
{
    QVERIFY(exportToFile(*painted(), {.format = ExportFormat::Stl}, path("a.stl")));
    QVERIFY(exportToFile(*menger(1), {}, path("b.obj")));
    QCOMPARE(names(), (QStringList{"a.stl", "b.obj"}));
}

void TestExportToFile::whatFailsLeavesBothFilesAsTheyWere_data()
{
    QTest::addColumn<QString>("obstacle");
    QTest::newRow("materials cannot be written") << "out.mtl";
    QTest::newRow("the file cannot be written") << "out.obj";
}

void TestExportToFile::whatFailsLeavesBothFilesAsTheyWere()
{
    QFETCH(const QString, obstacle);
    const bool isLibrary = obstacle == QLatin1String("out.mtl");
    put(isLibrary ? "out.obj" : "out.mtl", "old");
    QVERIFY(QDir(m_folder->path()).mkdir(obstacle));
    const QStringList before = names();
    const auto report = exportToFile(*painted(), {}, path("out.obj"));
    QVERIFY(!report);
    QCOMPARE(report.error(), std::string(isLibrary ? "out.mtl: it is a directory" : "it is a directory"));
    QCOMPARE(names(), before);
    QCOMPARE(bytes(isLibrary ? "out.obj" : "out.mtl"), QByteArray("old"));
}

void TestExportToFile::aStopLeavesNothing()
{
    for (const char *name : {"out.obj", "out.ply", "out.stl"}) {
        std::stop_source stop;
        const ExportContext context{stop.get_token(), [&](std::uint64_t) { stop.request_stop(); }};
        const auto report = exportToFile(*menger(4), {.format = exportFormat(name).value()}, path(name), context);
        QVERIFY(!report);
        QCOMPARE(report.error(), std::string("cancelled"));
    }
    QVERIFY(names().isEmpty());
}

void TestExportToFile::progressIsTold()
{
    std::vector<std::uint64_t> told;
    const auto report =
        exportToFile(*menger(3), {}, path("out.obj"), {{}, [&](std::uint64_t bytes) { told.push_back(bytes); }});
    QVERIFY(report);
    QVERIFY(told.size() > 10);
    QVERIFY(std::ranges::is_sorted(told));
    QCOMPARE(told.back(), report->bytes);
}

void TestExportToFile::memoryDoesNotGrowWithTheCopies()
{
    std::array<std::size_t, 2> most{};
    for (const int depth : {2, 4}) {
        const auto scene = menger(depth);
        for (const ExportFormat format : {ExportFormat::Obj, ExportFormat::Ply, ExportFormat::Stl}) {
            CountingSink sink;
            const std::size_t before = ::mallinfo2().uordblks;
            std::size_t &largest = most[depth == 2 ? 0 : 1];
            const auto report =
                exportScene(*scene, {.format = format}, sink,
                            {{}, [&](std::uint64_t) { largest = std::max(largest, ::mallinfo2().uordblks - before); }});
            QVERIFY(report);
        }
    }
    // 160,000 copies in place of 400
    QVERIFY2(most[1] < most[0] + 100'000 && most[1] < 2'000'000,
             qPrintable(QStringLiteral("%1 and %2 bytes").arg(most[0]).arg(most[1])));
}

}

ROMANESCO_TEST(romanesco::test::TestExportToFile)
#include "testexporttofile.moc"
