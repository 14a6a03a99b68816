#include "ui/keys/peer_dialog.h"

#include "core/keys/peer_line.h"
#include "core/keys/public_key_text.h"
#include "ui/ask_file.h"
#include "ui/keys/changed_key_warning.h"
#include "ui/keys/fingerprint_text.h"
#include "ui/keys/peer_model.h"
#include "ui/text/vehicle_text.h"
#include "ui/theme/grid.h"
#include "ui/theme/palettes.h"

#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include <algorithm>

namespace skyseal::ui {

namespace {

/// System ids as text; empty for any.
QString systemsOf(const KnownPeer &peer)
{
    return peer.systems.empty() ? QString() : fromStd(keys::systemIdsText(peer.systems));
}

} // namespace

PeerDialog::PeerDialog(KeyringInterface &keyring, QWidget *parent) : PeerDialog(keyring, nullptr, parent) {}

PeerDialog::PeerDialog(KeyringInterface &keyring, const KnownPeer &peer, QWidget *parent) : PeerDialog(keyring, &peer, parent)
{}

PeerDialog::PeerDialog(KeyringInterface &keyring, const KnownPeer *peer, QWidget *parent)
    : QDialog(parent), m_keyring(keyring), m_peers(keyring.peerList().peers)
{
    if (peer)
        m_changing = *peer;
    setObjectName(QStringLiteral("peerDialog"));
    setWindowTitle(peer ? tr("Peer %1").arg(peer->name) : tr("Add a peer"));
    m_key = new QLineEdit(this);
    m_key->setObjectName(QStringLiteral("peerKey"));
    m_key->setAccessibleName(tr("Public key"));
    m_key->setPlaceholderText(QStringLiteral("skyseal:…"));
    auto *browse = new QPushButton(tr("From a &file…"), this);
    browse->setObjectName(QStringLiteral("peerKeyFile"));
    browse->setAutoDefault(false);
    m_fingerprint = fixedWidthLabel({}, "peerFingerprint", tr("Fingerprint"), this);
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("peerName"));
    m_name->setAccessibleName(tr("Name"));
    m_systems = new QLineEdit(this);
    m_systems->setObjectName(QStringLiteral("peerSystems"));
    m_systems->setAccessibleName(tr("MAVLink system IDs"));
    m_systems->setPlaceholderText(tr("any; or e.g. 1,2"));
    m_warning = new ChangedKeyWarning(this);
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("peerProblem"));
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->setWordWrap(true);
    m_problem->setMinimumHeight(2 * kRow); // fixed, so that the dialog does not resize while typing
    m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);

    auto *form = new QFormLayout;
    form->setHorizontalSpacing(2 * kGrid);
    form->setVerticalSpacing(kGrid);
    if (!peer) {
        auto *keyRow = new QHBoxLayout;
        keyRow->setSpacing(kGrid);
        keyRow->addWidget(m_key, 1);
        keyRow->addWidget(browse);
        form->addRow(tr("&Public key"), keyRow);
        if (auto *buddy = qobject_cast<QLabel *>(form->labelForField(keyRow)))
            buddy->setBuddy(m_key);
    }
    form->addRow(tr("Fingerprint"), m_fingerprint);
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("&Systems"), m_systems);
    m_key->setVisible(!peer);
    browse->setVisible(!peer);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kGrid, 2 * kGrid, 2 * kGrid, 2 * kGrid);
    column->setSpacing(kGrid);
    column->addLayout(form);
    column->addWidget(m_warning);
    column->addWidget(m_problem);
    column->addWidget(m_buttons);

    if (peer) {
        m_name->setText(peer->name);
        m_systems->setText(systemsOf(*peer));
    } else {
        connect(m_name, &QLineEdit::textChanged, this, &PeerDialog::proposeAsKnown);
        connect(m_systems, &QLineEdit::textEdited, this, [this] { m_systemsTyped = true; });
    }
    for (const QLineEdit *edit : {m_key, m_name, m_systems})
        connect(edit, &QLineEdit::textChanged, this, &PeerDialog::check);
    connect(m_warning, &ChangedKeyWarning::acceptedChanged, this, &PeerDialog::check);
    connect(browse, &QPushButton::clicked, this, &PeerDialog::readKeyFile);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &PeerDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(78 * kGrid);
    check();
}

