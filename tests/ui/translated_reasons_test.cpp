// Reasons that come from the engine are shown in the language of the window: of commands, links, recordings, parameters, and of
// what is typed, of sweeps and checklists. The translation of this test puts each sentence between marks.
#include "core/engine/text/qt_text.h"
#include "core/experiment/load_check.h"
#include "core/experiment/measured_link.h"
#include "core/link/link_error.h"
#include "core/vehicle/checklist.h"
#include "core/vehicle/reasons.h"
#include "scripted_snapshots.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"
#include "ui/links/link_dialog.h"
#include "ui/sweep/sweep_page.h"
#include "window_hands.h"
#include "window_rig.h"

#include <QtCore/QTranslator>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

using namespace skyseal;
using namespace skyseal::ui;
namespace reasons = skyseal::vehicle::reasons;

namespace {

class Marks : public QTranslator
{
public:
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        return qstrcmp(context, "Reason") == 0 ? QStringLiteral("‹%1›").arg(QString::fromUtf8(source)) : QString();
    }
    bool isEmpty() const override { return false; }
};

} // namespace

class TranslatedReasonsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(QCoreApplication::installTranslator(&m_marks)); }
    void cleanupTestCase() { QCoreApplication::removeTranslator(&m_marks); }
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void ofCommands_data()
    {
        QTest::addColumn<Reason>("reason");
        QTest::addColumn<QString>("words");
        QTest::newRow("not sent")
            << vehicle::nothingSent(reasons::kTakeOffNeedsGuided("LOITER"))
            << QStringLiteral("Land: ‹nothing was sent: ‹take-off needs the mode GUIDED, the vehicle is in LOITER››");
        QTest::newRow("silence") << reasons::kNoAnswer(5) << QStringLiteral("Land: ‹no answer to 5 attempts›");
        QTest::newRow("words of the vehicle") << reasons::kWithTexts(reasons::kCancelled, "PreArm: 100 %1")
                                              << QStringLiteral("Land: ‹‹cancelled›: PreArm: 100 %1›");
    }
    void ofCommands()
    {
        QFETCH(Reason, reason);
        m_station->show(sealedSnapshot(++m_time));
        WindowHands(*m_window).hold("landButton");
        EVENTUALLY(!m_station->requests.empty());
        m_station->notify(vehicle::CommandResult{
            .id = vehicle::RequestId{1}, .systemId = 1, .outcome = vehicle::CommandOutcome::Refused, .reason = reason});
        QTEST(find<QLabel>("commandResult")->text(), "words");
    }

    void ofLinksAndRecordings()
    {
        engine::Snapshot snapshot = sealedSnapshot(++m_time);
        snapshot.links.front().phase = engine::LinkPhase::Failed;
        snapshot.links.front().problem = link::LinkError{link::LinkErrorCode::DeviceMissing, "/dev/ttyUSB0", {}}.reason();
        snapshot.recording.problem = sentence("Reason", "less than %1 MiB are free there")(200);
        m_station->show(snapshot);
        EVENTUALLY(texts().contains(QStringLiteral("‹there is no device /dev/ttyUSB0›")));
        QVERIFY(texts().contains(QStringLiteral("‹less than 200 MiB are free there›")));
    }

    void ofSweeps()
    {
        experiment::Values values;
        values[experiment::Metric::Cpu] = 41;
        auto results = std::make_shared<experiment::Results>();
        results->plan.arms = {{crypto::SuiteId::None}, {crypto::SuiteId::Aes256Gcm}};
        results->samples.resize(2);
        results->samples[0].problem = experiment::MeasuredLink::kUnreadable;
        results->samples[1].invalid = experiment::loadProblem(experiment::Load::Saturated, values);
        SweepPage page;
        page.begin(results->plan);
        page.finish(results, {});
        const auto *status = page.findChild<QLabel *>(QStringLiteral("sweepStatus"));
        QVERIFY(status);
        for (const char *said : {"‹the vehicle's payloads could not be decrypted; is its key another one?›",
                                 "‹not saturated: nothing reached 95 % (‹41 % of the station's core›)›"})
            QVERIFY2(status->text().contains(QString::fromUtf8(said)), qPrintable(status->text()));
    }

    void ofChecklists()
    {
        const auto list = vehicle::parseChecklist("Battery full [battery_v 3]", "q.txt");
        QVERIFY(list && list->problems.size() == 1);
        const QString said = engine::reasonText(list->problems.front().reason());
        QVERIFY2(said.contains(QStringLiteral("‹expected ‹one of >= <= > < == !=›, found '3'›")), qPrintable(said));
    }

    void ofAddressesForOthers_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QString>("said");
        const auto row = [](const char *typed, const char *said) {
            QTest::newRow(typed) << QString::fromLatin1(typed) << QString::fromUtf8(said);
        };
        row("serial:/dev/ttyUSB0:57600", "‹'serial': clients are served over UDP or TCP›");
        row("udpin:14550,all", "‹'all': OPTION=VALUE is expected›");
        row("udpin:14550,reed=all", "‹'reed': write, from, sysid or name is expected›");
        row("udpin:14550,write=rc,write=ftp", "‹write is given twice›");
        row("udpin:14550,write=missions", "‹write='missions': none, all, or mission, param, command, ftp and rc are expected›");
        row("udpin:14550,sysid=0", "‹sysid='0': a system ID from 1 to 255 is expected›");
        row("udpin:14550,from=10.1.0.0/33", "‹from='10.1.0.0/33': ADDRESS/PREFIX is expected›");
        row("udpin:14550,name=", "‹name='': a name of printable characters is expected›");
        row("tcp:10.1.0.9:5760,from=10.1.0.0/16", "‹from=: 'tcp' serves the host of its URL alone");
    }
    void ofAddressesForOthers()
    {
        QFETCH(QString, typed);
        QFETCH(QString, said);
        find<QCheckBox>("serveOn")->click();
        auto *address = find<QComboBox>("serveUrl")->lineEdit();
        address->selectAll();
        QTest::keyClicks(address, typed);
        QTest::keyClick(address, Qt::Key_Return);
        const QString shown = find<QLabel>("serveState")->text();
        QVERIFY2(shown.contains(said), qPrintable(shown));
    }

    void ofWhatIsTyped()
    {
        QTest::keyClick(m_window.get(), Qt::Key_F12);
        auto *dialog = m_window->findChild<LinkDialog *>();
        EVENTUALLY(dialog && dialog->isVisible());
        auto *host = dialog->findChild<QLineEdit *>(QStringLiteral("linkHost"));
        QVERIFY(host);
        host->selectAll();
        QTest::keyClicks(host, QStringLiteral("999.1.1.1"));
        EVENTUALLY(texts().contains(QStringLiteral("‹\"999.1.1.1\" is not")));
    }

private:
    /// All that the labels and lists of the window say.
    QString texts() const
    {
        QStringList out;
        for (const QLabel *label : m_window->findChildren<QLabel *>())
            out << label->text() << label->toolTip();
        for (const QAbstractItemView *view : m_window->findChildren<QAbstractItemView *>())
            for (int row = 0; view->model() && row < view->model()->rowCount(); ++row)
                for (int column = 0; column < view->model()->columnCount(); ++column)
                    out << view->model()->index(row, column).data().toString();
        return out.join(QLatin1Char('\n'));
    }

    Marks m_marks;
    double m_time = 0;
};

SKYSEAL_TEST_WIDGETS(TranslatedReasonsTest)
#include "translated_reasons_test.moc"
