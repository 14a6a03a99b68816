// A replay with its thread and its clock, on a file: play, pause, speed, seek, and files that cannot be read.
#include "core/engine/replay/replay.h"

#include "core/engine/replay/replayed_flight.h"
#include "core/engine/station/snapshot.h"
#include "core/log/log_index.h"
#include "recorded_copter.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <fstream>
#include <limits>
#include <random>
#include <sstream>

using namespace skyseal;
using namespace skyseal::engine;
using namespace std::chrono_literals;

class ReplayTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_recorded.flies);
        m_path = m_folder.filePath(QStringLiteral("flight.tlog")).toStdString();
        std::ofstream(m_path, std::ios::binary) << m_recorded.content;
        m_url.emplace(*link::LinkUrl::parse(link::LinkUrl::ofRecording(m_path)));
    }
    void init()
    {
        m_events.clear();
        m_newest.reset();
    }

    void playsAtOnceAndIsIndexed()
    {
        const auto replay = start(*m_url);
        EVENTUALLY(m_newest && status().position > 500ms && !m_newest->vehicles.empty());
        QVERIFY(status().playing && !status().ended);
        EVENTUALLY(status().index);
        QCOMPARE(status().index->gaps.size(), std::size_t(1));
        QCOMPARE(status().index->vehicles, std::vector<std::uint8_t>{1});
        QVERIFY(status().index->modes.size() >= 4);
        QCOMPARE(m_newest->links.at(0).phase, LinkPhase::Connected);
        QVERIFY(m_newest->links.at(0).recording);
    }

    void suitesBesideTheRecordingAreOnItsLine()
    {
        const std::string path = m_folder.filePath(QStringLiteral("sealed.tlog")).toStdString();
        std::ofstream(path, std::ios::binary) << m_recorded.content;
        const tlog::LinkEvent event{tlog::LinkEvent::Kind::Sealed, {}, "aes-256-gcm", "air-1"};
        std::ofstream(tlog::linkEventsFile(path)) << tlog::lineOf(event) << "no event\n";
        const auto replay = start(*link::LinkUrl::parse(link::LinkUrl::ofRecording(path)));
        EVENTUALLY(m_newest && status().index);
        QCOMPARE(status().index->suites.size(), std::size_t(1));
        QVERIFY(status().index->suites[0].event == event);
        QCOMPARE(status().index->unreadableEvents, std::uint64_t(1));
    }

    void pausedPictureKeepsItsAge()
    {
        const auto replay = start(*m_url);
        replay->perform(PauseReplay{});
        replay->perform(SeekReplay{20s});
        EVENTUALLY(m_newest && !m_newest->vehicles.empty() && arrived(1));
        const auto number = m_newest->number;
        EVENTUALLY(m_newest->number > number + 1);
        QCOMPARE(status().position, Duration(20s));
        QVERIFY(m_newest->vehicles.at(0).state.messageAge < 1);
        QVERIFY(!status().playing);
    }

    void seekBackShowsTheSamePictureAgain()
    {
        const auto replay = start(*m_url);
        replay->perform(PauseReplay{});
        replay->perform(SeekReplay{30s});
        EVENTUALLY(arrived(1));
        const vehicle::VehicleState first = m_newest->vehicles.at(0).state;
        QVERIFY(first.armed);
        replay->perform(SeekReplay{90s});
        EVENTUALLY(arrived(2));
        QVERIFY(m_newest->vehicles.at(0).state.mode != first.mode);
        replay->perform(SeekReplay{1s});
        EVENTUALLY(arrived(3));
        QVERIFY(!m_newest->vehicles.at(0).state.armed);
        QCOMPARE(m_newest->vehicles.at(0).state.flightTime, 0.0);
        replay->perform(SeekReplay{30s});
        EVENTUALLY(arrived(4));
        const vehicle::VehicleState again = m_newest->vehicles.at(0).state;
        QCOMPARE(again.mode, first.mode);
        QCOMPARE(again.position.latitude, first.position.latitude);
        QCOMPARE(again.flightTime, first.flightTime);
        QCOMPARE(again.messageAge, first.messageAge);
    }

    /// Also after a seek forward, which passes over a part.
    void seekBringsTheWaySoFar()
    {
        const auto replay = start(*m_url);
        replay->perform(PauseReplay{});
        for (const auto &[to, seeks] : {std::pair(30s, 1), {90s, 2}, {40s, 3}}) {
            replay->perform(SeekReplay{to});
            EVENTUALLY(arrived(static_cast<std::uint64_t>(seeks)) && status().flown);
            std::istringstream file(m_recorded.content);
            ReplayedFlight played(file, [](const Event &) {});
            played.advance(to, std::numeric_limits<std::size_t>::max());
            const FlownTracks::Points &expected = played.flown().of(1);
            const FlownTracks::Points &way = status().flown->of(1);
            QVERIFY(!way.empty());
            QCOMPARE(way.size(), expected.size());
            QCOMPARE(way.back().at, expected.back().at);
        }
    }

    /// Events that a seek passes over are not reported as if they happened.
    void seekIsSilent()
    {
        const auto replay = start(*m_url);
        replay->perform(PauseReplay{});
        replay->perform(SeekReplay{80s});
        EVENTUALLY(arrived(1));
        QCOMPARE(count<VehicleLost>(), 0);
        QCOMPARE(count<VehicleBack>(), 0);
    }

    void fastReplayEndsAndPlaysAgain()
    {
        const auto replay = start(*m_url);
        replay->perform(SetReplaySpeed{50});
        EVENTUALLY(m_newest && status().ended);
        QCOMPARE(m_newest->links.at(0).phase, LinkPhase::Finished);
        QVERIFY(!status().playing);
        QVERIFY(status().index);
        QCOMPARE(status().position, status().index->length);
        QCOMPARE(count<VehicleLost>(), 1);
        QCOMPARE(count<VehicleBack>(), 1);
        replay->perform(PlayReplay{}); // has no effect at the end
        replay->perform(SeekReplay{0s});
        replay->perform(PlayReplay{});
        EVENTUALLY(arrived(1) && status().playing && status().position < status().index->length);
        EVENTUALLY(status().ended);
    }

    void newestSeekWins()
    {
        const auto replay = start(*m_url);
        replay->perform(PauseReplay{});
        for (int i = 0; i < 50; ++i)
            replay->perform(SeekReplay{std::chrono::seconds(i % 2 ? 10 + i : 90 - i)});
        EVENTUALLY(arrived(50));
        QCOMPARE(status().position, Duration(59s));
    }

    void unreadableFileIsReported()
    {
        const auto replay = start(*link::LinkUrl::parse("tlog:/no/such/file.tlog"));
        replay->perform(SeekReplay{10s});
        replay->perform(PlayReplay{});
        EVENTUALLY(m_newest);
        QCOMPARE(m_newest->links.at(0).phase, LinkPhase::Failed);
        QCOMPARE(m_newest->links.at(0).problem.text(),
                 std::string("cannot read /no/such/file.tlog: No such file or directory"));
        QVERIFY(m_newest->vehicles.empty());
    }

    /// What has no frame is no recording, whatever its name: its replay is not one that is over.
    void fileWithoutFramesIsRefused_data()
    {
        QTest::addColumn<QByteArray>("content");
        std::mt19937 random(1);
        QByteArray noise(50'000, 0);
        std::ranges::generate(noise, [&random] { return static_cast<char>(random()); });
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("random bytes") << noise;
    }
    void fileWithoutFramesIsRefused()
    {
        QFETCH(QByteArray, content);
        const std::string path = m_folder.filePath(QStringLiteral("other.tlog")).toStdString();
        std::ofstream(path, std::ios::binary) << content.toStdString();
        const auto replay = start(*link::LinkUrl::parse(link::LinkUrl::ofRecording(path)));
        EVENTUALLY(m_newest && m_newest->links.at(0).phase == LinkPhase::Failed);
        QCOMPARE(m_newest->links.at(0).problem.text(), "cannot read " + path + ": it contains no MAVLink frame");
        QVERIFY(!status().playing && !status().ended);
    }

    /// The silence in the middle lasts half a minute, of which five seconds are shown.
    void longSilenceIsNotWaitedFor()
    {
        const auto replay = start(*m_url);
        replay->perform(SeekReplay{Duration(test::RecordedCopter::kGapFrom) + 4500ms});
        EVENTUALLY(arrived(1));
        QVERIFY(m_newest->vehicles.at(0).state.lost);
        replay->perform(PlayReplay{});
        EVENTUALLY(status().position > test::RecordedCopter::kGapTo && !m_newest->vehicles.at(0).state.lost);
        QVERIFY(status().position < test::RecordedCopter::kGapTo + 10s);
    }

private:
    std::unique_ptr<Replay> start(const link::LinkUrl &url)
    {
        auto replay = std::make_unique<Replay>(url);
        connect(replay.get(), &Replay::snapshotReady, this, [this](const SnapshotPtr &snapshot) { m_newest = snapshot; });
        connect(replay.get(), &Replay::eventOccurred, this, [this](const Event &event) { m_events.push_back(event); });
        return replay;
    }
    const ReplayStatus &status() const { return *m_newest->replay; }
    bool arrived(std::uint64_t seeks) const { return m_newest && status().seeks == seeks && !status().seeking; }
    template<typename E> int count() const
    {
        return static_cast<int>(
            std::ranges::count_if(m_events, [](const Event &event) { return std::holds_alternative<E>(event); }));
    }

    const test::RecordedCopter m_recorded;
    QTemporaryDir m_folder;
    std::string m_path;
    std::optional<link::LinkUrl> m_url;
    SnapshotPtr m_newest;
    std::vector<Event> m_events;
};

SKYSEAL_TEST(ReplayTest)
#include "replay_test.moc"