void PeerDialog::readKeyFile()
{
    askFile(*this, {.title = tr("Public key of a peer"), .kinds = tr("Public keys (*.pub);;All files (*)")},
            [this](const QString &file) {
                const auto text = m_keyring.readKeyText(file);
                m_key->setText(text ? *text : QString());
                if (!text)
                    m_problem->setText(reasonText(text.error().reason()));
            });
}

const KnownPeer *PeerDialog::knownByName(const QString &name) const
{
    const auto found = std::ranges::find(m_peers, name, &KnownPeer::name);
    return found == m_peers.end() ? nullptr : &*found;
}

void PeerDialog::proposeAsKnown()
{
    if (m_systemsTyped)
        return;
    const KnownPeer *known = knownByName(m_name->text().trimmed());
    m_systems->setText(known ? systemsOf(*known) : QString());
}

QString PeerDialog::problem(KnownPeer &out) const
{
    if (m_changing)
        out = *m_changing;
    out.name = m_name->text().trimmed();
    // The roles of stations are chosen at the agent; the peers of a station are agents, whose role means nothing here.
    if (const KnownPeer *known = knownByName(out.name); known && !m_changing)
        out.role = known->role;
    QString wrong;
    const auto note = [&wrong](const QString &text) {
        if (wrong.isEmpty())
            wrong = text;
    };
    if (!m_changing) {
        const auto key = keys::publicKeyFromText(m_key->text().toStdString());
        if (key)
            out.key = *key;
        else
            note(m_key->text().isEmpty() ? tr("Paste the public key that skyseal-cli keys show prints at the other end.")
                                         : reasonText(key.error().message));
    }
    keys::PeerEntry entry;
    entry.peer.name = out.name.toStdString();
    if (const auto fits = keys::checkPeerEntry(entry); !fits)
        note(out.name.isEmpty() ? tr("Enter a name.") : reasonText(fits.error().message));
    const QString systems = m_systems->text().trimmed();
    auto ids = keys::systemIdsFromText(systems.isEmpty() ? "any" : systems.toStdString());
    if (ids)
        out.systems = std::move(*ids);
    else
        note(reasonText(ids.error().message));
    return wrong;
}

void PeerDialog::check()
{
    KnownPeer peer;
    QString wrong = problem(peer);
    const bool hasKey = peer.key != channel::PublicKey{};
    m_fingerprint->setText(hasKey ? fingerprintLines(peer.key) : QStringLiteral("–\n"));
    const KnownPeer *known = knownByName(peer.name);
    const bool changed = !m_changing && hasKey && known && known->key != peer.key;
    if (changed)
        m_warning->showKeys(peer.name, known->key, peer.key);
    else
        m_warning->hide();
    if (wrong.isEmpty() && changed && !m_warning->isAccepted())
        wrong = tr("Confirm that the key is replaced, or choose another name.");
    QPalette colors = palette();
    const bool started = m_changing || !m_key->text().isEmpty();
    colors.setColor(QPalette::WindowText, started ? stateColors(palette()).alarm : stateColors(palette()).dim);
    m_problem->setPalette(colors);
    m_problem->setText(wrong);
    QPushButton *ok = m_buttons->button(QDialogButtonBox::Ok);
    ok->setEnabled(wrong.isEmpty());
    ok->setText(m_changing ? tr("Change") : changed ? tr("Replace the key") : tr("Add"));
}

void PeerDialog::accept()
{
    KnownPeer peer;
    if (!problem(peer).isEmpty())
        return;
    const KnownPeer *known = knownByName(peer.name);
    const bool replaces = !m_changing && known && known->key != peer.key;
    if (replaces && !m_warning->isAccepted())
        return;
    const auto done = m_changing ? m_keyring.changePeer(m_changing->name, peer)
        : replaces               ? m_keyring.changePeer(peer.name, peer)
                                 : m_keyring.addPeer(peer);
    if (done)
        QDialog::accept();
    else
        m_problem->setText(reasonText(done.error().reason()));
}

} // namespace skyseal::ui

#include "moc_peer_dialog.cpp"
