// Refused frames are one number wherever the window shows them, counted since the link came up, in one colour.
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/alert_row.h"
#include "ui/refusal_meter.h"
#include "ui/status/strip_item.h"
#include "ui/theme/palettes.h"
#include "window_rig.h"

#include <QtGui/QAction>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>

using namespace skyseal;
using namespace skyseal::ui;

class RefusalCountTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        setUp();
        m_time = 0;
    }
    void cleanup() { tearDown(); }

    void lockAndNoticeShowTheSameNumber()
    {
        show(2481, 2481);
        for (const std::uint64_t lastMinute : {2481U, 1958U, 3U}) { // the attack has stopped
            show(2481, lastMinute);
            const QString lock = find<StripItem>("stripLock")->text();
            QVERIFY2(lock.contains(QStringLiteral("2,481 refused")), qPrintable(lock));
            EVENTUALLY(notice() && notice()->text == QStringLiteral("2,481 forged frames"));
            const QString advice = find<QLabel>("secureAdvice")->text();
            QVERIFY2(advice.contains(QStringLiteral("2,481 forged, 0 replayed in this session")), qPrintable(advice));
            const QString tip = find<StripItem>("stripLock")->toolTip();
            QVERIFY2(tip.contains(QStringLiteral("2,481 forged or replayed records since the link came up")), qPrintable(tip));
            QVERIFY(notice()->details.contains(QStringLiteral("since the link came up")));
        }
    }

    void framesOutsideTheSessionCountInBoth()
    {
        show(0, 0);
        m_station->notify(engine::PlaintextRefused{1, "10.0.0.9:14550", 1200, {}});
        show(0, 0);
        m_station->notify(engine::PlaintextRefused{1, "10.0.0.9:14550", 9, {}});
        show(7, 7);
        QVERIFY2(find<StripItem>("stripLock")->text().contains(QStringLiteral("1,216 refused")),
                 qPrintable(find<StripItem>("stripLock")->text()));
        EVENTUALLY(notice() && notice()->text == QStringLiteral("1,216 forged frames"));
    }

    /// A network repeats some records without an attacker: they are in no alarm.
    void repeatedRecordsOfTheNetworkCountInNone()
    {
        engine::Snapshot snapshot = attacked(5, 5);
        snapshot.sessions.front().goodLastMinute = 1000;
        snapshot.sessions.front().stats.rx.replayed = snapshot.sessions.front().replayedLastMinute = 30;
        m_station->show(snapshot);
        QVERIFY(find<StripItem>("stripLock")->text().contains(QStringLiteral("5 refused")));
        EVENTUALLY(notice() && notice()->text == QStringLiteral("5 forged frames"));
    }

    void noticeHasTheColourOfTheLock()
    {
        show(12, 12);
        EVENTUALLY(notice().has_value());
        auto *row = find<AlertRow>("alertRow0");
        EVENTUALLY(row->isVisible());
        const QColor alarm = stateColors(row->palette()).alarm;
        QVERIFY(has(row->grab().toImage(), alarm));
        QVERIFY(has(find<StripItem>("stripLock")->grab().toImage(), alarm));
    }

    void totalBeginsAnewWithTheSession()
    {
        RefusalMeter meter;
        meter.handleEvent(engine::PlaintextRefused{1, "10.0.0.9:14550", 87, {}}, 10);
        QCOMPARE(meter.total(1), std::uint64_t(87));
        QCOMPARE(meter.lastMinute(1, 100), std::uint64_t(0));
        QCOMPARE(meter.total(1), std::uint64_t(87));
        meter.handleEvent(channel::SessionUp{}, 200);
        QCOMPARE(meter.total(1), std::uint64_t(0));
    }

private:
    static bool has(const QImage &image, const QColor &color)
    {
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (image.pixelColor(x, y).rgb() == color.rgb())
                    return true;
        return false;
    }

    engine::Snapshot attacked(std::uint64_t forged, std::uint64_t lastMinute)
    {
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.number = static_cast<std::uint64_t>(m_time);
        snapshot.security = lastMinute > 0 ? engine::Security::UnderAttack : engine::Security::Sealed;
        snapshot.sessions.front().stats.rx.forged = forged;
        snapshot.sessions.front().forgedLastMinute = lastMinute;
        return snapshot;
    }
    void show(std::uint64_t forged, std::uint64_t lastMinute) { m_station->show(attacked(forged, lastMinute)); }

    std::optional<Alert> notice() const { return find<AlertRow>("alertRow0")->alert(); }

    double m_time = 0;
};

SKYSEAL_TEST_WIDGETS(RefusalCountTest)
#include "refusal_count_test.moc"
