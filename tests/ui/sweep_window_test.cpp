// A sweep from the window, by clicks, on the real engine with a simulated vehicle and the agent beside it: what is shown is
// what is saved, and the link goes back to the suite that it had, whatever ended the sweep. Pictures are kept in the
// folder that SKYSEAL_PICTURES names.
#include "app/skyseal/station_adapter.h"
#include "app/skyseal/sweep_controller.h"
#include "core/channel/policy.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/suite.h"
#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "core/experiment/metric.h"
#include "tests/support/eventually.h"
#include "tests/support/flight.h"
#include "tests/support/free_port.h"
#include "tests/support/test_runner.h"
#include "ui/window/main_window.h"
#include "ui/security/suite_actions.h"
#include "ui/settings.h"
#include "ui/status/strip_item.h"
#include "ui/sweep/sweep_bars.h"
#include "ui/sweep/sweep_presenter.h"
#include "ui/sweep/sweep_dialog.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_table_model.h"

#include <QtCore/QDir>
#include <QtCore/QElapsedTimer>
#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QSettings>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtTest/QAbstractItemModelTester>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtGui/QAction>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>
#include <QtWidgets/QTableView>

#include <cmath>

using namespace skyseal;
using namespace skyseal::test;
using namespace skyseal::ui;
using crypto::SuiteId;

namespace {

QString q(const char *text)
{
    return QString::fromUtf8(text);
}

} // namespace

class SweepWindowTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void nothingConnected();
    void showsDisabledReason();
    void showsWhatItSaves();
    void cancelGoesBack();
    void overARadio();
    void onAVehicleOfItsOwn();
    void besideAnAutopilot();
    void lossGoesBack();
    void closingGoesBack();
    void cleanupTestCase();

private:
    void connectSealed();
    void beginWith(SuiteId suite);
    SweepDialog *openDialog();
    void choose(SweepDialog &dialog, const QStringList &suites, double seconds, int repeats, bool withInline);
    void run(SweepDialog &dialog);
    void compareWithFiles(const QString &folder);
    void picture(const char *name);

    template<typename W> W *find(const char *name)
    {
        W *found = m_window->findChild<W *>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }
    static void set(QDialog &dialog, const char *name, bool on)
    {
        auto *box = dialog.findChild<QAbstractButton *>(QLatin1String(name));
        QVERIFY2(box, name);
        if (box->isChecked() != on)
            QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(10, box->height() / 2));
        QVERIFY2(box->isChecked() == on, name);
    }
    SweepPage &page() { return *m_window->findChild<SweepPage *>(); }
    QString status() { return find<QLabel>("sweepStatus")->text(); }
    SuiteId suite() { return m_window->view().session ? m_window->view().session->info.suite : SuiteId::None; }

    Flight m_flight;
    QTemporaryDir m_folder;
    std::unique_ptr<Program> m_sim, m_air;
    std::unique_ptr<QSettings> m_store;
    std::unique_ptr<app::StationAdapter> m_station;
    std::unique_ptr<app::SweepController> m_server;
    std::unique_ptr<MainWindow> m_window;
};

void SweepWindowTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
    qputenv("PATH", QByteArray(SKYSEAL_BIN_DIR) + ':' + qgetenv("PATH"));
    QVERIFY(m_flight.ready());
    engine::StationConfig config;
    config.keys = {m_flight.path(q("ground.key")).toStdString(), m_flight.path(q("ground.peers")).toStdString()};
    config.policy.suites = channel::defaultSuites();
    config.policy.allowResearch = true;
    config.record = false;
    auto station = engine::Station::create(config);
    QVERIFY2(station, station ? "" : station.error().text().c_str());
    m_station = std::make_unique<app::StationAdapter>(std::move(*station));
    m_server = std::make_unique<app::SweepController>(*m_station, nullptr);
    m_store = std::make_unique<QSettings>(m_folder.filePath(q("s.ini")), QSettings::IniFormat);
    Settings settings;
    settings.allowResearch = true;
    settings.theme = qEnvironmentVariable("SKYSEAL_THEME") == q("dark") ? Theme::Dark : Theme::Light;
    storeSettings(*m_store, settings);
    m_window = std::make_unique<MainWindow>(*m_station, *m_store, ProgramFacts{});
    m_window->setSweep(*m_server);
    m_window->resize(1280, 900);
    m_window->show();
}

