// Item models under QAbstractItemModelTester while they are filled, changed and emptied, and the content of their cells. The
// models of peers, shortcuts, sweeps and vehicles are tested beside their panels.
#include "core/engine/text/event_text.h"
#include "core/mavlink/enums.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/charts/suite_table_model.h"
#include "ui/refusal_meter.h"
#include "ui/inspector/field_model.h"
#include "ui/inspector/inspector_model.h"
#include "ui/links/client_model.h"
#include "ui/links/link_model.h"
#include "ui/messages/message_filter.h"
#include "ui/messages/message_model.h"
#include "ui/messages/messages_panel.h"
#include "ui/mission/mission_model.h"
#include "ui/overlays/overlay_model.h"
#include "ui/parameters/parameter_model.h"
#include "ui/replay/recording_model.h"
#include "ui/values/source_model.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QAbstractItemModelTester>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>

#include <bit>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::QtTest;

QString cell(const QAbstractItemModel &model, int row, int column)
{
    return model.index(row, column).data().toString();
}

} // namespace

class ModelsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void messagesAreBounded()
    {
        MessageModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        for (int i = 0; i < MessageModel::kMost + 50; ++i)
            model.append({QDateTime::currentDateTime(), 1, static_cast<std::uint8_t>(i % 8), QString::number(i)});
        QCOMPARE(model.rowCount(), MessageModel::kMost);
        QCOMPARE(cell(model, 0, MessageModel::Text), QStringLiteral("50"));
        QCOMPARE(cell(model, model.rowCount() - 1, MessageModel::Text), QString::number(MessageModel::kMost + 49));
        model.clear();
        QCOMPARE(model.rowCount(), 0);
    }

    void vehicleTextIsNotMarkup()
    {
        MessageModel model;
        model.append({QDateTime::currentDateTime(), 1, 6, QStringLiteral("<img src='file:///x'>1 < 2")});
        const QString tip = model.index(0, MessageModel::Text).data(Qt::ToolTipRole).toString();
        QVERIFY(!tip.contains(QStringLiteral("<img")));
        QVERIFY(tip.contains(QStringLiteral("&lt;img")));
    }

    void eventsReadAsOnTheCommandLine()
    {
        MessagesPanel panel;
        engine::PeerNames names;
        const auto shown = [&](const engine::Event &event) {
            panel.handleEvent(event);
            names.note(event);
            return cell(panel.model(), panel.model().rowCount() - 1, MessageModel::Text);
        };
        const auto sentence = [&](const engine::Event &event) { return engine::eventText(event, names).line(); };
        const engine::Event up = channel::SessionUp{channel::SessionId{7}, {}, "air-1", crypto::SuiteId::Aes256Gcm, {}};
        const engine::Event down = channel::SessionDown{channel::SessionId{7}, channel::DownReason::TimedOut, {}};
        QCOMPARE(shown(up), sentence(up));
        QCOMPARE(shown(down), sentence(down));
        const int rows = panel.model().rowCount();
        panel.handleEvent(channel::SwitchPending{});
        QCOMPARE(panel.model().rowCount(), rows);
        const engine::Event pending = engine::PlaintextRefused{1, "10.0.0.9:14550", 3, "air-1"};
        QVERIFY(shown(pending).startsWith(sentence(pending)));
        QVERIFY(shown(pending).contains(QStringLiteral("Allow plain MAVLink")));
        const engine::Event dropped = engine::EventsDropped{250};
        QCOMPARE(shown(dropped), QStringLiteral("Dropped 250 events because this program did not keep up"));
        QCOMPARE(cell(panel.model(), panel.model().rowCount() - 1, MessageModel::Severity), QStringLiteral("warning"));
    }

    /// Actions of this station on a vehicle are not shown as words of that vehicle.
    void onlyTextsOfTheVehicleComeFromIt()
    {
        MessagesPanel panel;
        panel.handleEvent(vehicle::TextReceived{1, {.number = 1, .severity = 6, .text = "EKF3 ready"}});
        panel.handleEvent(vehicle::MissionResult{.id = {}, .systemId = 1, .ok = true, .reason = {}});
        panel.handleEvent(vehicle::ParameterResult{.id = {}, .systemId = 1, .ok = true, .reason = {}});
        QStringList senders;
        for (int row = 0; row < panel.model().rowCount(); ++row)
            senders << cell(panel.model(), row, MessageModel::Vehicle);
        QCOMPARE(senders, (QStringList{QStringLiteral("1"), QStringLiteral("station"), QStringLiteral("station")}));
        QCOMPARE(cell(panel.model(), 0, MessageModel::Text), QStringLiteral("EKF3 ready"));
        QVERIFY2(cell(panel.model(), 1, MessageModel::Text).startsWith(QStringLiteral("Vehicle 1: ")),
                 qPrintable(cell(panel.model(), 1, MessageModel::Text)));
    }

    void messagesAreFiltered()
    {
        MessageModel model;
        MessageFilter filter;
        filter.setSourceModel(&model);
        QAbstractItemModelTester tester(&filter, kFatal);
        model.append({QDateTime::currentDateTime(), 1, 3, QStringLiteral("PreArm: Compass")});
        model.append({QDateTime::currentDateTime(), 1, 6, QStringLiteral("EKF3 ready")});
        filter.setLeastGrave(4);
        QCOMPARE(filter.rowCount(), 1);
        QCOMPARE(cell(filter, 0, MessageModel::Severity), QStringLiteral("error"));
        filter.setLeastGrave(7);
        filter.setWantedText(QStringLiteral("ekf"));
        QCOMPARE(filter.rowCount(), 1);
        QCOMPARE(cell(filter, 0, MessageModel::Text), QStringLiteral("EKF3 ready"));
    }

    void inspectorRowsKeepTheirPlace()
    {
        InspectorModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        auto rows = plainSnapshot(0).inspector;
        model.setRows(rows);
        QCOMPARE(model.rowCount(), static_cast<int>(rows.size()));
        QCOMPARE(cell(model, 0, InspectorModel::Name), QStringLiteral("ATTITUDE"));
        QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
        QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
        std::ranges::reverse(rows);
        for (auto &row : rows)
            row.count += 10;
        model.setRows(rows);
        QCOMPARE(inserted.size(), 0);
        QCOMPARE(reset.size(), 0);
        QCOMPARE(cell(model, 0, InspectorModel::Name), QStringLiteral("ATTITUDE"));
        rows.front().systemId = 2;
        model.setRows(rows);
        QCOMPARE(inserted.size(), 1);
        QCOMPARE(model.rowAt(model.rowCount() - 1)->systemId, std::uint8_t(2));
    }

    void inspectorRowsLeaveWithTheirVehicle()
    {
        InspectorModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        auto rows = plainSnapshot(0).inspector;
        const auto own = rows.size();
        for (std::size_t i = 0; i < own; ++i) {
            rows.push_back(rows[i]);
            rows.back().systemId = 2;
        }
        model.setRows(rows);
        QCOMPARE(model.rowCount(), static_cast<int>(2 * own));
        rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(own));
        model.setRows(rows);
        QCOMPARE(model.rowCount(), static_cast<int>(own));
        for (int row = 0; row < model.rowCount(); ++row)
            QCOMPARE(model.rowAt(row)->systemId, std::uint8_t(2));
        model.setRows({});
        QCOMPARE(model.rowCount(), 0);
    }

    void fieldsAreDecoded()
    {
        FieldModel model(mavlink::Dialect::builtin());
        QAbstractItemModelTester tester(&model, kFatal);
        engine::InspectorRow heartbeat;
        heartbeat.messageId = 0;
        heartbeat.payloadSize = 9;
        const std::uint8_t payload[] = {4, 0,    0, 0, 2,
                                        3, 0x81, 4, 3}; // custom_mode, quadrotor, ArduPilot, armed, active, version
        std::ranges::copy(payload, heartbeat.payload.begin());
        model.setMessage(&heartbeat);
        QHash<QString, QString> values;
        for (int row = 0; row < model.rowCount(); ++row)
            values.insert(cell(model, row, FieldModel::Name), cell(model, row, FieldModel::Value));
        QCOMPARE(values.value(QStringLiteral("type")), QStringLiteral("2 (MAV_TYPE_QUADROTOR)"));
        QCOMPARE(values.value(QStringLiteral("autopilot")), QStringLiteral("3 (MAV_AUTOPILOT_ARDUPILOTMEGA)"));
        QCOMPARE(values.value(QStringLiteral("custom_mode")), QStringLiteral("4"));
        QVERIFY(values.value(QStringLiteral("base_mode")).contains(QStringLiteral("MAV_MODE_FLAG_SAFETY_ARMED")));

        engine::InspectorRow attitude;
        attitude.messageId = 30;
        attitude.payloadSize = 28;
        const auto roll = std::bit_cast<std::array<std::uint8_t, 4>>(0.25f);
        std::ranges::copy(roll, attitude.payload.begin() + 4);
        model.setMessage(&attitude);
        QCOMPARE(cell(model, 1, FieldModel::Name), QStringLiteral("roll"));
        QCOMPARE(cell(model, 1, FieldModel::Value), QStringLiteral("0.25"));
        QCOMPARE(cell(model, 1, FieldModel::Unit), QStringLiteral("rad"));

        engine::InspectorRow strange;
        strange.messageId = 0xfffff0;
        strange.payloadSize = 2;
        strange.payload[0] = 0xab;
        model.setMessage(&strange);
        QCOMPARE(model.rowCount(), 1);
        QCOMPARE(cell(model, 0, FieldModel::Value), QStringLiteral("ab00"));
        model.setMessage(nullptr);
        QCOMPARE(model.rowCount(), 0);
    }

    void parametersAskAndShowWhatCameBack()
    {
        ParameterModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        QSignalSpy wanted(&model, &ParameterModel::writeRequested);
        model.setParameters(plainSnapshot(0).vehicles.front().parameters);
        QCOMPARE(model.rowCount(), 12);
        const QModelIndex value = model.index(2, ParameterModel::Value);
        QCOMPARE(value.data().toString(), QStringLiteral("3300"));
        QVERIFY(model.setData(value, QStringLiteral("5200"), Qt::EditRole));
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(wanted[0][0].toString(), QStringLiteral("BATT_CAPACITY"));
        QCOMPARE(wanted[0][1].toDouble(), 5200.0);
        QCOMPARE(value.data().toString(), QStringLiteral("3300")); // until the vehicle has read it back
        model.written({"BATT_CAPACITY", 5200, 9, 2}, true, {});
        QVERIFY(cell(model, 2, ParameterModel::State).contains(QStringLiteral("5200")));
        QVERIFY(!model.setData(value, QStringLiteral("many"), Qt::EditRole));
        QVERIFY(cell(model, 2, ParameterModel::State).contains(QStringLiteral("not a number")));
        QCOMPARE(wanted.size(), 1);
        model.setParameters(nullptr);
        QCOMPARE(model.rowCount(), 0);
    }

    void parametersAreCheckedAgainstTheirType_data()
    {
        QTest::addColumn<int>("type");
        QTest::addColumn<QString>("value");
        QTest::addColumn<bool>("fits");
        QTest::newRow("byte") << int(mavlink::MAV_PARAM_TYPE_UINT8) << QStringLiteral("255") << true;
        QTest::newRow("above a byte") << int(mavlink::MAV_PARAM_TYPE_UINT8) << QStringLiteral("256") << false;
        QTest::newRow("below a byte") << int(mavlink::MAV_PARAM_TYPE_UINT8) << QStringLiteral("-1") << false;
        QTest::newRow("part of a whole number") << int(mavlink::MAV_PARAM_TYPE_INT16) << QStringLiteral("1.5") << false;
        QTest::newRow("least 32 bits") << int(mavlink::MAV_PARAM_TYPE_INT32) << QStringLiteral("-2147483648") << true;
        QTest::newRow("real") << int(mavlink::MAV_PARAM_TYPE_REAL32) << QStringLiteral("1.5") << true;
        QTest::newRow("above a float") << int(mavlink::MAV_PARAM_TYPE_REAL32) << QStringLiteral("1e39") << false;
        QTest::newRow("not a number") << int(mavlink::MAV_PARAM_TYPE_REAL32) << QStringLiteral("nan") << false;
        QTest::newRow("infinite") << int(mavlink::MAV_PARAM_TYPE_REAL32) << QStringLiteral("inf") << false;
    }
    void parametersAreCheckedAgainstTheirType()
    {
        QFETCH(int, type);
        QFETCH(QString, value);
        QFETCH(bool, fits);
        ParameterModel model;
        model.setParameters(std::make_shared<const std::vector<vehicle::Parameter>>(
            1, vehicle::Parameter{"X", 3, static_cast<std::uint8_t>(type), 0}));
        const QSignalSpy wanted(&model, &ParameterModel::writeRequested);
        QCOMPARE(model.setData(model.index(0, ParameterModel::Value), value, Qt::EditRole), fits);
        QCOMPARE(wanted.size(), fits ? 1 : 0);
        QCOMPARE(model.index(0, ParameterModel::State).data().toString().startsWith(QStringLiteral("not written")), !fits);
    }

    /// The same name on two components, and whole numbers with all their digits.
    void parametersOfOtherComponentsHaveRowsOfTheirOwn()
    {
        constexpr std::uint8_t kWhole = mavlink::MAV_PARAM_TYPE_INT32;
        ParameterModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        const QSignalSpy wanted(&model, &ParameterModel::writeRequested);
        const auto show = [&model](std::uint8_t second) {
            model.setParameters(std::make_shared<const std::vector<vehicle::Parameter>>(
                std::vector<vehicle::Parameter>{{"RTL_ALT", 1500}, {"RTL_ALT", 60180513, kWhole, 0, second}}));
        };
        show(154);
        QCOMPARE(cell(model, 0, ParameterModel::Name), QStringLiteral("RTL_ALT"));
        QCOMPARE(cell(model, 1, ParameterModel::Name), QStringLiteral("154:RTL_ALT"));
        QCOMPARE(cell(model, 1, ParameterModel::Value), QStringLiteral("60180513"));
        QVERIFY(model.setData(model.index(1, ParameterModel::Value), QStringLiteral("60180512"), Qt::EditRole));
        QCOMPARE(wanted[0][0].toString(), QStringLiteral("154:RTL_ALT"));
        QCOMPARE(wanted[0][1].toDouble(), 60180512.);
        model.written({"RTL_ALT", 60180512, kWhole, 0, 154}, true, {});
        QVERIFY(cell(model, 0, ParameterModel::State).isEmpty());
        QVERIFY(cell(model, 1, ParameterModel::State).contains(QStringLiteral("60180512")));
        QCOMPARE(model.find(QStringLiteral("154:RTL_ALT"))->componentId, std::uint8_t(154));
        show(100); // another component, with the same names
        QCOMPARE(cell(model, 1, ParameterModel::Name), QStringLiteral("100:RTL_ALT"));
    }

    void resultsOfWritesAreForgottenWithTheVehicle()
    {
        ParameterModel model;
        model.setParameters(std::make_shared<const std::vector<vehicle::Parameter>>(1, vehicle::Parameter{"X", 3}));
        model.written({"X", 4}, true, {});
        QVERIFY(!model.index(0, ParameterModel::State).data().toString().isEmpty());
        model.forgetResults();
        QVERIFY(model.index(0, ParameterModel::State).data().toString().isEmpty());
    }

    /// The station reports once a second: one line counts them.
    void refusalsAreCountedInOneLine()
    {
        MessagesPanel panel;
        for (int second = 0; second < 5; ++second)
            panel.handleEvent(engine::PlaintextRefused{1, "10.0.0.9:14550", 87, {}});
        panel.handleEvent(engine::VehicleLost{1});
        panel.handleEvent(engine::PlaintextRefused{1, "10.0.0.9:14550", 87, {}});
        QCOMPARE(panel.model().rowCount(), 2);
        const auto line = [&panel](int row) { return panel.model().index(row, MessageModel::Text).data().toString(); };
        QVERIFY2(line(0).contains(QStringLiteral("522")), qPrintable(line(0)));
        panel.handleEvent(engine::PlaintextRefused{2, "10.0.0.9:14550", 1, {}}); // of another vehicle
        panel.handleEvent(engine::SystemRefused{1, "scout", {}, 3});
        QCOMPARE(panel.model().rowCount(), 4);
        panel.model().clear();
        panel.handleEvent(engine::PlaintextRefused{1, "10.0.0.9:14550", 87, {}});
        QCOMPARE(panel.model().rowCount(), 1);
    }

    void refusedFramesOfTheLastMinute()
    {
        RefusalMeter meter;
        meter.handleEvent(engine::PlaintextRefused{1, "10.0.0.9:14550", 87, {}}, 10);
        meter.handleEvent(engine::SystemRefused{1, "scout", {}, 3}, 30);
        meter.handleEvent(engine::PlaintextRefused{2, "10.0.0.9:14550", 5, {}}, 30);
        meter.handleEvent(engine::PlaintextRefused{1, "10.0.0.9:14550", 1, "scout"}, 30); // waits for approval
        QCOMPARE(meter.lastMinute(1, 40), std::uint64_t(90));
        QCOMPARE(meter.lastMinute(2, 40), std::uint64_t(5));
        QCOMPARE(meter.lastMinute(1, 71), std::uint64_t(3));
        QCOMPARE(meter.lastMinute(1, 91), std::uint64_t(0));
    }

    void missionShowsWhatIsFlown()
    {
        MissionModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        const auto mission = plainSnapshot(0).vehicles.front().mission;
        model.setMission(mission, 2, true);
        QCOMPARE(model.rowCount(), 5);
        QCOMPARE(cell(model, 0, MissionModel::Command), QStringLiteral("home"));
        QVERIFY(cell(model, 1, MissionModel::Command).startsWith(QStringLiteral("WAYPOINT")));
        QVERIFY(cell(model, 2, MissionModel::Command).contains(QStringLiteral("now")));
        model.setMission(mission, 0, false); // PX4 keeps home elsewhere, and flies to the first item
        QCOMPARE(cell(model, 0, MissionModel::Command), QStringLiteral("WAYPOINT (now)"));
        model.setMission(nullptr, -1, false);
        QCOMPARE(model.rowCount(), 0);
    }

    void itemsWithoutAPlaceShowNone_data()
    {
        QTest::addColumn<int>("command");
        QTest::addColumn<bool>("placed");
        QTest::addColumn<float>("altitude");
        QTest::addColumn<QString>("shown"); // latitude and altitude
        const QString none = QString(QChar(0x2013));
        QTest::newRow("waypoint") << int(mavlink::MAV_CMD_NAV_WAYPOINT) << true << 0.f
                                  << QStringLiteral("47.5000000 0.0\u00a0m");
        QTest::newRow("take-off here") << int(mavlink::MAV_CMD_NAV_TAKEOFF) << false << 20.f
                                       << none + QStringLiteral(" 20.0\u00a0m");
        QTest::newRow("return") << int(mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH) << false << 0.f << none + QLatin1Char(' ') + none;
        QTest::newRow("jump") << int(mavlink::MAV_CMD_DO_JUMP) << false << 0.f << none + QLatin1Char(' ') + none;
        QTest::newRow("camera, whose last parameter is no altitude")
            << int(mavlink::MAV_CMD_DO_DIGICAM_CONTROL) << false << 1.f << none + QLatin1Char(' ') + none;
    }
    void itemsWithoutAPlaceShowNone()
    {
        QFETCH(int, command);
        QFETCH(bool, placed);
        QFETCH(float, altitude);
        vehicle::MissionItem item{.command = static_cast<std::uint16_t>(command), .altitude = altitude};
        if (placed)
            item.latitude = 47.5;
        MissionModel model;
        model.setMission(std::make_shared<const std::vector<vehicle::MissionItem>>(1, item), -1, false);
        QTEST(cell(model, 0, MissionModel::Latitude) + QLatin1Char(' ') + cell(model, 0, MissionModel::Altitude), "shown");
    }

    /// Altitudes above home stand alone.
    void altitudesNameTheirReference()
    {
        std::vector<vehicle::MissionItem> items(3, {.latitude = 47.5, .longitude = 8.5, .altitude = 584});
        items[0].frame = mavlink::MAV_FRAME_GLOBAL;
        items[1].frame = mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT;
        items[2].frame = mavlink::MAV_FRAME_GLOBAL_TERRAIN_ALT;
        MissionModel model;
        model.setMission(std::make_shared<const std::vector<vehicle::MissionItem>>(items), -1, true);
        QCOMPARE(cell(model, 0, MissionModel::Altitude), QStringLiteral("584.0\u00a0m MSL"));
        QCOMPARE(cell(model, 1, MissionModel::Altitude), QStringLiteral("584.0\u00a0m"));
        QCOMPARE(cell(model, 2, MissionModel::Altitude), QStringLiteral("584.0\u00a0m above ground"));
    }

    void clientsShowTheirRights()
    {
        ClientModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        std::vector<engine::ClientSnapshot> clients{{"tcpin:127.0.0.1:5790", "127.0.0.1:50123", "none", {7, 2, 1, 3}}};
        model.setClients(clients);
        QCOMPARE(cell(model, 0, ClientModel::Client), QStringLiteral("127.0.0.1:50123"));
        QCOMPARE(cell(model, 0, ClientModel::Rights), QStringLiteral("reads"));
        QCOMPARE(cell(model, 0, ClientModel::Forwarded), QStringLiteral("7"));
        QCOMPARE(cell(model, 0, ClientModel::Refused), QStringLiteral("6"));
        clients.front().write = "mission,param";
        clients.push_back(clients.front());
        clients.back().address = "127.0.0.1:50124";
        clients.push_back(clients.front());
        clients.back().address = "127.0.0.1:50125";
        clients.back().write = "all";
        model.setClients(clients);
        QCOMPARE(cell(model, 1, ClientModel::Rights), QStringLiteral("reads, writes mission,param"));
        QCOMPARE(cell(model, 2, ClientModel::Rights), QStringLiteral("reads and writes"));
        model.setClients({});
        QCOMPARE(model.rowCount(), 0);
    }

    void linksShowWhereTheyListen()
    {
        LinkModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        auto links = plainSnapshot(0).links;
        model.setLinks(links);
        QCOMPARE(cell(model, 0, LinkModel::State), QStringLiteral("listening"));
        QCOMPARE(cell(model, 0, LinkModel::Local), QStringLiteral("0.0.0.0:14550"));
        links.front().phase = engine::LinkPhase::Failed;
        links.front().problem = "address in use";
        model.setLinks(links);
        QCOMPARE(cell(model, 0, LinkModel::State), QStringLiteral("failed: address in use"));
        links.clear();
        model.setLinks(links);
        QCOMPARE(model.rowCount(), 0);
    }

    void suitesHaveARowEach()
    {
        SampleHistory history;
        SuiteTableModel model(history, allQuantities());
        QAbstractItemModelTester tester(&model, kFatal);
        history.take(samplesOf(0, 0, 10, crypto::SuiteId::Aes256Gcm, 1));
        model.refresh();
        QCOMPARE(model.rowCount(), 1);
        history.take(samplesOf(1000, 10, 20, crypto::SuiteId::ChaCha20, 2));
        model.refresh();
        QCOMPARE(model.rowCount(), 2);
        QVERIFY(cell(model, 0, 0) != cell(model, 1, 0));
        history.take(samplesOf(0, 0, 5, crypto::SuiteId::Rc4, 1)); // of another station
        QCOMPARE(cell(model, 1, 0), QString());                    // until the model has heard of it
        model.refresh();
        QCOMPARE(model.rowCount(), 1);
    }

    void sourcesAreFilteredByWords()
    {
        SourceModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        const int all = model.rowCount();
        model.filter(QStringLiteral("ATTITUDE roll"));
        QVERIFY(model.rowCount() > 0 && model.rowCount() < all);
        model.filter(QStringLiteral("no such field"));
        QCOMPARE(model.rowCount(), 0);
        model.filter({});
        QCOMPARE(model.rowCount(), all);
    }

    void overlaysAreAddedChangedAndRemoved()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("field.kml"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly)
                && file.write(
                       "<kml><Placemark><name>Tree</name><Point><coordinates>8.5,47.4</coordinates></Point></Placemark></kml>")
                    > 0);
        file.close();
        OverlayModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        QVERIFY(model.add(path) && model.add(folder.filePath(QStringLiteral("none.kml"))));
        QCOMPARE(model.rowCount(), 2);
        EVENTUALLY(model.entries().front().shapes && !model.entries().back().problem.isEmpty());
        model.setColor(0, OverlayColor::Blue);
        QVERIFY(model.setData(model.index(0, OverlayModel::File), Qt::Unchecked, Qt::CheckStateRole));
        model.remove(1);
        QCOMPARE(model.rowCount(), 1);
        model.setFiles({});
        QCOMPARE(model.rowCount(), 0);
    }

    void recordingsAreDescribedWhereTheyStand()
    {
        RecordingModel model;
        QAbstractItemModelTester tester(&model, kFatal);
        engine::RecordingInfo one{.path = "/logs/a.tlog", .name = "a.tlog", .bytes = 1000}, other = one;
        other.path = "/logs/b.tlog";
        other.name = "b.tlog";
        model.setRecordings({one, other});
        other.problem = "permission denied";
        model.update(other);
        QCOMPARE(model.readCount(), 1);
        QVERIFY(cell(model, 1, RecordingModel::Vehicle).contains(QStringLiteral("permission denied")));
        model.setRecordings({});
        QCOMPARE(model.rowCount(), 0);
    }
};

SKYSEAL_TEST_WIDGETS(ModelsTest)
#include "models_test.moc"
