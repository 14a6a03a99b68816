// The list of recordings: what it shows while and after they are read, and what the choice of one starts.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/replay/recordings_dialog.h"
#include "ui/text/units.h"
#include "window_rig.h"

#include "core/mavlink/enums.h"

#include <QtTest/QAbstractItemModelTester>
#include <QtGui/QImage>
#include <QtTest/QTest>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;
using namespace std::chrono_literals;

class RecordingsDialogTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        ProgramFacts facts;
        facts.recordFolder = QStringLiteral("/logs");
        setUp(facts);
        QTest::keySequence(m_window.get(), QKeySequence::Open);
        EVENTUALLY(m_window->findChild<RecordingsDialog *>());
        m_view = find<QTreeView>("recordingView");
    }
    void cleanup() { tearDown(); }

    void foldersRecordingsAreListed()
    {
        QCOMPARE(m_station->listedFolders, std::vector<std::string>{"/logs"});
        QVERIFY(state().contains(QStringLiteral("/logs")));
        QVERIFY(!find<QPushButton>("recordingReplay")->isEnabled());
        list({file("old.tlog", 1000s), file("new.tlog", 2000s)});
        QCOMPARE(text(0, RecordingModel::File), QStringLiteral("new.tlog"));
        QCOMPARE(text(0, RecordingModel::Vehicle), QStringLiteral("reading…"));
        QVERIFY(state().startsWith(QStringLiteral("0 of 2")));
    }

    void recordingIsDescribedOnceItWasRead()
    {
        const QAbstractItemModelTester tester(m_view->model());
        engine::RecordingInfo one = file("a.tlog", 1000s), other = file("b.tlog", 2000s);
        list({one, other});
        one.index = indexed(1'600'000'000s, 754s, {1, 2});
        Q_EMIT m_station->recordingRead(one);
        other.problem = "permission denied";
        Q_EMIT m_station->recordingRead(other);
        const int row = text(0, RecordingModel::File) == QLatin1String("a.tlog") ? 0 : 1;
        QCOMPARE(row, 1); // stays where it was listed, although the flight began later
        QCOMPARE(text(row, RecordingModel::Length), QStringLiteral("12:34"));
        QVERIFY2(text(row, RecordingModel::Date).startsWith(QStringLiteral("2020-09-13")),
                 qPrintable(text(row, RecordingModel::Date)));
        QVERIFY(text(row, RecordingModel::Vehicle).contains(QStringLiteral(" 1, ")));
        QVERIFY(text(1 - row, RecordingModel::Vehicle).contains(QStringLiteral("permission denied")));
        QVERIFY(state().startsWith(QStringLiteral("2 recordings")));
    }

    void ciphersAreListed()
    {
        engine::RecordingInfo sealed = file("sealed.tlog", 3000s), plain = file("plain.tlog", 2000s),
                              damaged = file("damaged.tlog", 1000s);
        list({sealed, plain, damaged});
        QCOMPARE(text(0, RecordingModel::Ciphers), QString());
        QCOMPARE(m_view->model()->headerData(RecordingModel::Ciphers, Qt::Horizontal).toString(), QStringLiteral("Ciphers"));
        auto index = *indexed(1'600'000'000s, 754s, {1});
        plain.index = std::make_shared<const tlog::LogIndex>(index);
        for (const char *suite : {"chacha20-poly1305", "rc4", "chacha20-poly1305", "of-tomorrow"})
            index.suites.push_back({{}, {tlog::LinkEvent::Kind::Switched, {}, suite, "air-1"}});
        sealed.index = std::make_shared<const tlog::LogIndex>(index);
        index.suites.resize(1);
        index.unreadableEvents = 1;
        damaged.index = std::make_shared<const tlog::LogIndex>(index);
        for (const engine::RecordingInfo &one : {sealed, plain, damaged})
            Q_EMIT m_station->recordingRead(one);
        const QString names = text(0, RecordingModel::Ciphers);
        QVERIFY2(names.startsWith(QStringLiteral("ChaCha20-Poly1305, RC4")) && names.contains(QStringLiteral("insecure"))
                     && names.endsWith(QStringLiteral(", of-tomorrow")),
                 qPrintable(names));
        QCOMPARE(names.count(QStringLiteral("ChaCha20")), 1);
        QCOMPARE(text(1, RecordingModel::Ciphers), dash());
        const QModelIndex none = m_view->model()->index(1, RecordingModel::Ciphers);
        QVERIFY(none.data(Qt::ToolTipRole).toString().contains(QStringLiteral("No cipher suite is noted")));
        QCOMPARE(text(2, RecordingModel::Ciphers), QStringLiteral("ChaCha20-Poly1305, one unreadable line about ciphers"));
    }

    void plainMavlinkIsOneOfTheCiphers()
    {
        engine::RecordingInfo one = file("a.tlog", 1000s);
        list({one});
        auto index = *indexed(1'600'000'000s, 754s, {1});
        index.suites.push_back({{}, {tlog::LinkEvent::Kind::Plain, {}, "none", "1"}});
        index.suites.push_back({400s, {tlog::LinkEvent::Kind::Sealed, {}, "aes-256-gcm", "air-1"}});
        one.index = std::make_shared<const tlog::LogIndex>(index);
        Q_EMIT m_station->recordingRead(one);
        QCOMPARE(text(0, RecordingModel::Ciphers), QStringLiteral("plain MAVLink, AES-256-GCM"));
    }

    /// As the recorder names them.
    void namesAreLegible()
    {
        const char *name = "2026-11-27T08-24-12Z.tlog";
        list({file(name, 1000s)});
        EVENTUALLY(m_view->isVisible());
        const int room = m_view->visualRect(m_view->model()->index(0, RecordingModel::File)).width();
        QVERIFY(room > m_view->fontMetrics().horizontalAdvance(QLatin1String(name)) + 4);
        QVERIFY(m_view->model()
                    ->index(0, RecordingModel::File)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("/logs/") + QLatin1String(name)));
        const std::string longName(80, 'm');
        list({file(longName + "1.tlog", 1000s), file(longName + "2.tlog", 1000s)});
        m_view->setCurrentIndex({});
        m_view->clearSelection();
        const auto picture = [this](int row) {
            return m_view->viewport()->grab(m_view->visualRect(m_view->model()->index(row, RecordingModel::File))).toImage();
        };
        QVERIFY(picture(0) != picture(1)); // their ends are seen
    }

    /// A file beside a recording may name any number of suites.
    void ciphersOfAHostileFileAreFew()
    {
        engine::RecordingInfo one = file("a.tlog", 1000s);
        list({one});
        auto index = *indexed(1'600'000'000s, 754s, {1});
        for (int i = 0; i < 500; ++i)
            index.suites.push_back({{}, {tlog::LinkEvent::Kind::Switched, {}, "suite-" + std::to_string(i), {}}});
        one.index = std::make_shared<const tlog::LogIndex>(index);
        Q_EMIT m_station->recordingRead(one);
        QVERIFY(text(0, RecordingModel::Ciphers).size() < 200);
        QVERIFY(text(0, RecordingModel::Ciphers).endsWith(QStringLiteral("and others")));
    }

    void emptyFolderSaysWhatToDo()
    {
        list({});
        QVERIFY(state().contains(QStringLiteral("Settings")));
        QVERIFY(!find<QPushButton>("recordingReplay")->isEnabled());
    }

    void enterReplaysTheSelectedOne()
    {
        list({file("old.tlog", 1000s), file("new.tlog", 2000s)});
        QTest::keyClick(m_view, Qt::Key_Down);
        QTest::keyClick(m_view, Qt::Key_Return);
        QCOMPARE(m_station->replays, std::vector<std::string>{"tlog:/logs/old.tlog"});
        EVENTUALLY(!m_window->findChild<RecordingsDialog *>());
        QCOMPARE(m_station->listingsStopped, 1);
    }

    void buttonReplaysTheSelectedOne()
    {
        list({file("old.tlog", 1000s), file("new.tlog", 2000s)});
        QTest::mouseClick(find<QPushButton>("recordingReplay"), Qt::LeftButton);
        QCOMPARE(m_station->replays, std::vector<std::string>{"tlog:/logs/new.tlog"});
    }

    void anyFileCanBeChosen()
    {
        QTest::mouseClick(find<QPushButton>("recordingOther"), Qt::LeftButton);
        EVENTUALLY(m_window->findChild<QFileDialog *>());
        Q_EMIT m_window->findChild<QFileDialog *>()->fileSelected(QStringLiteral("/else/where.tlog"));
        QCOMPARE(m_station->replays, std::vector<std::string>{"tlog:/else/where.tlog"});
    }

    /// The selection stays where it is while hundreds of recordings are read.
    void manyRecordingsAreRead()
    {
        std::vector<engine::RecordingInfo> all;
        for (int i = 0; i < 500; ++i)
            all.push_back(file("flight-" + std::to_string(1000 + i) + ".tlog", std::chrono::seconds(10'000 - i)));
        list(all);
        m_view->setCurrentIndex(m_view->model()->index(7, 0));
        const QString selected = text(7, RecordingModel::File);
        for (engine::RecordingInfo &one : all) {
            one.index = indexed(std::chrono::floor<std::chrono::seconds>(one.modified.time_since_epoch()), 60s, {1});
            Q_EMIT m_station->recordingRead(one);
        }
        QVERIFY(state().startsWith(QStringLiteral("500 recordings")));
        QCOMPARE(m_view->currentIndex().siblingAtColumn(RecordingModel::File).data().toString(), selected);
    }

private:
    static engine::RecordingInfo file(const std::string &name, std::chrono::seconds modified)
    {
        engine::RecordingInfo out{"/logs/" + name, name};
        out.bytes = 1'500'000;
        out.modified = WallTime(modified);
        return out;
    }
    static std::shared_ptr<const tlog::LogIndex> indexed(std::chrono::seconds first, Duration length,
                                                         std::vector<std::uint8_t> vehicles)
    {
        auto out = std::make_shared<tlog::LogIndex>();
        out->first = WallTime(first);
        out->length = length;
        out->vehicles = std::move(vehicles);
        for (const std::uint8_t systemId : out->vehicles)
            out->modes.push_back({{}, systemId, mavlink::MAV_TYPE_QUADROTOR, mavlink::MAV_AUTOPILOT_ARDUPILOTMEGA, 1, 0});
        return out;
    }
    void list(const std::vector<engine::RecordingInfo> &all) { Q_EMIT m_station->recordingsListed(all); }
    QString state() const { return find<QLabel>("recordingState")->text(); }
    QString text(int row, int column) const { return m_view->model()->index(row, column).data().toString(); }

    QTreeView *m_view = nullptr;
};

SKYSEAL_TEST_WIDGETS(RecordingsDialogTest)
#include "recordings_dialog_test.moc"
