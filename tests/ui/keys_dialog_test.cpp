// The dialog of keys and peers by real clicks and keys: each state designed, each change asked of the keyring, a changed key
// replaced only knowingly, revoking confirmed.
#include "core/crypto/passphrase.h"
#include "core/keys/public_key_text.h"
#include "fake_keyring.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"
#include "ui/keys/change_passphrase_dialog.h"
#include "ui/keys/changed_key_warning.h"
#include "ui/keys/fingerprint_text.h"
#include "ui/keys/keys_dialog.h"
#include "ui/keys/passphrase_dialog.h"
#include "ui/keys/peer_dialog.h"

#include <QtGui/QClipboard>
#include <QtGui/QGuiApplication>
#include <QtTest/QAbstractItemModelTester>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QMessageBox>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTreeView>

using namespace skyseal;
using namespace skyseal::ui;
using channel::PeerRole;

namespace {

channel::PublicKey key(std::uint8_t first)
{
    channel::PublicKey out{};
    out.fill(first);
    return out;
}

QString textOf(const channel::PublicKey &publicKey)
{
    return QString::fromStdString(keys::publicKeyText(publicKey));
}

KnownPeer peer(const char *name, std::uint8_t first)
{
    KnownPeer out;
    out.name = QLatin1String(name);
    out.key = key(first);
    return out;
}

} // namespace

class KeysDialogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_keyring = std::make_unique<FakeKeyring>();
        m_keyring->own = {key(1), true, QStringLiteral("/home/ann/identity.key"), {}};
        m_keyring->list = {{peer("scout-1", 2), peer("tablet", 3)}, QStringLiteral("/home/ann/peers"), {}};
        m_keyring->list.peers[1].role = PeerRole::Observer;
        m_keyring->list.peers[1].systems = {1, 2};
        open();
    }
    void cleanup() { m_dialog.reset(); }

    void ownKeyIsShownAndCopied();
    void missingKeyShowsTheReason();
    void peersAreListed();
    void emptyListShowsInstructions();
    void unreadableListShowsTheReason();
    void addedByItsText();
    void everyInputErrorHasAMessage_data();
    void everyInputErrorHasAMessage();
    void changedKeyIsReplacedKnowingly();
    void replacedPeerStaysWhatItWas();
    void tickCountsForOneKeyAlone();
    void editedByKeysAlone();
    void revokedAfterAQuestion();
    void revokeBeginsAtCancel();
    void refusalIsShown();
    void chosenPeerStaysChosen();
    void namesAreNoMarkup();
    void everyControlHasANameAndAKey();
    void passphraseIsHiddenAndTaken();
    void passphraseIsSet();
    void passphraseIsChangedAndTakenAway();
    void passphraseRefusalIsShown();
    void modelKeepsItsPromises();

private:
    void open()
    {
        m_dialog = std::make_unique<KeysDialog>(*m_keyring);
        m_dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get(), test::kDeadlineMs));
        m_dialog->activateWindow();
    }
    template<typename W = QPushButton> W *find(const char *name) const { return m_dialog->findChild<W *>(QLatin1String(name)); }
    QModelIndex cell(int row, int column) const { return find<QTreeView>("peerView")->model()->index(row, column); }
    void choose(int row) { find<QTreeView>("peerView")->setCurrentIndex(cell(row, 0)); }
    PeerDialog *openAdd()
    {
        QTest::mouseClick(find("peerAdd"), Qt::LeftButton);
        return m_dialog->findChild<PeerDialog *>();
    }
    static void type(PeerDialog *dialog, const char *field, const QString &text)
    {
        auto *edit = dialog->findChild<QLineEdit *>(QLatin1String(field));
        edit->setFocus();
        edit->selectAll();
        QTest::keyClick(edit, Qt::Key_Delete);
        QTest::keyClicks(edit, text);
    }
    ChangePassphraseDialog *openPassphrase()
    {
        QTest::mouseClick(find("ownPassphrase"), Qt::LeftButton);
        return m_dialog->findChild<ChangePassphraseDialog *>();
    }
    static void typePassphrase(QDialog *dialog, const char *field, const char *words)
    {
        auto *edit = dialog->findChild<QLineEdit *>(QLatin1String(field));
        QCOMPARE(edit->echoMode(), QLineEdit::Password);
        QTest::keyClicks(edit, QLatin1String(words));
    }
    static QString problemOf(PeerDialog *dialog) { return dialog->findChild<QLabel *>(QStringLiteral("peerProblem"))->text(); }
    static QPushButton *okOf(QDialog *dialog) { return dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok); }

    std::unique_ptr<FakeKeyring> m_keyring;
    std::unique_ptr<KeysDialog> m_dialog;
};

