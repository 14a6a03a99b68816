// The pairing dialog: its input, the content of each step, and no confirmation by accident.
#include "fake_keyring.h"
#include "fake_pairing.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/keys/changed_key_warning.h"
#include "ui/keys/fingerprint_text.h"
#include "ui/keys/pairing_dialog.h"

#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

using namespace skyseal;
using namespace skyseal::ui;

namespace {

channel::PublicKey key(std::uint8_t first)
{
    channel::PublicKey out{};
    out.fill(first);
    return out;
}

} // namespace

class PairingDialogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_keyring = std::make_unique<FakeKeyring>();
        m_keyring->own.publicKey = key(1);
        m_pairing = std::make_unique<FakePairing>();
        m_dialog = std::make_unique<PairingDialog>(*m_pairing, *m_keyring);
        m_dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get(), test::kDeadlineMs));
        m_dialog->activateWindow();
    }
    void cleanup() { m_dialog.reset(); }

    void waitingShowsInstructions();
    void comparedAndConfirmed();
    void returnKeyDoesNotConfirm();
    void returnKeyDoesNotCloseTheLastPage();
    void refusedByTheEye();
    void fingerprintsAreBehindTheButton();
    void passphraseNeedsNoCode();
    void changedKeyNeedsTheTick();
    void anotherNameAvoidsTheWarning();
    void badNameIsNoYes();
    void failureCanBeTriedAgain();
    void leavingCancels();
    void passphraseIsUsedOnceItIsTyped();
    void passphraseNeedsNoReturn();
    void passphraseIsUsedWhenTheWindowIsLeft();
    void questionWithoutTheTypedPassphraseIsNotShown();
    void wrongPassphraseIsTold();

private:
    template<typename W> W *find(const char *name) const { return m_dialog->findChild<W *>(QLatin1String(name)); }
    QString words() const { return find<QLabel>("pairingText")->text(); }
    void see(std::uint8_t first, const char *name)
    {
        Q_EMIT m_pairing->seen({key(first), QLatin1String(name), QStringLiteral("012 345"), 7});
    }

    std::unique_ptr<FakeKeyring> m_keyring;
    std::unique_ptr<FakePairing> m_pairing;
    std::unique_ptr<PairingDialog> m_dialog;
};

void PairingDialogTest::waitingShowsInstructions()
{
    QCOMPARE(m_pairing->passphrases.size(), std::size_t(1));
    QVERIFY(words().contains(QStringLiteral("skyseal-air --pair")));
    QVERIFY(!find<QLabel>("pairingCode")->isVisible() && !find<QLabel>("pairingOwn")->isVisible());
    QVERIFY(find<QLabel>("pairingTime")->text().contains(QStringLiteral("s left")));
    QVERIFY(!find<QPushButton>("pairingAgree")->isVisible());
}

void PairingDialogTest::comparedAndConfirmed()
{
    see(5, "heron");
    QVERIFY(find<QLabel>("pairingCode")->isVisible());
    QCOMPARE(find<QLabel>("pairingCode")->text(), QStringLiteral("012 345"));
    QCOMPARE(find<QLabel>("pairingSystem")->text(), QStringLiteral("system ID 7"));
    QCOMPARE(find<QLineEdit>("pairingName")->text(), QStringLiteral("heron"));
    Q_EMIT m_pairing->confirmedThere();
    QVERIFY(words().contains(QStringLiteral("has confirmed")));
    find<QLineEdit>("pairingName")->setText(QStringLiteral("scout-1"));
    QTest::mouseClick(find<QPushButton>("pairingAgree"), Qt::LeftButton);
    QCOMPARE(m_pairing->confirmations.size(), std::size_t(1));
    QCOMPARE(m_pairing->confirmations[0].name, QStringLiteral("scout-1"));
    QVERIFY(m_pairing->confirmations[0].key == key(5) && !m_pairing->confirmations[0].replace);
    QVERIFY(!find<QPushButton>("pairingAgree")->isVisible());
    Q_EMIT m_pairing->paired(QStringLiteral("scout-1"));
    QVERIFY(words().contains(QStringLiteral("Paired with scout-1")));
    QVERIFY(find<QLabel>("pairingTime")->text().isEmpty());
}

void PairingDialogTest::returnKeyDoesNotConfirm()
{
    see(5, "heron");
    for (QWidget *at : std::initializer_list<QWidget *>{m_dialog.get(), find<QLineEdit>("pairingName")}) {
        QTest::keyClick(at, Qt::Key_Return);
        QTest::keyClick(at, Qt::Key_Enter);
    }
    QVERIFY(m_pairing->confirmations.empty());
}

