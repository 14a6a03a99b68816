// The window in another language, and which language that is.
#include "core/engine/text/state_text.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/dialogs/help_dialog.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/language.h"
#include "ui/sweep/sweep_labels.h"
#include "ui/text/coordinates.h"
#include "ui/text/units.h"
#include "window_rig.h"

#include <QtCore/QDir>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QTextBrowser>

using namespace skyseal;
using namespace skyseal::ui;

class LanguageTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { tearDown(); }

    void theDesktopChoosesUnlessTheOperatorHas_data()
    {
        QTest::addColumn<QString>("chosen");
        QTest::addColumn<QStringList>("desktop");
        QTest::addColumn<QString>("language");
        const auto row = [](const char *name, const char *chosen, const char *desktop, const char *language) {
            QTest::newRow(name) << QString::fromLatin1(chosen)
                                << QString::fromLatin1(desktop).split(QLatin1Char(' '), Qt::SkipEmptyParts)
                                << QString::fromLatin1(language);
        };
        row("none", "", "", "en");
        row("C", "", "C", "en");
        row("German", "", "de-DE de", "de");
        row("Austrian", "", "de-AT de", "de");
        row("English before German", "", "en-GB en de-DE de", "en");
        row("French before German", "", "fr-FR fr de-DE de en", "de");
        row("unknown", "", "fr-FR fr", "en");
        row("chosen German", "de", "en-GB en", "de");
        row("chosen English", "en", "de-DE de", "en");
        row("chosen nonsense", "../de", "fr", "en");
    }
    void theDesktopChoosesUnlessTheOperatorHas()
    {
        QFETCH(QString, chosen);
        QFETCH(QStringList, desktop);
        QTEST(languageToUse(chosen, desktop), "language");
    }

    void menusAreGerman()
    {
        setUp();
        QCOMPARE(menus().first(), QStringLiteral("File"));
        tearDown();
        const WindowTranslation german(QStringLiteral("de"));
        QCOMPARE(languageInUse(), QStringLiteral("de"));
        setUp();
        QCOMPARE(menus(),
                 QString::fromUtf8("Datei Verbindung Fahrzeug Sicherheit Ansicht Extras Hilfe").split(QLatin1Char(' ')));
    }

    void englishWithoutATranslation()
    {
        const WindowTranslation english(QStringLiteral("en"));
        QCOMPARE(languageInUse(), QStringLiteral("en"));
        setUp();
        QCOMPARE(menus().first(), QStringLiteral("File"));
    }

    void numbersHaveTheDecimalPointOfTheLanguage()
    {
        QCOMPARE(number(12, 1), QStringLiteral("12.0"));
        QCOMPARE(engine::switchTimeText(std::chrono::microseconds(430)), QStringLiteral("0.4 ms"));
        {
            const WindowTranslation german(QStringLiteral("de"));
            QCOMPARE(number(12, 1), QStringLiteral("12,0"));
            QCOMPARE(altitudeFigure(-0.5, UnitSystem::Metric).text(), QStringLiteral("−0,5\u00a0m"));
            QCOMPARE(rateText(3200), QStringLiteral("3,2\u00a0kB/s"));
            QCOMPARE(localNumber("1,234.5 ± 0.1"), QStringLiteral("1.234,5 ± 0,1"));
            QCOMPARE(coordinatesText(-35.363261, 149.16523, CoordinateFormat::Decimal),
                     QStringLiteral("−35,363261 149,165230"));
            QCOMPARE(engine::switchTimeText(std::chrono::microseconds(430)), QStringLiteral("0,4 ms"));
            // Of the compass, German has another letter for the east.
            QCOMPARE(compassLetter(Compass::East), QStringLiteral("O"));
            QVERIFY(coordinatesText(47.5, 8.25, CoordinateFormat::DegreesMinutesSeconds).endsWith(QStringLiteral("0,0\" O")));
            // Other programs read these.
            QCOMPARE(coordinatesToCopy(-35.363261, 149.16523, CoordinateFormat::Decimal),
                     QStringLiteral("-35.363261, 149.165230"));
            QVERIFY(coordinatesToCopy(47.5, 8.25, CoordinateFormat::DegreesMinutesSeconds).endsWith(QStringLiteral("0.0\" E")));
        }
        QCOMPARE(number(12, 1), QStringLiteral("12.0"));
    }

    void everyHelpPageIsGerman()
    {
        const QStringList pages = QDir(QStringLiteral(":/skyseal/help")).entryList({QStringLiteral("*.md")}, QDir::Files);
        QVERIFY(pages.size() > 4);
        for (const QString &page : pages) {
            const QString english = helpText(page), german = [&] {
                const WindowTranslation translation(QStringLiteral("de"));
                return helpText(page);
            }();
            QVERIFY(english.size() > 500);
            QVERIFY2(german != english && german.contains(QStringLiteral(" der ")), qPrintable(page));
            QCOMPARE(german.count(QStringLiteral("<!--")), english.count(QStringLiteral("<!--")));
        }
    }

    void aPageWithoutTranslationIsEnglish()
    {
        const WindowTranslation german(QStringLiteral("de"));
        QVERIFY(
            HelpDialog(QStringLiteral("none"), {}).findChild<QTextBrowser *>()->toPlainText().contains(QStringLiteral("none")));
    }

    void languageIsChosenByKeys()
    {
        SettingsDialog dialog{Settings()};
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog, test::kDeadlineMs));
        dialog.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&dialog, test::kDeadlineMs));
        QCOMPARE(dialog.settings().language, QString());
        QTest::keyClick(&dialog, Qt::Key_G, Qt::AltModifier);
        QTest::keyClicks(dialog.focusWidget(), QStringLiteral("Deutsch"));
        QCOMPARE(dialog.settings().language, QStringLiteral("de"));
        const QTemporaryDir folder;
        QSettings store(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        storeSettings(store, dialog.settings());
        QCOMPARE(storedLanguage(store), QStringLiteral("de"));
        QCOMPARE(loadSettings(store).language, QStringLiteral("de"));
    }

private:
    QStringList menus() const
    {
        QStringList out;
        for (const QAction *menu : m_window->menuBar()->actions())
            out << menu->text().remove(QLatin1Char('&'));
        return out;
    }
    static QString helpText(const QString &page)
    {
        return HelpDialog(page.chopped(3), {}).findChild<QTextBrowser *>()->toMarkdown();
    }
};

SKYSEAL_TEST_WIDGETS(LanguageTest)
#include "language_test.moc"