void KeysDialogTest::ownKeyIsShownAndCopied()
{
    QCOMPARE(find<QLabel>("ownKey")->text(), textOf(key(1)));
    const QString fingerprint = find<QLabel>("ownFingerprint")->text().replace(QLatin1Char('\n'), QLatin1Char(' '));
    QCOMPARE(fingerprint.toStdString(), keys::fingerprint(key(1)));
    QVERIFY(!find<QLabel>("ownCode")->pixmap().isNull());
    QVERIFY(find<QLabel>("ownFile")->text().contains(QStringLiteral("sealed with a passphrase")));
    QTest::mouseClick(find("ownCopy"), Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), textOf(key(1)));
    QCOMPARE(find<QLabel>("ownResult")->text(), QStringLiteral("copied"));
}

void KeysDialogTest::missingKeyShowsTheReason()
{
    m_keyring->own = {std::nullopt, false, {}, QStringLiteral("the passphrase was not given")};
    m_keyring->notify();
    QVERIFY(find<QLabel>("ownIntro")->text().contains(QStringLiteral("the passphrase was not given")));
    QVERIFY(!find("ownCopy")->isVisible() && !find<QLabel>("ownCode")->isVisible());
}

void KeysDialogTest::peersAreListed()
{
    QCOMPARE(cell(0, PeerModel::Name).data().toString(), QStringLiteral("scout-1"));
    QCOMPARE(cell(0, PeerModel::Systems).data().toString(), QStringLiteral("any"));
    QCOMPARE(cell(1, PeerModel::Systems).data().toString(), QStringLiteral("1,2"));
    QCOMPARE(cell(1, PeerModel::Fingerprint).data().toString(), fingerprintLines(key(3)));
    m_keyring->list.peers[0].connected = true;
    m_keyring->notify();
    QCOMPARE(cell(0, PeerModel::LastSeen).data().toString(), QStringLiteral("connected"));
}

