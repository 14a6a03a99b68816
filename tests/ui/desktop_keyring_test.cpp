// The passphrase of a sealed key in the desktop's keyring: against a real gnome-keyring-daemon on a session bus of its own.
// Skipped, and saying so, where these programs or the library are missing.
#include "core/crypto/passphrase.h"
#include "core/crypto/system_random.h"
#include "app/skyseal/passphrase_memory.h"
#include "app/skyseal/passphrase_question.h"
#include "tests/support/eventually.h"
#include "tests/support/requirements.h"
#include "tests/support/test_runner.h"
#include "ui/keys/passphrase_dialog.h"

#include <QtCore/QFile>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtDBus/QDBusConnection>
#include <QtDBus/QDBusConnectionInterface>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLineEdit>

using namespace skyseal;
using namespace skyseal::app;

namespace {

constexpr const char *kInside = "SKYSEAL_TEST_SESSION_BUS";

crypto::Passphrase passphrase(std::string_view words)
{
    return *crypto::Passphrase::fromBytes(asBytes(words));
}

bool is(const std::optional<crypto::Passphrase> &found, std::string_view words)
{
    return found && asText(found->view()) == words;
}

} // namespace

class DesktopKeyringTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void init();
    void rememberedAndForgotten();
    void askedOnceThenNoMore();
    void stalePassphraseIsRequested();

private:
    /// A restarted program: only the files and the keyring remain.
    void restart()
    {
        m_store = std::make_unique<QSettings>(m_folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
        m_memory = desktopMemory(*m_store);
    }
    void remember(const std::string &file, std::string_view words)
    {
        QSignalSpy done(m_memory.get(), &PassphraseMemory::done);
        QSignalSpy failed(m_memory.get(), &PassphraseMemory::failed);
        m_memory->remember(file, passphrase(words));
        EVENTUALLY(done.size() == 1 || !failed.isEmpty());
        QVERIFY2(failed.isEmpty(), failed.isEmpty() ? "" : qPrintable(failed[0][0].toString()));
    }

    std::optional<crypto::Passphrase> recall(const std::string &file)
    {
        QObject context;
        bool answered = false;
        std::optional<crypto::Passphrase> out;
        m_memory->recall(file, &context, [&](std::optional<crypto::Passphrase> found) {
            answered = true;
            out = std::move(found);
        });
        [&] { EVENTUALLY(answered); }();
        return out;
    }
    /// Opens the key by what the keyring remembers: "opened", "wrong", "nothing" or the problem.
    QString openRemembered(PassphraseQuestion &question, QWidget &window, const std::string &file)
    {
        QString out;
        question.recall(
            window, file, [&](const auto &) { out = QStringLiteral("opened"); },
            [&](const InputError &why) { out = QString::fromStdString(why.text()); },
            [&](bool wrong) { out = wrong ? QStringLiteral("wrong") : QStringLiteral("nothing"); });
        [&] { EVENTUALLY(!out.isEmpty()); }();
        return out;
    }

    std::string sealedKey(const char *name, std::string_view words)
    {
        const std::string file = m_folder.filePath(QString::fromLatin1(name)).toStdString();
        const crypto::Passphrase sealing = passphrase(words);
        if (!keys::writeNewIdentity(file, m_random, {&sealing, {.passes = 1, .memoryKiB = 8192}}))
            qFatal("no key %s", name);
        return file;
    }
    static ui::PassphraseDialog *openDialog(const QWidget &window)
    {
        auto *dialog = window.findChild<ui::PassphraseDialog *>();
        return dialog && dialog->isVisible() ? dialog : nullptr;
    }
    static void answer(const QWidget &window, const QString &words)
    {
        auto *dialog = openDialog(window);
        QVERIFY(dialog);
        QTest::keyClicks(dialog->findChild<QLineEdit *>(QStringLiteral("passphrase")), words);
        QTest::keyClick(dialog, Qt::Key_Return);
    }

    crypto::SystemRandom m_random;
    QTemporaryDir m_folder;
    QProcess m_daemon;
    std::unique_ptr<QSettings> m_store;
    std::unique_ptr<PassphraseMemory> m_memory;
};

void DesktopKeyringTest::initTestCase()
{
    SKYSEAL_REQUIRES("gnome_keyring");
    restart();
    m_daemon.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_daemon.start(QStringLiteral("gnome-keyring-daemon"),
                   {QStringLiteral("--foreground"), QStringLiteral("--unlock"), QStringLiteral("--components=secrets")});
    QVERIFY(m_daemon.waitForStarted(test::kDeadlineMs));
    m_daemon.write("login");
    m_daemon.closeWriteChannel();
    const auto *bus = QDBusConnection::sessionBus().interface();
    EVENTUALLY(bus->isServiceRegistered(QStringLiteral("org.freedesktop.secrets")).value());
    restart();
    QCOMPARE(m_memory->problem(), QString());
}

