// The page of a sweep without a station: the ratios to plain MAVLink with their 95 % intervals are what it shows first, in
// the table and as bars, and the means by choice; what disturbed the runs, and the measurement's own share, stand above
// them. A picture is kept in the folder that SKYSEAL_PICTURES names.
#include "core/experiment/analysis.h"
#include "core/experiment/disturbances.h"
#include "core/experiment/report_warnings.h"
#include "tests/support/test_runner.h"
#include "ui/sweep/sweep_bars.h"
#include "ui/sweep/sweep_labels.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_table_model.h"

#include <QtTest/QAbstractItemModelTester>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QTableView>

#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;
using experiment::Metric;

namespace {

/// Plain MAVLink costs 1000 ns a frame, each suite a twentieth more than the one before; blocks differ by more than that.
experiment::Sample measured(const experiment::Run &run)
{
    experiment::Sample out;
    out.run = run;
    const double block = 1 + 0.2 * run.repeat, noise = 1 + 0.004 * static_cast<double>((run.repeat * 2 + run.arm) % 3);
    out.values[Metric::CpuPerFrame] = 1000 * (1 + 0.05 * static_cast<double>(run.arm)) * block * noise;
    out.values[Metric::Latency] = 1.2 * noise;
    out.values[Metric::Packets] = 500;
    out.values[Metric::Loss] = 0;
    return out;
}

experiment::Plan planned(unsigned repeats)
{
    experiment::Plan out;
    out.arms = {{SuiteId::None}, {SuiteId::Aes256Gcm}, {SuiteId::ChaCha20Poly1305}, {SuiteId::Rc4}};
    out.repeats = repeats;
    return out;
}

/// The page after all runs.
std::unique_ptr<SweepPage> pageAfter(const experiment::Plan &plan)
{
    auto page = std::make_unique<SweepPage>();
    page->resize(1000, 320);
    page->begin(plan);
    for (const experiment::Run &run : experiment::schedule(plan))
        page->take(measured(run), {});
    auto results = std::make_shared<experiment::Results>(*page->results());
    results->complete = true;
    page->finish(results, {});
    page->show();
    return page;
}

QComboBox *shownBy(const SweepPage &page)
{
    return page.findChild<QComboBox *>(QStringLiteral("sweepShown"));
}

} // namespace

class SweepPageTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ratiosAreTheResult();
    void singleRunsHaveMeans();
    void disturbancesAreShownAsInTheReport();
    void manyWarningsLeaveRoomForTheResults();
};

void SweepPageTest::ratiosAreTheResult()
{
    const auto page = pageAfter(planned(5));
    auto *model = qobject_cast<SweepTableModel *>(page->findChild<QTableView *>(QStringLiteral("sweepTable"))->model());
    const QAbstractItemModelTester tester(model);
    QCOMPARE(shownBy(*page)->currentText(), QStringLiteral("Ratios to plain MAVLink"));
    // Packets are the vehicle's, and shares are no ratios.
    QCOMPARE(model->metrics(), std::vector<Metric>({Metric::CpuPerFrame, Metric::Latency}));
    const auto ratios = experiment::plannedContrasts(*page->results(), 0, 0, Metric::CpuPerFrame);
    const experiment::BarChart &bars = page->findChild<SweepBars *>()->chart();
    QCOMPARE(bars.axis, std::string("CPU time per frame, station: Ratios to plain MAVLink"));
    for (int row = 0; row < 4; ++row) {
        const QModelIndex cell = model->index(row, SweepTableModel::FixedColumns);
        const auto arm = static_cast<std::size_t>(row);
        if (row == 0) {
            QCOMPARE(cell.data().toString(), QStringLiteral("1"));
            QCOMPARE(bars.bars[arm].mean, 1.0);
            continue;
        }
        const experiment::Contrast &ratio = ratios[arm - 1];
        QCOMPARE(ratio.second, arm);
        QVERIFY(std::abs(ratio.value() - (1 + 0.05 * row)) < 0.01 && ratio.low() < ratio.high());
        QCOMPARE(cell.data(SweepTableModel::ValueRole).toDouble(), ratio.value());
        QCOMPARE(cell.data().toString(), ratioText(ratio));
        QVERIFY(cell.data().toString().contains(QLatin1String(" to ")));
        QCOMPARE(bars.bars[arm].low, ratio.low());
        QCOMPARE(bars.bars[arm].high, ratio.high());
    }
    if (const QString folder = qEnvironmentVariable("SKYSEAL_PICTURES"); !folder.isEmpty())
        page->grab().save(folder + QStringLiteral("/sweep-ratios.png"));
    shownBy(*page)->setFocus();
    QTest::keyClick(shownBy(*page), Qt::Key_Down);
    QCOMPARE(shownBy(*page)->currentText(), QStringLiteral("Means"));
    QVERIFY(model->metrics().size() > 2);
    QVERIFY(page->findChild<SweepBars *>()->chart().bars[0].samples.size() == 5);
}