void KeysDialogTest::emptyListShowsInstructions()
{
    m_keyring->list.peers.clear();
    m_keyring->notify();
    QVERIFY(find<QLabel>("noPeers")->isVisible());
    QVERIFY(find<QLabel>("noPeers")->text().contains(QStringLiteral("skyseal-cli keys show")));
    QVERIFY(find("peerAdd")->isEnabled() && !find("peerEdit")->isEnabled() && !find("peerRevoke")->isEnabled());
    QVERIFY(!find("peerPair")->isVisible());
    m_dialog->offerPairing();
    QSignalSpy wanted(m_dialog.get(), &KeysDialog::pairRequested);
    QTest::mouseClick(find("peerPair"), Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
}

void KeysDialogTest::unreadableListShowsTheReason()
{
    m_keyring->list = {{}, QStringLiteral("/home/ann/peers"), QStringLiteral("/home/ann/peers:3: \"captain\" is not a role")};
    m_keyring->notify();
    QVERIFY(find<QLabel>("keysProblem")->isVisible());
    QVERIFY(find<QLabel>("keysProblem")->text().contains(QStringLiteral("captain")));
    QVERIFY(!find("peerAdd")->isEnabled() && !find<QLabel>("noPeers")->isVisible());
}

void KeysDialogTest::addedByItsText()
{
    PeerDialog *dialog = openAdd();
    QVERIFY(dialog && !okOf(dialog)->isEnabled());
    type(dialog, "peerKey", QStringLiteral(" ") + textOf(key(9)));
    QCOMPARE(dialog->findChild<QLabel *>(QStringLiteral("peerFingerprint"))->text(), fingerprintLines(key(9)));
    type(dialog, "peerName", QStringLiteral("heron"));
    type(dialog, "peerSystems", QStringLiteral("4,5"));
    QVERIFY(!dialog->findChild<QComboBox *>()); // the role of an agent would have no effect
    QVERIFY2(okOf(dialog)->isEnabled(), qPrintable(problemOf(dialog)));
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    QCOMPARE(m_keyring->list.peers.size(), std::size_t(3));
    const KnownPeer &added = m_keyring->list.peers.back();
    QCOMPARE(added.name, QStringLiteral("heron"));
    QVERIFY(added.key == key(9) && added.role == PeerRole::Pilot && added.systems == (std::vector<std::uint8_t>{4, 5}));
    QVERIFY(!dialog->isVisible());
}

void KeysDialogTest::everyInputErrorHasAMessage_data()
{
    QTest::addColumn<QString>("keyText");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("systems");
    QTest::addColumn<QString>("words");
    const QString good = textOf(key(9));
    QTest::newRow("nothing") << QString() << QString() << QString() << QStringLiteral("Paste the public key");
    QTest::newRow("no key") << QStringLiteral("ssh-ed25519 AAAA") << QStringLiteral("a") << QString()
                            << QStringLiteral("does not begin with");
    QTest::newRow("slip") << QString(good).replace(20, 1, QStringLiteral("#")) << QStringLiteral("a") << QString()
                          << QStringLiteral("check does not fit");
    QTest::newRow("no name") << good << QString() << QString() << QStringLiteral("Enter a name");
    QTest::newRow("bad name") << good << QStringLiteral("two words") << QString() << QStringLiteral("is not a peer's name");
    QTest::newRow("systems") << good << QStringLiteral("a") << QStringLiteral("1,300")
                             << QStringLiteral("not a list of system IDs");
}

void KeysDialogTest::everyInputErrorHasAMessage()
{
    QFETCH(QString, keyText);
    QFETCH(QString, name);
    QFETCH(QString, systems);
    QFETCH(QString, words);
    PeerDialog *dialog = openAdd();
    type(dialog, "peerKey", keyText);
    type(dialog, "peerName", name);
    type(dialog, "peerSystems", systems);
    QVERIFY2(problemOf(dialog).contains(words), qPrintable(problemOf(dialog)));
    QVERIFY(!okOf(dialog)->isEnabled());
    QTest::keyClick(dialog, Qt::Key_Return);
    QVERIFY(dialog->isVisible());
    QCOMPARE(m_keyring->list.peers.size(), std::size_t(2));
}

void KeysDialogTest::changedKeyIsReplacedKnowingly()
{
    PeerDialog *dialog = openAdd();
    type(dialog, "peerKey", textOf(key(9)));
    type(dialog, "peerSystems", QStringLiteral("7"));
    type(dialog, "peerName", QStringLiteral("scout-1"));
    auto *warning = dialog->findChild<ChangedKeyWarning *>();
    QVERIFY(warning->isVisible());
    QCOMPARE(dialog->findChild<QLabel *>(QStringLiteral("knownFingerprint"))->text(), fingerprintLines(key(2)));
    QCOMPARE(dialog->findChild<QLabel *>(QStringLiteral("offeredFingerprint"))->text(), fingerprintLines(key(9)));
    QVERIFY(!okOf(dialog)->isEnabled());
    QTest::keyClick(dialog, Qt::Key_Return);
    QVERIFY(m_keyring->list.peers[0].key == key(2));
    auto *accept = dialog->findChild<QCheckBox *>(QStringLiteral("replaceKey"));
    accept->setFocus();
    QTest::keyClick(accept, Qt::Key_Space);
    QVERIFY(okOf(dialog)->isEnabled());
    QCOMPARE(okOf(dialog)->text(), QStringLiteral("Replace the key"));
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    QVERIFY(m_keyring->list.peers[0].key == key(9));
    QCOMPARE(m_keyring->list.peers[0].systems, std::vector<std::uint8_t>{7}); // the input is kept
    QCOMPARE(m_keyring->list.peers.size(), std::size_t(2));
}

void KeysDialogTest::replacedPeerStaysWhatItWas()
{
    PeerDialog *dialog = openAdd();
    type(dialog, "peerKey", textOf(key(9)));
    type(dialog, "peerName", QStringLiteral("tablet"));
    QCOMPARE(dialog->findChild<QLineEdit *>(QStringLiteral("peerSystems"))->text(), QStringLiteral("1,2"));
    type(dialog, "peerName", QStringLiteral("tablet-2")); // a new one brings nothing along
    QVERIFY(dialog->findChild<QLineEdit *>(QStringLiteral("peerSystems"))->text().isEmpty());
    type(dialog, "peerName", QStringLiteral("tablet"));
    dialog->findChild<QCheckBox *>(QStringLiteral("replaceKey"))->setChecked(true);
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    const KnownPeer &replaced = m_keyring->list.peers[1];
    QVERIFY(replaced.key == key(9) && replaced.role == PeerRole::Observer);
    QCOMPARE(replaced.systems, (std::vector<std::uint8_t>{1, 2}));
}

void KeysDialogTest::tickCountsForOneKeyAlone()
{
    PeerDialog *dialog = openAdd();
    type(dialog, "peerKey", textOf(key(9)));
    type(dialog, "peerName", QStringLiteral("scout-1"));
    dialog->findChild<QCheckBox *>(QStringLiteral("replaceKey"))->setChecked(true);
    QVERIFY(okOf(dialog)->isEnabled());
    dialog->findChild<QLineEdit *>(QStringLiteral("peerKey"))->setText(textOf(key(10)));
    QVERIFY(!okOf(dialog)->isEnabled());
    dialog->findChild<QCheckBox *>(QStringLiteral("replaceKey"))->setChecked(true);
    dialog->findChild<QLineEdit *>(QStringLiteral("peerName"))->setText(QStringLiteral("tablet")); // nor for another peer
    QVERIFY(!okOf(dialog)->isEnabled());
}

void KeysDialogTest::editedByKeysAlone()
{
    choose(1);
    find<QTreeView>("peerView")->setFocus();
    QTest::keyClick(find<QTreeView>("peerView"), Qt::Key_Return);
    auto *dialog = m_dialog->findChild<PeerDialog *>();
    QVERIFY(dialog);
    QVERIFY(!dialog->findChild<QLineEdit *>(QStringLiteral("peerKey"))->isVisible());
    QCOMPARE(dialog->findChild<QLineEdit *>(QStringLiteral("peerSystems"))->text(), QStringLiteral("1,2"));
    type(dialog, "peerName", QStringLiteral("slate"));
    type(dialog, "peerSystems", QString());
    QTest::keyClick(dialog->findChild<QLineEdit *>(QStringLiteral("peerName")), Qt::Key_Return);
    QCOMPARE(m_keyring->list.peers[1].name, QStringLiteral("slate"));
    QVERIFY(m_keyring->list.peers[1].systems.empty());
    QVERIFY(m_keyring->list.peers[1].role == PeerRole::Observer && m_keyring->list.peers[1].key == key(3));
}

void KeysDialogTest::revokedAfterAQuestion()
{
    choose(0);
    QTest::mouseClick(find("peerRevoke"), Qt::LeftButton);
    auto *box = m_dialog->findChild<QMessageBox *>(QStringLiteral("confirmRevoke"));
    QVERIFY(box && box->text().contains(QStringLiteral("scout-1")));
    QVERIFY(box->informativeText().contains(fingerprintLines(key(2), 4)));
    QTest::mouseClick(box->button(QMessageBox::Yes), Qt::LeftButton);
    QCOMPARE(m_keyring->list.peers.size(), std::size_t(1));
    QCOMPARE(m_keyring->list.peers[0].name, QStringLiteral("tablet"));
}

void KeysDialogTest::revokeBeginsAtCancel()
{
    choose(0);
    auto *view = find<QTreeView>("peerView");
    for (const Qt::Key answer : {Qt::Key_Return, Qt::Key_Escape}) {
        m_dialog->activateWindow();
        view->setFocus();
        EVENTUALLY(view->hasFocus());
        QTest::keyClick(view, Qt::Key_Delete);
        auto *box = m_dialog->findChild<QMessageBox *>(QStringLiteral("confirmRevoke"));
        QVERIFY(box && box->isVisible());
        QTest::keyClick(box, answer);
        EVENTUALLY(!m_dialog->findChild<QMessageBox *>(QStringLiteral("confirmRevoke")));
    }
    QCOMPARE(m_keyring->list.peers.size(), std::size_t(2));
}

void KeysDialogTest::refusalIsShown()
{
    m_keyring->refusal = QStringLiteral("/home/ann/peers: cannot be written: No space left on device");
    PeerDialog *dialog = openAdd();
    type(dialog, "peerKey", textOf(key(9)));
    type(dialog, "peerName", QStringLiteral("heron"));
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    QVERIFY(dialog->isVisible());
    QVERIFY(problemOf(dialog).contains(QStringLiteral("No space left")));
    QTest::keyClick(dialog, Qt::Key_Escape);
    choose(0);
    QTest::mouseClick(find("peerRevoke"), Qt::LeftButton);
    QTest::mouseClick(m_dialog->findChild<QMessageBox *>()->button(QMessageBox::Yes), Qt::LeftButton);
    QVERIFY(find<QLabel>("keysProblem")->text().contains(QStringLiteral("No space left")));
}

void KeysDialogTest::chosenPeerStaysChosen()
{
    choose(1);
    m_keyring->list.peers.insert(m_keyring->list.peers.begin(), peer("a-first-one", 7));
    m_keyring->notify();
    QCOMPARE(find<QTreeView>("peerView")->currentIndex().row(), 2);
    m_keyring->list.peers.erase(m_keyring->list.peers.begin() + 2);
    m_keyring->notify();
    QVERIFY(m_keyring->list.peers.size() == 2);
}

void KeysDialogTest::namesAreNoMarkup()
{
    m_keyring->list.peers[0].name = QStringLiteral("<b>x</b>");
    m_keyring->notify();
    choose(0);
    QTest::mouseClick(find("peerRevoke"), Qt::LeftButton);
    auto *box = m_dialog->findChild<QMessageBox *>(QStringLiteral("confirmRevoke"));
    QCOMPARE(box->textFormat(), Qt::PlainText);
    QTest::keyClick(box, Qt::Key_Escape);
}

void KeysDialogTest::everyControlHasANameAndAKey()
{
    PeerDialog *add = openAdd();
    for (QWidget *window : std::initializer_list<QWidget *>{m_dialog.get(), add}) {
        for (const QPushButton *button : window->findChildren<QPushButton *>()) {
            QVERIFY2(!button->text().isEmpty(), qPrintable(button->objectName()));
            QVERIFY2(button->focusPolicy() & Qt::TabFocus, qPrintable(button->text()));
        }
        for (const QLineEdit *edit : window->findChildren<QLineEdit *>())
            QVERIFY2(!edit->accessibleName().isEmpty(), qPrintable(edit->objectName()));
    }
}

void KeysDialogTest::passphraseIsHiddenAndTaken()
{
    PassphraseDialog dialog(QStringLiteral("/home/ann/identity.key"), RefusedPassphrase::Typed,
                            QStringLiteral("no keyring is running in this desktop session"));
    auto *edit = dialog.findChild<QLineEdit *>(QStringLiteral("passphrase"));
    QCOMPARE(edit->echoMode(), QLineEdit::Password);
    QVERIFY(!okOf(&dialog)->isEnabled());
    QVERIFY(!dialog.findChild<QLabel *>(QStringLiteral("passphraseWrong"))->text().isEmpty());
    QTest::keyClicks(edit, QStringLiteral("swordfish"));
    QVERIFY(okOf(&dialog)->isEnabled());
    const auto taken = dialog.takePassphrase();
    QVERIFY(taken && asText(taken->view()) == "swordfish");
    QVERIFY(edit->text().isEmpty());
    auto *remember = dialog.findChild<QCheckBox *>(QStringLiteral("rememberPassphrase"));
    QVERIFY(!remember->isEnabled() && remember->text().contains(QStringLiteral("no keyring is running")));
    QVERIFY(!dialog.isToBeRemembered());
    PassphraseDialog other(QStringLiteral("/home/ann/identity.key"), RefusedPassphrase::None, {});
    other.show();
    remember = other.findChild<QCheckBox *>(QStringLiteral("rememberPassphrase"));
    QVERIFY(remember->isEnabled() && !other.isToBeRemembered()); // only if the operator ticks it
    QTest::mouseClick(remember, Qt::LeftButton, {}, QPoint(8, remember->height() / 2));
    QVERIFY(other.isToBeRemembered());
}

void KeysDialogTest::passphraseIsSet()
{
    m_keyring->own.sealed = false;
    m_keyring->notify();
    QVERIFY(find("ownPassphrase")->text().startsWith(QStringLiteral("Set")));
    ChangePassphraseDialog *dialog = openPassphrase();
    QVERIFY(dialog && !dialog->findChild<QLineEdit *>(QStringLiteral("presentPassphrase"))->isVisible());
    QVERIFY(!dialog->findChild<QCheckBox *>(QStringLiteral("noPassphrase"))->isVisible());
    typePassphrase(dialog, "newPassphrase", "swordfish");
    QVERIFY(!okOf(dialog)->isEnabled());
    typePassphrase(dialog, "newPassphraseAgain", "swordfisk");
    QVERIFY(!okOf(dialog)->isEnabled());
    QVERIFY(dialog->findChild<QLabel *>(QStringLiteral("passphraseProblem"))->text().contains(QStringLiteral("differ")));
    QTest::keyClick(dialog->findChild<QLineEdit *>(QStringLiteral("newPassphraseAgain")), Qt::Key_Backspace);
    QTest::keyClick(dialog, Qt::Key_Return);
    QVERIFY(m_keyring->passphrases.empty());
    typePassphrase(dialog, "newPassphraseAgain", "h");
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    QCOMPARE(m_keyring->passphrases.size(), std::size_t(1));
    QCOMPARE(m_keyring->passphrases[0].first, std::string());
    QCOMPARE(m_keyring->passphrases[0].second, std::string("swordfish"));
    QTest::keyClick(dialog, Qt::Key_Escape); // not in the middle of it
    QVERIFY(dialog->isVisible());
    m_keyring->finishPassphrase({});
    QVERIFY(!dialog->isVisible());
    QCOMPARE(find<QLabel>("ownResult")->text(), QStringLiteral("sealed"));
    QVERIFY(find("ownPassphrase")->text().startsWith(QStringLiteral("Change")));
}

void KeysDialogTest::passphraseIsChangedAndTakenAway()
{
    m_keyring->own.remembered = true;
    ChangePassphraseDialog *dialog = openPassphrase();
    typePassphrase(dialog, "newPassphrase", "b");
    typePassphrase(dialog, "newPassphraseAgain", "b");
    QVERIFY(!okOf(dialog)->isEnabled());
    typePassphrase(dialog, "presentPassphrase", "a");
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    QCOMPARE(m_keyring->passphrases.back().first, std::string("a"));
    QCOMPARE(m_keyring->passphrases.back().second, std::string("b"));
    QVERIFY(m_keyring->remembers); // as it was
    m_keyring->finishPassphrase({});
    EVENTUALLY(!m_dialog->findChild<ChangePassphraseDialog *>());
    dialog = openPassphrase();
    typePassphrase(dialog, "presentPassphrase", "b");
    dialog->findChild<QCheckBox *>(QStringLiteral("noPassphrase"))->setFocus();
    QTest::keyClick(dialog->findChild<QCheckBox *>(QStringLiteral("noPassphrase")), Qt::Key_Space);
    QVERIFY(!dialog->findChild<QLineEdit *>(QStringLiteral("newPassphrase"))->isEnabled());
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    QCOMPARE(m_keyring->passphrases.back().second, std::string());
    QVERIFY(!m_keyring->remembers);
    m_keyring->finishPassphrase({});
    QVERIFY(find("ownPassphrase")->text().startsWith(QStringLiteral("Set")));
}

void KeysDialogTest::passphraseRefusalIsShown()
{
    ChangePassphraseDialog *dialog = openPassphrase();
    typePassphrase(dialog, "presentPassphrase", "x");
    typePassphrase(dialog, "newPassphrase", "b");
    typePassphrase(dialog, "newPassphraseAgain", "b");
    QTest::mouseClick(okOf(dialog), Qt::LeftButton);
    m_keyring->finishPassphrase(QStringLiteral("the passphrase does not open it"));
    QVERIFY(dialog->isVisible());
    QVERIFY(
        dialog->findChild<QLabel *>(QStringLiteral("passphraseProblem"))->text().contains(QStringLiteral("does not open it")));
    QVERIFY(dialog->findChild<QLineEdit *>(QStringLiteral("presentPassphrase"))->text().isEmpty());
    QVERIFY(!okOf(dialog)->isEnabled());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QVERIFY(!dialog->isVisible());
}

void KeysDialogTest::modelKeepsItsPromises()
{
    PeerModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setPeers({peer("a", 1)});
    model.setPeers({peer("a", 2)});
    model.setPeers({peer("a", 2), peer("b", 3)});
    QCOMPARE(model.rowOf(QStringLiteral("b")), 1);
    model.setPeers({});
    QCOMPARE(model.rowOf(QStringLiteral("b")), -1);
}

SKYSEAL_TEST_WIDGETS(KeysDialogTest)
#include "keys_dialog_test.moc"