void PairingDialogTest::returnKeyDoesNotCloseTheLastPage()
{
    see(5, "heron");
    auto *agree = find<QPushButton>("pairingAgree");
    agree->setFocus();
    QTest::keyClick(agree, Qt::Key_Space);
    QCOMPARE(m_pairing->confirmations.size(), std::size_t(1));
    Q_EMIT m_pairing->paired(QStringLiteral("heron"));
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        QTest::keyClick(m_dialog->focusWidget() ? m_dialog->focusWidget() : m_dialog.get(), key);
        QTest::keyClick(m_dialog.get(), key);
    }
    QVERIFY(m_dialog->isVisible());
}

void PairingDialogTest::refusedByTheEye()
{
    see(5, "heron");
    QTest::mouseClick(find<QPushButton>("pairingDiffer"), Qt::LeftButton);
    QCOMPARE(m_pairing->refusals, 1);
    QVERIFY(words().contains(QStringLiteral("man in the middle")));
    QVERIFY(!find<QLabel>("pairingCode")->isVisible());
    Q_EMIT m_pairing->failed(QStringLiteral("refused here"));
    QVERIFY(words().contains(QStringLiteral("man in the middle")));
    QVERIFY(find<QPushButton>("pairingAgain")->isVisible());
}

void PairingDialogTest::fingerprintsAreBehindTheButton()
{
    QVERIFY(!find<QPushButton>("pairingFingerprints")->isVisible());
    see(5, "heron");
    QVERIFY(!find<QLabel>("pairingTheirs")->isVisible());
    QTest::mouseClick(find<QPushButton>("pairingFingerprints"), Qt::LeftButton);
    QVERIFY(find<QLabel>("pairingOwn")->isVisible() && find<QLabel>("pairingTheirs")->isVisible());
    QCOMPARE(find<QLabel>("pairingOwn")->text(), fingerprintLines(key(1)));
    QCOMPARE(find<QLabel>("pairingTheirs")->text(), fingerprintLines(key(5)));
    QTest::mouseClick(find<QPushButton>("pairingFingerprints"), Qt::LeftButton);
    QVERIFY(!find<QLabel>("pairingTheirs")->isVisible());
}

void PairingDialogTest::passphraseNeedsNoCode()
{
    auto *field = find<QLineEdit>("pairingPassphrase");
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("blue heron"));
    QTest::keyClick(field, Qt::Key_Return);
    see(5, "heron");
    QVERIFY(!find<QLabel>("pairingCode")->isVisible());
    QVERIFY(words().contains(QStringLiteral("knows the passphrase")));
    QTest::mouseClick(find<QPushButton>("pairingAgree"), Qt::LeftButton);
    QCOMPARE(m_pairing->confirmations.size(), std::size_t(1));
}

void PairingDialogTest::changedKeyNeedsTheTick()
{
    KnownPeer known;
    known.name = QStringLiteral("heron");
    known.key = key(4);
    m_keyring->list.peers = {known};
    see(5, "heron");
    QVERIFY(m_dialog->findChild<ChangedKeyWarning *>()->isVisible());
    QVERIFY(!find<QPushButton>("pairingAgree")->isEnabled());
    QTest::mouseClick(find<QPushButton>("pairingAgree"), Qt::LeftButton);
    QVERIFY(m_pairing->confirmations.empty());
    find<QCheckBox>("replaceKey")->setFocus();
    QTest::keyClick(find<QCheckBox>("replaceKey"), Qt::Key_Space);
    QTest::mouseClick(find<QPushButton>("pairingAgree"), Qt::LeftButton);
    QVERIFY(m_pairing->confirmations.at(0).replace);
}

void PairingDialogTest::anotherNameAvoidsTheWarning()
{
    KnownPeer known;
    known.name = QStringLiteral("heron");
    known.key = key(4);
    m_keyring->list.peers = {known};
    see(5, "heron");
    find<QLineEdit>("pairingName")->setText(QStringLiteral("heron-2"));
    QVERIFY(!m_dialog->findChild<ChangedKeyWarning *>()->isVisible());
    QVERIFY(find<QPushButton>("pairingAgree")->isEnabled());
    // A key that is known is no changed one, whatever it is called.
    m_keyring->list.peers[0].key = key(5);
    find<QLineEdit>("pairingName")->setText(QStringLiteral("heron"));
    QVERIFY(find<QPushButton>("pairingAgree")->isEnabled());
}

