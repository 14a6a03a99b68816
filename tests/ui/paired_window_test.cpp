// Keys, pairing and revocation as an operator does them: the whole program in this process, a real agent and a simulated
// vehicle on loopback, by clicks and keys. Pictures of each step, light and dark, are kept in the folder that SKYSEAL_PICTURES
// names.
#include "app/skyseal/application.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/engine/station/session_snapshot.h"
#include "core/engine/station/vehicle_snapshot.h"
#include "tests/support/eventually.h"
#include "tests/support/flight.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"
#include "ui/keys/change_passphrase_dialog.h"
#include "ui/keys/changed_key_warning.h"
#include "ui/keys/keys_dialog.h"
#include "ui/keys/pairing_dialog.h"
#include "ui/keys/passphrase_dialog.h"
#include "ui/security/suite_actions.h"
#include "ui/status/strip_item.h"
#include "ui/theme/palettes.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTimer>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>

#include <functional>

using namespace skyseal;
using namespace skyseal::ui;
using test::Program;

namespace {

Program::Predicate stateIs(const char *state)
{
    return [state](const QJsonObject &event) { return event[QLatin1String("state")].toString() == QLatin1String(state); };
}

QString inOneLine(QString fingerprint)
{
    return fingerprint.replace(QLatin1Char('\n'), QLatin1Char(' '));
}

/// The person in front of the program: acts on the next question for a passphrase; on another one after `person` was started
/// again.
void answerPassphrases(QTimer &person, const std::function<void(PassphraseDialog *)> &act)
{
    QObject::connect(&person, &QTimer::timeout, &person, [&person, act] {
        PassphraseDialog *dialog = nullptr;
        for (QWidget *window : QApplication::topLevelWidgets())
            if (auto *question = qobject_cast<PassphraseDialog *>(window); question && question->isVisible())
                dialog = question;
        if (!dialog)
            return;
        person.stop();
        act(dialog);
    });
    person.start(20);
}

} // namespace

class PairedWindowTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void wrongPassphraseIsTold();
    void pairedByTheWindow();
    void revokedInTheDialog();
    void pairedAgain();
    void changedKeyIsRefusedUntilReplaced();
    void anotherStationIsServed();
    void agentThatGoesAwayIsWaitedFor();
    void keyIsSealedInTheDialog();
    void sealedKeyNeedsItsPassphraseAtStart();
    void namedKeyMayStaySealed();

