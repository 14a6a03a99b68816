// The file of known peers, which this device talks to. Text, one peer per line, fields separated by blanks:
//
//   # name     role      system ids   public key                                                 pre-shared key (optional)
//   scout-1    pilot     1,2          skyseal:…                                                  psk=/etc/skyseal/scout-1.psk
//   tablet     observer  any          skyseal:…
//
// Comments (lines that begin with #) and empty lines are kept.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::keys {

/// One line: the peer, and the file of its pre-shared key (empty if it has none).
struct PeerEntry
{
    channel::Peer peer;
    std::string presharedKeyFile;
};

/// How a name and a key relate to the list.
enum class Acquaintance {
    Stranger,   ///< neither the name nor the key
    Known,      ///< this key, by this name
    OtherName,  ///< this key, by another name
    KeyChanged, ///< the name with another key: the owner made a new one, or it is an impersonation
};

class PeersFile
{
public:
    /// A longer list is refused: the cost of a stranger's message grows with it, and an end has no more sessions.
    static constexpr std::size_t kMostPeers = 256;

    PeersFile() = default;

    /// `source` names the text in errors, which carry line numbers. Safe for any bytes.
    static Result<PeersFile, InputError> parse(std::string_view text, const std::string &source);
    /// Fails if other users can change the file.
    static Result<PeersFile, InputError> load(const std::string &path);
    /// An empty list if the file does not exist.
    static Result<PeersFile, InputError> loadOrEmpty(const std::string &path);

    /// Replaces the file atomically. A new one is readable by the owner only.
    Result<void, InputError> save(const std::string &path) const;
    std::string text() const;

    /// In the order of the file.
    std::vector<PeerEntry> entries() const;
    std::vector<channel::Peer> peers() const;
    /// By name; null if there is none.
    const PeerEntry *find(std::string_view name) const;
    const PeerEntry *findKey(const channel::PublicKey &key) const;
    Acquaintance acquaintance(std::string_view name, const channel::PublicKey &key) const;

    /// Appends a peer. Fails if the name is invalid, or if the name or the key exists.
    Result<void, InputError> add(PeerEntry entry);
    /// Replaces the peer of that name: a new key, role or system ids.
    Result<void, InputError> replace(PeerEntry entry);
    /// Fails if the new name is invalid or in use.
    Result<void, InputError> rename(std::string_view name, const std::string &newName);
    /// False if there is no peer of that name.
    bool remove(std::string_view name);

private:
    /// A peer, or a line that is kept unchanged.
    struct Line
    {
        std::string raw;
        bool isPeer = false;
        PeerEntry entry;
    };

    Result<void, InputError> check(const PeerEntry &entry, const Line *except) const;
    Result<void, InputError> exchange(std::string_view name, PeerEntry entry);
    Line *lineOf(std::string_view name);

    std::vector<Line> m_lines;
};

/// Changes or creates a file of peers under a lock, so that two programs do not overwrite each other's changes. If `change`
/// fails, nothing is written and its error is returned.
Result<void, InputError> editPeers(const std::string &path, const std::function<Result<void, InputError>(PeersFile &)> &change);

/// Creates an empty list, readable by the owner only, unless the file exists. Returns whether it created one.
Result<bool, InputError> createMissingPeers(const std::string &path);

/// The path of an entry's pre-shared key; a relative one is resolved from the folder of the list. Empty if it has none.
std::string presharedKeyPath(const std::string &peersFile, const PeerEntry &entry);

/// The peers of a file in the channel's form, without their pre-shared keys.
Result<std::vector<channel::Peer>, InputError> loadPeers(const std::string &path);

/// "pilot" or "observer"; nullopt for anything else.
std::optional<channel::PeerRole> peerRoleFromText(std::string_view text);
std::string_view peerRoleText(channel::PeerRole role);

/// "1,2,40" (1..255 each), or "any", which gives an empty list.
Result<std::vector<std::uint8_t>, InputError> systemIdsFromText(std::string_view text);
std::string systemIdsText(const std::vector<std::uint8_t> &ids);

} // namespace skyseal::keys
