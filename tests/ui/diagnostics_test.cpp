// The charts by content: what is plotted is what was measured, in the suite's colour, with a mark where the suite changed.
#include "scripted_snapshots.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/charts/suite_legend.h"
#include "ui/theme/suite_style.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;
using engine::MetricsSample;

namespace {

Scene sceneWith(std::vector<MetricsSample> samples)
{
    auto snapshot = std::make_shared<engine::Snapshot>();
    snapshot->samples = std::move(samples);
    return Scene{snapshot};
}

} // namespace

class DiagnosticsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plotsWhatWasMeasured()
    {
        DiagnosticsPanel panel;
        panel.resize(1200, 240);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto first = samplesOf(0, 0, 20, SuiteId::ChaCha20Poly1305, 0);
        auto second = samplesOf(first.size(), 20, 40, SuiteId::Rc4, 1);
        panel.showScene(sceneWith(first));
        panel.showScene(sceneWith(second));
        panel.showScene(sceneWith(second)); // repeated samples count once
        panel.refresh();

        auto all = first;
        all.insert(all.end(), second.begin(), second.end());
        const ChartContent rate = panel.chart(0)->plotted();
        QCOMPARE(rate.runs.size(), std::size_t(2));
        QCOMPARE(rate.runs[0].color, suiteColor(SuiteId::ChaCha20Poly1305));
        QCOMPARE(rate.runs[1].color, suiteColor(SuiteId::Rc4));
        std::vector<QPointF> plotted(rate.runs[0].points.begin(),
                                     rate.runs[0].points.end() - 1); // the last one is where the next begins
        plotted.insert(plotted.end(), rate.runs[1].points.begin(), rate.runs[1].points.end());
        QCOMPARE(plotted.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            QCOMPARE(plotted[i].x(), all[i].time - all.back().time);
            QCOMPARE(plotted[i].y(), all[i].openedFramesPerSecond);
        }
        QCOMPARE(rate.marks.size(), std::size_t(1));
        QCOMPARE(rate.marks[0].x, 20 - all.back().time);
        QVERIFY(rate.marks[0].text.contains(QStringLiteral("RC4 (insecure)")));

        const ChartContent loss = panel.chart(1)->plotted();
        QCOMPARE(loss.runs.size(), std::size_t(4)); // both directions
        QCOMPARE(loss.runs[3].points.back().y(), all.back().peerLossPercent);
        QVERIFY(loss.runs[3].dashed);
        const ChartContent cpu = panel.chart(2)->plotted();
        QCOMPARE(cpu.runs[1].points.back().y(), all.back().processCpuPercent);
        QCOMPARE(cpu.runs[3].points.back().y(), all.back().suiteCpuPercent);

        const QStringList legend = panel.findChild<SuiteLegend *>()->names();
        QCOMPARE(legend, (QStringList{QStringLiteral("ChaCha20-Poly1305"), QStringLiteral("RC4 (insecure)")}));
    }

    void axisHoldsStill()
    {
        AxisScale scale(10);
        QCOMPARE(scale.update(62, 0), 100.0);
        QCOMPARE(scale.update(90, 1), 100.0);
        QCOMPARE(scale.update(101, 2), 200.0);
        QCOMPARE(scale.update(30, 3), 200.0);
        QCOMPARE(scale.update(30, 12), 200.0);
        QCOMPARE(scale.update(90, 12.5), 200.0); // high again: the wait begins anew
        QCOMPARE(scale.update(30, 13), 200.0);
        QCOMPARE(scale.update(30, 23), 50.0);
        QCOMPARE(scale.update(0, 40), 50.0);
        QCOMPARE(scale.update(0, 50), 10.0);
    }

    void thinningKeepsPeaks()
    {
        SampleHistory history;
        auto samples = samplesOf(0, 0, 600, SuiteId::Aes256Gcm, 0);
        samples[1000].openedFramesPerSecond = 999;
        samples[1500].openedFramesPerSecond = 1;
        history.take(samples);
        const ChartContent content
            = buildChart(history, {{[](const MetricsSample &s) { return s.openedFramesPerSecond; }}}, 600, 300);
        std::size_t points = 0;
        double low = 1e9;
        for (const ChartRun &run : content.runs)
            for (const QPointF &point : run.points) {
                ++points;
                low = std::min(low, point.y());
            }
        QVERIFY(points <= 300);
        QCOMPARE(highestOf(content), 999.0);
        QCOMPARE(low, 1.0);
    }

    void aSilentLinkBreaksTheLine()
    {
        SampleHistory history;
        auto samples = samplesOf(0, 0, 10, SuiteId::Aes256Gcm, 0);
        for (std::size_t i = 16; i < 24; ++i)
            samples[i].openedFramesPerSecond = vehicle::kUnknown;
        history.take(samples);
        const ChartContent content
            = buildChart(history, {{[](const MetricsSample &s) { return s.openedFramesPerSecond; }}}, 60, 1000);
        QCOMPARE(content.runs.size(), std::size_t(2));
        QVERIFY(content.marks.empty());
    }

    void historyIsBounded()
    {
        SampleHistory history;
        history.take(samplesOf(0, 0, 2000, SuiteId::Aes256Gcm, 0));
        QVERIFY(history.samples().size() <= 2401);
        QVERIFY(history.samples().back().time > 1999);
    }

    void hiddenChartsAreNotDrawn()
    {
        DiagnosticsPanel panel;
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.hide();
        panel.showScene(sceneWith(samplesOf(0, 0, 20, SuiteId::ChaCha20, 0)));
        QVERIFY(!panel.findChild<QTimer *>()->isActive());
        QVERIFY(panel.chart(0)->plotted().runs.empty());
        panel.show();
        QTRY_COMPARE(panel.chart(0)->plotted().runs.size(), std::size_t(1));
    }
};

QTEST_MAIN(DiagnosticsTest)
#include "diagnostics_test.moc"
