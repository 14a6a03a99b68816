// The settings dialog by keys: every mnemonic leads to a field.
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/alerts/speech.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/settings.h"

#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

using namespace skyseal;
using namespace skyseal::ui;

class SettingsDialogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void mnemonicsHaveTheirFields()
    {
        const SettingsDialog dialog{Settings()};
        int mnemonics = 0;
        for (const QLabel *label : dialog.findChildren<QLabel *>()) {
            if (!label->text().contains(QLatin1Char('&')))
                continue;
            ++mnemonics;
            QVERIFY2(label->buddy(), qPrintable(label->text())); // without one the label shows the ampersand
        }
        QCOMPARE(mnemonics, 9);
    }

    void idOfAVehicleCannotBeChosen()
    {
        SettingsDialog dialog{Settings()};
        std::bitset<256> vehicles;
        dialog.setVehicles(vehicles.set(1));
        auto *id = dialog.findChild<QSpinBox *>(QStringLiteral("settingSystemId"));
        const auto *why = dialog.findChild<QLabel *>(QStringLiteral("settingIdTaken"));
        const auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        QVERIFY(ok->isEnabled() && why->isHidden());
        id->setValue(1);
        QVERIFY(!ok->isEnabled() && !why->isHidden());
        QVERIFY(why->text().contains(QLatin1Char('1')));
        dialog.findChild<QLineEdit *>(QStringLiteral("settingLink"))->setText(QStringLiteral("udpin:127.0.0.1:14550"));
        QVERIFY(!ok->isEnabled()); // a valid link does not outweigh it
        id->setValue(254);
        QVERIFY(ok->isEnabled() && why->isHidden());
        id->setValue(Settings().systemId);
        dialog.setVehicles(vehicles.set(static_cast<std::size_t>(id->value())));
        QVERIFY(ok->isEnabled() && !why->isHidden()); // the other settings can be changed all the same
    }

    void folderIsReachedByItsKey()
    {
        SettingsDialog dialog{Settings()};
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, test::kDeadlineMs));
        dialog.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&dialog, test::kDeadlineMs));
        QTest::keyClick(&dialog, Qt::Key_F, Qt::AltModifier);
        QTest::keyClicks(dialog.focusWidget(), QStringLiteral("/tmp/flights"));
        QCOMPARE(dialog.settings().recordFolder, QStringLiteral("/tmp/flights"));
    }

    void coordinatesAreChosenByKeys()
    {
        SettingsDialog dialog{Settings()};
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, test::kDeadlineMs));
        dialog.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&dialog, test::kDeadlineMs));
        QTest::keyClick(&dialog, Qt::Key_N, Qt::AltModifier);
        QTest::keyClicks(dialog.focusWidget(), QStringLiteral("UTM"));
        QCOMPARE(dialog.settings().coordinates, CoordinateFormat::Utm);
        QTest::keyClick(dialog.focusWidget(), Qt::Key_Down);
        QCOMPARE(dialog.settings().coordinates, CoordinateFormat::Mgrs);
    }

    void speechIsOffUnlessItIsChosen()
    {
        QVERIFY(!Settings().speakAlerts);
        SettingsDialog dialog{Settings()};
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, test::kDeadlineMs));
        auto *box = dialog.findChild<QCheckBox *>(QStringLiteral("settingSpeak"));
        QCOMPARE(box->isEnabled(), isDesktopVoiceBuilt());
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
        QCOMPARE(dialog.settings().speakAlerts, isDesktopVoiceBuilt());
    }

    void noTextIsCut()
    {
        SettingsDialog dialog(Settings{});
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, skyseal::test::kDeadlineMs));
        int wrapped = 0;
        for (const QLabel *label : dialog.findChildren<QLabel *>()) {
            if (!label->isVisible() || !label->wordWrap())
                continue;
            ++wrapped;
            QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
        }
        QVERIFY(wrapped > 1);
    }

    void warningsSpeakOfTheLink()
    {
        const SettingsDialog dialog{Settings()};
        for (const QLabel *label : dialog.findChildren<QLabel *>())
            QVERIFY2(!label->text().contains(QStringLiteral("I understand")), qPrintable(label->text()));
    }
};

SKYSEAL_TEST_WIDGETS(SettingsDialogTest)
#include "settings_dialog_test.moc"
