// Export of recordings as tables: a row per period for each vehicle, also where the clock was set or a time is damaged.
#include "core/engine/headless/telemetry_csv.h"

#include "tests/log/recordings.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <sstream>

using namespace skyseal;
using namespace skyseal::tlog;

namespace {

std::string position(int number)
{
    mavlink::FrameWriter writer(1, 1);
    mavlink::GlobalPositionInt message;
    message.lat = -353632610;
    message.lon = 1491652300;
    message.relative_alt = 1000 * number;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    return std::string(asText(writer.write(message, buffer)));
}

struct Table
{
    std::vector<std::string> lines;
    std::string column(std::size_t line, const std::string &name) const
    {
        std::istringstream head(lines.at(0)), row(lines.at(line));
        for (std::string title, cell; std::getline(head, title, ',') && std::getline(row, cell, ',');)
            if (title == name)
                return cell;
        return {};
    }
};

Table exported(const std::string &content, Duration every)
{
    Table out;
    std::istringstream input(content);
    engine::exportTelemetry(input, mavlink::Dialect::builtin(), every, [&](const std::string &line) {
        out.lines.push_back(line);
        return true;
    });
    return out;
}

} // namespace

class TelemetryCsvTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clockThatWasSetLosesNothing_data();
    void clockThatWasSetLosesNothing();
    void frameWithADamagedTimeCounts();
};

void TelemetryCsvTest::clockThatWasSetLosesNothing_data()
{
    QTest::addColumn<qint64>("step");
    QTest::newRow("not set") << qint64(0);
    QTest::newRow("back by an hour") << qint64(-3600);
    QTest::newRow("back to 1970") << -qint64(std::chrono::floor<std::chrono::seconds>(kNoon.time_since_epoch()).count());
    QTest::newRow("forward by an hour") << qint64(3600);
    QTest::newRow("forward by 50 years") << qint64(50) * 365 * 86400;
}

/// Twenty seconds of flight, ten of them after the clock was set.
void TelemetryCsvTest::clockThatWasSetLosesNothing()
{
    QFETCH(qint64, step);
    std::string content;
    for (int i = 0; i < 200; ++i) {
        const WallTime time = kNoon + std::chrono::milliseconds(100) * i + std::chrono::seconds(i < 100 ? 0 : step);
        if (i % 10 == 0)
            content += entry(time, heartbeat(4));
        content += entry(time, position(i));
    }
    const Table table = exported(content, std::chrono::seconds(1));
    QCOMPARE(table.lines.size(), std::size_t(21));
    for (std::size_t row = 1; row < table.lines.size(); ++row) {
        const auto seconds = static_cast<qint64>(row - 1) + (row <= 10 ? 0 : step)
            + std::chrono::floor<std::chrono::seconds>(kNoon.time_since_epoch()).count();
        QCOMPARE(QString::fromStdString(table.column(row, "time")).toDouble(), double(seconds));
        QCOMPARE(table.column(row, "heartbeat_age"), std::string("0"));
        if (row > 1) // the first heartbeat makes the first row
            QCOMPARE(QString::fromStdString(table.column(row, "alt_rel")).toInt(), 10 * int(row - 1) - 1);
    }
}

/// It is that of the entry before.
void TelemetryCsvTest::frameWithADamagedTimeCounts()
{
    std::string content = entry(kNoon, heartbeat(4)) + entry(kNoon, position(1));
    content += std::string("\xff\xff\xff", 3) + position(7); // the rest of an entry
    const Table table = exported(content, Duration(0));
    QCOMPARE(table.lines.size(), std::size_t(4));
    QCOMPARE(table.column(3, "alt_rel"), std::string("7"));
    QCOMPARE(table.column(3, "time"), table.column(2, "time"));
}

SKYSEAL_TEST_APPLESS(TelemetryCsvTest)
#include "telemetry_csv_test.moc"
