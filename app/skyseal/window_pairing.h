// The engine's pairing behind the windows' seam: what both persons confirmed goes into the list of peers.
#pragma once

#include "app/skyseal/station_adapter.h"
#include "ui/keys/pairing_port.h"

namespace skyseal::app {

class WindowPairing : public ui::PairingPort
{
    Q_OBJECT

public:
    explicit WindowPairing(QObject *parent = nullptr) : PairingPort(parent) {}

    /// The station, which must outlive it, and the list that belongs to it.
    void use(StationAdapter &station, const std::string &peersFile);

    void open(channel::PeerRole roleAsked, const std::optional<crypto::Passphrase> &passphrase) override;
    void confirm(const channel::PublicKey &key, const QString &name, bool replaceKnownKey) override;
    void refuse() override;
    void cancel() override;

private:
    void take(const channel::PairingEvent &event);
    void keep(channel::Peer peer);

    StationAdapter *m_station = nullptr;
    std::string m_peersFile;
    std::string m_name;
    bool m_replace = false;
};

} // namespace skyseal::app
