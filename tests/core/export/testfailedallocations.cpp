// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <functional>
#include <limits>
#include <map>
#include <new>

#include <QTest>

#include "core/export/exporter.h"
#include "core/scene/sceneloader.h"
#include "tests/core/collide/allocations.h"
#include "tests/core/export/exported.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Holds its texts, so that nothing of the system's own asks for memory.
class Texts final : public FileAccess
{
public:
    void add(const QString &name) { m_texts.emplace(name.toStdString(), exampleText(name)); }

    [[nodiscard]] std::expected<std::string, std::string> read(const std::filesystem::path &path) const override
    {
        const auto found = m_texts.find(path.filename().string());
        if (found == m_texts.end()) {
            return std::unexpected("no such file");
        }
        return found->second;
    }

private:
    std::map<std::string, std::string> m_texts;
};

/// Takes what comes, and nothing of it.
class Nowhere final : public ByteSink
{
public:
    [[nodiscard]] std::expected<void, std::string> write(std::string_view bytes) override
    {
        count += bytes.size();
        return {};
    }
    std::size_t count = 0;
};

}

/// Where there is no memory, what was asked for ends with std::bad_alloc or an error, and nothing is lost or kept: each
/// allocation is made to fail once.
class TestFailedAllocations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readersGiveUp_data();
    void readersGiveUp();
    void exportersGiveUp_data();
    void exportersGiveUp();

private:
    static void failEach(const std::function<bool()> &isDone);
};

/// isDone tells whether all came out as it does with memory.
void TestFailedAllocations::failEach(const std::function<bool()> &isDone)
{
    QVERIFY(isDone()); // what is made once and kept
    const std::size_t before = bytesAllocated();
    const std::size_t count = allocationCount();
    QVERIFY(isDone());
    const std::size_t all = allocationCount() - count;
    QCOMPARE(bytesAllocated(), before);
    QVERIFY(all > 10);

    std::size_t thrown = 0;
    for (std::size_t i = 0; i < all; ++i) {
        failAllocation(i);
        bool isComplete = false;
        try {
            isComplete = isDone();
        } catch (const std::bad_alloc &) {
            ++thrown;
        }
        failAllocation(none);
        QVERIFY2(bytesAllocated() == before, qPrintable(QStringLiteral("%1 of %2 is lost").arg(i).arg(all)));
        // An algorithm that could do with more memory may do without.
        QVERIFY2(!isComplete || isDone(), qPrintable(QStringLiteral("%1 of %2").arg(i).arg(all)));
    }
    QVERIFY2(2 * thrown > all, qPrintable(QStringLiteral("%1 of %2 were heard of").arg(thrown).arg(all)));
    QVERIFY(isDone());
}

void TestFailedAllocations::readersGiveUp_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QStringList>("others");
    QTest::newRow("fractal") << "appendix-b.fdo" << QStringList{"FractalBase.obj"};
    QTest::newRow("mesh") << "ball.obj" << QStringList();
    QTest::newRow("scene") << "terrain.sdo" << QStringList{"terrain.fdo", "peak.obj", "lighthouse.obj", "ball.obj"};
}

void TestFailedAllocations::readersGiveUp()
{
    QFETCH(const QString, file);
    QFETCH(const QStringList, others);
    Texts files;
    for (const QString &other : others) {
        files.add(other);
    }
    const std::string text = exampleText(file);
    const std::string path = file.toStdString();
    failEach([&] {
        const SceneResult result = SceneLoader(files).load(path, text);
        return result.scene && result.diagnostics.empty();
    });
}

void TestFailedAllocations::exportersGiveUp_data()
{
    QTest::addColumn<int>("format");
    QTest::addColumn<bool>("isWelded");
    QTest::newRow("obj") << int(ExportFormat::Obj) << false;
    QTest::newRow("ply") << int(ExportFormat::Ply) << false;
    QTest::newRow("stl") << int(ExportFormat::Stl) << false;
    QTest::newRow("glb") << int(ExportFormat::Glb) << false;
    QTest::newRow("welded") << int(ExportFormat::Obj) << true;
}

void TestFailedAllocations::exportersGiveUp()
{
    QFETCH(const int, format);
    QFETCH(const bool, isWelded);
    const std::shared_ptr<const Scene> scene = menger(1);
    const ExportOptions options{.format = ExportFormat(format), .isWelded = isWelded};
    Nowhere whole;
    QVERIFY(exportScene(*scene, options, whole));
    failEach([&] {
        Nowhere sink;
        return exportScene(*scene, options, sink).has_value() && sink.count == whole.count;
    });
}

}

ROMANESCO_TEST(romanesco::test::TestFailedAllocations)

#include "testfailedallocations.moc"