void PairingDialogTest::badNameIsNoYes()
{
    see(5, "heron");
    find<QLineEdit>("pairingName")->setText(QStringLiteral("two words"));
    QVERIFY(!find<QPushButton>("pairingAgree")->isEnabled());
    QVERIFY(find<QLabel>("pairingProblem")->text().contains(QStringLiteral("is not a peer's name")));
}

void PairingDialogTest::failureCanBeTriedAgain()
{
    Q_EMIT m_pairing->failed(QStringLiteral("the vehicle was armed"));
    QVERIFY(words().contains(QStringLiteral("the vehicle was armed")));
    QTest::mouseClick(find<QPushButton>("pairingAgain"), Qt::LeftButton);
    QCOMPARE(m_pairing->passphrases.size(), std::size_t(2));
    QVERIFY(words().contains(QStringLiteral("skyseal-air --pair")));
}

void PairingDialogTest::leavingCancels()
{
    m_dialog.reset();
    QCOMPARE(m_pairing->cancels, 1);
    PairingDialog done(*m_pairing, *m_keyring);
    Q_EMIT m_pairing->paired(QStringLiteral("heron"));
    done.reject();
    QCOMPARE(m_pairing->cancels, 1);
}

void PairingDialogTest::passphraseIsUsedOnceItIsTyped()
{
    auto *field = find<QLineEdit>("pairingPassphrase");
    QCOMPARE(field->echoMode(), QLineEdit::Password);
    QCOMPARE(m_pairing->passphrases, std::vector<std::string>{""});
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("blue heron"));
    QCOMPARE(m_pairing->passphrases.size(), std::size_t(1)); // not with each letter
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(m_dialog->isVisible());
    QCOMPARE(m_pairing->passphrases, (std::vector<std::string>{"", "blue heron"}));
    field->clearFocus(); // unchanged: the pairing is not restarted
    QCOMPARE(m_pairing->passphrases.size(), std::size_t(2));
    see(5, "heron");
    QVERIFY(!field->isVisible());
}

void PairingDialogTest::passphraseNeedsNoReturn()
{
    auto *field = find<QLineEdit>("pairingPassphrase");
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("blue heron"));
    Q_EMIT m_pairing->passphraseDiffers(); // an agent answers the window that has no passphrase
    QVERIFY(find<QLabel>("pairingProblem")->text().isEmpty());
    EVENTUALLY(m_pairing->passphrases.size() > 1);
    QCOMPARE(m_pairing->passphrases, (std::vector<std::string>{"", "blue heron"})); // once, after a pause
    see(5, "heron");
    QVERIFY(words().contains(QStringLiteral("knows the passphrase")));
}

void PairingDialogTest::passphraseIsUsedWhenTheWindowIsLeft()
{
    auto *field = find<QLineEdit>("pairingPassphrase");
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("blue heron"));
    QWidget terminal;
    terminal.show();
    terminal.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&terminal, test::kDeadlineMs));
    QCOMPARE(m_pairing->passphrases, (std::vector<std::string>{"", "blue heron"}));
}

void PairingDialogTest::questionWithoutTheTypedPassphraseIsNotShown()
{
    auto *field = find<QLineEdit>("pairingPassphrase");
    field->setFocus();
    QTest::keyClicks(field, QStringLiteral("blue"));
    see(5, "heron");
    QVERIFY(!find<QPushButton>("pairingAgree")->isVisible());
    QCOMPARE(m_pairing->passphrases.back(), std::string("blue"));
    see(5, "heron");
    QVERIFY(find<QPushButton>("pairingAgree")->isVisible());
}

void PairingDialogTest::wrongPassphraseIsTold()
{
    Q_EMIT m_pairing->passphraseDiffers();
    QVERIFY(find<QLabel>("pairingProblem")->text().contains(QStringLiteral("passphrases of the two ends differ")));
    see(5, "heron");
    QVERIFY(find<QLabel>("pairingProblem")->text().isEmpty());
    Q_EMIT m_pairing->passphraseDiffers(); // a late event about another device
    QVERIFY(find<QLabel>("pairingProblem")->text().isEmpty());
}

SKYSEAL_TEST_WIDGETS(PairingDialogTest)
#include "pairing_dialog_test.moc"
