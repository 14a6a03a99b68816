#include "ui/keys/pairing_dialog.h"

#include "core/channel/pairing.h"
#include "core/keys/peer_line.h"
#include "ui/keys/changed_key_warning.h"
#include "ui/keys/fingerprint_text.h"
#include "ui/keys/passphrase_field.h"
#include "ui/text/state_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr auto kWindowSeconds = std::chrono::duration_cast<std::chrono::seconds>(channel::kPairingWindow).count();

} // namespace

PairingDialog::PairingDialog(PairingInterface &pairing, const KeyringInterface &keyring, QWidget *parent)
    : QDialog(parent), m_pairing(pairing), m_keyring(keyring)
{
    setObjectName(QStringLiteral("pairingDialog"));
    setWindowTitle(tr("Pair with an agent"));
    const auto label = [this](const char *name) {
        auto *out = new QLabel(this);
        out->setObjectName(QLatin1String(name));
        out->setTextFormat(Qt::PlainText);
        out->setWordWrap(true);
        return out;
    };
    m_text = label("pairingText");
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_time = label("pairingTime");
    m_time->setForegroundRole(QPalette::PlaceholderText);
    m_problem = label("pairingProblem");
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, stateColors(palette()).alarm);
    m_problem->setPalette(colors);
    auto *ours = fixedWidthLabel(fingerprintLines(keyring.ownKey().publicKey.value_or(channel::PublicKey{})), "pairingOwn",
                                 tr("Fingerprint of this station"), this);
    m_theirs = fixedWidthLabel({}, "pairingTheirs", tr("Fingerprint of the agent"), this);
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("pairingName"));
    m_name->setAccessibleName(tr("Name"));
    m_role = new QComboBox(this);
    m_role->setObjectName(QStringLiteral("pairingRole"));
    m_role->setAccessibleName(tr("Role that this station requests"));
    m_role->addItem(tr("pilot: may send commands"), static_cast<int>(channel::PeerRole::Pilot));
    m_role->addItem(tr("observer: receives telemetry only"), static_cast<int>(channel::PeerRole::Observer));
    m_passphrase = new PassphraseField("pairingPassphrase", tr("Passphrase of this pairing"), this);
    m_passphrase->setPlaceholderText(tr("none; or the same as at the agent"));
    m_passphrase->setToolTip(tr("Only an agent with the same passphrase is shown: skyseal-air --pair --pair-passphrase.\nIt is "
                                "valid for this pairing only. The fingerprints must be compared nevertheless."));
    m_warning = new ChangedKeyWarning(this);
    m_form = new QFormLayout;
    m_form->setHorizontalSpacing(2 * kGrid);
    m_form->setVerticalSpacing(kGrid);
    m_form->addRow(tr("This station"), ours);
    m_form->addRow(tr("The agent"), m_theirs);
    m_form->addRow(tr("&Name"), m_name);
    m_form->addRow(tr("Re&quest role"), m_role);
    m_form->addRow(tr("&Passphrase"), m_passphrase);
    auto *buttons = new QDialogButtonBox(this);
    m_agree = buttons->addButton(tr("&Both are the same"), QDialogButtonBox::ActionRole);
    m_agree->setObjectName(QStringLiteral("pairingAgree"));
    m_differ = buttons->addButton(tr("They &differ"), QDialogButtonBox::ActionRole);
    m_differ->setObjectName(QStringLiteral("pairingDiffer"));
    m_again = buttons->addButton(tr("Try a&gain"), QDialogButtonBox::ActionRole);
    m_again->setObjectName(QStringLiteral("pairingAgain"));
    m_close = buttons->addButton(QDialogButtonBox::Cancel);
    for (QPushButton *button : {m_agree, m_differ, m_again, m_close})
        button->setAutoDefault(false); // a stray Return must neither confirm nor close
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(m_text);
    column->addLayout(m_form);
    column->addWidget(m_warning);
    column->addWidget(m_problem);
    column->addStretch(1);
    column->addWidget(m_time);
    column->addWidget(buttons);

    connect(&pairing, &PairingInterface::seen, this, &PairingDialog::showQuestion);
    connect(&pairing, &PairingInterface::confirmedThere, this, [this] {
        if (m_step == Step::Comparing)
            m_text->setText(tr("The agent's side has confirmed. Compare both fingerprints with those that the agent shows."));
    });
    connect(&pairing, &PairingInterface::gone, this, [this](const QString &reason) {
        m_question.reset();
        showStep(Step::Waiting, tr("The agent is gone: %1. Waiting for the agent …").arg(reason));
    });
    connect(&pairing, &PairingInterface::otherTried, this, [this](const QString &fingerprint) {
        m_problem->setText(tr("Another device tried to pair at the same time, fingerprint %1").arg(fingerprint));
    });
    connect(&pairing, &PairingInterface::paired, this, [this](const QString &name) {
        showStep(Step::Paired, tr("Paired with %1. The link is sealed as soon as both ends are connected.").arg(name));
    });
    connect(&pairing, &PairingInterface::failed, this,
            [this](const QString &reason) { showStep(Step::Failed, tr("Not paired: %1.").arg(reason)); });
    connect(&pairing, &PairingInterface::passphraseDiffers, this, [this] {
        if (m_step == Step::Waiting)
            m_problem->setText(tr("An agent answers, but the passphrases differ, or only one end has one. Enter the same "
                                  "passphrase at both ends."));
    });
    connect(m_passphrase, &QLineEdit::textEdited, this, [this] { m_passphraseTyped = true; });
    connect(m_passphrase, &QLineEdit::editingFinished, this, &PairingDialog::applyPassphrase);
    connect(m_agree, &QPushButton::clicked, this, &PairingDialog::agree);
    connect(m_differ, &QPushButton::clicked, this, [this] {
        m_question.reset();
        m_pairing.refuse();
        showStep(Step::Waiting,
                 tr("Refused. If you compared the right fingerprints, this may be an attack on the link (man in the "
                    "middle). Waiting for the agent …"));
    });
    connect(m_again, &QPushButton::clicked, this, &PairingDialog::begin);
    connect(m_name, &QLineEdit::textChanged, this, &PairingDialog::check);
    connect(m_warning, &ChangedKeyWarning::acceptedChanged, this, &PairingDialog::check);
    connect(m_role, &QComboBox::activated, this, &PairingDialog::begin);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_tick.setInterval(1000);
    connect(&m_tick, &QTimer::timeout, this, &PairingDialog::showTime);
    setMinimumWidth(72 * kGrid);
    begin();
}