SweepDialog *SweepWindowTest::openDialog()
{
    m_window->activateWindow();
    if (!QTest::qWaitForWindowActive(m_window.get(), test::kDeadlineMs))
        qFatal("the window does not become active");
    QTest::keyClick(m_window.get(), Qt::Key_R, Qt::ControlModifier);
    auto *dialog = m_window->findChild<SweepDialog *>();
    if (!dialog) // the key did not reach the window
        qFatal("no dialog");
    return dialog;
}

void SweepWindowTest::choose(SweepDialog &dialog, const QStringList &suites, double seconds, int repeats, bool withInline)
{
    for (const crypto::SuiteInfo &info : crypto::suites()) {
        const QByteArray name = QByteArray::fromStdString(std::string(info.name));
        set(dialog, ("sweep_" + name).constData(), suites.contains(QLatin1String(name)));
    }
    set(dialog, "sweepInline", withInline);
    dialog.findChild<QDoubleSpinBox *>(q("sweepSeconds"))->setValue(seconds);
    dialog.findChild<QSpinBox *>(q("sweepRepeats"))->setValue(repeats);
}

void SweepWindowTest::run(SweepDialog &dialog)
{
    QAbstractButton *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
    QVERIFY(ok->isEnabled());
    QTest::mouseClick(ok, Qt::LeftButton);
    EVENTUALLY(page().isRunning());
}

void SweepWindowTest::nothingConnected()
{
    SweepDialog *dialog = openDialog();
    auto *connected = dialog->findChild<QAbstractButton *>(q("sweepConnected"));
    QVERIFY(!connected->isEnabled());
    QVERIFY2(connected->text().contains(q("nothing is connected")), qPrintable(connected->text()));
    QVERIFY(dialog->order().target == SweepTarget::Simulated);
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(!page().isRunning());
    delete dialog;
}

void SweepWindowTest::connectSealed()
{
    m_air = std::make_unique<Program>(q("skyseal-air"), m_flight.airArguments(0, {q("--allow-plain"), q("--allow-inline")}));
    const ViewState &view = m_window->view();
    EVENTUALLY(view.session && view.vehicle && !view.vehicle->state.lost);
}

/// The suite that the link is to have again in the end; not the default one, which it would have after any new session.
void SweepWindowTest::beginWith(SuiteId wanted)
{
    EVENTUALLY(m_window->suites().action(wanted)->isEnabled());
    if (suite() != wanted)
        m_window->suites().action(wanted)->trigger();
    EVENTUALLY_EQUAL(suite(), wanted);
}

void SweepWindowTest::showsDisabledReason()
{
    m_sim = std::make_unique<Program>(q("skyseal-sim"), m_flight.simArguments());
    m_window->addLink(q("udpin:127.0.0.1:%1").arg(m_flight.groundPort));
    { // an agent that does not allow plain MAVLink
        Program air(q("skyseal-air"), m_flight.airArguments());
        EVENTUALLY(m_window->view().session && m_window->view().vehicle);
        SweepDialog *dialog = openDialog();
        QVERIFY(dialog->order().target == SweepTarget::Connected);
        auto *plain = dialog->findChild<QAbstractButton *>(q("sweep_none"));
        QVERIFY(!plain->isEnabled());
        QVERIFY2(plain->text().contains(q("the agent does not allow it")), qPrintable(plain->text()));
        QVERIFY2(plain->toolTip().contains(q("--allow-plain")), qPrintable(plain->toolTip()));
        auto *saturated = dialog->findChild<QAbstractButton *>(q("sweepSaturated"));
        QVERIFY(!saturated->isEnabled() && saturated->text().contains(q("cannot be changed")));
        set(*dialog, "sweepOwn", true);
        QVERIFY(plain->isEnabled() && saturated->isEnabled());
        picture("sweep-dialog");
        delete dialog;
        air.terminate();
    }
    EVENTUALLY(!m_window->view().session);
    connectSealed();
    SweepDialog *dialog = openDialog();
    auto *plain = dialog->findChild<QAbstractButton *>(q("sweep_none"));
    QVERIFY(plain->isEnabled() && !plain->isChecked()); // it takes an act of this end as well
    set(*dialog, "sweep_none", true);
    QVERIFY(dialog->findChild<QLabel *>(q("sweepWarning"))->isVisible());
    delete dialog;
}

