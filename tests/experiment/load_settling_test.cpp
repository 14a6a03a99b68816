// When a load counts as settled, and whether it was what its name says, by made-up readings.
#include "core/experiment/load_check.h"
#include "core/experiment/load_settling.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace skyseal::experiment;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep = 0.05; ///< seconds between snapshots

/// Seconds until it settles at a rate over time; infinite if it does not within a minute.
double settlesAfter(LoadSettling settling, const std::function<double(double)> &rate, double trip)
{
    double bytes = 0;
    for (double time = 0; time < 60; time += kStep) {
        settling.note(100 + time, static_cast<std::uint64_t>(bytes), trip);
        if (settling.settled())
            return time;
        bytes += kStep * rate(time);
    }
    return std::numeric_limits<double>::infinity();
}

Values used(double line, double station, double agent)
{
    Values out;
    out[Metric::LineLoad] = line;
    out[Metric::Cpu] = station;
    out[Metric::AgentCpu] = agent;
    return out;
}

} // namespace

class LoadSettlingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void steadyRateIsSettledSoon()
    {
        const double after = settlesAfter(
            LoadSettling(), [](double) { return 1e6; }, 0.001);
        QVERIFY2(after < 2, qPrintable(QString::number(after)));
    }

    void growingRateIsWaitedFor()
    {
        // Grows by a tenth each third of a second, for ten seconds.
        const auto grows = [](double time) { return 1e5 * std::pow(1.1, 3 * std::min(time, 10.0)); };
        const double after = settlesAfter(LoadSettling(), grows, kUnknown);
        QVERIFY2(after >= 10 && after < 12, qPrintable(QString::number(after)));
    }

    void silenceIsNoSettledLoad()
    {
        QVERIFY(std::isinf(settlesAfter(
            LoadSettling(), [](double) { return 0.0; }, kUnknown)));
        const double after = settlesAfter(
            LoadSettling(), [](double time) { return time < 5 ? 0.0 : 1e6; }, kUnknown);
        QVERIFY2(after > 5 && after < 8, qPrintable(QString::number(after)));
    }

    void windowsAreAsLongAsTheTrips()
    {
        // The effect of a load with a trip of a second shows only after such trips.
        QVERIFY(settlesAfter(
                    LoadSettling(), [](double) { return 1e6; }, 1)
                >= 6);
    }

    /// The load pauses at first, as after a change of the session: half of the line is other telemetry, and steadily so.
    void lineHasToBeFull()
    {
        const auto rate = [](double time) { return time < 4 ? 2700.0 : 5700.0; };
        const double after = settlesAfter(LoadSettling(5760), rate, 0.2);
        QVERIFY2(after > 4 && after < 7, qPrintable(QString::number(after)));
        QVERIFY(std::isinf(settlesAfter(
            LoadSettling(5760), [](double) { return 0.94 * 5760; }, 0.2)));
        QVERIFY(settlesAfter(
                    LoadSettling(5760), [](double) { return 0.96 * 5760; }, 0.2)
                < 2);
    }

    void saturatedRunHasToUseSomethingUp_data()
    {
        QTest::addColumn<double>("line");
        QTest::addColumn<double>("station");
        QTest::addColumn<double>("agent");
        QTest::addColumn<bool>("valid");
        QTest::newRow("the line") << 95.0 << 3.0 << 5.0 << true;
        QTest::newRow("the station") << kUnknown << 95.1 << 60.0 << true;
        QTest::newRow("the agent") << kUnknown << 70.0 << 99.0 << true;
        QTest::newRow("an agent that is not known") << kUnknown << 96.0 << kUnknown << true;
        QTest::newRow("half of a line") << 71.0 << 3.0 << 5.0 << false;
        QTest::newRow("almost") << 94.9 << 94.9 << 94.9 << false;
        QTest::newRow("the generator") << kUnknown << 41.0 << 56.0 << false;
    }

    void saturatedRunHasToUseSomethingUp()
    {
        QFETCH(double, line);
        QFETCH(double, station);
        QFETCH(double, agent);
        QFETCH(bool, valid);
        const std::string problem = loadProblem(Load::Saturated, used(line, station, agent)).text();
        QCOMPARE(problem.empty(), valid);
        QVERIFY(loadProblem(Load::Natural, used(line, station, agent)).empty());
        if (!valid && !std::isnan(line))
            QVERIFY2(problem.find(readable(line) + " % of the line's rate") != std::string::npos, problem.c_str());
        QCOMPARE(problem.find("nan"), std::string::npos);
        QCOMPARE(problem.find(','), std::string::npos); // a column of the CSV file
    }

    /// Two seconds at 500 frames a second: ten sends are one per cent.
    void pacedLoadMayMissLittle()
    {
        Values values;
        values[Metric::FrameRate] = 560;
        values[Metric::Packets] = 1120;
        QVERIFY(!loadProblem(Load::paced(500), values).empty()); // nobody counted
        values[Metric::MissedSends] = 10;
        QVERIFY(loadProblem(Load::paced(500), values).empty());
        values[Metric::MissedSends] = 11;
        QCOMPARE(loadProblem(Load::paced(500), values).text(), std::string("the generator missed 1.1 % of its sends"));
    }
};

SKYSEAL_TEST_APPLESS(LoadSettlingTest)
#include "load_settling_test.moc"
