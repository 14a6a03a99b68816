// The chosen fields of a snapshot: the newest value of each sender, and nothing that was not chosen.
#include "core/engine/station/field_table.h"

#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;

namespace {

const mavlink::Dialect &builtinDialect()
{
    return mavlink::Dialect::builtin();
}

FieldChoice choiceOf(const char *message, const char *field, std::uint8_t element = 0)
{
    const mavlink::MessageInfo *info = builtinDialect().find(std::string_view(message));
    return {info->id, info->field(field), element};
}

template<typename Message>
void noteMessage(FieldTable &table, TimePoint now, const Message &message, std::uint8_t systemId = 1,
                 std::uint8_t componentId = 1)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView bytes = mavlink::FrameWriter(systemId, componentId).write(message, buffer);
    table.note(now, mavlink::readFrame(bytes, builtinDialect()).value());
}

} // namespace

class FieldTableTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyChosenFieldsAreRead()
    {
        FieldTable table;
        noteMessage(table, {}, mavlink::Attitude{.roll = 0.5f});
        QVERIFY(table.readings({}).empty());
        table.choose({choiceOf("ATTITUDE", "roll")});
        QVERIFY(table.readings({}).empty()); // nothing of before the choice
        noteMessage(table, TimePoint(1s), mavlink::VfrHud{.airspeed = 20});
        noteMessage(table, TimePoint(1s), mavlink::Attitude{.roll = 0.25f, .pitch = 1});
        const auto readings = table.readings(TimePoint(3500ms));
        QCOMPARE(readings.size(), std::size_t(1));
        QVERIFY(readings[0].choice == choiceOf("ATTITUDE", "roll"));
        QCOMPARE(readings[0].value.asDouble(), 0.25);
        QCOMPARE(readings[0].age, 2.5);
    }

    void eachSenderHasItsOwn()
    {
        FieldTable table;
        table.choose({choiceOf("ATTITUDE", "pitch")});
        noteMessage(table, {}, mavlink::Attitude{.pitch = 1}, 1, 1);
        noteMessage(table, {}, mavlink::Attitude{.pitch = 2}, 1, 158);
        noteMessage(table, {}, mavlink::Attitude{.pitch = 3}, 2, 1);
        noteMessage(table, {}, mavlink::Attitude{.pitch = 4}, 1, 1);
        const auto readings = table.readings({});
        QCOMPARE(readings.size(), std::size_t(3));
        QCOMPARE(readings[0].value.asDouble(), 4.0); // the newest
        QCOMPARE(int(readings[1].componentId), 158);
        QCOMPARE(int(readings[2].systemId), 2);
    }

    void elementsOfArraysAreApart()
    {
        FieldTable table;
        table.choose({choiceOf("BATTERY_STATUS", "voltages", 0), choiceOf("BATTERY_STATUS", "voltages", 2)});
        mavlink::BatteryStatus battery;
        battery.voltages[0] = 4100;
        battery.voltages[2] = 3900;
        noteMessage(table, {}, battery);
        const auto readings = table.readings({});
        QCOMPARE(readings.size(), std::size_t(2));
        QCOMPARE(readings[0].value.asDouble(), 4100.0);
        QCOMPARE(readings[1].value.asDouble(), 3900.0);
    }

    void newChoiceKeepsWhatStays()
    {
        FieldTable table;
        table.choose({choiceOf("ATTITUDE", "roll"), choiceOf("ATTITUDE", "yaw")});
        noteMessage(table, {}, mavlink::Attitude{.roll = 1, .yaw = 2});
        table.choose({choiceOf("ATTITUDE", "yaw"), choiceOf("ATTITUDE", "pitch")});
        const auto readings = table.readings({});
        QCOMPARE(readings.size(), std::size_t(1));
        QCOMPARE(readings[0].value.asDouble(), 2.0);
    }

    void numberOfReadingsIsBounded()
    {
        FieldTable table;
        table.choose(std::vector<FieldChoice>(1000, choiceOf("ATTITUDE", "roll")));
        for (int system = 1; system < 256; ++system) {
            for (const std::uint8_t component : {1, 2, 3, 4, 5})
                noteMessage(table, {}, mavlink::Attitude{}, static_cast<std::uint8_t>(system), component);
        }
        QCOMPARE(table.readings({}).size(), FieldTable::kMostReadings);
    }
};

SKYSEAL_TEST(FieldTableTest)
#include "field_table_test.moc"
