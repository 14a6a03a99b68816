#include "core/keys/paired_ends.h"

#include "core/keys/peers_file.h"
#include "core/keys/secret_file.h"

#include <utility>

namespace skyseal::keys {

namespace {

Result<void, InputError> writePeer(const std::string &peersFile, const std::string &name, const crypto::PublicKey &peer)
{
    PeersFile peers;
    PeerEntry entry;
    entry.peer.name = name;
    entry.peer.key = peer;
    if (auto added = peers.add(std::move(entry)); !added)
        return added;
    return peers.save(peersFile);
}

} // namespace

Result<void, InputError> writePairedEnds(const std::string &folder, const std::string &agent, RandomSource &random)
{
    const auto station = writeNewIdentity(folder + "/station.key", random);
    if (!station)
        return tl::unexpected(station.error());
    const auto air = writeNewIdentity(folder + "/air.key", random);
    if (!air)
        return tl::unexpected(air.error());
    if (auto written = writePeer(folder + "/station.peers", agent, *air); !written)
        return written;
    return writePeer(folder + "/air.peers", "station", *station);
}

} // namespace skyseal::keys
