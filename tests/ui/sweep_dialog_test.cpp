// The question before a sweep, by clicks and without any program: what is chosen is what is ordered, above all over which
// links.
#include "fake_station.h"
#include "tests/support/test_runner.h"
#include "ui/security/suite_actions.h"
#include "ui/sweep/link_conditions.h"
#include "ui/sweep/sweep_dialog.h"
#include "ui/sweep/sweep_page.h"
#include "ui/sweep/sweep_labels.h"

#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include <memory>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

QStringList namesOf(const std::vector<experiment::Condition> &conditions)
{
    QStringList out;
    for (const experiment::Condition &condition : conditions)
        out << QString::fromStdString(condition.name);
    return out;
}

} // namespace

class SweepDialogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linksAreThoseThatWereClicked()
    {
        SweepDialog &dialog = open({});
        QVERIFY(dialog.order().target == SweepTarget::Simulated);
        QCOMPARE(namesOf(dialog.order().plan.conditions), QStringList{QStringLiteral("clean")});
        const std::size_t once = runs();
        click("sweepRadio57600");
        QCOMPARE(namesOf(dialog.order().plan.conditions),
                 (QStringList{QStringLiteral("clean"), QStringLiteral("rate=57600,delay=20")}));
        QCOMPARE(dialog.order().plan.conditions[1].settings.baud, std::uint64_t(57600));
        QCOMPARE(runs(), 2 * once);
        click("sweepRadio115200");
        QCOMPARE(runs(), 3 * once);
        QCOMPARE(dialog.order().plan.conditions[2].settings.baud, std::uint64_t(115200));

        QVERIFY(!find<QWidget>("sweepLoss")->isEnabled());
        click("sweepOwnLink");
        type("sweepLoss", "2.5");
        type("sweepDelay", "40");
        type("sweepJitter", "15");
        type("sweepRate", "38400");
        QCOMPARE(runs(), 4 * once);
        for (const char *name : {"sweepClean", "sweepRadio57600", "sweepRadio115200"})
            click(name);
        const auto conditions = dialog.order().plan.conditions;
        QCOMPARE(namesOf(conditions), QStringList{QStringLiteral("loss=0.025,delay=40,jitter=15,rate=38400")});
        const impair::ImpairmentSettings &link = conditions.front().settings;
        QCOMPARE(link.loss, 0.025);
        QVERIFY(link.delay == std::chrono::milliseconds(40) && link.jitter == std::chrono::milliseconds(15));
        QCOMPARE(link.baud, std::uint64_t(38400));

        QVERIFY(run().isEnabled());
        click("sweepOwnLink");
        QVERIFY(!run().isEnabled()); // no link at all
        QVERIFY(find<QLabel>("sweepSummary")->text().contains(QStringLiteral("Choose a link")));
    }

    void noiseNeedsRepeats()
    {
        SweepDialog &dialog = open({});
        auto *noise = find<QAbstractButton>("sweepNoise");
        auto *repeats = find<QSpinBox>("sweepRepeats");
        QVERIFY(noise->isEnabled() && noise->isChecked());
        repeats->setFocus();
        while (repeats->value() > 1)
            QTest::keyClick(repeats, Qt::Key_Down);
        QVERIFY(!noise->isEnabled());
        QVERIFY(noise->toolTip().contains(QStringLiteral("2 or more")));
        for (const experiment::SweepArm &arm : dialog.order().plan.arms)
            QVERIFY(!arm.again);
        QTest::keyClick(repeats, Qt::Key_Up);
        QVERIFY(noise->isEnabled() && noise->isChecked());
    }

    void theSameLinkIsMeasuredOnce()
    {
        SweepDialog &dialog = open({});
        click("sweepRadio57600");
        click("sweepOwnLink");
        type("sweepLoss", "0");
        QCOMPARE(dialog.order().plan.conditions.size(), std::size_t(2)); // nothing set: clean, which is there
        type("sweepRate", "57600");
        type("sweepDelay", "20");
        QCOMPARE(dialog.order().plan.conditions.size(), std::size_t(2));
        type("sweepDelay", "21");
        QCOMPARE(dialog.order().plan.conditions.size(), std::size_t(3));
    }

    void withoutOwnCoresTheLineCanBeFilled()
    {
        const QStringList clean{QStringLiteral("clean")}, line{QStringLiteral("rate=921600")};
        SweepDialog &dialog = open({}, false);
        const auto links = [&dialog] { return namesOf(dialog.order().plan.conditions); };
        QVERIFY(find<QAbstractButton>("sweepSaturated")->isChecked());
        QCOMPARE(links(), line);
        click("sweepBeside"); // natural load only
        QCOMPARE(links(), clean);
        click("sweepOwn");
        QCOMPARE(links(), line);
        click("sweepRadio57600");
        click("sweepBeside");
        QCOMPARE(links().size(), 2); // the choice was kept
        click("sweepLine921600");
        click("sweepOwn");
        QCOMPARE(links(), QStringList{QStringLiteral("rate=57600,delay=20")});
    }

    void connectedLinkIsMeasuredAsItIs()
    {
        const ViewState view = sealedView(1);
        SweepDialog &dialog = open(view);
        QVERIFY(dialog.order().target == SweepTarget::Connected);
        auto &links = *dialog.findChild<LinkConditions *>();
        QVERIFY(!links.isEnabled());
        QVERIFY2(links.title().contains(QStringLiteral("as it is")), qPrintable(links.title()));
        click("sweepOwn");
        QVERIFY(links.isEnabled());
        click("sweepRadio57600");
        QCOMPARE(dialog.order().plan.conditions.size(), std::size_t(2));
        click("sweepConnected");
        QVERIFY(!links.isEnabled());
        QCOMPARE(namesOf(dialog.order().plan.conditions), QStringList{QStringLiteral("clean")});
        click("sweepOwn");
        QCOMPARE(dialog.order().plan.conditions.size(), std::size_t(2)); // the choice was kept
    }

    void autopilotIsMeasuredBesideAnAgent()
    {
        SweepDialog &dialog = open({});
        auto *link = find<QLineEdit>("sweepAutopilot");
        QVERIFY(!link->isEnabled());
        click("sweepBeside");
        QVERIFY(dialog.order().target == SweepTarget::Autopilot);
        QCOMPARE(dialog.order().autopilot->toText(), std::string("tcp:127.0.0.1:5760"));
        QVERIFY(dialog.order().plan.loads == std::vector{experiment::Load::Natural}); // it sets its own rates
        QVERIFY(!find<QAbstractButton>("sweepSaturated")->isEnabled());
        click("sweepRadio57600"); // the agent is the sweep's own, so the link can be impaired
        QCOMPARE(dialog.order().plan.conditions.size(), std::size_t(2));

        type("sweepAutopilot", "tcp:nowhere");
        QVERIFY(!run().isEnabled());
        QVERIFY(find<QLabel>("sweepSummary")->text().contains(QStringLiteral("must be a URL")));
        type("sweepAutopilot", "udpin:14560");
        QVERIFY(run().isEnabled());
        QCOMPARE(dialog.order().autopilot->toText(), std::string("udpin:127.0.0.1:14560"));
        click("sweepOwn");
        QVERIFY(!dialog.order().autopilot);
        QVERIFY(find<QAbstractButton>("sweepSaturated")->isChecked());
    }

    void pageNamesTheLink()
    {
        SweepPage page;
        page.show();
        auto *place = page.findChild<QComboBox *>(QStringLiteral("sweepPlace"));
        auto *status = page.findChild<QLabel *>(QStringLiteral("sweepStatus"));
        experiment::Plan plan;
        plan.arms = experiment::armsOf({crypto::SuiteId::Aes256Gcm}, {experiment::ArmFraming::Sealed}, false);
        page.begin(plan);
        QVERIFY(!place->isVisible()); // one clean link under one load needs no name
        plan.conditions = {*experiment::parseCondition("rate=57600,delay=20")};
        page.begin(plan);
        QVERIFY(place->isVisible());
        QCOMPARE(place->currentText(), QStringLiteral("57,600 baud, 20 ms delay · natural load"));
        plan.conditions.insert(plan.conditions.begin(), experiment::Condition{});
        page.begin(plan);
        QCOMPARE(place->itemText(0), QStringLiteral("clean link · natural load"));
        page.showRun({1, 0, 0, 0}, {3, 6, 12});
        QCOMPARE(place->currentIndex(), 1); // follows the measurement until another entry is chosen
        QTest::keyClick(place, Qt::Key_Up);
        page.showRun({1, 0, 0, 1}, {4, 6, 9});
        QCOMPARE(place->currentIndex(), 0);
        QVERIFY2(status->text().contains(QStringLiteral("57,600 baud")), qPrintable(status->text()));
    }

