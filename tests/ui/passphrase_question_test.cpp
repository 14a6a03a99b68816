// The passphrase of this station's key, from the keyring or by a question beside the window, which stays usable, also while
// the passphrase is being hashed.
#include "app/skyseal/passphrase_question.h"
#include "core/crypto/passphrase.h"
#include "core/crypto/system_random.h"
#include "core/crypto/x25519.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/keys/passphrase_dialog.h"

#include <QtCore/QPointer>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include <functional>
#include <map>

using namespace skyseal;
using namespace skyseal::app;

namespace {

class FakeMemory final : public PassphraseMemory
{
public:
    QString problem() const override { return {}; }
    bool remembers(const std::string &file) const override { return kept.contains(file); }
    void recall(const std::string &file, QObject *context, Recalled recalled) override
    {
        answer = [this, file, asked = QPointer(context), recalled = std::move(recalled)] {
            if (asked)
                recalled(kept.contains(file) ? crypto::Passphrase::fromBytes(asBytes(kept.at(file))) : std::nullopt);
        };
    }
    void remember(const std::string &file, const crypto::Passphrase &passphrase) override
    {
        kept[file] = std::string(asText(passphrase.view()));
    }
    void forget(const std::string &file) override { kept.erase(file); }

    std::map<std::string, std::string> kept;
    std::function<void()> answer; ///< of the keyring, to what was requested last
};

} // namespace

class PassphraseQuestionTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_file = m_folder.filePath(QStringLiteral("identity.key")).toStdString();
        const auto passphrase = crypto::Passphrase::fromBytes(asBytes(std::string_view("swordfish")));
        QVERIFY(keys::writeNewIdentity(m_file, m_random, {&*passphrase, {.passes = 2, .memoryKiB = 65536}}));
        m_key = keys::readIdentityFacts(m_file)->publicKey;
    }

    void init()
    {
        m_window = std::make_unique<QWidget>();
        m_land = new QPushButton(QStringLiteral("Land"), m_window.get());
        m_window->resize(300, 200);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), test::kDeadlineMs));
        m_opened = m_notOpened = m_unknown = 0;
        m_wrong = false;
        m_memory.kept.clear();
    }
    void cleanup() { m_window.reset(); }

    void theWindowStaysUsable()
    {
        PassphraseQuestion question(m_memory);
        ask(question); // returns at once
        QVERIFY(dialog() && !dialog()->isModal() && !QApplication::activeModalWidget());
        int pressed = 0;
        connect(m_land, &QPushButton::clicked, this, [&] { ++pressed; });
        QTest::mouseClick(m_land, Qt::LeftButton);
        QCOMPARE(pressed, 1);
        type("swordfish");
        EVENTUALLY_EQUAL(m_opened, 1);
        QVERIFY(m_openedKey == m_key);
        EVENTUALLY(!dialog());
        QCOMPARE(m_notOpened, 0);
    }

    void theEventLoopGoesOnWhileItIsHashed()
    {
        PassphraseQuestion question(m_memory);
        ask(question);
        QTimer timer;
        int ticks = 0;
        connect(&timer, &QTimer::timeout, this, [&] { ticks += m_opened == 0; });
        timer.start(0);
        type("swordfish");
        QCOMPARE(m_opened, 0); // it arrives by the event loop
        EVENTUALLY_EQUAL(m_opened, 1);
        QVERIFY(ticks > 0);
    }

    void requestMeanwhileWaitsForTheResult()
    {
        PassphraseQuestion question(m_memory);
        ask(question);
        type("swordfish");
        ask(question);
        QVERIFY(!dialog());
        EVENTUALLY_EQUAL(m_opened, 1);
        QVERIFY(!dialog());
    }

    void withdrawnOneIsIgnored()
    {
        PassphraseQuestion question(m_memory);
        ask(question);
        type("swordfish");
        question.withdraw();
        ask(question);
        QVERIFY(dialog());
        type("sworfish"); // hashed after the first one
        EVENTUALLY(dialog() && !dialog()->findChild<QLabel *>(QStringLiteral("passphraseWrong"))->text().isEmpty());
        QCOMPARE(m_opened + m_notOpened, 0);
    }

    /// Without a window to tell, and before the event loop runs again.
    void leavingMeanwhileIsQuiet_data()
    {
        QTest::addColumn<bool>("windowFirst");
        QTest::newRow("the window goes first") << true;
        QTest::newRow("the question goes first") << false;
    }
    void leavingMeanwhileIsQuiet()
    {
        QFETCH(bool, windowFirst);
        {
            PassphraseQuestion question(m_memory);
            ask(question);
            type("swordfish");
            if (windowFirst)
                m_window.reset();
        }
        QCoreApplication::processEvents();
        QCOMPARE(m_opened + m_notOpened, 0);
    }

    void wrongOneIsAskedAgain()
    {
        PassphraseQuestion question(m_memory);
        ask(question);
        QVERIFY(dialog()->findChild<QLabel *>(QStringLiteral("passphraseWrong"))->text().isEmpty());
        type("sworfish");
        EVENTUALLY(dialog() && !dialog()->findChild<QLabel *>(QStringLiteral("passphraseWrong"))->text().isEmpty());
        QCOMPARE(m_opened + m_notOpened, 0);
        type("swordfish");
        EVENTUALLY_EQUAL(m_opened, 1);
    }

    void mayBeDeclinedAndAskedLater()
    {
        PassphraseQuestion question(m_memory);
        ask(question);
        QTest::mouseClick(dialog()->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Cancel), Qt::LeftButton);
        EVENTUALLY_EQUAL(m_notOpened, 1);
        QVERIFY2(m_why.find("the passphrase was not given") != std::string::npos, m_why.c_str());
        ask(question);
        QTest::keyClick(dialog(), Qt::Key_Escape);
        EVENTUALLY_EQUAL(m_notOpened, 2);
    }

    void oneDialogAtATime()
    {
        PassphraseQuestion question(m_memory);
        ask(question);
        ask(question);
        QCOMPARE(m_window->findChildren<ui::PassphraseDialog *>().size(), 1);
        question.withdraw();
        EVENTUALLY(!dialog());
        QCOMPARE(m_opened + m_notOpened, 0);
    }

    void whatIsRememberedNeedsNoQuestion()
    {
        PassphraseQuestion question(m_memory);
        QVERIFY(!question.isRemembered(m_file));
        m_memory.kept[m_file] = "swordfish";
        QVERIFY(question.isRemembered(m_file));
        QSignalSpy opening(&question, &PassphraseQuestion::openingChanged);
        recall(question);
        QVERIFY(question.isOpening() && opening.size() == 1); // the keyring has not answered
        QTimer timer;
        int ticks = 0;
        connect(&timer, &QTimer::timeout, this, [&] { ticks += m_opened == 0; });
        timer.start(0);
        m_memory.answer();
        QCOMPARE(m_opened, 0); // it arrives by the event loop, which goes on while it is hashed
        EVENTUALLY_EQUAL(m_opened, 1);
        QVERIFY(ticks > 0);
        QVERIFY(m_openedKey == m_key && !dialog());
        QVERIFY(!question.isOpening() && opening.size() == 2);
        QCOMPARE(m_notOpened + m_unknown, 0);
    }

    void outdatedOneIsAskedFor()
    {
        PassphraseQuestion question(m_memory);
        m_memory.kept[m_file] = "outdated";
        recall(question);
        m_memory.answer();
        EVENTUALLY_EQUAL(m_unknown, 1);
        QVERIFY(m_wrong && !question.isOpening() && !dialog());
        ask(question, ui::RefusedPassphrase::Remembered);
        const QString said = dialog()->findChild<QLabel *>(QStringLiteral("passphraseWrong"))->text();
        QVERIFY2(said.contains(QLatin1String("remembered")), qPrintable(said));
        type("swordfish");
        EVENTUALLY_EQUAL(m_opened, 1);
        QCOMPARE(m_memory.kept[m_file], std::string("swordfish")); // it went on being remembered
    }

    void keyringThatGivesNothing()
    {
        PassphraseQuestion question(m_memory);
        recall(question);
        m_memory.answer(); // access was denied
        QCOMPARE(m_unknown, 1);
        QVERIFY(!m_wrong && !question.isOpening());
        QCOMPARE(m_opened + m_notOpened, 0);
    }

    void fileThatCannotBeOpenedIsNamed()
    {
        PassphraseQuestion question(m_memory);
        const std::string missing = m_folder.filePath(QStringLiteral("missing.key")).toStdString();
        m_memory.kept[missing] = "swordfish";
        recall(question, missing);
        m_memory.answer();
        EVENTUALLY_EQUAL(m_notOpened, 1);
        QVERIFY2(m_why.find("missing.key") != std::string::npos, m_why.c_str());
        QVERIFY(!question.isOpening());
        QCOMPARE(m_opened + m_unknown, 0);
    }

    void withdrawnRecallIsIgnored()
    {
        PassphraseQuestion question(m_memory);
        m_memory.kept[m_file] = "swordfish";
        recall(question);
        question.withdraw();
        QVERIFY(!question.isOpening());
        m_memory.answer();
        ask(question);
        type("sworfish"); // hashed after what would have been recalled
        EVENTUALLY(dialog() && !dialog()->findChild<QLabel *>(QStringLiteral("passphraseWrong"))->text().isEmpty());
        QCOMPARE(m_opened + m_notOpened + m_unknown, 0);
    }

