// The program's start with a sealed key whose passphrase is in the keyring: the window is there before the passphrase is
// hashed, says that the key is being opened, and opens the links once it is known which ones may be sealed.
#include "app/skyseal/application.h"
#include "core/crypto/init_crypto.h"
#include "core/crypto/system_random.h"
#include "core/engine/station/snapshot.h"
#include "core/keys/peers_file.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/keys/passphrase_dialog.h"

#include <QtCore/QFile>
#include <QtCore/QPointer>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>

#include <functional>

using namespace skyseal;
using namespace skyseal::app;

namespace {

/// A keyring that answers when the test wants it.
class HeldKeyring final : public PassphraseMemory
{
public:
    QString problem() const override { return {}; }
    bool remembers(const std::string &) const override { return true; }
    void recall(const std::string &, QObject *context, Recalled recalled) override
    {
        m_context = context;
        m_recalled = std::move(recalled);
    }
    void remember(const std::string &, const crypto::Passphrase &) override {}
    void forget(const std::string &) override {}

    bool isWaiting() const { return m_recalled != nullptr; }
    void answer(std::string_view words)
    {
        if (const Recalled recalled = std::exchange(m_recalled, {}); recalled && m_context)
            recalled(crypto::Passphrase::fromBytes(asBytes(words)));
    }

private:
    QPointer<QObject> m_context;
    Recalled m_recalled;
};

} // namespace

class RememberedKeyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(crypto::initCrypto()); }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        for (const char *folder : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
            qputenv(folder, m_folder->filePath(QLatin1String(folder)).toUtf8());
        WindowOptions options;
        options.identityFile = m_folder->filePath(QStringLiteral("ground.key")).toStdString();
        options.peersFile = m_folder->filePath(QStringLiteral("ground.peers")).toStdString();
        options.links = {*link::LinkUrl::parse("udpin:127.0.0.1:0")};
        const auto passphrase = crypto::Passphrase::fromBytes(asBytes(std::string_view("swordfish")));
        QVERIFY(keys::writeNewIdentity(options.identityFile, m_random, {&*passphrase, {.passes = 1, .memoryKiB = 8192}}));
        QVERIFY(keys::createMissingPeers(options.peersFile));
        auto keyring = std::make_unique<HeldKeyring>();
        m_keyring = keyring.get();
        m_application = std::make_unique<Application>(std::move(options), m_random, nullptr, std::move(keyring));
        QVERIFY(m_application->start());
        m_window = nullptr;
        for (QWidget *top : QApplication::topLevelWidgets())
            if (auto *made = qobject_cast<ui::MainWindow *>(top))
                m_window = made;
        QVERIFY(m_window && m_window->isVisible());
        EVENTUALLY(m_window->view().station() && isWaiting());
    }
    void cleanup()
    {
        if (m_application)
            m_application->stop();
        m_application.reset();
    }

    void linksWaitForTheKey()
    {
        m_window->addLink(QStringLiteral("udpout:127.0.0.1:9")); // by the operator meanwhile
        EVENTUALLY_EQUAL(links(), std::size_t(1));
        const std::uint64_t now = m_window->view().station()->number;
        EVENTUALLY(m_window->view().station()->number > now + 3);
        QVERIFY(isWaiting()); // as long as the keyring
        m_keyring->answer("swordfish");
        EVENTUALLY(said("emptyTitle").startsWith(QStringLiteral("Waiting for a vehicle on ")));
        EVENTUALLY_EQUAL(links(), std::size_t(2));
        QVERIFY(!dialog() && said("problemText").isEmpty());
    }

    void outdatedPassphraseIsAskedFor()
    {
        m_keyring->answer("outdated");
        EVENTUALLY(dialog());
        const QString why = dialog()->findChild<QLabel *>(QStringLiteral("passphraseWrong"))->text();
        QVERIFY2(why.contains(QStringLiteral("remembered passphrase")), qPrintable(why));
        EVENTUALLY_EQUAL(links(), std::size_t(1)); // plain MAVLink need not wait for the operator
        EVENTUALLY_EQUAL(said("emptyTitle"), QStringLiteral("This station cannot use its key"));
        QTest::keyClicks(dialog()->findChild<QLineEdit *>(QStringLiteral("passphrase")), QStringLiteral("swordfish"));
        QTest::keyClick(dialog(), Qt::Key_Return);
        EVENTUALLY(said("emptyTitle").startsWith(QStringLiteral("Waiting for a vehicle on ")));
        EVENTUALLY_EQUAL(links(), std::size_t(1));
        QVERIFY(!dialog());
    }

    void failureIsSaidInTheWindow()
    {
        QVERIFY(QFile::remove(m_folder->filePath(QStringLiteral("ground.key"))));
        m_keyring->answer("swordfish");
        EVENTUALLY_EQUAL(said("emptyTitle"), QStringLiteral("This station cannot use its key"));
        QVERIFY2(said("emptyText").contains(QStringLiteral("ground.key")), qPrintable(said("emptyText")));
        QVERIFY2(said("problemText").startsWith(QStringLiteral("No sealed links: ")), qPrintable(said("problemText")));
        EVENTUALLY_EQUAL(links(), std::size_t(1));
        QVERIFY(!dialog());
    }

    void endsWhileItWaits()
    {
        m_application->stop();
        m_application.reset(); // with the keyring
        QCoreApplication::processEvents();
    }

private:
    bool isWaiting() const
    {
        return m_keyring->isWaiting() && said("emptyTitle") == QStringLiteral("Opening this station's key…") && !dialog();
    }
    QString said(const char *label) const { return m_window->findChild<QLabel *>(QLatin1String(label))->text(); }
    std::size_t links() const { return m_window->view().station()->links.size(); }
    ui::PassphraseDialog *dialog() const
    {
        for (auto *found : m_window->findChildren<ui::PassphraseDialog *>())
            if (found->isVisible())
                return found;
        return nullptr;
    }

    crypto::SystemRandom m_random;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Application> m_application;
    HeldKeyring *m_keyring = nullptr;
    ui::MainWindow *m_window = nullptr;
};

SKYSEAL_TEST_WIDGETS(RememberedKeyTest)
#include "remembered_key_test.moc"
