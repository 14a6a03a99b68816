// Cost of looking at the diagnostics: CPU time of the window's thread while samples come as they do in flight, over the time
// that passes, once with the view in sight at its own refresh and once hidden, ten minutes of history behind it; less what the
// same snapshots take without a visible panel. The bound is a multiple of a reference drawing of the same size, painted in the
// same run, so that it holds on fast and slow machines.
#include "core/metrics/process_usage.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/charts/diagnostics_tools.h"

#include <QtCore/QElapsedTimer>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>

#include <algorithm>
#include <array>
#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;

namespace {

/// Reference drawings a second that a visible panel may cost; measured 5 to 10. Not of a debug build.
[[maybe_unused]] constexpr double kVisibleLimit = 16;
constexpr int kSeconds = 8;
constexpr double kHistory = 580;

/// Four samples a second in snapshots that come thirty times a second, as the station's do.
class WatchedFlight
{
public:
    explicit WatchedFlight(DiagnosticsPanel &panel) : m_panel(panel)
    {
        // The paper's four ciphers and two more, each for a while.
        const SuiteId suites[] = {SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm, SuiteId::Aes256Ctr,
                                  SuiteId::Aes256Cbc,        SuiteId::ChaCha20,  SuiteId::Rc4};
        for (std::uint32_t i = 0; i < 12; ++i) {
            const auto part = samplesOf(m_all.size(), kHistory * i / 12, kHistory * (i + 1) / 12, suites[i % 6], i);
            m_all.insert(m_all.end(), part.begin(), part.end());
        }
        const auto rest = samplesOf(m_all.size(), kHistory, kHistory + 4 * kSeconds, SuiteId::ChaCha20Poly1305, 12);
        m_sent = m_all.size();
        m_all.insert(m_all.end(), rest.begin(), rest.end());
        show(m_sent, 0);
    }

    /// CPU time of this thread in percent of one core over so many seconds of samples.
    double load(int duration, bool given = true)
    {
        QTimer snapshots;
        QElapsedTimer clock;
        const std::size_t before = m_sent;
        QObject::connect(&snapshots, &QTimer::timeout, [&] {
            m_sent = std::min(m_all.size(), before + static_cast<std::size_t>(clock.elapsed() / 250));
            show(m_sent, std::min<std::size_t>(m_sent, 40), given);
        });
        clock.start();
        const Duration cpu = metrics::threadCpuTime();
        snapshots.start(33);
        QEventLoop loop;
        QTimer::singleShot(duration * 1000, &loop, &QEventLoop::quit);
        loop.exec();
        return 100 * seconds(metrics::threadCpuTime() - cpu) / (static_cast<double>(clock.elapsed()) / 1000);
    }

private:
    /// The newest `last` of the first `count` samples; all of them for 0.
    void show(std::size_t count, std::size_t last, bool given = true)
    {
        auto snapshot = std::make_shared<engine::Snapshot>();
        const auto end = m_all.begin() + static_cast<std::ptrdiff_t>(count);
        snapshot->samples.assign(last ? end - static_cast<std::ptrdiff_t>(last) : m_all.begin(), end);
        if (given)
            m_panel.onSnapshot(ViewState{snapshot});
    }

    DiagnosticsPanel &m_panel;
    std::vector<engine::MetricsSample> m_all;
    std::size_t m_sent = 0;
};

/// CPU time of one drawing as a chart program does it plainly: a picture of that size, filled, with 24 antialiased lines of
/// 600 points; the median of 15.
double referenceDrawing(QSize size)
{
    QImage picture(size, QImage::Format_ARGB32_Premultiplied);
    std::array<double, 15> costs{};
    for (double &cost : costs) {
        const Duration before = metrics::threadCpuTime();
        picture.fill(Qt::white);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        for (int line = 0; line < 24; ++line) {
            QPolygonF points;
            for (int i = 0; i < 600; ++i)
                points << QPointF(i * size.width() / 600.0, size.height() * (0.5 + 0.3 * std::sin(0.05 * i + line)));
            painter.drawPolyline(points);
        }
        painter.end();
        cost = seconds(metrics::threadCpuTime() - before);
    }
    std::nth_element(costs.begin(), costs.begin() + costs.size() / 2, costs.end());
    return costs[costs.size() / 2];
}

} // namespace

class DiagnosticsCostTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void seenAndHidden_data();
    void seenAndHidden();
};

void DiagnosticsCostTest::seenAndHidden_data()
{
    QTest::addColumn<QString>("group");
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("view");
    const int lines = static_cast<int>(DiagnosticsView::TimeLine), overlay = static_cast<int>(DiagnosticsView::Overlay);
    const QSize docked(1200, 300), whole(1600, 1000);
    QTest::newRow("three charts, as it opens") << QStringLiteral("Overview") << docked << lines;
    QTest::newRow("six charts") << QStringLiteral("Cost") << docked << lines;
    QTest::newRow("all charts on a whole screen") << QStringLiteral("All") << whole << lines;
    QTest::newRow("all charts, suite over suite") << QStringLiteral("All") << whole << overlay;
}

void DiagnosticsCostTest::seenAndHidden()
{
    QFETCH(QString, group);
    QFETCH(QSize, size);
    QFETCH(int, view);
    DiagnosticsPanel panel;
    panel.resize(size);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel, test::kDeadlineMs));
    panel.findChild<QComboBox *>(QStringLiteral("chartGroup"))->setCurrentText(group);
    panel.findChild<DiagnosticsTools *>()->setView(static_cast<DiagnosticsView>(view));
    WatchedFlight flight(panel);
    const double seen = flight.load(kSeconds);
    panel.hide();
    const double hidden = flight.load(kSeconds);
    const double alone = flight.load(kSeconds, false);
    QVERIFY(panel.history().newest() > kHistory + 1.5 * kSeconds); // nothing was missed meanwhile
    const double drawing = 100 * referenceDrawing(size);           // percent of one core, at one a second
    qInfo("%s: seen %.2f %% of one core, hidden %.3f %%, the snapshots alone %.3f %%; %.2f reference drawings a second",
          QTest::currentDataTag(), seen, hidden, alone, (seen - alone) / drawing);
    QVERIFY(hidden - alone < 0.1 * drawing);
#ifdef NDEBUG
    QVERIFY(seen - alone < kVisibleLimit * drawing);
#endif
}

SKYSEAL_TEST_WIDGETS(DiagnosticsCostTest)
#include "diagnostics_cost_test.moc"