void SweepWindowTest::compareWithFiles(const QString &folder)
{
    QFile file(folder + q("/sweep.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject report = QJsonDocument::fromJson(file.readAll()).object();
    QCOMPARE(report[q("schema")].toString(), q("skyseal-sweep"));
    QHash<QString, double> means;
    for (const QJsonValue summary : report[q("summaries")].toArray())
        means[summary[q("suite")].toString() + summary[q("framing")].toString() + summary[q("again")].toVariant().toString()
              + summary[q("metric")].toString()] = summary[q("mean")].toDouble();
    auto *model = qobject_cast<SweepTableModel *>(find<QTableView>("sweepTable")->model());
    const experiment::Plan &plan = page().results()->plan;
    QCOMPARE(model->rowCount(), static_cast<int>(plan.arms.size()));
    QCOMPARE(report[q("plan")][q("arms")].toArray().size(), model->rowCount());
    qsizetype compared = 0;
    for (int row = 0; row < model->rowCount(); ++row) {
        const experiment::SweepArm &arm = plan.arms[static_cast<std::size_t>(row)];
        for (int column = SweepTableModel::FixedColumns; column < model->columnCount(); ++column) {
            const auto place = static_cast<std::size_t>(column - SweepTableModel::FixedColumns);
            const experiment::MetricInfo &metric = experiment::info(model->metrics()[place]);
            const QString key = q(crypto::suiteInfo(arm.suite).name.data()) + q(framingName(arm).data())
                + (arm.again ? q("true") : q("false")) + q(metric.key.data());
            const QModelIndex index = model->index(row, column);
            const QVariant mean = index.data(SweepTableModel::ValueRole);
            QCOMPARE(mean.isValid(), means.contains(key));
            if (!mean.isValid())
                continue;
            QCOMPARE(mean.toDouble(), means[key]);
            QVERIFY(index.data().toString().startsWith(QString::fromStdString(experiment::readable(means[key]))));
            ++compared;
        }
    }
    QCOMPARE(compared, means.size());
    QVERIFY(compared > 20);
    const experiment::BarChart &chart = m_window->findChild<SweepBars *>()->chart();
    QCOMPARE(chart.title, std::string("Packets transmitted"));
    QCOMPARE(chart.bars[0].mean, means[q("noneplainfalsepackets")]);
}

void SweepWindowTest::showsWhatItSaves()
{
    beginWith(SuiteId::Aes256Gcm);
    auto *model = find<QTableView>("sweepTable")->model();
    const QAbstractItemModelTester tester(model);
    SweepDialog *dialog = openDialog();
    choose(*dialog, {q("none"), q("aes-256-gcm"), q("chacha20")}, 1, 1, true);
    picture("sweep-dialog-connected");
    // The longest time that this thread did nothing else, seen by a timer.
    qint64 longest = 0;
    QElapsedTimer since;
    QTimer pulse;
    connect(&pulse, &QTimer::timeout, this, [&] { longest = std::max(longest, since.restart()); });
    pulse.start(20);
    since.start();
    QStringList shown; // at the beginning of each run: a look now and then could miss one
    const auto runs = connect(m_server.get(), &SweepInterface::runBegan, this, [&] { shown << status(); });
    run(*dialog);
    QVERIFY(!m_window->suites().action(SuiteId::Aes256Cbc)->isEnabled()); // the sweep's business now
    const auto secondWasShown = [&shown] {
        return std::ranges::any_of(shown, [](const QString &text) { return text.startsWith(q("Run 2 of 4")); });
    };
    EVENTUALLY(secondWasShown());
    disconnect(runs);
    picture("sweep-running");
    EVENTUALLY(!page().isRunning());
    pulse.stop();
    qInfo("the window stood still for %lld ms at the most; %s", static_cast<long long>(longest), qPrintable(status()));
    QVERIFY(page().results()->complete);
    QCOMPARE(page().results()->samples.size(), std::size_t(4)); // AES-256-GCM is not inline
    for (const experiment::Sample &sample : page().results()->samples) {
        QVERIFY2(sample.problem.empty(), sample.problem.text().c_str());
        QVERIFY(sample.values[experiment::Metric::Packets] >= 10);
    }
    QCOMPARE(model->index(3, SweepTableModel::FixedColumns).data().toString(), q("not in this framing"));
    EVENTUALLY_EQUAL(suite(), SuiteId::Aes256Gcm);
    EVENTUALLY(m_window->suites().action(SuiteId::Aes256Cbc)->isEnabled());

    QSignalSpy saved(m_server.get(), &SweepInterface::saved);
    m_window->sweep()->saveIn(m_folder.path());
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, 2 * test::kDeadlineMs);
    QVERIFY2(saved[0][1].toBool(), qPrintable(saved[0][2].toString()));
    compareWithFiles(saved[0][0].toString());
    for (const char *file : {"sweep.csv", "report.html", "figures/packets-natural.svg"})
        QVERIFY2(QFile::exists(saved[0][0].toString() + QLatin1Char('/') + q(file)), file);
    picture("sweep-done");
}

void SweepWindowTest::cancelGoesBack()
{
    beginWith(SuiteId::Aes256Gcm);
    SweepDialog *dialog = openDialog();
    choose(*dialog, {q("rc4")}, 1, 50, false);
    run(*dialog);
    EVENTUALLY(!page().results()->samples.empty());
    QCOMPARE(suite(), SuiteId::Rc4);
    QTest::mouseClick(find<QPushButton>("sweepCancel"), Qt::LeftButton);
    EVENTUALLY(!page().isRunning());
    EVENTUALLY_EQUAL(suite(), SuiteId::Aes256Gcm);
    QVERIFY(!page().results()->complete);
    QVERIFY2(status().startsWith(q("Incomplete")), qPrintable(status()));

    // In the middle of plain MAVLink as well: sealed again, and with that suite.
    dialog = openDialog();
    choose(*dialog, {q("none")}, 1, 50, false);
    run(*dialog);
    EVENTUALLY(!page().results()->samples.empty());
    QVERIFY(!m_window->view().session);
    const QString advice = find<QLabel>("secureAdvice")->text();
    QVERIFY2(advice.contains(q("is measuring plain MAVLink")) && !advice.contains(q("Start skyseal-air")), qPrintable(advice));
    QVERIFY2(find<StripItem>("stripLock")->toolTip().contains(q("is measuring plain MAVLink")),
             qPrintable(find<StripItem>("stripLock")->toolTip()));
    QCOMPARE(find<QLabel>("switchNote")->text(), QString()); // the session ended as was wanted
    picture("sweep-in-clear");
    QTest::mouseClick(find<QPushButton>("sweepCancel"), Qt::LeftButton);
    EVENTUALLY(!page().isRunning());
    EVENTUALLY_EQUAL(suite(), SuiteId::Aes256Gcm);
    EVENTUALLY(find<QLabel>("secureTitle")->text().startsWith(q("Sealed")));
}

/// A radio's line, by clicks: the page and the report name it, and it shows in what comes through.
void SweepWindowTest::overARadio()
{
    SweepDialog *dialog = openDialog();
    set(*dialog, "sweepOwn", true);
    choose(*dialog, {q("chacha20-poly1305")}, 2, 1, false);
    set(*dialog, "sweepNatural", false);
    for (const char *link : {"sweepClean", "sweepLine921600"})
        set(*dialog, link, false);
    set(*dialog, "sweepRadio57600", true);
    picture("sweep-dialog-radio");
    QString shown;
    const auto runs = connect(m_server.get(), &SweepInterface::runBegan, this, [&] { shown = status(); });
    run(*dialog);
    EVENTUALLY(!page().isRunning());
    disconnect(runs);
    QVERIFY2(shown.startsWith(q("Run 1 of 1")) && shown.contains(q("57,600 baud, 20 ms delay")), qPrintable(shown));
    QVERIFY2(page().results()->complete, qPrintable(status()));
    const experiment::Sample &sample = page().results()->samples.front();
    QVERIFY2(sample.problem.empty(), sample.problem.text().c_str());
    const double rate = sample.values[experiment::Metric::WireRate];
    // 5,760 bytes a second; on a busy machine the relay delivers in bursts at the ends of the interval. Without the radio it is
    // a thousand times as much.
    QVERIFY2(rate > 1000 && rate < 9000, qPrintable(QString::number(rate)));
    auto *place = find<QComboBox>("sweepPlace");
    QVERIFY(place->isVisible() && place->currentText().contains(q("57,600 baud")));

    QSignalSpy saved(m_server.get(), &SweepInterface::saved);
    m_window->sweep()->saveIn(m_folder.path());
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, 2 * test::kDeadlineMs);
    QFile report(saved[0][0].toString() + q("/report.html"));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QByteArray html = report.readAll();
    QVERIFY(html.contains("link 57,600 baud, 20 ms delay; saturated load"));
    QVERIFY(html.contains("--impair rate=57600,delay=20")); // how to do it again
}

