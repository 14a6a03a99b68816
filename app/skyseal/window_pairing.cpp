#include "app/skyseal/window_pairing.h"

#include "app/common/pairing_status.h"
#include "core/keys/paired_peer.h"
#include "core/keys/public_key_text.h"

#include <QtCore/QSysInfo>

namespace skyseal::app {

void WindowPairing::use(StationAdapter &station, const std::string &peersFile)
{
    m_peersFile = peersFile;
    if (m_station == &station)
        return;
    m_station = &station;
    connect(&station, &StationAdapter::pairing, this, &WindowPairing::handleEvent);
}

WindowPairing::~WindowPairing()
{
    if (m_deriving)
        m_deriving->wait();
}

void WindowPairing::open(channel::PeerRole roleAsked, const std::optional<crypto::Passphrase> &passphrase)
{
    forgetDerivation();
    if (!isThere())
        return;
    if (!passphrase)
        return m_station->station().openPairing(QSysInfo::machineHostName().toStdString(), roleAsked, nullptr);
    if (m_deriving)
        m_deriving->wait();
    m_deaf = true;
    m_deriving.reset(QThread::create([this, roleAsked, number = m_derivation, typed = passphrase->clone()] {
        auto key = m_derive(typed);
        QMetaObject::invokeMethod(
            this,
            [this, roleAsked, number, key = std::move(key)] {
                if (number == m_derivation)
                    openWith(roleAsked, key);
            },
            Qt::QueuedConnection);
    }));
    m_deriving->setObjectName(QStringLiteral("skyseal-pairing-key"));
    m_deriving->start();
}

void WindowPairing::openWith(channel::PeerRole roleAsked, std::shared_ptr<const Key32> key)
{
    if (!isThere())
        return;
    if (key) {
        m_deaf = false;
        m_station->station().openPairing(QSysInfo::machineHostName().toStdString(), roleAsked, std::move(key));
        return;
    }
    m_station->station().cancelPairing(); // its pending events belong to a window that is not wanted
    Q_EMIT failed(tr("this machine has not the memory to make a key of the passphrase"));
}

bool WindowPairing::isThere()
{
    if (m_station && m_station->isRunning())
        return true;
    Q_EMIT failed(tr("the station is not running"));
    return false;
}

void WindowPairing::forgetDerivation()
{
    ++m_derivation;
    m_deaf = false;
}

void WindowPairing::confirm(const channel::PublicKey &key, const QString &name, bool replaceKnownKey)
{
    m_name = name.toStdString();
    m_replace = replaceKnownKey;
    if (isThere())
        m_station->station().confirmPairing(key);
}

void WindowPairing::refuse()
{
    if (isThere())
        m_station->station().refusePairing();
}

void WindowPairing::cancel()
{
    forgetDerivation();
    if (m_station && m_station->isRunning())
        m_station->station().cancelPairing();
}

void WindowPairing::handleEvent(const channel::PairingEvent &event)
{
    if (const auto *paired = std::get_if<channel::Paired>(&event)) {
        keep(paired->peer);
        return;
    }
    if (m_deaf) // an event of the previous window, which had another passphrase or none
        return;
    const auto known = keys::PeersFile::loadOrEmpty(m_peersFile);
    const auto status = statusOf(event, known ? *known : keys::PeersFile());
    if (!status)
        return;
    const QString reason = QString::fromStdString(status->reason);
    switch (status->state) {
    case PairingStatus::State::Seen: Q_EMIT seen({status->key, QString::fromStdString(status->name)}); return;
    case PairingStatus::State::Confirmed: Q_EMIT confirmedThere(); return;
    case PairingStatus::State::Gone: Q_EMIT gone(reason); return;
    case PairingStatus::State::Other: Q_EMIT otherTried(QString::fromStdString(keys::fingerprint(status->key))); return;
    case PairingStatus::State::Differs: Q_EMIT passphraseDiffers(); return;
    case PairingStatus::State::Over:
        if (!reason.isEmpty()) // empty: both confirmed
            Q_EMIT failed(reason);
        return;
    default: return;
    }
}

void WindowPairing::keep(channel::Peer peer)
{
    peer.name = keys::fitPeerName(m_name.empty() ? peer.name : m_name, peer.key);
    peer.role = channel::PeerRole::Pilot; // an agent has no role at the station
    const auto kept = keys::keepPairedPeer(m_peersFile, peer, m_replace ? keys::KeyChange::Accepted : keys::KeyChange::Refused);
    if (kept)
        Q_EMIT paired(QString::fromStdString(peer.name));
    else
        Q_EMIT failed(QString::fromStdString(kept.error().text()));
}

} // namespace skyseal::app