private:
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    QByteArray read(const QString &name) const
    {
        QFile file(name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QString ownFile(const char *name) const { return path("data/skyseal/skyseal/") + QLatin1String(name); }
    QString write(const char *name, const QByteArray &content) const
    {
        QFile file(path(name));
        if (file.open(QIODevice::WriteOnly))
            file.write(content);
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        return file.fileName();
    }
    QString newKey(const char *name) const;
    void startAgent(const char *key);
    void startWindow(app::WindowOptions options = {});
    std::unique_ptr<Program> openDesk(const char *key, const char *passphraseFile = nullptr) const;

    template<typename W> W *find(const char *name) const
    {
        W *found = m_window->findChild<W *>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return found;
    }
    KeysDialog *openKeys();
    void closeKeys()
    {
        openKeys()->close();
        EVENTUALLY(!m_window->findChild<KeysDialog *>());
    }
    PairingDialog *openPairing();
    static void click(QWidget *inside, const char *name)
    {
        QTest::mouseClick(inside->findChild<QAbstractButton *>(QLatin1String(name)), Qt::LeftButton);
    }
    static QString textOf(QWidget *inside, const char *label)
    {
        return inside->findChild<QLabel *>(QLatin1String(label))->text();
    }
    QString lock() const { return find<StripItem>("stripLock")->text(); }
    bool isUnder(crypto::SuiteId suite) const
    {
        return m_window->view().session && m_window->view().session->info.suite == suite;
    }
    bool isSealed() const { return m_window->view().session && lock().contains(QStringLiteral("heron ✓")); }
    void confirmBoth(PairingDialog *dialog, Program &desk);
    void picture(const char *name, QWidget *of);

    QTemporaryDir m_folder;
    crypto::SystemRandom m_random;
    quint16 m_vehiclePort = test::freeUdpPort(), m_groundPort = test::freeUdpPort();
    QString m_air; ///< the agent's fingerprint
    std::unique_ptr<Program> m_sim, m_agent;
    std::unique_ptr<app::Application> m_app;
    MainWindow *m_window = nullptr;
};

QString PairedWindowTest::newKey(const char *name) const
{
    Program made(
        QStringLiteral("skyseal-cli"),
        {QStringLiteral("keys"), QStringLiteral("new"), QStringLiteral("--out"), path(name), QStringLiteral("--json")});
    return made.waitFor(QStringLiteral("key"))[QLatin1String("fingerprint")].toString();
}

void PairedWindowTest::startAgent(const char *key)
{
    m_agent.reset(); // its ports first
    m_agent = std::make_unique<Program>(
        QStringLiteral("skyseal-air"),
        QStringList{QStringLiteral("--vehicle"), QStringLiteral("udpin:127.0.0.1:%1").arg(m_vehiclePort),
                    QStringLiteral("--ground"), QStringLiteral("udpout:127.0.0.1:%1").arg(m_groundPort),
                    QStringLiteral("--identity"), path(key), QStringLiteral("--peers"), path("air.peers"),
                    QStringLiteral("--json")});
    QVERIFY(!m_agent->waitFor(QStringLiteral("link")).isEmpty());
}

void PairedWindowTest::startWindow(app::WindowOptions options)
{
    options.links = {*link::LinkUrl::parse(QStringLiteral("udpin:127.0.0.1:%1").arg(m_groundPort).toStdString())};
    m_app = std::make_unique<app::Application>(std::move(options), m_random);
    QVERIFY(m_app->start());
    m_window = nullptr;
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (auto *window = qobject_cast<MainWindow *>(widget))
            m_window = window;
    }
    QVERIFY(m_window && QTest::qWaitForWindowExposed(m_window, test::kDeadlineMs));
    m_window->resize(1280, 860);
    m_window->activateWindow();
}

void PairedWindowTest::initTestCase()
{
    QVERIFY(crypto::initCrypto());
    qputenv("XDG_DATA_HOME", path("data").toUtf8());
    qputenv("XDG_CONFIG_HOME", path("config").toUtf8());
    QCoreApplication::setApplicationName(QStringLiteral("skyseal"));
    QCoreApplication::setOrganizationName(QStringLiteral("skyseal"));
    m_air = newKey("air.key");
    QVERIFY(!m_air.isEmpty());
    write("air.peers", {});
    m_sim = std::make_unique<Program>(
        QStringLiteral("skyseal-sim"),
        QStringList{QStringLiteral("--link"), QStringLiteral("udpout:127.0.0.1:%1").arg(m_vehiclePort)});
    startAgent("air.key");
    startWindow();
}

void PairedWindowTest::cleanupTestCase()
{
    m_app.reset();
    m_agent.reset();
    m_sim.reset();
}

std::unique_ptr<Program> PairedWindowTest::openDesk(const char *key, const char *passphraseFile) const
{
    QStringList arguments{QStringLiteral("--pair"), QStringLiteral("--identity"), path(key),
                          QStringLiteral("--as"),   QStringLiteral("base"),       QStringLiteral("--json")};
    if (passphraseFile)
        arguments += {QStringLiteral("--pair-passphrase-file"), path(passphraseFile)};
    return std::make_unique<Program>(QStringLiteral("skyseal-air"), arguments);
}

KeysDialog *PairedWindowTest::openKeys()
{
    if (auto *open = m_window->findChild<KeysDialog *>())
        return open;
    m_window->activateWindow(); // a dialog that closed may have had it
    if (!QTest::qWaitForWindowActive(m_window, test::kDeadlineMs))
        return nullptr;
    QTest::keyClick(m_window, Qt::Key_P, Qt::ControlModifier);
    auto *dialog = m_window->findChild<KeysDialog *>();
    if (dialog && !QTest::qWaitForWindowExposed(dialog, test::kDeadlineMs))
        return nullptr;
    return dialog;
}

PairingDialog *PairedWindowTest::openPairing()
{
    KeysDialog *keys = openKeys();
    if (!keys)
        return nullptr;
    click(keys, "peerPair");
    auto *dialog = m_window->findChild<PairingDialog *>();
    if (dialog && !QTest::qWaitForWindowExposed(dialog, test::kDeadlineMs))
        return nullptr;
    return dialog;
}

