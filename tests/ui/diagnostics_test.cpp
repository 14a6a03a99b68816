// The content of the charts: measured values in the suite's colour with marks for events, the overlay, bars and table, and the
// saved files.
#include "core/experiment/cipher_bench.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/test_runner.h"
#include "ui/charts/chart_cursor.h"
#include "ui/charts/chart_view.h"
#include "ui/charts/chart_text.h"
#include "ui/charts/diagnostics_panel.h"
#include "ui/charts/quantities.h"
#include "ui/charts/samples_csv.h"
#include "ui/charts/suite_legend.h"
#include "ui/dialogs/help_dialog.h"
#include "ui/theme/palettes.h"
#include "ui/theme/suite_style.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QTableView>
#include <QtWidgets/QTextBrowser>

#include <numeric>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;
using engine::MetricsSample;

namespace {

ViewState viewWith(std::vector<MetricsSample> samples)
{
    auto snapshot = std::make_shared<engine::Snapshot>();
    snapshot->samples = std::move(samples);
    return ViewState{snapshot};
}

std::vector<MetricsSample> twoSuites()
{
    auto all = samplesOf(0, 0, 20, SuiteId::ChaCha20Poly1305, 0);
    const auto second = samplesOf(all.size(), 20, 40, SuiteId::Rc4, 1);
    all.insert(all.end(), second.begin(), second.end());
    return all;
}

/// Mean of a figure over those samples of a suite that are counted: not the first second after a change.
double meanOf(const std::vector<MetricsSample> &samples, SuiteId suite, double MetricsSample::*figure)
{
    double sum = 0;
    int count = 0, since = 0;
    for (const MetricsSample &sample : samples) {
        if (sample.suite != suite)
            continue;
        if (since++ >= SuiteHistory::kSettling) {
            sum += sample.*figure;
            ++count;
        }
    }
    return sum / count;
}

} // namespace

class DiagnosticsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_panel = std::make_unique<DiagnosticsPanel>();
        m_panel->resize(1200, 240);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get(), test::kDeadlineMs));
    }

    void cleanup() { m_panel.reset(); }

    void saysWhatToDoWithoutAVehicle()
    {
        auto *empty = m_panel->findChild<QLabel *>(QStringLiteral("chartsEmpty"));
        QVERIFY(empty && empty->isVisible() && empty->text().startsWith(QStringLiteral("Connect to a vehicle")));
        auto all = twoSuites();
        auto unheard = all;
        for (auto &sample : unheard)
            sample.linkUp = false;
        m_panel->onSnapshot(viewWith({unheard.begin(), unheard.begin() + 10}));
        QVERIFY(empty->isVisible()); // this program's own memory is no link
        m_panel->onSnapshot(viewWith(all));
        QVERIFY(!empty->isVisible() && m_panel->chart(0)->isVisible());
    }

    void plotsWhatWasMeasured()
    {
        const auto all = twoSuites();
        m_panel->onSnapshot(viewWith({all.begin(), all.begin() + 80}));
        m_panel->onSnapshot(viewWith(all)); // repeated samples count once
        m_panel->refresh();

        const ChartContent rate = m_panel->chart(0)->plotted();
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

        const ChartContent loss = m_panel->chart(1)->plotted();
        QCOMPARE(loss.runs.size(), std::size_t(4)); // both directions
        QCOMPARE(loss.runs[3].points.back().y(), all.back().peerLossPercent);
        QVERIFY(loss.runs[3].stroke == Stroke::Dashed);
        const ChartContent cpu = m_panel->chart(2)->plotted();
        QCOMPARE(cpu.runs[1].points.back().y(), all.back().processCpuPercent);
        QCOMPARE(cpu.runs[5].points.back().y(), all.back().suiteCpuPercent);
        QVERIFY(cpu.runs[5].stroke == Stroke::Dotted);

        const QStringList legend = m_panel->findChild<SuiteLegend *>()->names();
        QCOMPARE(legend, (QStringList{QStringLiteral("ChaCha20-Poly1305"), QStringLiteral("RC4 (insecure)")}));
    }

    void everyQuantityPlotsItsSample()
    {
        const auto all = samplesOf(0, 0, 10, SuiteId::Aes256Gcm, 0);
        m_panel->onSnapshot(viewWith(all));
        choose("chartGroup", QStringLiteral("All"));
        const std::vector<Quantity> quantities = allQuantities();
        QCOMPARE(m_panel->chartCount(), static_cast<int>(quantities.size()));
        const MetricsSample &last = all.back();
        const std::pair<const char *, std::vector<double>> expected[] = {
            {"byteRate", {last.openedBytesPerSecond / 1e3, last.rxBytesPerSecond / 1e3}},
            {"overhead", {55, 80}},
            {"mavlinkLoss", {last.mavlinkLossPercent, last.peerMavlinkLossPercent}},
            {"power", {last.powerWatts}},
            {"latency", {last.latency * 1e3, last.roundTrip * 1e3}},
            {"openCost", {last.openNsP50 / 1e3, last.openNsP99 / 1e3, last.openNextNsP50 / 1e3}},
            {"sealCost", {last.sealNsP50 / 1e3, last.sealNsP99 / 1e3}},
            {"memory", {92}}};
        for (const auto &[key, values] : expected) {
            const auto *chart = m_panel->findChild<TimeSeriesChart *>(QStringLiteral("chart_") + QLatin1String(key));
            QVERIFY2(chart, key);
            const ChartContent content = chart->plotted();
            QCOMPARE(content.runs.size(), values.size());
            for (std::size_t i = 0; i < values.size(); ++i)
                QVERIFY2(qFuzzyCompare(content.runs[i].points.back().y(), values[i]), key);
            QVERIFY2(content.top >= highestOf(content), key);
        }
        for (const Quantity &quantity : quantities) { // every axis has a unit, every chart a description
            QVERIFY(!quantity.unit.isEmpty());
            QVERIFY(!quantity.note.isEmpty());
        }
    }

    /// One row of the table makes a chart, its columns of the CSV file and its paragraph of the help page.
    void everyQuantityIsInChartCsvAndHelp()
    {
        m_panel->onSnapshot(viewWith(twoSuites()));
        choose("chartGroup", QStringLiteral("All"));
        const QByteArray header = samplesCsv({}, 0, 0).trimmed();
        const QList<QByteArray> columns = header.split(',');
        QSet<QByteArray> expected{"number", "time_s", "suite", "insecure", "epoch", "link_up", "refused_so_far"};
        const HelpDialog help(QStringLiteral("diagnostics"), {{QStringLiteral("quantities"), quantitiesHelp()}});
        const QString page = help.findChild<QTextBrowser *>()->toPlainText();
        for (const Quantity &quantity : allQuantities()) {
            const auto *chart = m_panel->findChild<TimeSeriesChart *>(QStringLiteral("chart_") + QLatin1String(quantity.key));
            QVERIFY2(chart && chart->isVisibleTo(m_panel.get()), quantity.key);
            QCOMPARE(chart->accessibleName(), quantity.title);
            QVERIFY2(page.contains(QStringLiteral("%1 (%2): %3").arg(quantity.title, quantity.unit, quantity.note)),
                     quantity.key);
            for (const QuantityLine &line : quantity.lines)
                expected += line.value.column;
            for (const SampleValue &value : quantity.csvOnly)
                expected += value.column;
        }
        QCOMPARE(QSet<QByteArray>(columns.begin(), columns.end()), expected);
        QCOMPARE(columns.size(), expected.size()); // no two quantities share a column
        for (const QuantityGroup &group : quantityGroups())
            QVERIFY2(!group.keys.empty(), qPrintable(group.title));
    }

    void memoryOfASessionIsThatOfTheSuite()
    {
        m_panel->onSnapshot(viewWith(twoSuites()));
        choose("chartGroup", QStringLiteral("Cost"));
        const ChartContent memory = m_panel->findChild<TimeSeriesChart *>(QStringLiteral("chart_sessionMemory"))->plotted();
        QCOMPARE(memory.bars.size(), std::size_t(2));
        const SuiteId suites[] = {SuiteId::ChaCha20Poly1305, SuiteId::Rc4};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto bytes = experiment::sessionBytes(suites[i]); // measured a second time
            QVERIFY(bytes && *bytes > 1000);
            QVERIFY2(std::abs(memory.bars[i].mean * 1000 / *bytes - 1) < 0.05, qPrintable(QString::number(*bytes)));
            QVERIFY(std::abs(memory.runs[i].points.front().y() - memory.bars[i].mean)
                    < 1e-9); // the last one is where the next begins
        }
    }

    void powerIsShownOnlyWhereItCanBeRead()
    {
        const auto powerOf = [](const std::string &folder) { return allQuantities(folder).back(); };
        QCOMPARE(QLatin1String(powerOf("/nonexistent").key), QLatin1String("power"));
        QCOMPARE(powerOf("/nonexistent").remark, QStringLiteral("not readable here"));
        QVERIFY(powerOf("/nonexistent").note.contains(QStringLiteral("/nonexistent")));
        QTemporaryDir folder;
        const QString package = folder.filePath(QStringLiteral("class/powercap/intel-rapl:0"));
        QVERIFY(QDir().mkpath(package));
        for (const auto &[name, text] : {std::pair("name", "package-0\n"), std::pair("energy_uj", "5000\n")}) {
            QFile file(package + QLatin1Char('/') + QLatin1String(name));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) > 0);
        }
        QVERIFY(powerOf(folder.path().toStdString()).remark.isEmpty());
        QVERIFY(powerOf(folder.path().toStdString()).note.contains(QStringLiteral("package-0")));
    }

    void barsAreTheMeansOfTheSuites()
    {
        const auto all = twoSuites();
        m_panel->onSnapshot(viewWith(all));
        m_panel->refresh();
        const ChartContent rate = m_panel->chart(0)->plotted();
        QCOMPARE(rate.bars.size(), std::size_t(2));
        QCOMPARE(rate.bars[1].suite, QStringLiteral("RC4 (insecure)"));
        QCOMPARE(rate.bars[1].color, suiteColor(SuiteId::Rc4));
        QCOMPARE(rate.bars[1].samples, std::uint64_t(80 - SuiteHistory::kSettling));
        QCOMPARE(rate.bars[1].mean, meanOf(all, SuiteId::Rc4, &MetricsSample::openedFramesPerSecond));
        QVERIFY(rate.bars[1].low < rate.bars[1].mean && rate.bars[1].mean < rate.bars[1].high);
        choose("chartGroup", QStringLiteral("Cost"));
        QVERIFY(m_panel->findChild<TimeSeriesChart *>(QStringLiteral("chart_memory"))->plotted().bars.empty());
        const ChartContent cpu = m_panel->findChild<TimeSeriesChart *>(QStringLiteral("chart_cpu"))->plotted();
        QCOMPARE(cpu.bars.size(), std::size_t(2));
        QCOMPARE(cpu.bars[1].mean, meanOf(all, SuiteId::Rc4, &MetricsSample::suiteCpuPercent)); // not of the process
    }

    void overlayShowsAllSuites()
    {
        auto all = twoSuites();
        const auto again = samplesOf(all.size(), 40, 50, SuiteId::ChaCha20Poly1305, 2);
        all.insert(all.end(), again.begin(), again.end());
        m_panel->onSnapshot(viewWith(all));
        choose("chartView", QStringLiteral("Suites overlaid"));
        const ChartContent rate = m_panel->chart(0)->plotted();
        QVERIFY(rate.time == ChartTime::InUse);
        QVERIFY(rate.marks.empty());
        QCOMPARE(rate.runs.size(), std::size_t(3)); // one suite was in use twice
        QCOMPARE(rate.runs[0].points.front().x(), 0.0);
        QCOMPARE(rate.runs[0].points.size(), std::size_t(80));
        QCOMPARE(rate.runs[1].suite, QStringLiteral("ChaCha20-Poly1305"));
        QCOMPARE(rate.runs[1].points.front().x(), 19.75); // its second use goes on where the first one ended
        QCOMPARE(rate.runs[1].points.back().y(), all.back().openedFramesPerSecond);
        QCOMPARE(rate.runs[2].suite, QStringLiteral("RC4 (insecure)"));
        QCOMPARE(rate.runs[2].points.front().x(), 0.0);
    }

    void tableMatchesTheBars()
    {
        const auto all = twoSuites();
        m_panel->onSnapshot(viewWith(all));
        choose("chartView", QStringLiteral("Table"));
        const auto *table = m_panel->findChild<QTableView *>(QStringLiteral("suiteTable"));
        QVERIFY(table->isVisible());
        const QAbstractItemModel *model = table->model();
        QCOMPARE(model->rowCount(), 2);
        QCOMPARE(model->index(1, 0).data().toString(), QStringLiteral("RC4 (insecure)"));
        QCOMPARE(model->index(1, 1).data().toString(), QStringLiteral("00:19"));
        QCOMPARE(model->index(1, 2).data().toDouble(),
                 std::round(meanOf(all, SuiteId::Rc4, &MetricsSample::openedFramesPerSecond) * 10) / 10);
        for (int column = 0; column < model->columnCount(); ++column)
            QVERIFY(!model->headerData(column, Qt::Horizontal).toString().contains(QStringLiteral("MB resident")));
    }

    void costOfWatchingIsSaid()
    {
        auto *watching = m_panel->findChild<QLabel *>(QStringLiteral("watchingCost"));
        QVERIFY(watching && !watching->isVisible()); // nothing was measured
        auto all = twoSuites();
        for (auto &sample : all) {
            sample.ioCpuPercent = 1.5;
            sample.watchingCpuPercent = 0.4;
        }
        m_panel->onSnapshot(viewWith(all));
        m_panel->refresh();
        QVERIFY(watching->isVisible());
        QCOMPARE(watching->text(), QStringLiteral("CPU of the link thread: 1.50 % of a core, of it watching: 0.40 %"));
        QVERIFY(watching->toolTip().contains(QStringLiteral("“link” and “process” contain it")));
        auto *group = m_panel->findChild<QComboBox *>(QStringLiteral("chartGroup"));
        group->setCurrentText(QStringLiteral("Rates")); // no CPU load
        QVERIFY(!watching->isVisible());
        group->setCurrentText(QStringLiteral("Cost"));
        QVERIFY(watching->isVisible());
        m_panel->findChild<QComboBox *>(QStringLiteral("chartView"))->setCurrentText(QStringLiteral("Table"));
        QVERIFY(!watching->isVisible());
        // Frozen charts, and what is said below them, stay.
        m_panel->findChild<QComboBox *>(QStringLiteral("chartView"))->setCurrentText(QStringLiteral("Over time"));
        m_panel->findChild<QCheckBox *>(QStringLiteral("chartFreeze"))->setChecked(true);
        auto later = all;
        later.push_back(all.back());
        later.back().number = all.back().number + 1;
        later.back().time = all.back().time + 0.25;
        later.back().watchingCpuPercent = 0.9;
        m_panel->onSnapshot(viewWith(later));
        m_panel->refresh();
        QVERIFY(watching->text().endsWith(QStringLiteral("0.40 %")));
        m_panel->findChild<QCheckBox *>(QStringLiteral("chartFreeze"))->setChecked(false);
        QVERIFY(watching->text().endsWith(QStringLiteral("0.90 %")));
    }

    void incidentsAreMarked()
    {
        auto all = samplesOf(0, 0, 30, SuiteId::Aes256Gcm, 0);
        for (std::size_t i = 40; i < all.size(); ++i)
            all[i].refused = i < 44 ? i - 39 : 4; // one incident of four
        for (std::size_t i = 80; i < 100; ++i)
            all[i].linkUp = false;
        for (std::size_t i = 60; i < all.size(); ++i)
            all[i].epoch = 1;
        m_panel->onSnapshot(viewWith(all));
        m_panel->refresh();
        const auto marks = m_panel->chart(0)->plotted().marks;
        QCOMPARE(marks.size(), std::size_t(4));
        QVERIFY(marks[0].incident);
        QVERIFY(marks[0].text.startsWith(QStringLiteral("4 forged")));
        QCOMPARE(marks[0].color, stateColors(m_panel->palette()).alarm);
        QCOMPARE(marks[0].x, 10 - all.back().time);
        QVERIFY(!marks[1].incident);
        QVERIFY(marks[1].text.contains(QStringLiteral("epoch 1")));
        QCOMPARE(marks[2].text, QStringLiteral("link lost"));
        QCOMPARE(marks[3].text, QStringLiteral("link recovered"));
    }

    void hoverTellsTheValues()
    {
        const auto all = twoSuites();
        m_panel->onSnapshot(viewWith(all));
        m_panel->refresh();
        Q_EMIT m_panel->chart(0)->hovered(-10);
        const MetricsSample &there = all[all.size() - 41];
        QCOMPARE(there.time - all.back().time, -10.0);
        for (int i = 0; i < 3; ++i)
            QVERIFY(!m_panel->chart(i)->cursorText().isEmpty()); // one cursor for all
        const QStringList loss = m_panel->chart(1)->cursorText();
        QVERIFY2(loss[0].contains(QStringLiteral("RC4 (insecure)")), qPrintable(loss.join(QLatin1Char('|'))));
        QVERIFY(loss.contains(QStringLiteral("from vehicle ") + QString::number(there.lossPercent, 'f', 3)));
        QVERIFY(loss.contains(QStringLiteral("to vehicle ") + QString::number(there.peerLossPercent, 'f', 3)));
        Q_EMIT m_panel->chart(0)->hoverEnded();
        QVERIFY(m_panel->chart(0)->cursorText().isEmpty());
        Q_EMIT m_panel->chart(0)->hovered(20 - all.back().time);
        QVERIFY(m_panel->chart(0)->cursorText().last().contains(QStringLiteral("RC4 (insecure)"))); // the mark
    }

    void cursorTextAvoidsTheCurves()
    {
        m_panel->onSnapshot(viewWith(samplesOf(0, 0, 130, SuiteId::Aes256Gcm, 0)));
        m_panel->refresh();
        for (int i = 0; i < 3; ++i) {
            TimeSeriesChart *chart = m_panel->chart(i);
            const auto *cursor = chart->findChild<ChartCursor *>();
            for (int x = -120; x <= 0; ++x) {
                Q_EMIT chart->hovered(x);
                const QRectF box = cursor->box();
                const qreal line = chart->findChild<ChartView *>()->plot().xOf(x);
                QVERIFY2(line < box.left() || line > box.right(), qPrintable(QStringLiteral("chart %1 at %2 s").arg(i).arg(x)));
                QVERIFY(cursor->rect().contains(box.toAlignedRect()));
            }
        }
        // A line at the top is left free, and one at the bottom.
        ChartCursor cursor(m_panel.get());
        cursor.resize(400, 100);
        const QRectF plot(0, 0, 400, 100);
        std::vector<QPointF> high, low;
        for (int x = 0; x <= 400; ++x) {
            high.emplace_back(x, 10);
            low.emplace_back(x, 90);
        }
        const QStringList words{QStringLiteral("69.0")};
        cursor.showAt(200, plot, words, high);
        QVERIFY(cursor.box().top() > 10);
        cursor.showAt(200, plot, words, low);
        QVERIFY(cursor.box().bottom() < 90);
        // Both are as good: it stays.
        const QRectF before = cursor.box();
        cursor.showAt(200, plot, words, {});
        QCOMPARE(cursor.box(), before);
    }

    void interruptedLineHasOneCursorValue()
    {
        // Two readings within a second of the cursor, with none between: two runs of one line.
        const QString suite = QStringLiteral("RC4 (insecure)");
        ChartContent content;
        content.time = ChartTime::InUse;
        content.to = 10;
        content.runs = {{Qt::red, Stroke::Solid, QStringLiteral("p50"), suite, {{4, 1}, {4.5, 2}, {5.2, 4}}},
                        {Qt::red, Stroke::Dotted, QStringLiteral("next p50"), suite, {{4, 1}, {4.5, 2}}},
                        {Qt::red, Stroke::Dotted, QStringLiteral("next p50"), suite, {{5.2, 3}}}};
        const QStringList words = chartTextAt(content, 4.9, 0.1, 1);
        const QStringList expected{QStringLiteral("4.9 s"), suite + QStringLiteral(": p50 4.0"),
                                   suite + QStringLiteral(": next p50 3.0")};
        QCOMPARE(words, expected);
    }

    void freezeStopsThePictureOnly()
    {
        auto all = samplesOf(0, 0, 20, SuiteId::Aes256Gcm, 0);
        m_panel->onSnapshot(viewWith(all));
        m_panel->refresh();
        const ChartContent before = m_panel->chart(0)->plotted();
        m_panel->findChild<QCheckBox *>(QStringLiteral("chartFreeze"))->click();
        const auto more = samplesOf(all.size(), 20, 30, SuiteId::Rc4, 1);
        m_panel->onSnapshot(viewWith(more));
        m_panel->refresh();
        const ChartContent frozen = m_panel->chart(0)->plotted();
        QCOMPARE(frozen.runs, before.runs);
        QVERIFY(frozen.marks.empty());
        QTest::keyClick(m_panel.get(), Qt::Key_Home);
        QVERIFY(!m_panel->range().frozen());
        QCOMPARE(m_panel->chart(0)->plotted().runs.size(), std::size_t(2)); // nothing was missed
    }

    void zoomByWheelKeysAndDrag()
    {
        m_panel->onSnapshot(viewWith(samplesOf(0, 0, 100, SuiteId::Aes256Gcm, 0)));
        m_panel->refresh();
        Q_EMIT m_panel->chart(0)->zoomRequested(1);
        QCOMPARE(m_panel->chart(2)->plotted().from, -60.0); // all charts show the same time
        QVERIFY(!m_panel->range().frozen());
        QTest::keyClick(m_panel.get(), Qt::Key_Minus);
        QCOMPARE(m_panel->chart(0)->plotted().from, -120.0);
        Q_EMIT m_panel->chart(1)->rangeRequested(-50, -20);
        QVERIFY(m_panel->findChild<QCheckBox *>(QStringLiteral("chartFreeze"))->isChecked());
        QCOMPARE(m_panel->chart(0)->plotted().from, -50.0);
        QCOMPARE(m_panel->chart(0)->plotted().to, -20.0);
        const ChartContent part = m_panel->chart(0)->plotted();
        QCOMPARE(part.runs.size(), std::size_t(1));
        for (const QPointF &point : part.runs[0].points)
            QVERIFY(point.x() >= -50 && point.x() <= -20);
        QTest::keyClick(m_panel.get(), Qt::Key_Right);
        QCOMPARE(m_panel->chart(0)->plotted().to, -12.5);
        for (int i = 0; i < 9; ++i)
            QTest::keyClick(m_panel.get(), Qt::Key_Right);
        QCOMPARE(m_panel->chart(0)->plotted().to, 0.0); // the future is not shown
        QTest::keyClick(m_panel.get(), Qt::Key_Escape);
        QCOMPARE(m_panel->chart(0)->plotted().from, -120.0); // as wide as it was before
    }

    void csvHoldsWhatIsShown()
    {
        QTemporaryDir folder;
        auto all = twoSuites();
        all[3].latency = vehicle::kUnknown;
        m_panel->onSnapshot(viewWith(all));
        m_panel->refresh();
        const QString file = folder.filePath(QStringLiteral("samples.csv"));
        QCOMPARE(m_panel->saveCsv(file), QString());
        QFile in(file);
        QVERIFY(in.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = in.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(all.size()) + 1);
        const QList<QByteArray> head = lines[0].trimmed().split(',');
        const auto cell = [&](std::size_t row, const char *name) {
            return lines[static_cast<qsizetype>(row) + 1].trimmed().split(',')[head.indexOf(name)];
        };
        for (std::size_t i = 0; i < all.size(); ++i) {
            QVERIFY(qFuzzyCompare(cell(i, "frames_per_s").toDouble(), all[i].openedFramesPerSecond));
            QVERIFY(qFuzzyCompare(1 + cell(i, "channel_loss_to_vehicle_percent").toDouble(), 1 + all[i].peerLossPercent));
            QVERIFY(
                qFuzzyCompare(1 + cell(i, "mavlink_loss_to_vehicle_percent").toDouble(), 1 + all[i].peerMavlinkLossPercent));
            QVERIFY(std::abs(cell(i, "processor_watts").toDouble() - all[i].powerWatts) < 1e-9);
        }
        QCOMPARE(cell(0, "suite"), QByteArray("chacha20-poly1305"));
        QCOMPARE(cell(0, "insecure"), QByteArray("0"));
        QCOMPARE(cell(100, "suite"), QByteArray("rc4"));
        QCOMPARE(cell(100, "insecure"), QByteArray("1"));
        QCOMPARE(cell(3, "latency_s"), QByteArray());
        Q_EMIT m_panel->chart(0)->rangeRequested(-10, -5);
        QCOMPARE(m_panel->saveCsv(file), QString());
        in.seek(0);
        QFile part(file);
        QVERIFY(part.open(QIODevice::ReadOnly));
        QCOMPARE(part.readAll().trimmed().split('\n').size(), qsizetype(21 + 1));
        QVERIFY(!m_panel->saveCsv(folder.filePath(QStringLiteral("no/such/folder.csv"))).isEmpty());
    }

    void fullDiskKeepsTheOldFiles()
    {
        QTemporaryDir folder;
        m_panel->onSnapshot(viewWith(twoSuites()));
        m_panel->refresh();
        for (const char *name : {"samples.csv", "picture.png", "picture.svg"}) {
            const QString path = folder.filePath(QLatin1String(name));
            QFile old(path);
            QVERIFY(old.open(QIODevice::WriteOnly) && old.write("good") == 4 && old.flush());
            const QString problem = [&] {
                const test::FileSizeLimit limit(10);
                return path.endsWith(QStringLiteral("csv")) ? m_panel->saveCsv(path) : m_panel->savePicture(path);
            }();
            QCOMPARE(problem, path + QStringLiteral(": cannot be written: File too large"));
            QCOMPARE(QFileInfo(path).size(), qint64(4));
        }
    }

    void picturesAreWritten()
    {
        QTemporaryDir folder;
        m_panel->onSnapshot(viewWith(twoSuites()));
        m_panel->refresh();
        const QString png = folder.filePath(QStringLiteral("p.png")), svg = folder.filePath(QStringLiteral("p.svg"));
        QCOMPARE(m_panel->savePicture(png), QString());
        const QImage image(png);
        QVERIFY(image.width() > 2000); // twice the screen's
        int coloured = 0;
        for (int x = 0; x < image.width(); ++x)
            for (int y = 0; y < image.height(); ++y)
                coloured += image.pixelColor(x, y) == suiteColor(SuiteId::Rc4);
        QVERIFY(coloured > 100);
        QCOMPARE(m_panel->savePicture(svg), QString());
        QFile in(svg);
        QVERIFY(in.open(QIODevice::ReadOnly));
        const QByteArray drawn = in.readAll();
        QVERIFY(drawn.contains("RC4 (insecure)"));
        QVERIFY(drawn.contains("<polyline") || drawn.contains("<path"));
        QVERIFY(!m_panel->savePicture(folder.filePath(QStringLiteral("no/such/folder.png"))).isEmpty());
        const QString unknown = folder.filePath(QStringLiteral("p.unknown"));
        QVERIFY(m_panel->savePicture(unknown).startsWith(unknown + QStringLiteral(" cannot be written as a picture: ")));
    }

    void axisHoldsStill()
    {
        AxisScale scale(10);
        QCOMPARE(scale.update(62, 0), 100.0);
        QCOMPARE(scale.update(90, 1), 100.0);
        QCOMPARE(scale.update(101, 2), 200.0);
        QCOMPARE(scale.update(30, 3), 200.0);
        QCOMPARE(scale.update(30, 12), 200.0);
        QCOMPARE(scale.update(90, 12.5), 200.0); // high again: the wait restarts
        QCOMPARE(scale.update(30, 13), 200.0);
        QCOMPARE(scale.update(30, 23), 50.0);
        QCOMPARE(scale.update(0, 40), 50.0);
        QCOMPARE(scale.update(0, 50), 10.0);
    }

    void axisEndsAtShortNumbers()
    {
        for (const double top : {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 2000.0})
            for (const double pixels : {60.0, 300.0}) {
                const double step = top / axisParts(top, pixels);
                const int places = decimalsOf(step);
                QVERIFY2(places <= (top < 0.1 ? 3 : top < 1 ? 2 : 1), qPrintable(QString::number(top)));
                QCOMPARE(QString::number(step, 'f', places).toDouble(), step);
            }
    }

    void thinningKeepsPeaks()
    {
        SampleHistory history;
        auto samples = samplesOf(0, 0, 600, SuiteId::Aes256Gcm, 0);
        samples[1000].openedFramesPerSecond = 999;
        samples[1500].openedFramesPerSecond = 1;
        history.take(samples);
        ChartRange range;
        range.setSpan(600);
        const ChartContent content = buildTimeLine(history, allQuantities().front(), range, 300);
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
        const ChartContent content = buildTimeLine(history, allQuantities().front(), {}, 1000);
        QCOMPARE(content.runs.size(), std::size_t(2));
    }

    void historyIsBounded()
    {
        SampleHistory history;
        history.take(samplesOf(0, 0, 2000, SuiteId::Aes256Gcm, 0));
        QVERIFY(history.samples().size() <= 2401);
        QVERIFY(history.samples().back().time > 1999);
        QVERIFY(history.suites().uses().front().points.size() <= 2401);
        QCOMPARE(history.suites().uses().front().tallies.front().count, std::uint64_t(8000 - SuiteHistory::kSettling));
        history.take(samplesOf(0, 0, 5, SuiteId::Rc4, 0)); // another station: the old one's figures go
        QCOMPARE(history.suites().uses().size(), std::size_t(1));
    }

    void hiddenChartsAreNotDrawn()
    {
        m_panel->hide();
        m_panel->onSnapshot(viewWith(samplesOf(0, 0, 20, SuiteId::ChaCha20, 0)));
        QVERIFY(!m_panel->findChild<QTimer *>()->isActive());
        QVERIFY(m_panel->chart(0)->plotted().runs.empty());
        m_panel->show();
        EVENTUALLY_EQUAL(m_panel->chart(0)->plotted().runs.size(), std::size_t(1));
    }

private:
    void choose(const char *box, const QString &text)
    {
        auto *choice = m_panel->findChild<QComboBox *>(QLatin1String(box));
        QVERIFY(choice->findText(text) >= 0);
        choice->setCurrentIndex(choice->findText(text));
    }

    std::unique_ptr<DiagnosticsPanel> m_panel;
};

SKYSEAL_TEST_WIDGETS(DiagnosticsTest)
#include "diagnostics_test.moc"