private:
    ui::PassphraseDialog *dialog() const
    {
        for (ui::PassphraseDialog *found : m_window->findChildren<ui::PassphraseDialog *>())
            if (found->isVisible())
                return found;
        return nullptr;
    }
    void ask(PassphraseQuestion &question, ui::RefusedPassphrase refused = ui::RefusedPassphrase::None)
    {
        question.ask(
            *m_window, m_file, [this](const PassphraseQuestion::Identity &identity) { takeIdentity(identity); },
            [this](const InputError &why) { takeProblem(why); }, refused);
    }
    void recall(PassphraseQuestion &question) { recall(question, m_file); }
    void recall(PassphraseQuestion &question, const std::string &file)
    {
        question.recall(
            *m_window, file, [this](const PassphraseQuestion::Identity &identity) { takeIdentity(identity); },
            [this](const InputError &why) { takeProblem(why); },
            [this](bool wrong) {
                ++m_unknown;
                m_wrong = wrong;
            });
    }
    void takeIdentity(const PassphraseQuestion::Identity &identity)
    {
        ++m_opened;
        m_openedKey = identity->publicKey;
    }
    void takeProblem(const InputError &why)
    {
        ++m_notOpened;
        m_why = why.text();
    }
    void type(const char *words)
    {
        QTest::keyClicks(dialog()->findChild<QLineEdit *>(QStringLiteral("passphrase")), QLatin1String(words));
        QTest::keyClick(dialog(), Qt::Key_Return);
    }

    QTemporaryDir m_folder;
    crypto::SystemRandom m_random;
    FakeMemory m_memory;
    std::string m_file, m_why;
    crypto::PublicKey m_key{}, m_openedKey{};
    std::unique_ptr<QWidget> m_window;
    QPushButton *m_land = nullptr;
    int m_opened = 0, m_notOpened = 0, m_unknown = 0;
    bool m_wrong = false;
};

SKYSEAL_TEST_WIDGETS(PassphraseQuestionTest)
#include "passphrase_question_test.moc"
