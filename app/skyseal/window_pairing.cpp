#include "app/skyseal/window_pairing.h"

#include "core/crypto/passphrase.h"
#include "app/common/pairing_status.h"
#include "core/engine/text/qt_text.h"
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

void WindowPairing::open(const std::optional<crypto::Passphrase> &passphrase)
{
    if (!isThere())
        return;
    m_station->station().openPairing(QSysInfo::machineHostName().toStdString(),
                                     passphrase ? std::make_shared<const crypto::Passphrase>(passphrase->clone()) : nullptr);
}

bool WindowPairing::isThere()
{
    if (m_station && m_station->isRunning())
        return true;
    Q_EMIT failed(tr("the station is not running"));
    return false;
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
    if (m_station && m_station->isRunning())
        m_station->station().cancelPairing();
}

void WindowPairing::handleEvent(const channel::PairingEvent &event)
{
    if (const auto *paired = std::get_if<channel::Paired>(&event)) {
        keep(paired->peer);
        return;
    }
    const auto known = keys::PeersFile::loadOrEmpty(m_peersFile);
    const auto status = statusOf(event, known ? *known : keys::PeersFile());
    if (!status)
        return;
    const QString reason = QString::fromStdString(status->reason);
    switch (status->state) {
    case PairingStatus::State::Seen:
        Q_EMIT seen(
            {status->key, QString::fromStdString(status->name), QString::fromStdString(status->code), status->systemId});
        return;
    case PairingStatus::State::Confirmed: Q_EMIT confirmedThere(); return;
    case PairingStatus::State::Other: Q_EMIT otherTried(); return;
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
    const auto kept = keys::keepPairedPeer(m_peersFile, peer, m_replace ? keys::KeyChange::Accepted : keys::KeyChange::Refused,
                                           keys::SharedIds::Refused);
    if (kept)
        Q_EMIT paired(QString::fromStdString(peer.name));
    else
        Q_EMIT failed(engine::reasonText(kept.error().reason()));
}

} // namespace skyseal::app

#include "moc_window_pairing.cpp"