void PairedWindowTest::picture(const char *name, QWidget *of)
{
    const QString folder = qEnvironmentVariable("SKYSEAL_PICTURES");
    if (folder.isEmpty())
        return;
    QDir().mkpath(folder);
    for (const auto &[theme, word] : {std::pair(Theme::Dark, "dark"), std::pair(Theme::Light, "light")}) {
        applyTheme(theme);
        QCoreApplication::processEvents(); // the palette reaches every widget
        const QString file = QStringLiteral("%1-%2.png").arg(QLatin1String(name), QLatin1String(word));
        QVERIFY(of->grab().save(QDir(folder).filePath(file)));
    }
}

void PairedWindowTest::confirmBoth(PairingDialog *dialog, Program &desk)
{
    // A known station keeps its role, a new one gets one.
    desk.notify(QStringLiteral("pilot"));
    desk.notify(QStringLiteral("yes"));
    EVENTUALLY(textOf(dialog, "pairingText").contains(QStringLiteral("has confirmed")));
    const bool replaces = dialog->findChild<ChangedKeyWarning *>()->isVisible();
    QVERIFY(!read(ownFile("peers")).contains("heron ") || replaces); // one yes is none
    click(dialog, "pairingAgree");
    EVENTUALLY(textOf(dialog, "pairingText").contains(QStringLiteral("Paired with heron")));
    QCOMPARE(desk.waitForExit(), 0);
}

void PairedWindowTest::wrongPassphraseIsTold()
{
    EVENTUALLY(find<QWidget>("emptyState")->isVisible());
    write("wrong", "grey heron\n");
    write("right", "blue heron\n");
    picture("keys-empty", openKeys());
    PairingDialog *dialog = openPairing();
    QVERIFY(dialog);
    auto *passphrase = dialog->findChild<QLineEdit *>(QStringLiteral("pairingPassphrase"));
    passphrase->setFocus();
    QTest::keyClicks(passphrase, QStringLiteral("blue heron"));
    QTest::keyClick(passphrase, Qt::Key_Return);
    QVERIFY(dialog->isVisible());
    const auto desk = openDesk("air.key", "wrong");
    EVENTUALLY(textOf(dialog, "pairingProblem").contains(QStringLiteral("passphrases of the two ends differ")));
    QVERIFY(!dialog->findChild<QWidget *>(QStringLiteral("pairingAgree"))->isVisible());
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("passphrase-differs")).isEmpty());
    picture("pairing-passphrase-differs", dialog);
    // The opening was shown to an end that did not continue: the next attempt needs a new window.
    EVENTUALLY(textOf(dialog, "pairingText").contains(QStringLiteral("interrupted")));
    QCOMPARE(desk->terminate(), 1);
    click(dialog, "pairingAgain");
}

/// Goes on in the dialog that stands open.
void PairedWindowTest::pairedByTheWindow()
{
    auto *dialog = m_window->findChild<PairingDialog *>();
    QVERIFY(dialog && dialog->isVisible());
    const auto desk = openDesk("air.key", "right");
    const QJsonObject news = desk->waitFor(QStringLiteral("pairing"), stateIs("seen"));
    const QString seen = news[QLatin1String("fingerprint")].toString();
    EVENTUALLY(dialog->findChild<QPushButton *>(QStringLiteral("pairingAgree"))->isVisible());
    QVERIFY(!dialog->findChild<QLabel *>(QStringLiteral("pairingCode"))->isVisible());
    click(dialog, "pairingFingerprints");
    QCOMPARE(inOneLine(textOf(dialog, "pairingTheirs")), m_air);
    QCOMPARE(inOneLine(textOf(dialog, "pairingOwn")), seen);
    QVERIFY(textOf(dialog, "pairingProblem").isEmpty());
    auto *name = dialog->findChild<QLineEdit *>(QStringLiteral("pairingName"));
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("heron"));
    picture("pairing-compare", dialog);
    confirmBoth(dialog, *desk);
    picture("pairing-paired", dialog);
    dialog->close();
    EVENTUALLY(isSealed());
    KeysDialog *keys = openKeys();
    auto *view = keys->findChild<QAbstractItemView *>(QStringLiteral("peerView"));
    const auto lastSeen = [view] { return view->model()->index(0, PeerModel::LastSeen).data().toString(); };
    EVENTUALLY_EQUAL(lastSeen(), QStringLiteral("connected"));
    EVENTUALLY(m_window->view().vehicle);
    QVERIFY(m_window->view().vehicle->session);
    picture("keys-connected", keys);
    picture("window-sealed", m_window);
}