/// A ratio takes two runs of each suite.
void SweepPageTest::singleRunsHaveMeans()
{
    const auto page = pageAfter(planned(1));
    QCOMPARE(shownBy(*page)->currentText(), QStringLiteral("Means"));
    auto *model = qobject_cast<SweepTableModel *>(page->findChild<QTableView *>(QStringLiteral("sweepTable"))->model());
    QVERIFY(model->metrics().size() > 2);
    shownBy(*page)->setFocus();
    QTest::keyClick(shownBy(*page), Qt::Key_Up);
    QCOMPARE(model->index(1, SweepTableModel::FixedColumns).data().toString(), QStringLiteral("–"));
    QVERIFY(std::isnan(page->findChild<SweepBars *>()->chart().bars[1].mean));
}

/// Run after run while the sweep goes on, and the sentences of the report's first page at its end.
void SweepPageTest::disturbancesAreShownAsInTheReport()
{
    const experiment::Plan plan = planned(2);
    SweepPage page;
    page.resize(1000, 320);
    page.show();
    auto *notes = page.findChild<QLabel *>(QStringLiteral("sweepNotes"));
    page.begin(plan);
    QVERIFY(!notes->isVisible());
    std::size_t taken = 0;
    for (const experiment::Run &run : experiment::schedule(plan)) {
        experiment::Sample sample = measured(run);
        sample.values[Metric::MeterCpu] = 0.4;
        if (taken == 1) {
            sample.values[Metric::Steal] = 7;
            sample.values[Metric::OtherCpu] = 35;
        }
        if (taken == 2)
            sample.values[Metric::FrequencyChange] = 12;
        page.take(sample, {});
        ++taken;
        QVERIFY(notes->isVisible());
        QCOMPARE(notes->text().contains(QLatin1String("the hypervisor took up to 7 % of a core (1 run)")), taken > 1);
        QCOMPARE(notes->text().contains(QLatin1String("incomplete")), false);
    }
    auto results = std::make_shared<experiment::Results>(*page.results());
    results->complete = true;
    page.finish(results, {});
    const QString text = notes->text();
    for (const Reason &warning : experiment::reportWarnings(*results))
        QVERIFY2(text.contains(QString::fromStdString(warning.text())), warning.text().c_str());
    QVERIFY(!experiment::disturbedRuns(*results).empty());
    QVERIFY(text.contains(QString::fromStdString(experiment::disturbedRuns(*results).text())));
    QVERIFY(text.contains(QLatin1String("2 of 8 runs were disturbed")));
    QVERIFY(text.contains(QLatin1String("the frequency of the cores differed by up to 12 %")));
    QVERIFY(text.contains(QString::fromStdString(experiment::meterText(*results).text())));
    QVERIFY(text.contains(QLatin1String("up to 0.4 % under the natural load (meter_cpu)")));
    page.begin(plan); // those of the sweep before are gone
    QVERIFY(!notes->isVisible());
    QVERIFY(notes->text().isEmpty());
}

void SweepPageTest::manyWarningsLeaveRoomForTheResults()
{
    const experiment::Plan plan = planned(2);
    SweepPage page;
    page.resize(700, 320);
    page.show();
    page.begin(plan);
    for (const experiment::Run &run : experiment::schedule(plan)) {
        experiment::Sample sample = measured(run);
        for (const Metric metric : {Metric::OtherCpu, Metric::Steal, Metric::Preemptions, Metric::AgentPreemptions,
                                    Metric::FrequencyChange, Metric::LoadBegin, Metric::LoadEnd, Metric::SimulatorCpu})
            sample.values[metric] = 120;
        page.take(sample, {});
    }
    QApplication::processEvents(); // the layout
    const auto *status = page.findChild<QLabel *>(QStringLiteral("sweepStatus"));
    QVERIFY(status->width() > page.width() - 20); // beside the lists it would be cut
    const auto *area = page.findChild<QScrollArea *>(QStringLiteral("sweepNoteArea"));
    QVERIFY(area->height() < page.height() / 3);
    QVERIFY(area->widget()->height() > area->height()); // the rest is scrolled to
    QVERIFY(page.findChild<QTableView *>(QStringLiteral("sweepTable"))->height() > page.height() / 3);
}

SKYSEAL_TEST_WIDGETS(SweepPageTest)
#include "sweep_page_test.moc"
