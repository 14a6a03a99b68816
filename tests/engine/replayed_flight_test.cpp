// The picture at a position of a recording is the same however the replay got there.
#include "core/engine/replay/replayed_flight.h"

#include "core/engine/replay/replay_clock.h"
#include "core/engine/station/snapshot.h"
#include "recorded_copter.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>

#include <rapidcheck.h>

#include <sstream>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

/// All that the window shows of the vehicles, in a form in which unknown numbers are equal.
std::string pictureText(const Snapshot &picture)
{
    std::ostringstream out;
    out.precision(17);
    for (const VehicleSnapshot &vehicle : picture.vehicles) {
        const vehicle::VehicleState &s = vehicle.state;
        out << int(s.systemId) << ' ' << s.mode << ' ' << s.armed << s.lost << '\n';
        for (const double value : {s.roll,
                                   s.pitch,
                                   s.yaw,
                                   s.position.latitude,
                                   s.position.longitude,
                                   s.position.altitude,
                                   s.home.latitude,
                                   s.home.longitude,
                                   s.altitudeRelative,
                                   s.groundSpeed,
                                   s.climb,
                                   s.heading,
                                   s.throttle,
                                   s.distanceHome,
                                   s.flightTime,
                                   s.batteryVoltage,
                                   s.batteryPercent,
                                   s.hdop,
                                   s.latency,
                                   s.heartbeatAge,
                                   s.messageAge,
                                   vehicle.lossPercent,
                                   vehicle.framesPerSecond})
            out << value << ' ';
        out << s.gpsFix << ' ' << s.satellites << ' ' << s.ekfOk.value_or(false) << ' ' << s.sequence.frames << ' '
            << s.sequence.lost << '\n';
        for (const vehicle::StatusText &text : s.texts)
            out << text.number << ' ' << text.text << ' ' << text.time.time_since_epoch().count() << '\n';
    }
    for (const InspectorRow &row : picture.inspector)
        out << row.name << ' ' << row.count << '\n';
    out << picture.mavlink.frames << ' ' << picture.mavlink.lost << ' ' << picture.mavlink.badCrc << '\n';
    return out.str();
}

/// A replay that stops wherever it is told to.
struct Player
{
    explicit Player(const std::string &content)
        : file(content), flight(file, [this](Event event) {
              lost += std::holds_alternative<VehicleLost>(event);
              back += std::holds_alternative<VehicleBack>(event);
              found += std::holds_alternative<VehicleFound>(event);
          })
    {
        flight.setInspecting(true);
    }

    Snapshot picture() const
    {
        Snapshot out;
        flight.describe(out, {});
        return out;
    }

    std::istringstream file;
    int lost = 0, back = 0, found = 0;
    ReplayedFlight flight;
};

} // namespace

class ReplayedFlightTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(m_recorded.flies); }

    void seekShowsWhatPlayingShows()
    {
        QVERIFY(rc::check("the picture depends on the position alone", [this] {
            const auto anywhere = rc::gen::inRange<std::int64_t>(0, (RecordedCopter::kLength + 5s) / 1ms);
            const Duration to = std::chrono::milliseconds(*anywhere);
            Player sought(m_recorded.content);
            sought.flight.advance(to, kAll);
            Player played(m_recorded.content);
            auto stops = *rc::gen::container<std::vector<std::int64_t>>(anywhere);
            std::ranges::sort(stops);
            for (const std::int64_t stop : stops) {
                if (std::chrono::milliseconds(stop) < to)
                    played.flight.advance(std::chrono::milliseconds(stop), *rc::gen::inRange<std::size_t>(0, 500));
            }
            while (!played.flight.advance(to, 7)) {}
            RC_ASSERT(played.flight.position() == sought.flight.position());
            RC_ASSERT(pictureText(played.picture()) == pictureText(sought.picture()));
            RC_ASSERT(played.lost == sought.lost && played.back == sought.back && played.found == sought.found);
        }));
    }

    void chosenFieldsAreThoseOfThePosition()
    {
        const mavlink::MessageInfo *message = mavlink::Dialect::builtin().find("GLOBAL_POSITION_INT");
        const FieldChoice choice{message->id, message->field("relative_alt"), 0};
        Player player(m_recorded.content);
        player.flight.chooseFields({choice});
        player.flight.advance(30s, kAll);
        const Snapshot picture = player.picture();
        QCOMPARE(picture.fields.size(), std::size_t(1));
        QVERIFY(picture.fields[0].choice == choice);
        QCOMPARE(picture.fields[0].value.asDouble() * 1e-3, picture.vehicles.at(0).state.altitudeRelative);
    }

    void flightTimeIsThatOfTheRecording()
    {
        Player player(m_recorded.content);
        player.flight.advance(30s, kAll);
        const double before = player.picture().vehicles.at(0).state.flightTime;
        player.flight.advance(40s, kAll);
        const double after = player.picture().vehicles.at(0).state.flightTime;
        QVERIFY2(before > 0 && std::abs(after - before - 10) < 1, qPrintable(QString::number(after - before)));
        QCOMPARE(player.picture().vehicles.at(0).state.armed, true);
    }

    void wayLeadsFromTheBeginningToThePosition()
    {
        Player player(m_recorded.content);
        QVERIFY(player.flight.flown().of(1).empty());
        player.flight.advance(RecordedCopter::kLength, kAll);
        const FlownTracks::Points &way = player.flight.flown().of(1);
        QVERIFY2(!way.empty() && way.front().begins, qPrintable(QString::number(way.size())));
        const auto after = std::ranges::find_if(way,
                                                [](const FlownPoint &place) { return place.at >= RecordedCopter::kGapTo; });
        QVERIFY(after != way.end());
        for (auto place = way.begin() + 1; place != way.end(); ++place) {
            QVERIFY(place->at > (place - 1)->at);
            QCOMPARE(place->begins, place == after); // lost in the gap
        }
        QVERIFY(player.flight.flown().of(2).empty());
    }

    void waysAreBounded()
    {
        FlownTracks ways;
        constexpr int kVehicleCount = 20, kPlaces = 12'000;
        for (int i = 0; i < kPlaces; ++i) {
            for (std::uint8_t id = 1; id <= kVehicleCount; ++id) {
                ways.note(id, {.at = std::chrono::seconds(i), .latitude = 47 + i * 2e-5, .longitude = 8});
                ways.note(id, {.at = std::chrono::seconds(i), .latitude = 47 + i * 2e-5, .longitude = 8}); // hovers
            }
        }
        std::size_t places = 0;
        for (std::uint8_t id = 1; id <= kVehicleCount; ++id) {
            places += ways.of(id).size();
            QVERIFY(ways.of(id).size() <= FlownTracks::kMostOfOne);
            QCOMPARE(ways.of(id).back().at, Duration(std::chrono::seconds(kPlaces - 1)));
        }
        QCOMPARE(places, FlownTracks::kMost);
    }

    void gapMakesTheVehicleLostUntilItIsOver()
    {
        Player player(m_recorded.content);
        player.flight.advance(RecordedCopter::kGapFrom + 3s, kAll);
        QVERIFY(!player.picture().vehicles.at(0).state.lost);
        player.flight.advance(RecordedCopter::kGapFrom + 4s, kAll);
        QVERIFY(player.picture().vehicles.at(0).state.lost);
        QCOMPARE(player.lost, 1);
        player.flight.advance(RecordedCopter::kGapTo - 1s, kAll);
        const double age = player.picture().vehicles.at(0).state.messageAge;
        QVERIFY2(std::abs(age - 29) < 1, qPrintable(QString::number(age)));
        player.flight.advance(RecordedCopter::kGapTo + 1s, kAll);
        QVERIFY(!player.picture().vehicles.at(0).state.lost);
        QCOMPARE(player.lost, 1);
        QCOMPARE(player.back, 1);
        QCOMPARE(player.found, 1);
    }

    void textsHaveTheirRecordedTimes()
    {
        Player player(m_recorded.content);
        player.flight.advance(RecordedCopter::kLength, kAll);
        const auto texts = player.picture().vehicles.at(0).state.texts;
        QVERIFY(!texts.empty());
        QVERIFY(texts.back().time >= tlog::kNoon && texts.back().time <= tlog::kNoon + 100s);
    }

    void endIsThatOfTheLastFrame()
    {
        Player player(m_recorded.content);
        QVERIFY(player.flight.advance(1000s, kAll));
        QVERIFY(player.flight.isOver());
        QVERIFY(player.flight.position() <= RecordedCopter::kLength && player.flight.position() > RecordedCopter::kLength - 2s);
        QCOMPARE(player.picture().mavlink.badCrc, std::uint64_t(1));
    }

    void clockMovesAtItsSpeed()
    {
        constexpr TimePoint kBegin{100s};
        ReplayClock clock;
        QCOMPARE(clock.position(kBegin + 5s), Duration(0s));
        clock.setPlaying(kBegin, true);
        QCOMPARE(clock.position(kBegin + 5s), Duration(5s));
        clock.setSpeed(kBegin + 5s, 50);
        QCOMPARE(clock.position(kBegin + 6s), Duration(55s));
        clock.setSpeed(kBegin + 6s, 0.1);
        QCOMPARE(clock.position(kBegin + 16s), Duration(56s));
        clock.setPlaying(kBegin + 16s, false);
        QCOMPARE(clock.position(kBegin + 99s), Duration(56s));
        clock.setPosition(kBegin + 99s, 3s);
        clock.setSpeed(kBegin + 99s, 1000);
        QCOMPARE(clock.speed(), ReplayClock::kFastest);
        QCOMPARE(clock.position(kBegin + 99s), Duration(3s));
    }

private:
    const test::RecordedCopter m_recorded;
    using RecordedCopter = test::RecordedCopter;
};

SKYSEAL_TEST_APPLESS(ReplayedFlightTest)
#include "replayed_flight_test.moc"