void PairedWindowTest::revokedInTheDialog()
{
    KeysDialog *keys = openKeys();
    auto *view = keys->findChild<QAbstractItemView *>(QStringLiteral("peerView"));
    view->setCurrentIndex(view->model()->index(0, 0));
    click(keys, "peerRevoke");
    auto *box = keys->findChild<QMessageBox *>(QStringLiteral("confirmRevoke"));
    QVERIFY(box && QTest::qWaitForWindowExposed(box, test::kDeadlineMs));
    QVERIFY(box->informativeText().contains(QStringLiteral("ends at once")));
    picture("revoke-question", box);
    m_agent->skipReceivedEvents();
    QVERIFY(isSealed());
    QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
    EVENTUALLY(!m_window->view().session);
    QVERIFY(!m_agent->waitFor(QStringLiteral("session"), stateIs("down")).isEmpty());

    // The window shows the actual state.
    EVENTUALLY_EQUAL(lock(), QStringLiteral("Revoked · heron"));
    QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Revoked · heron"));
    const QString advice = find<QLabel>("secureAdvice")->text();
    QVERIFY2(advice.contains(QStringLiteral("no longer a known peer")), qPrintable(advice));
    QVERIFY2(!advice.contains(QStringLiteral("plain MAVLink")), qPrintable(advice));
    closeKeys();
    picture("window-revoked", m_window);
    QVERIFY(read(ownFile("peers")).isEmpty() || !read(ownFile("peers")).contains("heron"));
}

void PairedWindowTest::pairedAgain()
{
    click(m_window, "secureKeys"); // the panel leads there
    PairingDialog *dialog = openPairing();
    QVERIFY(dialog);
    const auto desk = openDesk("air.key");
    EVENTUALLY(dialog->findChild<QLabel *>(QStringLiteral("pairingCode"))->isVisible());
    auto *name = dialog->findChild<QLineEdit *>(QStringLiteral("pairingName"));
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("heron"));
    const QJsonObject news = desk->waitFor(QStringLiteral("pairing"), stateIs("seen"));
    QCOMPARE(news[QLatin1String("code")].toString(), textOf(dialog, "pairingCode"));
    confirmBoth(dialog, *desk);
    dialog->close();
    EVENTUALLY(isSealed());
    closeKeys();
}

void PairedWindowTest::changedKeyIsRefusedUntilReplaced()
{
    const QString changed = newKey("new-air.key");
    const QByteArray before = read(ownFile("peers"));
    QCOMPARE(m_agent->terminate(), 0);
    EVENTUALLY(!m_window->view().session);
    auto *messages = find<QWidget>("dockMessages")->findChild<QAbstractItemView *>();
    const auto refusals = [&] {
        int count = 0;
        for (int row = 0; row < messages->model()->rowCount(); ++row) {
            for (int column = 0; column < messages->model()->columnCount(); ++column) {
                const QString text = messages->model()->index(row, column).data().toString();
                count += text.contains(QStringLiteral("with an unknown key")) ? 1 : 0;
            }
        }
        return count;
    };
    const int refusedBefore = refusals();
    startAgent("new-air.key"); // it knows us, and we do not know its new key
    EVENTUALLY(refusals() > refusedBefore);
    QVERIFY(!m_window->view().session);
    QCOMPARE(read(ownFile("peers")), before);
    QCOMPARE(find<QLabel>("secureTitle")->text(), QStringLiteral("Session ended · heron"));

    PairingDialog *dialog = openPairing();
    QVERIFY(dialog);
    const auto desk = openDesk("new-air.key");
    EVENTUALLY(dialog->findChild<QLabel *>(QStringLiteral("pairingCode"))->isVisible());
    QCOMPARE(inOneLine(textOf(dialog, "pairingTheirs")), changed);
    auto *name = dialog->findChild<QLineEdit *>(QStringLiteral("pairingName"));
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("heron"));
    auto *warning = dialog->findChild<ChangedKeyWarning *>();
    QVERIFY(warning->isVisible());
    QCOMPARE(inOneLine(textOf(dialog, "knownFingerprint")), m_air);
    QCOMPARE(inOneLine(textOf(dialog, "offeredFingerprint")), changed);
    picture("pairing-changed-key", dialog);
    click(dialog, "pairingAgree"); // is disabled
    QVERIFY(!textOf(dialog, "pairingText").contains(QStringLiteral("Confirmed here")));
    auto *tick = dialog->findChild<QCheckBox *>(QStringLiteral("replaceKey"));
    tick->setFocus();
    QTest::keyClick(tick, Qt::Key_Space);
    QVERIFY(!desk->waitFor(QStringLiteral("pairing"), stateIs("seen")).isEmpty());
    QCOMPARE(read(ownFile("peers")), before);
    confirmBoth(dialog, *desk);
    dialog->close();
    EVENTUALLY(isSealed());
    QVERIFY(read(ownFile("peers")) != before);
    closeKeys();
}

