#include "core/keys/usable_peers.h"

#include "core/base/locked_memory.h"
#include "core/base/secret_bytes.h"
#include "core/keys/peers_file.h"
#include "core/keys/secret_file.h"

#include <utility>

namespace skyseal::keys {

PeersInForce UsablePeers::inForce() const
{
    PeersInForce out{peers.size(), {}};
    for (const InputError &error : unusable)
        out.leftOut = out.leftOut.empty() ? error.reason() : sentence("Reason", "%1; %2")(out.leftOut, error.reason());
    return out;
}

Result<UsablePeers, InputError> readPeers(const std::string &peersFile)
{
    if (peersFile.empty())
        return UsablePeers{};
    const auto file = PeersFile::load(peersFile);
    if (!file)
        return tl::unexpected(file.error());
    UsablePeers out;
    for (const PeerEntry &entry : file->entries()) {
        channel::Peer peer = entry.peer;
        if (!entry.presharedKeyFile.empty()) {
            auto key = loadPresharedKey(presharedKeyPath(peersFile, entry));
            if (!key) {
                out.unusable.push_back(std::move(key.error()));
                Reason &message = out.unusable.back().message;
                message = sentence("Reason", "%1 (pre-shared key of \"%2\")")(message, peer.name);
                continue;
            }
            peer.presharedKey = shareInLockedMemory(std::move(*key));
        }
        out.peers.push_back(std::move(peer));
    }
    return out;
}

} // namespace skyseal::keys