PairingDialog::~PairingDialog()
{
    if (m_step != Step::Paired && m_step != Step::Failed)
        m_pairing.cancel();
}

void PairingDialog::begin()
{
    m_question.reset();
    m_passphraseTyped = false;
    m_clock.start();
    m_tick.start();
    showStep(Step::Waiting,
             tr("Start pairing at the agent, while the vehicle is disarmed:\n\n    skyseal-air --pair "
                "--identity FILE\n\nWaiting for the agent …"));
    m_pairing.open(static_cast<channel::PeerRole>(m_role->currentData().toInt()), m_passphrase->passphrase());
}

void PairingDialog::applyPassphrase()
{
    if (m_step == Step::Waiting && m_passphraseTyped)
        begin();
}

void PairingDialog::showStep(Step step, const QString &text)
{
    m_step = step;
    m_text->setText(text);
    const bool comparing = step == Step::Comparing;
    const bool hasPeer = comparing || step == Step::Confirmed;
    for (QWidget *widget :
         std::initializer_list<QWidget *>{m_theirs, m_form->labelForField(m_theirs), m_name, m_form->labelForField(m_name)})
        widget->setVisible(hasPeer);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_role, m_form->labelForField(m_role), m_passphrase,
                                                            m_form->labelForField(m_passphrase)})
        widget->setVisible(step == Step::Waiting || step == Step::Failed);
    m_name->setEnabled(comparing);
    m_agree->setVisible(comparing);
    m_differ->setVisible(comparing);
    m_again->setVisible(step == Step::Failed);
    if (!comparing)
        m_warning->hide();
    m_problem->clear();
    const bool over = step == Step::Paired || step == Step::Failed;
    m_close->setText(over ? tr("Close") : tr("Cancel"));
    if (over) {
        m_tick.stop();
        resize(width(), sizeHint().height());
    }
    showTime();
    check();
}

void PairingDialog::showQuestion(const PairingQuestion &question)
{
    if (m_passphraseTyped && m_step == Step::Waiting) { // the agent was found with the previous passphrase
        begin();
        return;
    }
    m_question = question;
    m_theirs->setText(fingerprintLines(question.key));
    m_name->setText(question.name);
    showStep(Step::Comparing, tr("An agent answers. Compare both fingerprints, every group, with those that the agent shows."));
    m_differ->setFocus();
}

void PairingDialog::showTime()
{
    const qint64 left = std::max<qint64>(0, kWindowSeconds - m_clock.elapsed() / 1000);
    const bool counts = m_step != Step::Paired && m_step != Step::Failed;
    m_time->setText(counts ? tr("%1 s left").arg(left) : QString());
}

void PairingDialog::check()
{
    if (m_step != Step::Comparing || !m_question)
        return;
    const PeerList list = m_keyring.peerList();
    const bool known = std::ranges::any_of(list.peers, [&](const KnownPeer &peer) { return peer.key == m_question->key; });
    const auto same = std::ranges::find(list.peers, m_name->text(), &KnownPeer::name);
    if (!known && same != list.peers.end())
        m_warning->showKeys(same->name, same->key, m_question->key);
    else
        m_warning->hide();
    keys::PeerEntry entry;
    entry.peer.name = m_name->text().toStdString();
    const auto fits = keys::checkPeerEntry(entry);
    m_problem->setText(fits ? QString() : fromStd(fits.error().message));
    m_agree->setEnabled(fits && (m_warning->isHidden() || m_warning->isAccepted()));
}

void PairingDialog::agree()
{
    if (!m_question)
        return;
    const bool replaces = !m_warning->isHidden();
    m_pairing.confirm(m_question->key, m_name->text(), replaces);
    showStep(Step::Confirmed, tr("Confirmed here. The pairing must now be confirmed at the agent as well."));
}

} // namespace skyseal::ui
