#include "ui/keys/pairing_dialog.h"

#include "core/crypto/passphrase.h"
#include "core/channel/pairing.h"
#include "core/engine/text/pairing_text.h"
#include "core/keys/peer_line.h"
#include "ui/keys/changed_key_warning.h"
#include "ui/keys/passphrase_field.h"
#include "ui/keys/pairing_question_form.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtCore/QEvent>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>

#include <algorithm>

namespace skyseal::ui {

namespace {

constexpr auto kWindowSeconds = std::chrono::duration_cast<std::chrono::seconds>(channel::kPairingWindow).count();
/// After this pause the passphrase counts as typed. Not shorter: an agent ends the pairing after three wrong passphrases.
constexpr std::chrono::seconds kTypingPause{3};

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
    m_agent = new PairingQuestionForm(keyring.ownKey().publicKey.value_or(channel::PublicKey{}), this);
    m_passphrase = new PassphraseField("pairingPassphrase", tr("Passphrase of this pairing"), this);
    m_passphrase->setPlaceholderText(tr("none; or the same as at the agent"));
    m_passphrase->setToolTip(tr("Only an agent with the same passphrase is shown: skyseal-air --pair --pair-passphrase.\nThen "
                                "there is no code to compare. It is valid for this pairing only."));
    m_warning = new ChangedKeyWarning(this);
    m_passphraseRow = new QWidget(this);
    auto *row = new QFormLayout(m_passphraseRow);
    row->setContentsMargins(0, 0, 0, 0);
    row->setHorizontalSpacing(2 * kGrid);
    row->addRow(tr("&Passphrase"), m_passphrase);
    auto *buttons = new QDialogButtonBox(this);
    m_fingerprints = buttons->addButton(tr("&Fingerprints"), QDialogButtonBox::ResetRole);
    m_fingerprints->setObjectName(QStringLiteral("pairingFingerprints"));
    m_fingerprints->setCheckable(true);
    m_fingerprints->setToolTip(tr("The complete fingerprints of both keys. They need not be compared: the code covers them."));
    m_agree = buttons->addButton(QString(), QDialogButtonBox::ActionRole);
    m_agree->setObjectName(QStringLiteral("pairingAgree"));
    m_differ = buttons->addButton(QString(), QDialogButtonBox::ActionRole);
    m_differ->setObjectName(QStringLiteral("pairingDiffer"));
    m_again = buttons->addButton(tr("Try a&gain"), QDialogButtonBox::ActionRole);
    m_again->setObjectName(QStringLiteral("pairingAgain"));
    m_close = buttons->addButton(QDialogButtonBox::Cancel);
    for (QPushButton *button : {m_fingerprints, m_agree, m_differ, m_again, m_close})
        button->setAutoDefault(false); // a stray Return must neither confirm nor close
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addWidget(m_text);
    column->addWidget(m_agent);
    column->addWidget(m_passphraseRow);
    column->addWidget(m_warning);
    column->addWidget(m_problem);
    column->addStretch(1);
    column->addWidget(m_time);
    column->addWidget(buttons);

