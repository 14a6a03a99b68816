// A pairing without an engine: remembers what the dialog asked and says what a test (or the gallery) wants.
#pragma once

#include "ui/keys/pairing_port.h"

#include <vector>

namespace skyseal::ui {

class FakePairing : public PairingPort
{
    Q_OBJECT

public:
    struct Confirmation
    {
        channel::PublicKey key{};
        QString name;
        bool replace = false;
    };

    using PairingPort::PairingPort;

    void open(channel::PeerRole roleAsked) override { opened.push_back(roleAsked); }
    void confirm(const channel::PublicKey &key, const QString &name, bool replace) override
    {
        confirmations.push_back({key, name, replace});
    }
    void refuse() override { ++refusals; }
    void cancel() override { ++cancels; }

    std::vector<channel::PeerRole> opened;
    std::vector<Confirmation> confirmations;
    int refusals = 0, cancels = 0;
};

} // namespace skyseal::ui
