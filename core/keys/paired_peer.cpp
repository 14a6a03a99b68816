#include "core/keys/paired_peer.h"

#include "core/base/utf8.h"
#include "core/keys/file_io.h"
#include "core/keys/peer_line.h"
#include "core/keys/public_key_text.h"
#include "core/keys/secret_file.h"

#include <algorithm>

namespace skyseal::keys {

namespace {

constexpr std::size_t kLongestName = 32;

Result<void, InputError> checkSystemsAreFree(const PeersFile &file, const channel::Peer &peer)
{
    for (const PeerEntry &other : file.entries()) {
        for (const std::uint8_t id : peer.systemIds) {
            if (other.peer.key != peer.key && std::ranges::find(other.peer.systemIds, id) != other.peer.systemIds.end())
                return tl::unexpected(
                    InputError{sentence("Reason", "the system ID %1 is bound to \"%2\" already; each vehicle needs its own")(
                                   id, other.peer.name),
                               {}});
        }
    }
    return {};
}

/// Without blanks, as required for the path of a pre-shared key. Each key gets a different file.
std::string presharedKeyName(const channel::Peer &peer)
{
    const std::string print = fingerprint(peer.key);
    return peer.name + "-" + print.substr(0, 4) + print.substr(5, 4) + ".psk";
}

} // namespace

std::string fitPeerName(std::string_view claimed, const channel::PublicKey &key)
{
    std::string name;
    while (!claimed.empty()) {
        const std::string_view character = claimed.substr(0, firstCharacter(claimed).length);
        claimed.remove_prefix(character.size());
        // After the first character, also a hyphen fits.
        if (checkPeerName((name.empty() ? "" : "x") + std::string(character)))
            name += character;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    if (name.size() > kLongestName) {
        name.resize(kLongestName);
        // Do not split a UTF-8 character.
        while (!name.empty() && (static_cast<unsigned char>(name.back()) & 0xC0) == 0x80)
            name.pop_back();
        if (!name.empty() && static_cast<unsigned char>(name.back()) >= 0xC0)
            name.pop_back();
    }
    while (name.ends_with('-'))
        name.pop_back();
    return checkPeerName(name) ? name : "peer-" + fingerprint(key).substr(0, 4);
}

Result<void, InputError> keepPairedPeer(const std::string &peersFile, const channel::Peer &peer, KeyChange change,
                                        SharedIds ids)
{
    return editPeers(peersFile, [&](PeersFile &file) -> Result<void, InputError> {
        const PeerEntry *known = file.findKey(peer.key);
        if (!known)
            known = file.find(peer.name);
        if (known && known->peer.key != peer.key && change != KeyChange::Accepted)
            return tl::unexpected(InputError{sentence("Reason", "the peer \"%1\" is known with another key")(peer.name), {}});
        PeerEntry entry;
        entry.peer = peer;
        if (known) {
            entry.peer.name = known->peer.name;
            entry.peer.systemIds = known->peer.systemIds;
        } else if (ids == SharedIds::Refused) {
            if (auto free = checkSystemsAreFree(file, peer); !free)
                return free;
        }
        if (peer.presharedKey) {
            entry.presharedKeyFile = presharedKeyName(entry.peer);
            if (auto written = writePresharedKey(presharedKeyPath(peersFile, entry), *peer.presharedKey); !written)
                return written;
        }
        return known ? file.replace(std::move(entry)) : file.add(std::move(entry));
    });
}

} // namespace skyseal::keys
