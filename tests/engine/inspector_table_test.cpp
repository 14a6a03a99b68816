// The rows of the inspector: rates are right from the second second on, whatever the rate, and systems that are gone leave.
#include "core/engine/station/inspector_table.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;

namespace {

constexpr TimePoint kBegin{std::chrono::hours(1)};

TimePoint at(double time)
{
    return kBegin + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(time));
}

void noteHeartbeat(InspectorTable &table, double time, std::uint8_t systemId = 1)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView bytes = mavlink::FrameWriter(systemId, 1).write(mavlink::Heartbeat{}, buffer);
    table.note(at(time), mavlink::readFrame(bytes, mavlink::Dialect::builtin()).value());
}

} // namespace

class InspectorTableTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ratesAreRightFromTheSecondSecond_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<double>("phase");
        for (const double rate : {1.0, 2.0, 4.0, 10.0, 50.0})
            for (const double phase : {0.0, 0.037, 0.4})
                QTest::addRow("%g /s from %g s on", rate, phase) << rate << phase;
    }
    void ratesAreRightFromTheSecondSecond()
    {
        QFETCH(double, rate);
        QFETCH(double, phase);
        InspectorTable table;
        table.setWatching(true);
        int sent = 0;
        for (double time = 0; time < 12; time += 0.01) {
            for (; phase + sent / rate <= time; ++sent)
                noteHeartbeat(table, phase + sent / rate);
            if (time < phase + std::max(1.0, 1 / rate) + 0.02)
                continue;
            const double shown = table.rows(at(time)).front().rate;
            QVERIFY2(std::abs(shown - rate) <= 0.1 * rate, qPrintable(QStringLiteral("%1 /s at %2 s").arg(shown).arg(time)));
        }
    }

    /// Slower than the window is long.
    void slowMessagesHaveARate()
    {
        InspectorTable table;
        table.setWatching(true);
        for (int i = 0; i < 3; ++i)
            noteHeartbeat(table, 5 * i);
        QCOMPARE(table.rows(at(12)).front().rate, 0.2);
        QVERIFY(table.rows(at(20)).front().rate < 0.11); // it has become slower, or has ended
    }

    void oneMessageIsNoStream()
    {
        InspectorTable table;
        table.setWatching(true);
        noteHeartbeat(table, 0);
        QCOMPARE(table.rows(at(0.1)).front().rate, 0.0);
        noteHeartbeat(table, 0.001);
        QVERIFY(table.rows(at(0.1)).front().rate <= 2);
    }

    void systemsThatAreGoneLeave()
    {
        InspectorTable table;
        table.setWatching(true);
        noteHeartbeat(table, 0);
        noteHeartbeat(table, 0, 2);
        const double gone = seconds(InspectorTable::kGoneAfter);
        noteHeartbeat(table, gone, 2);
        QCOMPARE(table.rows(at(gone)).size(), std::size_t(2));
        const auto left = table.rows(at(gone + 1));
        QCOMPARE(left.size(), std::size_t(1));
        QCOMPARE(left.front().systemId, std::uint8_t(2));
        noteHeartbeat(table, gone + 2); // it is back
        QCOMPARE(table.rows(at(gone + 2)).size(), std::size_t(2));
    }
};

SKYSEAL_TEST(InspectorTableTest)
#include "inspector_table_test.moc"