void DesktopKeyringTest::cleanupTestCase()
{
    m_memory.reset();
    if (m_daemon.state() == QProcess::Running) {
        m_daemon.terminate();
        m_daemon.waitForFinished(test::kDeadlineMs);
    }
}

void DesktopKeyringTest::init()
{
    restart();
}

void DesktopKeyringTest::rememberedAndForgotten()
{
    QVERIFY(!m_memory->remembers("/a.key"));
    QVERIFY(!recall("/a.key"));
    remember("/a.key", "swordfish");
    remember("/b.key", "zwölf Boxkämpfer");
    restart();
    QVERIFY(m_memory->remembers("/a.key") && m_memory->remembers("/b.key") && !m_memory->remembers("/c.key"));
    QVERIFY(is(recall("/a.key"), "swordfish"));
    QVERIFY(is(recall("/b.key"), "zwölf Boxkämpfer"));
    remember("/a.key", "another");
    QVERIFY(is(recall("/a.key"), "another"));
    QSignalSpy done(m_memory.get(), &PassphraseMemory::done);
    m_memory->forget("/a.key");
    EVENTUALLY_EQUAL(done.size(), 1);
    restart();
    QVERIFY(!m_memory->remembers("/a.key") && m_memory->remembers("/b.key"));
    QVERIFY(!recall("/a.key"));
    // Nothing of it stands in the settings.
    QFile settings(m_folder.filePath(QStringLiteral("s.ini")));
    QVERIFY(settings.open(QIODevice::ReadOnly));
    QVERIFY(!settings.readAll().contains("Box"));
}

void DesktopKeyringTest::askedOnceThenNoMore()
{
    const std::string file = sealedKey("asked.key", "swordfish");
    QWidget window;
    {
        PassphraseQuestion question(*m_memory);
        QVERIFY(!question.isRemembered(file));
        bool opened = false;
        question.ask(
            window, file, [&](const auto &) { opened = true; }, [](const InputError &) {});
        auto *dialog = openDialog(window);
        auto *remember = dialog->findChild<QCheckBox *>(QStringLiteral("rememberPassphrase"));
        QVERIFY(remember->isEnabled());
        QTest::mouseClick(remember, Qt::LeftButton, {}, QPoint(8, remember->height() / 2));
        QSignalSpy done(m_memory.get(), &PassphraseMemory::done);
        QVERIFY(!m_memory->remembers(file)); // not before it opened the file
        answer(window, QStringLiteral("swordfish"));
        EVENTUALLY(opened);
        EVENTUALLY_EQUAL(done.size(), 1);
    }
    restart();
    PassphraseQuestion question(*m_memory);
    QVERIFY(question.isRemembered(file));
    QCOMPARE(openRemembered(question, window, file), QStringLiteral("opened"));
    QVERIFY(!openDialog(window));
}

/// The passphrase was changed by skyseal-cli meanwhile.
void DesktopKeyringTest::stalePassphraseIsRequested()
{
    const std::string file = sealedKey("stale.key", "new");
    remember(file, "old");
    PassphraseQuestion question(*m_memory);
    QWidget window;
    QCOMPARE(openRemembered(question, window, file), QStringLiteral("wrong"));
    bool opened = false;
    question.ask(
        window, file, [&](const auto &) { opened = true; }, [](const InputError &) {});
    QSignalSpy done(m_memory.get(), &PassphraseMemory::done);
    answer(window, QStringLiteral("new"));
    EVENTUALLY(opened);
    EVENTUALLY_EQUAL(done.size(), 1);
    QVERIFY(is(recall(file), "new")); // it went on being remembered
}

/// Runs again on its own session bus, so that no real keyring is used.
static int runInSession(int argc, char **argv)
{
    const QTemporaryDir home;
    for (const char *folder : {"HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"})
        qputenv(folder, home.path().toUtf8());
    qunsetenv("XDG_CURRENT_DESKTOP");
    qputenv(kInside, "1");
    QStringList arguments{QStringLiteral("--"), QString::fromLocal8Bit(argv[0])};
    for (int i = 1; i < argc; ++i)
        arguments.append(QString::fromLocal8Bit(argv[i]));
    return QProcess::execute(QStringLiteral("dbus-run-session"), arguments);
}

SKYSEAL_TEST_ENTRY(DesktopKeyringTest,
                   if (!qEnvironmentVariableIsSet(kInside) && !test::lackOf("gnome_keyring")) return runInSession(argc, argv);
                   QApplication application(argc, argv);)

#include "desktop_keyring_test.moc"
