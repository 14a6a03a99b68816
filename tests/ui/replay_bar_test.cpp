// The controls of a replay by real keys and clicks: what they request of the station, what they show, and what they say.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/map/map_view.h"
#include "ui/replay/replay_bar.h"
#include "ui/replay/replay_timeline.h"
#include "ui/text/figures.h"
#include "ui/theme/suite_style.h"
#include "window_rig.h"

#include "core/log/log_index.h"

#include <QtGui/QAccessible>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;
using namespace std::chrono_literals;

class ReplayBarTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_station->show(sealedSnapshot(1));
    }
    void cleanup() { tearDown(); }

    void isThereDuringAReplayOnly()
    {
        const auto *bar = find<QWidget>("replayBar");
        QVERIFY(!bar->isVisible());
        start();
        QVERIFY(bar->isVisible());
        QTest::mouseClick(find<QPushButton>("sourceEnd"), Qt::LeftButton);
        QVERIFY(!bar->isVisible());
        m_window->setDemo(true);
        QVERIFY(!bar->isVisible());
    }

    void clickPausesAndPlays()
    {
        start();
        auto *play = find<QPushButton>("replayPlay");
        QCOMPARE(play->text(), QStringLiteral("Pause"));
        const int width = play->width();
        QTest::mouseClick(play, Qt::LeftButton);
        QVERIFY(newest<engine::PauseReplay>());
        showAt(300, [](engine::ReplayStatus &status) { status.playing = false; });
        QCOMPARE(play->text(), QStringLiteral("Play"));
        QCOMPARE(play->width(), width);
        QTest::mouseClick(play, Qt::LeftButton);
        QVERIFY(newest<engine::PlayReplay>());
    }

    void spacePlaysOnlyInTheBar()
    {
        start();
        m_window->setFocus();
        QTest::keyClick(m_window.get(), Qt::Key_Space);
        QVERIFY(m_station->replayCommands.empty());
        auto *line = find<ReplayTimeline>("replayLine");
        line->setFocus();
        QTest::keyClick(line, Qt::Key_Space);
        QCOMPARE(m_station->replayCommands.size(), std::size_t(1));
        QVERIFY(newest<engine::PauseReplay>());
        auto *play = find<QPushButton>("replayPlay");
        play->setFocus();
        QTest::keyClick(play, Qt::Key_Space);
        QCOMPARE(m_station->replayCommands.size(), std::size_t(2));
    }

    void playAtTheEndBeginsAgain()
    {
        start();
        showAt(900, [](engine::ReplayStatus &status) {
            status.playing = false;
            status.ended = true;
        });
        QTest::mouseClick(find<QPushButton>("replayPlay"), Qt::LeftButton);
        QCOMPARE(m_station->replayCommands.size(), std::size_t(2));
        QCOMPARE(std::get<engine::SeekReplay>(m_station->replayCommands[0]).to, Duration(0s));
        QVERIFY(newest<engine::PlayReplay>());
    }

    void speedIsChosen()
    {
        start();
        auto *speed = find<QComboBox>("replaySpeed");
        QCOMPARE(speed->count(), 9);
        QCOMPARE(speed->currentText(), QStringLiteral("1 ×"));
        speed->setFocus();
        QTest::keyClick(speed, Qt::Key_Down);
        QCOMPARE(newest<engine::SetReplaySpeed>()->factor, 2.0);
        QTest::keyClick(speed, Qt::Key_End);
        QCOMPARE(newest<engine::SetReplaySpeed>()->factor, 50.0);
        QTest::keyClick(speed, Qt::Key_Home);
        QCOMPARE(newest<engine::SetReplaySpeed>()->factor, 0.1);
        showAt(301, [](engine::ReplayStatus &status) { status.speed = 0.25; });
        QCOMPARE(speed->currentText(), QStringLiteral("0.25 ×"));
    }

    void keysSeek_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<bool>("control");
        QTest::addColumn<int>("to");
        QTest::newRow("right") << int(Qt::Key_Right) << false << 301;
        QTest::newRow("left") << int(Qt::Key_Left) << false << 299;
        QTest::newRow("page up") << int(Qt::Key_PageUp) << false << 310;
        QTest::newRow("page down") << int(Qt::Key_PageDown) << false << 290;
        QTest::newRow("home") << int(Qt::Key_Home) << false << 0;
        QTest::newRow("end") << int(Qt::Key_End) << false << 900;
        QTest::newRow("next mark: the gap") << int(Qt::Key_Right) << true << 400;
        QTest::newRow("mark before: the mode") << int(Qt::Key_Left) << true << 80;
    }
    void keysSeek()
    {
        QFETCH(int, key);
        QFETCH(bool, control);
        QFETCH(int, to);
        start();
        auto *line = find<ReplayTimeline>("replayLine");
        line->setFocus();
        QTest::keyClick(line, Qt::Key(key), control ? Qt::ControlModifier : Qt::NoModifier);
        QVERIFY(newest<engine::SeekReplay>());
        QCOMPARE(newest<engine::SeekReplay>()->to, Duration(std::chrono::seconds(to)));
        QCOMPARE(line->value(), to * 1000);
    }

    /// Pictures of before the seek are still on their way, and must not move the line back.
    void lineWaitsForTheSeek()
    {
        start();
        auto *line = find<ReplayTimeline>("replayLine");
        line->setFocus();
        QTest::keyClick(line, Qt::Key_Right);
        QTest::keyClick(line, Qt::Key_Right);
        QCOMPARE(newest<engine::SeekReplay>()->to, Duration(302s));
        showAt(300.1);
        QCOMPARE(line->value(), 302'000);
        showAt(301, [](engine::ReplayStatus &status) { status.seeks = 1; });
        QCOMPARE(line->value(), 302'000);
        showAt(302.5, [](engine::ReplayStatus &status) { status.seeks = 2; });
        QCOMPARE(line->value(), 302'500);
    }

    void mouseSeeksWhereItIsPressedAndDragged()
    {
        start();
        auto *line = find<ReplayTimeline>("replayLine");
        QVERIFY(line->width() > 300);
        QTest::mousePress(line, Qt::LeftButton, {}, QPoint(line->width() / 2, line->height() / 2));
        const auto pressed = newest<engine::SeekReplay>()->to;
        QVERIFY(pressed > 440s && pressed < 460s);
        QTest::mouseMove(line, QPoint(line->width() - 1, line->height() / 2));
        QCOMPARE(newest<engine::SeekReplay>()->to, Duration(900s));
        showAt(450, [](engine::ReplayStatus &status) { status.seeks = 9; });
        QCOMPARE(line->value(), 900'000); // not under the pointer
        QTest::mouseRelease(line, Qt::LeftButton, {}, QPoint(line->width() - 1, line->height() / 2));
        showAt(899, [](engine::ReplayStatus &status) { status.seeks = 9; });
        QCOMPARE(line->value(), 899'000);
    }

    void marksAreSaidInWords()
    {
        start();
        const auto *line = find<ReplayTimeline>("replayLine");
        const QString said = line->accessibleDescription();
        for (const char *words :
             {"06:40 nothing recorded for 00:55", "01:00 armed until 13:35", "01:20 mode AUTO", "12:40 mode LAND",
              "00:00 sealed with ChaCha20-Poly1305", "08:20 switched to AES-256-GCM", "11:40 switched to ChaCha20-Poly1305"})
            QVERIFY2(said.contains(QLatin1String(words)), qPrintable(said));
        const int gap = line->width() * 427 / 900;
        QVERIFY2(line->textAt(gap).contains(QStringLiteral("nothing recorded")), qPrintable(line->textAt(gap)));
        QVERIFY(line->textAt(gap).contains(QStringLiteral("armed until")));
        QVERIFY(!line->textAt(line->width() * 500 / 900).contains(QStringLiteral("nothing recorded")));
    }

    void switchIsSaidUnderThePointerAndReachedByKeys()
    {
        start();
        auto *line = find<ReplayTimeline>("replayLine");
        const int at = line->width() * 500 / 900;
        QVERIFY2(line->textAt(at).contains(QStringLiteral("\n08:20 switched to AES-256-GCM")), qPrintable(line->textAt(at)));
        QVERIFY(!line->textAt(line->width() * 580 / 900).contains(QStringLiteral("switched")));
        showAt(456);
        line->setFocus();
        QTest::keyClick(line, Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(newest<engine::SeekReplay>()->to, Duration(500s));
    }

    /// A diamond in the color of the suite, below the line.
    void switchIsDrawnInTheColorOfItsSuite()
    {
        start();
        auto *line = find<ReplayTimeline>("replayLine");
        const auto hasColor = [&](int second) {
            const QImage picture = line->grab().toImage();
            const double ratio = picture.devicePixelRatio();
            const int x = 6 + (line->width() - 12) * second / 900;
            for (int y = line->height() / 2 + 5; y < line->height(); ++y)
                for (int dx = -2; dx <= 2; ++dx)
                    if (picture.pixelColor(int((x + dx) * ratio), int(y * ratio)) == suiteColor(crypto::SuiteId::Aes256Gcm))
                        return true;
            return false;
        };
        QVERIFY(hasColor(500));
        QVERIFY(!hasColor(600));
    }

    void severalLinksAreNamed()
    {
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        showAt(300, [](engine::ReplayStatus &status) {
            auto index = *status.index;
            index.suites.at(1).event.peer = "air-2";
            index.suites.at(2).event.suite = "of-tomorrow";
            index.unreadableEvents = 2;
            status.index = std::make_shared<const tlog::LogIndex>(index);
        });
        const QString said = find<ReplayTimeline>("replayLine")->accessibleDescription();
        for (const char *words : {"2 unreadable lines about ciphers", "00:00 sealed with ChaCha20-Poly1305 (link to air-1)",
                                  "08:20 switched to AES-256-GCM (link to air-2)", "11:40 switched to of-tomorrow"})
            QVERIFY2(said.contains(QLatin1String(words)), qPrintable(said));
        QVERIFY(find<FigureLabel>("replayPosition")->toolTip().contains(QStringLiteral("2 unreadable lines")));
    }

    void positionIsSaid()
    {
        start();
        auto *line = find<ReplayTimeline>("replayLine");
        QAccessibleInterface *accessible = QAccessible::queryAccessibleInterface(line);
        QVERIFY(accessible);
        QCOMPARE(accessible->role(), QAccessible::Slider);
        QVERIFY(!accessible->text(QAccessible::Name).isEmpty());
        QVERIFY(accessible->valueInterface());
        QCOMPARE(accessible->valueInterface()->currentValue().toInt(), 300'000);
        QCOMPARE(accessible->text(QAccessible::Value), QStringLiteral("05:00 of 15:00"));
        const auto *position = find<FigureLabel>("replayPosition");
        QCOMPARE(position->text(), QStringLiteral("05:00 / 15:00"));
        QVERIFY(!find<QComboBox>("replaySpeed")->accessibleName().isEmpty());
        QVERIFY(!find<QPushButton>("replayPlay")->accessibleName().isEmpty());
    }

    void nothingCanBePlayedWithoutAFile()
    {
        start();
        QVERIFY(find<QPushButton>("replayPlay")->isEnabled());
        engine::Snapshot snapshot;
        engine::LinkSnapshot link;
        link.phase = engine::LinkPhase::Failed;
        link.problem = "cannot read /logs/own.tlog";
        snapshot.links.push_back(link);
        snapshot.replay.emplace();
        m_station->showReplay(snapshot);
        QVERIFY(!find<QPushButton>("replayPlay")->isEnabled());
        start();
        QVERIFY(find<QPushButton>("replayPlay")->isEnabled());
    }

    /// Before the recording was read, nobody knows its length.
    void lineIsOffUntilTheIndexIsThere()
    {
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        showAt(3, [](engine::ReplayStatus &status) { status.index.reset(); });
        const auto *line = find<ReplayTimeline>("replayLine");
        QVERIFY(!line->isEnabled());
        QVERIFY(find<FigureLabel>("replayPosition")->text().startsWith(QStringLiteral("00:03")));
        const int width = find<FigureLabel>("replayPosition")->width();
        showAt(4);
        QVERIFY(line->isEnabled());
        QCOMPARE(find<FigureLabel>("replayPosition")->width(), width);
    }

    void tracksBeforeAndAfterASeekAreNotJoined()
    {
        start();
        const Track &track = find<MapView>("map")->content().track();
        for (double t = 300; t < 320; t += 0.5)
            showAt(t);
        QVERIFY(track.points().size() > 3);
        showAt(320, [](engine::ReplayStatus &status) {
            status.seeks = 1;
            status.seeking = true;
        });
        showAt(100, [](engine::ReplayStatus &status) { status.seeks = 1; });
        QCOMPARE(track.points().size(), std::size_t(1));
        showAt(102, [](engine::ReplayStatus &status) { status.seeks = 1; });
        QVERIFY(track.points().size() > 1);
    }

    /// At fifty times the speed a vehicle flies far between two pictures.
    void fastReplayDrawsOneTrack()
    {
        start();
        const Track &track = find<MapView>("map")->content().track();
        const auto parts = [&] { return std::ranges::count_if(track.points(), &TrackPoint::begins); };
        showAt(310);
        const auto before = parts();
        engine::Snapshot far = replayedSnapshot(320);
        far.time = replayedSnapshot(310).time + 0.1;
        far.vehicles.front().state.position.latitude += 0.002; // 220 m in 10 s of the recording
        m_station->showReplay(far);
        QCOMPARE(parts(), before);
    }

private:
    void start()
    {
        m_window->startReplay(QStringLiteral("tlog:/logs/own.tlog"));
        showAt(300);
    }
    void showAt(double position, const std::function<void(engine::ReplayStatus &)> &change = {})
    {
        engine::Snapshot snapshot = replayedSnapshot(position);
        if (change)
            change(*snapshot.replay);
        m_station->showReplay(snapshot);
    }
    /// The newest request, if it is of this kind.
    template<typename Command> const Command *newest() const
    {
        return m_station->replayCommands.empty() ? nullptr : std::get_if<Command>(&m_station->replayCommands.back());
    }
};

SKYSEAL_TEST_WIDGETS(ReplayBarTest)
#include "replay_bar_test.moc"
