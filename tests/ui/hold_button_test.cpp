// Hold to confirm, by mouse and by keys, and all the ways to say no.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/flight/hold_button.h"

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QVBoxLayout>

using skyseal::ui::HoldButton;

class HoldButtonTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_window = std::make_unique<QWidget>();
        auto *column = new QVBoxLayout(m_window.get());
        m_button = new HoldButton(QStringLiteral("Arm"));
        m_other = new QLineEdit;
        column->addWidget(m_button);
        column->addWidget(m_other);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), skyseal::test::kDeadlineMs));
        m_button->setFocus();
        m_confirmed = std::make_unique<QSignalSpy>(m_button, &HoldButton::confirmed);
        m_aborted = std::make_unique<QSignalSpy>(m_button, &HoldButton::aborted);
    }

    void heldMouseConfirmsOnce()
    {
        QElapsedTimer since;
        since.start();
        QTest::mousePress(m_button, Qt::LeftButton);
        EVENTUALLY_EQUAL(m_confirmed->size(), 1);
        QVERIFY(since.elapsed() >= HoldButton::kHoldMs);
        QTest::mouseRelease(m_button, Qt::LeftButton);
        QCOMPARE(m_confirmed->size(), 1);
        QCOMPARE(m_aborted->size(), 0);
    }

    void clickConfirmsNothing()
    {
        QTest::mouseClick(m_button, Qt::LeftButton);
        QCOMPARE(m_aborted->size(), 1);
        QCOMPARE(m_button->progress(), 0.0);
        QVERIFY(!m_confirmed->wait(HoldButton::kHoldMs + 100));
    }

    void heldKeyConfirms_data()
    {
        QTest::addColumn<int>("key");
        QTest::newRow("space") << int(Qt::Key_Space);
        QTest::newRow("return") << int(Qt::Key_Return);
        QTest::newRow("enter") << int(Qt::Key_Enter);
    }
    void heldKeyConfirms()
    {
        QFETCH(int, key);
        QTest::keyPress(m_button, static_cast<Qt::Key>(key));
        EVENTUALLY_EQUAL(m_confirmed->size(), 1);
        QTest::keyRelease(m_button, static_cast<Qt::Key>(key));
        QCOMPARE(m_aborted->size(), 0);
    }

    void escapeAborts()
    {
        QTest::mousePress(m_button, Qt::LeftButton);
        EVENTUALLY(m_button->progress() > 0.1);
        QTest::keyClick(m_button, Qt::Key_Escape);
        QCOMPARE(m_aborted->size(), 1);
        QVERIFY(!m_confirmed->wait(HoldButton::kHoldMs + 100));
        QTest::mouseRelease(m_button, Qt::LeftButton);
    }

    void leavingTheButtonAborts()
    {
        QTest::mousePress(m_button, Qt::LeftButton);
        QTest::mouseMove(m_button, QPoint(m_button->width() + 20, m_button->height() + 60));
        QMouseEvent move(QEvent::MouseMove, QPointF(-30, -30), QPointF(-30, -30), Qt::LeftButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(m_button, &move);
        QCOMPARE(m_aborted->size(), 1);
        QVERIFY(!m_confirmed->wait(HoldButton::kHoldMs + 100));
    }

    void losingTheFocusAborts()
    {
        QTest::keyPress(m_button, Qt::Key_Space);
        m_other->setFocus();
        QCOMPARE(m_aborted->size(), 1);
        QVERIFY(!m_confirmed->wait(HoldButton::kHoldMs + 100));
    }

    void disabledWhileHeldAborts()
    {
        QTest::mousePress(m_button, Qt::LeftButton);
        m_button->setEnabled(false);
        QCOMPARE(m_aborted->size(), 1);
        QVERIFY(!m_confirmed->wait(HoldButton::kHoldMs + 100));
    }

private:
    std::unique_ptr<QWidget> m_window;
    HoldButton *m_button = nullptr;
    QLineEdit *m_other = nullptr;
    std::unique_ptr<QSignalSpy> m_confirmed, m_aborted;
};

SKYSEAL_TEST_WIDGETS(HoldButtonTest)
#include "hold_button_test.moc"