void SweepWindowTest::onAVehicleOfItsOwn()
{
    SweepDialog *dialog = openDialog();
    set(*dialog, "sweepOwn", true);
    choose(*dialog, {q("none"), q("chacha20")}, 1, 1, false);
    set(*dialog, "sweepNatural", false);
    run(*dialog);
    EVENTUALLY(!page().isRunning());
    QVERIFY2(page().results()->complete, qPrintable(status()));
    QCOMPARE(page().results()->samples.size(), std::size_t(2));
    for (const experiment::Sample &sample : page().results()->samples) {
        QVERIFY(sample.values[experiment::Metric::Packets] > 1000); // saturated
        QVERIFY(sample.values[experiment::Metric::AgentCpu] > 0);
    }
    QCOMPARE(suite(), SuiteId::Aes256Gcm); // the connected link was left alone
}

void SweepWindowTest::besideAnAutopilot()
{
    const QString url = q("tcp:127.0.0.1:%1").arg(freeTcpPort());
    Program autopilot(q("skyseal-sim"), {q("--link"), QString(url).replace(q("tcp:"), q("tcpin:"))});
    SweepDialog *dialog = openDialog();
    set(*dialog, "sweepBeside", true);
    auto *link = dialog->findChild<QLineEdit *>(q("sweepAutopilot"));
    link->selectAll();
    QTest::keyClicks(link, url);
    choose(*dialog, {q("none"), q("aes-256-ctr")}, 1, 1, false);
    run(*dialog);
    EVENTUALLY(!page().isRunning());
    const auto results = page().results();
    QVERIFY2(results->complete, qPrintable(status()));
    QCOMPARE(results->samples.size(), std::size_t(2));
    for (const experiment::Sample &sample : results->samples)
        QVERIFY(sample.isValid() && sample.values[experiment::Metric::Packets] > 10);
    QVERIFY2(results->source.find(url.toStdString()) != std::string::npos, results->source.c_str());
    QVERIFY(experiment::settingOf(*results, "command_line").find("--vehicle " + url.toStdString()) != std::string::npos);
    QCOMPARE(suite(), SuiteId::Aes256Gcm); // the connected link was left alone
}