/// A station that knows nothing of sealing uses the window's link: it reads, and it commands once the operator allows that.
void PairedWindowTest::anotherStationIsServed()
{
    const quint16 port = test::freeTcpPort();
    const auto commands = [port] {
        return test::runProgram("skyseal-cli",
                                {QStringLiteral("monitor"), QStringLiteral("--link"),
                                 QStringLiteral("tcp:127.0.0.1:%1").arg(port), QStringLiteral("--secure"),
                                 QStringLiteral("off"), QStringLiteral("--no-record"), QStringLiteral("--do"),
                                 QStringLiteral("mode GUIDED")});
    };
    QLineEdit *url = find<QComboBox>("serveUrl")->lineEdit();
    url->selectAll();
    QTest::keyClicks(url, QStringLiteral("tcpin:127.0.0.1:%1").arg(port));
    QTest::keyClick(url, Qt::Key_Return);
    find<QCheckBox>("serveOn")->click();
    EVENTUALLY(find<QLabel>("serveState")->text() == QStringLiteral("listening; no station is connected"));
    const test::RunResult reads = commands();
    QCOMPARE(reads.status, 1);
    QVERIFY2(reads.out.contains("denied") || reads.err.contains("denied"), (reads.out + reads.err).constData());
    auto *rights = find<QComboBox>("serveRights");
    rights->setFocus();
    QTest::keyClick(rights, Qt::Key_Down);
    EVENTUALLY(find<QLabel>("serveState")->text() == QStringLiteral("listening; no station is connected"));
    const test::RunResult writes = commands();
    QVERIFY2(writes.status == 0, (writes.out + writes.err).constData());
    picture("window-served", m_window);
    find<QCheckBox>("serveOn")->click();
    QCOMPARE(find<QLabel>("serveState")->text(), QStringLiteral("off"));
}

void PairedWindowTest::agentThatGoesAwayIsWaitedFor()
{
    EVENTUALLY(m_window->view().vehicle && m_window->view().session);
    m_window->suites().action(crypto::SuiteId::Aes256Gcm)->trigger();
    EVENTUALLY(isUnder(crypto::SuiteId::Aes256Gcm));
    QCOMPARE(m_agent->terminate(), 0); // says goodbye
    EVENTUALLY_EQUAL(lock(), QStringLiteral("Session ended · heron"));
    const QString advice = find<QLabel>("secureAdvice")->text();
    QVERIFY2(advice.contains(QStringLiteral("closed by the other end")), qPrintable(advice));
    QVERIFY2(advice.contains(QStringLiteral("Waiting: ")), qPrintable(advice));
    QVERIFY2(!advice.contains(QStringLiteral("plain MAVLink")), qPrintable(advice));
    picture("window-waiting", m_window);
    startAgent("new-air.key");
    EVENTUALLY(isSealed());
    EVENTUALLY(isUnder(crypto::SuiteId::Aes256Gcm)); // the operator's choice, not the first preference
}

