// A station that cannot use its key: no part of the window waits for a sealed link that cannot come.
#include "tests/support/test_runner.h"
#include "ui/status/strip_item.h"
#include "window_rig.h"

#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

class KeyProblemTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }
    void cleanup() { tearDown(); }

    void everyPartNamesTheProblem()
    {
        const QString problem = QStringLiteral("/home/ann/identity.key: is damaged");
        m_window->setKeyState({problem});
        m_station->showWaiting();
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("No sealed links"));
        QVERIFY(find<QLabel>("secureAdvice")->text().contains(problem));
        QVERIFY(find<QLabel>("emptyText")->text().contains(problem));
        QVERIFY(!find<QLabel>("emptyCommand")->isVisible()); // an agent would not help
        QVERIFY(find<QPushButton>("secureKeys")->isVisible() && find<QPushButton>("emptyKeys")->isVisible());
        QVERIFY(!find<QPushButton>("secureHelp")->isVisible());
        QVERIFY(find<StripItem>("stripLock")->toolTip().contains(problem));

        m_station->showPlain(1);
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Not sealed"));
        QVERIFY(find<QLabel>("secureAdvice")->text().contains(problem));
    }

    void solvedProblemDisappearsAtOnce()
    {
        m_window->setKeyState({QStringLiteral("is damaged")});
        m_station->showWaiting();
        m_window->setKeyState({});
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("No sealed link"));
        QVERIFY(find<QLabel>("secureAdvice")->text().contains(QStringLiteral("starts automatically")));
        QVERIFY(find<QLabel>("emptyCommand")->isVisible());
    }

    /// While the passphrase is being hashed nobody has to act.
    void keyThatIsBeingOpenedIsNoProblemYet()
    {
        const QString problem = QStringLiteral("the passphrase was not given");
        m_window->setKeyState({problem, true});
        m_station->showWaiting();
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Opening the key…"));
        QVERIFY(find<QLabel>("emptyText")->text().contains(QStringLiteral("is being checked")));
        QVERIFY(find<StripItem>("stripLock")->toolTip().contains(QStringLiteral("is being opened")));
        for (const char *label : {"secureAdvice", "emptyText"})
            QVERIFY(!find<QLabel>(label)->text().contains(problem));
        QVERIFY(!find<QLabel>("emptyCommand")->isVisible());
        for (const char *button : {"secureKeys", "emptyKeys", "secureHelp"})
            QVERIFY2(!find<QPushButton>(button)->isVisible(), button);

        m_window->setKeyState({problem});
        QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("No sealed links"));
        QVERIFY(find<QLabel>("emptyText")->text().contains(problem));
        QVERIFY(find<QPushButton>("secureKeys")->isVisible());
    }
};

SKYSEAL_TEST_WIDGETS(KeyProblemTest)
#include "key_problem_test.moc"