    connect(&pairing, &PairingInterface::seen, this, &PairingDialog::showQuestion);
    connect(&pairing, &PairingInterface::confirmedThere, this, [this] {
        if (m_step == Step::Comparing)
            m_text->setText(m_hasPassphrase ? tr("The agent's side has confirmed. Confirm here as well.")
                                            : tr("The agent's side has confirmed. Does the agent show this code?"));
    });
    connect(&pairing, &PairingInterface::otherTried, this, [this] {
        m_problem->setText(engine::otherDeviceTriedText());
        grow();
    });
    connect(&pairing, &PairingInterface::paired, this, [this](const QString &name) {
        showStep(Step::Paired, tr("%1. The link is sealed as soon as both ends are connected.").arg(engine::pairedText(name)));
    });
    connect(&pairing, &PairingInterface::failed, this, [this](const QString &reason) {
        if (m_step != Step::Failed) // refuse() has shown more
            showStep(Step::Failed, engine::notPairedText(reason) + QLatin1Char('.'));
    });
    connect(&pairing, &PairingInterface::passphraseDiffers, this, [this] {
        if (m_step == Step::Waiting && !m_passphraseTyped)
            m_problem->setText(engine::passphraseDiffersText() + QLatin1Char('.'));
        grow();
    });
    m_typing.setSingleShot(true);
    m_typing.setInterval(kTypingPause);
    connect(&m_typing, &QTimer::timeout, this, &PairingDialog::applyPassphrase);
    connect(m_passphrase, &QLineEdit::textEdited, this, [this] {
        m_passphraseTyped = true;
        m_typing.start();
    });
    connect(m_passphrase, &QLineEdit::editingFinished, this, &PairingDialog::applyPassphrase);
    connect(m_agree, &QPushButton::clicked, this, &PairingDialog::agree);
    connect(m_differ, &QPushButton::clicked, this, &PairingDialog::refuse);
    connect(m_fingerprints, &QPushButton::toggled, this, &PairingDialog::showFingerprints);
    connect(m_again, &QPushButton::clicked, this, &PairingDialog::begin);
    connect(m_agent, &PairingQuestionForm::nameChanged, this, &PairingDialog::check);
    connect(m_warning, &ChangedKeyWarning::acceptedChanged, this, &PairingDialog::check);
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
    m_typing.stop();
    m_clock.start();
    m_tick.start();
    showStep(Step::Waiting,
             tr("Start pairing at the agent, while the vehicle is disarmed:\n\n    skyseal-air --pair "
                "--identity FILE\n\nWaiting for the agent…"));
    const auto passphrase = m_passphrase->passphrase();
    m_hasPassphrase = passphrase.has_value();
    m_pairing.open(passphrase);
}

/// The operator goes on at the agent, in another window.
void PairingDialog::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::ActivationChange && isVisible() && !isActiveWindow())
        applyPassphrase();
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
    m_agent->setVisible(hasPeer);
    m_agent->setNameEnabled(comparing);
    m_passphraseRow->setVisible(step == Step::Waiting || step == Step::Failed);
    m_fingerprints->setVisible(hasPeer);
    if (!hasPeer)
        m_fingerprints->setChecked(false);
    showFingerprints();
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
    m_agent->showQuestion(question, !m_hasPassphrase);
    m_agree->setText(m_hasPassphrase ? tr("&Confirm") : tr("The codes are the &same"));
    m_differ->setText(m_hasPassphrase ? tr("&Refuse") : tr("They &differ"));
    showStep(Step::Comparing,
             m_hasPassphrase ? tr("An agent that knows the passphrase has answered. Is it the right one?")
                             : tr("An agent has answered. Does it show this code?"));
    m_differ->setFocus();
}

void PairingDialog::showFingerprints()
{
    const bool visible = m_fingerprints->isChecked();
    m_agent->showFingerprints(visible);
    if (visible)
        grow();
}

/// A layout with wrapped texts does not enlarge the window by itself.
void PairingDialog::grow()
{
    layout()->activate();
    resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

void PairingDialog::refuse()
{
    m_question.reset();
    m_pairing.refuse();
    showStep(Step::Failed,
             m_hasPassphrase ? engine::notPairedText(engine::pairingEndText(channel::PairingEnd::Refused)) + QLatin1Char('.')
                             : engine::notPairedText(tr("the codes differ. If both were codes of this pairing, an attacker is "
                                                        "between this station and the agent (man in the middle).")));
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
    const auto same = std::ranges::find(list.peers, m_agent->name(), &KnownPeer::name);
    if (!known && same != list.peers.end())
        m_warning->showKeys(same->name, same->key, m_question->key);
    else
        m_warning->hide();
    keys::PeerEntry entry;
    entry.peer.name = m_agent->name().toStdString();
    const auto fits = keys::checkPeerEntry(entry);
    m_problem->setText(fits ? QString() : reasonText(fits.error().message));
    m_agree->setEnabled(fits && (m_warning->isHidden() || m_warning->isAccepted()));
}

void PairingDialog::agree()
{
    if (!m_question)
        return;
    const bool replaces = !m_warning->isHidden();
    m_pairing.confirm(m_question->key, m_agent->name(), replaces);
    showStep(Step::Confirmed, tr("Confirmed here. The pairing must now be confirmed at the agent as well."));
}

} // namespace skyseal::ui

#include "moc_pairing_dialog.cpp"