void PairedWindowTest::keyIsSealedInTheDialog()
{
    const QByteArray before = read(ownFile("identity.key"));
    QVERIFY(before.startsWith("skyseal-private-key-v1"));
    KeysDialog *keys = openKeys();
    click(keys, "ownPassphrase");
    auto *dialog = keys->findChild<ChangePassphraseDialog *>();
    QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog, test::kDeadlineMs));
    picture("passphrase-set", dialog);
    QTest::keyClicks(dialog->findChild<QLineEdit *>(QStringLiteral("newPassphrase")), QStringLiteral("swordfish"));
    QTest::keyClicks(dialog->findChild<QLineEdit *>(QStringLiteral("newPassphraseAgain")), QStringLiteral("swordfish"));
    QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
    EVENTUALLY(!keys->findChild<ChangePassphraseDialog *>());
    QVERIFY(read(ownFile("identity.key")).startsWith("skyseal-sealed-key-v1"));
    QVERIFY(textOf(keys, "ownFile").contains(QStringLiteral("sealed with a passphrase")));
    QVERIFY(isSealed()); // the session does not notice

    // A wrong passphrase is reported and changes nothing.
    const QByteArray sealed = read(ownFile("identity.key"));
    click(keys, "ownPassphrase");
    dialog = keys->findChild<ChangePassphraseDialog *>();
    QVERIFY(dialog && QTest::qWaitForWindowExposed(dialog, test::kDeadlineMs));
    QTest::keyClicks(dialog->findChild<QLineEdit *>(QStringLiteral("presentPassphrase")), QStringLiteral("sworfish"));
    QTest::mouseClick(dialog->findChild<QCheckBox *>(QStringLiteral("noPassphrase")), Qt::LeftButton, {}, QPoint(8, 8));
    QVERIFY(dialog->findChild<QCheckBox *>(QStringLiteral("noPassphrase"))->isChecked());
    QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
    EVENTUALLY(textOf(dialog, "passphraseProblem").contains(QStringLiteral("does not open it")));
    picture("passphrase-wrong", dialog);
    dialog->close();
    QCOMPARE(read(ownFile("identity.key")), sealed);
    picture("keys-sealed", keys);
    closeKeys();
}

void PairedWindowTest::sealedKeyNeedsItsPassphraseAtStart()
{
    m_app.reset();
    int asked = 0;
    QTimer person;
    answerPassphrases(person, [&](PassphraseDialog *dialog) {
        QCOMPARE(textOf(dialog, "passphraseWrong").isEmpty(), asked == 0);
        picture(asked == 0 ? "passphrase-start" : "passphrase-start-again", dialog);
        QTest::keyClicks(dialog->findChild<QLineEdit *>(QStringLiteral("passphrase")),
                         asked == 0 ? QStringLiteral("sworfish") : QStringLiteral("swordfish"));
        ++asked;
        QTest::keyClick(dialog, Qt::Key_Return);
        person.start();
    });
    startWindow();
    QVERIFY(!QApplication::activeModalWidget()); // it is asked beside the window
    EVENTUALLY_EQUAL(asked, 2);
    EVENTUALLY(isSealed());
    EVENTUALLY(isUnder(crypto::SuiteId::Aes256Gcm)); // chosen before the restart
    person.stop();
}

void PairedWindowTest::namedKeyMayStaySealed()
{
    m_app.reset();
    bool declined = false;
    QTimer person;
    answerPassphrases(person, [&](PassphraseDialog *dialog) {
        if (!std::exchange(declined, true)) {
            QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Cancel), Qt::LeftButton);
        } else {
            QTest::keyClicks(dialog->findChild<QLineEdit *>(QStringLiteral("passphrase")), QStringLiteral("swordfish"));
            QTest::keyClick(dialog, Qt::Key_Return);
        }
    });
    app::WindowOptions options;
    options.identityFile = ownFile("identity.key").toStdString();
    options.peersFile = ownFile("peers").toStdString();
    startWindow(std::move(options));
    EVENTUALLY(declined && textOf(m_window, "problemText").startsWith(QStringLiteral("No sealed links")));
    picture("passphrase-declined", m_window);
    // It is not too late.
    person.start();
    click(m_window, "problemRemedy");
    EVENTUALLY(isSealed());
}

SKYSEAL_TEST_WIDGETS(PairedWindowTest)
#include "paired_window_test.moc"
