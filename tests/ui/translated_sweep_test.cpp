// What the page of a sweep says of runs, machine and build is shown in the language of the window, to the last word, and so are
// the names of what was measured. The translation of this test leaves the values of each sentence and none of its words.
#include "core/experiment/load_check.h"
#include "core/experiment/measured_link.h"
#include "core/experiment/report_warnings.h"
#include "core/experiment/setting.h"
#include "tests/support/test_runner.h"
#include "ui/sweep/sweep_bars.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_table_model.h"

#include <QtCore/QRegularExpression>
#include <QtCore/QTranslator>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QTableView>

#include <algorithm>
#include <cmath>

using namespace skyseal;
using namespace skyseal::ui;
using crypto::SuiteId;
using experiment::Metric;

namespace {

class WordlessTranslation : public QTranslator
{
public:
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        if (qstrcmp(context, "Reason") != 0 && qstrcmp(context, "Metric") != 0)
            return {};
        static const QRegularExpression kMarker(QStringLiteral("%[1-9]"));
        QStringList markers;
        for (auto match = kMarker.globalMatch(QString::fromUtf8(source)); match.hasNext();)
            markers << match.next().captured();
        return QStringLiteral("‹%1›").arg(markers.join(QLatin1Char(' ')));
    }
    bool isEmpty() const override { return false; }
};

/// Every kind of note: a slow build on a busy machine, a sweep that ended early, a run that failed, one that is not valid, a
/// disturbed one, values that fall from run to run, and the share of the measurement.
experiment::Results notedResults()
{
    experiment::Results out;
    out.plan.arms = {{SuiteId::None}, {SuiteId::Aes256Gcm}, {SuiteId::Aes256Gcm, true}, {SuiteId::ChaCha20Poly1305}};
    out.plan.loads = {experiment::Load::Natural, experiment::Load::Saturated};
    out.plan.repeats = 6;
    out.setting = {{"build_flags", "-O1"}, {"cores", "2"}, {"load_average_at_start", "8.57 4.2 3.1 2/345 678"}};
    out.setting.emplace_back(
        "warning", "this build is " + experiment::buildWarning("-O1").text() + "; " + experiment::busyWarning(8.57, 2).text());
    for (const experiment::Run &run : experiment::schedule(out.plan)) {
        experiment::Sample sample;
        sample.run = run;
        sample.order = static_cast<unsigned>(out.samples.size());
        const double noise = 1 + 0.001 * (sample.order % 3);
        sample.values[Metric::CpuPerFrame] = 1000 * std::exp(-0.02 * sample.order) * noise;
        sample.values[Metric::MeterCpu] = 0.4;
        out.samples.push_back(sample);
    }
    out.samples.pop_back();
    out.samples[1].values[Metric::OtherCpu] = 35;
    out.samples[2].problem = experiment::MeasuredLink::kUnreadable;
    out.samples[3].values[Metric::Cpu] = 41;
    out.samples[3].invalid = experiment::loadProblem(experiment::Load::Saturated, out.samples[3].values);
    return out;
}

} // namespace

class TranslatedSweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QVERIFY(QCoreApplication::installTranslator(&m_translation));
        m_results = std::make_shared<experiment::Results>(notedResults());
        m_page = std::make_unique<SweepPage>();
        m_page->begin(m_results->plan);
        m_page->finish(m_results, {});
    }
    void cleanup()
    {
        m_page.reset();
        QCoreApplication::removeTranslator(&m_translation);
    }

    void noWordOfANoteIsLeft()
    {
        QString said = find<QLabel>("sweepNotes")->text();
        QCOMPARE(said.count(QLatin1Char('\n')) + 1, 7); // one line for each kind
        QVERIFY2(said.contains(QLatin1String("8.57 2")) && said.contains(QLatin1String("41")), qPrintable(said));
        for (const char *value : {"aes-256-gcm", "chacha20-poly1305", "-O1"})
            said.remove(QLatin1String(value));
        QVERIFY2(!said.contains(QRegularExpression(QStringLiteral("[A-Za-z]"))), qPrintable(said));
    }

    void whatWasMeasuredIsNamed()
    {
        const auto *model = qobject_cast<const SweepTableModel *>(find<QTableView>("sweepTable")->model());
        QVERIFY(model && model->columnCount() > SweepTableModel::FixedColumns);
        for (int column = SweepTableModel::FixedColumns; column < model->columnCount(); ++column)
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
                QCOMPARE(model->headerData(column, Qt::Horizontal, role).toString(), QStringLiteral("‹›"));
        const auto *metric = find<QComboBox>("sweepMetric");
        QVERIFY(metric->count() > 3);
        for (int i = 0; i < metric->count(); ++i)
            QCOMPARE(metric->itemText(i), QStringLiteral("‹›"));
        QVERIFY(m_page->findChild<SweepBars *>()->chart().axis.starts_with("‹›: "));

        find<QComboBox>("sweepShown")->setCurrentIndex(1); // the means, with units
        for (int i = 0; i < metric->count(); ++i)
            QVERIFY2(metric->itemText(i).startsWith(QStringLiteral("‹›")), qPrintable(metric->itemText(i)));
        QVERIFY(m_page->findChild<SweepBars *>()->chart().axis.starts_with("‹›"));
    }

    /// Reports and files are in English, whatever the language of the window.
    void reportsStayEnglish()
    {
        const std::vector<Reason> notes = experiment::reportWarnings(*m_results);
        QCOMPARE(notes.front().text(), experiment::settingOf(*m_results, "warning"));
        QCOMPARE(notes.front().text(),
                 std::string("this build is optimised by -O1 alone, as for tests: the figures are higher than those of a "
                             "release; the machine was busy with other work: load average 8.57 on 2 cores at the start; the "
                             "figures are noisier and may be wrong"));
        const auto isTrend = [](const Reason &note) {
            return note.text().starts_with("values change with the order of the runs within a launch, so that the warm-up was "
                                           "too short or the machine drifts: CPU time per frame, station, natural load, -")
                && note.text().ends_with(" % for each run");
        };
        QCOMPARE(std::ranges::count_if(notes, isTrend), 1);
    }

    /// What another version wrote into a file.
    void foreignWarningStaysAsItIs()
    {
        experiment::Results results = notedResults();
        results.setting.back().second = "the fan was loud";
        QCOMPARE(experiment::reportWarnings(results).front().text(), std::string("the fan was loud"));
        m_page->finish(std::make_shared<experiment::Results>(results), {});
        QVERIFY(find<QLabel>("sweepNotes")->text().startsWith(QLatin1String("The fan was loud.\n"))); // a sentence of its own
        results.setting.back().second = "was the fan loud?";
        m_page->finish(std::make_shared<experiment::Results>(results), {});
        QVERIFY(find<QLabel>("sweepNotes")->text().startsWith(QLatin1String("Was the fan loud?\n")));
    }

private:
    template<typename Widget> Widget *find(const char *name) const
    {
        auto *found = m_page->findChild<Widget *>(QLatin1String(name));
        if (!found)
            qFatal("there is no %s", name);
        return found;
    }

    WordlessTranslation m_translation;
    std::shared_ptr<experiment::Results> m_results;
    std::unique_ptr<SweepPage> m_page;
};

SKYSEAL_TEST_WIDGETS(TranslatedSweepTest)
#include "translated_sweep_test.moc"