private:
    SweepDialog &open(const ViewState &view, bool ownCores = true)
    {
        m_view = view;
        m_suites.showViewState(m_view);
        m_dialog = std::make_unique<SweepDialog>(SweepContext{m_view, m_suites, false, {}, ownCores});
        m_dialog->show();
        return *m_dialog;
    }
    void click(const char *name)
    {
        auto *box = find<QAbstractButton>(name);
        const bool before = box->isChecked();
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(10, box->height() / 2));
        QVERIFY2(box->isChecked() != before, name);
    }
    void type(const char *name, const char *text)
    {
        auto *widget = find<QWidget>(name);
        auto *edit = qobject_cast<QLineEdit *>(widget);
        if (!edit)
            edit = widget->findChild<QLineEdit *>(); // of a spin box
        QVERIFY2(edit->isEnabled(), name);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, QLatin1String(text));
        QTest::keyClick(edit, Qt::Key_Tab);
    }
    std::size_t runs() { return experiment::schedule(m_dialog->order().plan).size(); }
    QAbstractButton &run() { return *m_dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok); }
    template<typename W> W *find(const char *name)
    {
        W *found = m_dialog->findChild<W *>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }

    FakeStation m_station;
    SuiteActions m_suites{m_station};
    ViewState m_view;
    std::unique_ptr<SweepDialog> m_dialog;
};

SKYSEAL_TEST_WIDGETS(SweepDialogTest)
#include "sweep_dialog_test.moc"
