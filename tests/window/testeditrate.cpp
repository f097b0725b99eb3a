// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>

#include <QElapsedTimer>

#include "app/window/texttab.h"
#include "app/window/texttabs.h"
#include "windowsample.h"

using namespace romanesco;
using Sample = romanesco::test::WindowSample;

namespace {

constexpr int editInterval = 10; // ms

/// Types a digit and takes it away again, a hundred times a second, and writes down when each edit was made, read on the
/// screen, and seen in the picture.
class Typist : public QObject
{
public:
    Typist(Sample &sample, int edits)
        : m_sample(sample)
        , m_tabs(*sample.window.findChild<TextTabs *>())
        , m_edits(edits)
        , m_firstRevision(m_tabs.current().preview().revision)
        , m_drawn(m_firstRevision)
    {
        m_sample.visibleEditor().viewport()->installEventFilter(this);
        connect(&m_sample.viewport, &Viewport::pictureAdvanced, this,
                [this] { m_drawn = m_tabs.current().preview().revision; });
        connect(&m_tabs.current(), &TextTab::previewed, this, [this] { ++m_built; });
        connect(&m_sample.viewport, &QOpenGLWidget::frameSwapped, this, &Typist::see);
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, &Typist::edit);
        m_clock.start();
        m_timer.start(editInterval);
    }
    [[nodiscard]] bool isDone() const { return !m_timer.isActive() && m_seen.size() == m_made.size(); }

    /// Edits that were not painted before the next but one was read.
    int lateEdits = 0;

    void print() const
    {
        qInfo("%d edits in %.1f s, %d of which were built; from the key to the screen:", int(m_made.size()),
              double(m_made.back()) / 1e9, m_built);
        print("text", m_painted);
        print("picture", m_seen);
    }

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::Paint) {
            m_painted.resize(m_made.size(), m_clock.nsecsElapsed());
        }
        return false;
    }

private:
    void edit()
    {
        lateEdits += m_painted.size() + 1 < m_made.size() ? 1 : 0;
        m_made.push_back(m_clock.nsecsElapsed());
        const bool isEven = m_made.size() % 2 == 0;
        QTest::keyClick(&m_sample.visibleEditor(), isEven ? Qt::Key_Backspace : Qt::Key_1);
        if (int(m_made.size()) == m_edits) {
            m_timer.stop();
        }
    }

    /// A picture of a text shows all edits up to that.
    void see()
    {
        // each edit is built, or left out for a newer one
        m_seen.resize(m_drawn - m_firstRevision, m_clock.nsecsElapsed());
    }

    void print(const char *what, const std::vector<qint64> &when) const
    {
        std::vector<double> latencies;
        for (std::size_t i = 0; i < when.size(); ++i) {
            latencies.push_back(double(when[i] - m_made[i]) / 1e6);
        }
        std::ranges::sort(latencies);
        const auto at = [&](double share) { return latencies[std::size_t(share * double(latencies.size() - 1))]; };
        qInfo("  %-8s median %.1f ms, 95 %% %.1f ms, 99 %% %.1f ms, all %.1f ms", what, at(0.5), at(0.95), at(0.99),
              at(1.0));
    }

    Sample &m_sample;
    TextTabs &m_tabs;
    int m_edits;
    int m_built = 0;
    quint64 m_firstRevision;
    /// Of the text that the picture is of.
    quint64 m_drawn;
    QTimer m_timer;
    QElapsedTimer m_clock;
    /// In nanoseconds.
    std::vector<qint64> m_made;
    std::vector<qint64> m_painted;
    std::vector<qint64> m_seen;
};

}

/// A hundred edits a second: the text keeps up, and the newest wins in the picture.
class TestEditRate : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theNewestTextWins();
};

void TestEditRate::theNewestTextWins()
{
    const int seconds = qEnvironmentVariableIntValue("ROMANESCO_TEST_SECONDS");
    const int edits = 100 * std::max(seconds, 1);
    Sample sample;
    QVERIFY(sample.waitForPicture());
    sample.placeCursorAt(QStringLiteral("66"));
    TextTab &tab = sample.window.findChild<TextTabs *>()->current();
    const quint64 before = tab.preview().revision;
    Typist typist(sample, edits);
    QVERIFY(QTest::qWaitFor([&] { return typist.isDone(); }, 240'000));
    typist.print();
    QCOMPARE(typist.lateEdits, 0);
    QCOMPARE(tab.preview().revision, before + quint64(edits));
    QCOMPARE(tab.preview().text.bytes(), sample.editor.toPlainText().toStdString());
    QVERIFY(sample.waitForPicture());
    QCOMPARE(sample.viewport.view().surroundings()->scene, tab.shown());
}

int main(int argc, char **argv)
{
    return romanesco::test::runWithGl<TestEditRate>(argc, argv);
}
#include "testeditrate.moc"
