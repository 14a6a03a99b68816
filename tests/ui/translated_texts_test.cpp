// The window in German: no text is looked up in vain, and no menu has two entries with one letter.
#include "gallery_dialogs.h"
#include "tests/support/test_runner.h"
#include "ui/language.h"
#include "window_rig.h"

#include <QtCore/QMutex>
#include <QtTest/QTest>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

/// Is asked for what the translators installed after it do not know, by any thread, and does not know it either.
class MissedTexts : public QTranslator
{
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        const QString owner = QString::fromLatin1(context);
        if (owner.startsWith(QLatin1String("skyseal::")) || owner == QLatin1String("Sweep")) {
            const QMutexLocker lock(&m_mutex);
            m_texts.insert(owner + QStringLiteral(": ") + QString::fromUtf8(source));
        }
        return {};
    }
    QStringList texts() const
    {
        const QMutexLocker lock(&m_mutex);
        return {m_texts.begin(), m_texts.end()};
    }

private:
    mutable QMutex m_mutex;
    mutable QSet<QString> m_texts;
};

} // namespace

class TranslatedTextsTest : public QObject, private WindowRig
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_missed = std::make_unique<MissedTexts>();
        QCoreApplication::installTranslator(m_missed.get());
        m_german = std::make_unique<WindowTranslation>(QStringLiteral("de"));
        setUp();
    }
    void cleanup()
    {
        tearDown();
        m_german.reset();
        m_missed.reset();
    }

    void aMissedTextIsNoticed()
    {
        QCOMPARE(QCoreApplication::translate("skyseal::ui::Nobody", "no such text"), QStringLiteral("no such text"));
        QVERIFY(m_missed->texts().contains(QStringLiteral("skyseal::ui::Nobody: no such text")));
    }

    void noTextOfTheWindowIsMissed()
    {
        m_station->showWaiting();
        m_station->showPendingApproval();
        m_station->showPlain(1);
        m_station->showSealed(2);
        m_station->showSealed(3);
        for (const QString &workspace :
             {QStringLiteral("fly"), QStringLiteral("plan"), QStringLiteral("vehicle"), QStringLiteral("lab")})
            find<QAction>(qPrintable(QStringLiteral("workspace_") + workspace))->trigger();
        QCoreApplication::processEvents();
        QCOMPARE(m_missed->texts(), QStringList());
    }

    void noTextOfADialogIsMissed_data()
    {
        QTest::addColumn<QString>("name");
        for (const QString &name : dialogStates())
            QTest::newRow(qPrintable(name)) << name;
    }
    void noTextOfADialogIsMissed()
    {
        QFETCH(QString, name);
        FakeKeyring keyring;
        FakePairing pairing;
        fillKeyring(keyring);
        const std::unique_ptr<QWidget> dialog(openDialog(name, *m_window, keyring, pairing));
        QVERIFY(dialog);
        QCoreApplication::processEvents();
        QCOMPARE(m_missed->texts(), QStringList());
    }

    void lettersOfAMenuDiffer()
    {
        m_station->showSealed(1);
        QStringList twice = sharedLetters(m_window->menuBar()->actions());
        for (const QAction *menu : m_window->menuBar()->actions())
            twice += sharedLetters(menu->menu()->actions());
        QCOMPARE(twice, QStringList());
    }

private:
    static QStringList sharedLetters(const QList<QAction *> &actions)
    {
        QHash<QString, QString> owners;
        QStringList out;
        for (const QAction *action : actions) {
            const QString letter = QKeySequence::mnemonic(action->text()).toString();
            if (letter.isEmpty())
                continue;
            if (owners.contains(letter))
                out << QStringLiteral("%1: \"%2\" and \"%3\"").arg(letter, owners.value(letter), action->text());
            owners.insert(letter, action->text());
        }
        return out;
    }

    std::unique_ptr<MissedTexts> m_missed;
    std::unique_ptr<WindowTranslation> m_german;
};

SKYSEAL_TEST_WIDGETS(TranslatedTextsTest)
#include "translated_texts_test.moc"