void SweepWindowTest::lossGoesBack()
{
    beginWith(SuiteId::Aes256Gcm);
    SweepDialog *dialog = openDialog();
    choose(*dialog, {q("chacha20")}, 1, 50, false);
    run(*dialog);
    EVENTUALLY(!page().results()->samples.empty());
    m_air->kill();
    QTRY_VERIFY_WITH_TIMEOUT(!page().isRunning(), 2 * test::kDeadlineMs); // three runs that each wait for the link
    QVERIFY2(status().startsWith(q("Incomplete")), qPrintable(status()));
    connectSealed();
    EVENTUALLY_EQUAL(suite(), SuiteId::Aes256Gcm);
}

void SweepWindowTest::closingGoesBack()
{
    beginWith(SuiteId::Aes256Gcm);
    SweepDialog *dialog = openDialog();
    choose(*dialog, {q("rc4")}, 1, 50, false);
    run(*dialog);
    EVENTUALLY(!page().results()->samples.empty());
    m_window->close();
    QVERIFY(m_window->isVisible());
    EVENTUALLY(!m_window->isVisible());
    EVENTUALLY_EQUAL(suite(), SuiteId::Aes256Gcm);
}

void SweepWindowTest::cleanupTestCase()
{
    m_window.reset();
    m_server.reset();
    m_station.reset();
}

void SweepWindowTest::picture(const char *name)
{
    const QString folder = qEnvironmentVariable("SKYSEAL_PICTURES");
    if (folder.isEmpty())
        return;
    auto *dialog = m_window->findChild<SweepDialog *>();
    QWidget *shown = dialog ? static_cast<QWidget *>(dialog) : m_window.get();
    QVERIFY(shown->grab().save(QDir(folder).filePath(QLatin1String(name) + q(".png"))));
}

SKYSEAL_TEST_WIDGETS(SweepWindowTest)
#include "sweep_window_test.moc"
