// The file of known peers: whom this device talks to. Text, one peer a line, fields apart by blanks:
//
//   # name     role      system ids   public key                                                 pre-shared key (optional)
//   scout-1    pilot     1,2          skyseal:…                                                  psk=/etc/skyseal/scout-1.psk
//   tablet     observer  any          skyseal:…
//
// Lines that begin with # and empty lines are kept as they are.
#pragma once

#include "core/base/result.h"
#include "core/channel/policy.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace skyseal::keys {

/// One line: the peer as the channel knows it, and where its pre-shared key lies; empty when it has none.
struct PeerEntry
{
    channel::Peer peer;
    std::string presharedKeyFile;
};

/// What is known of a name and a key that somebody brings.
enum class Acquaintance {
    Stranger,   ///< neither the name nor the key
    Known,      ///< this key, by this name
    OtherName,  ///< this key, by another name
    KeyChanged, ///< the name, with another key: its owner made a new one, or somebody else pretends to be it
};

class PeersFile
{
public:
    PeersFile() = default;

    /// `source` names the text in errors, which carry line numbers. Safe for any bytes.
    static Result<PeersFile, InputError> parse(std::string_view text, const std::string &source);
    /// Refused when others can change the file.
    static Result<PeersFile, InputError> load(const std::string &path);
    /// An empty list where there is no such file yet.
    static Result<PeersFile, InputError> loadOrEmpty(const std::string &path);

    /// Replaces the file as a whole. A new one is readable by the owner alone.
    Result<void, InputError> save(const std::string &path) const;
    std::string text() const;

    /// In the order of the file.
    std::vector<PeerEntry> entries() const;
    std::vector<channel::Peer> peers() const;
    /// By name; null when there is none.
    const PeerEntry *find(std::string_view name) const;
    const PeerEntry *findKey(const channel::PublicKey &key) const;
    Acquaintance acquaintance(std::string_view name, const channel::PublicKey &key) const;

    /// Appends a peer. Refused when the name is unfit, or name or key are there already.
    Result<void, InputError> add(PeerEntry entry);
    /// Replaces the peer of that name, knowingly: a new key, role or system ids.
    Result<void, InputError> replace(PeerEntry entry);
    /// The new name must be fit and free.
    Result<void, InputError> rename(std::string_view name, const std::string &newName);
    /// False when there is no peer of that name.
    bool remove(std::string_view name);

private:
    /// A peer, or a line that is kept as it is.
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

/// Changes a file of peers, or begins one, under a lock: two programs that change it at once do not undo each other. When
/// `change` gives an error nothing is written and that is the result.
Result<void, InputError> editPeers(const std::string &path, const std::function<Result<void, InputError>(PeersFile &)> &change);

/// Where the pre-shared key of an entry lies: a relative path begins at the folder of the list. Empty when it has none.
std::string presharedKeyPath(const std::string &peersFile, const PeerEntry &entry);

/// The peers of a file, as the channel wants them, but without their pre-shared keys.
Result<std::vector<channel::Peer>, InputError> loadPeers(const std::string &path);

/// What became of a list that changed while a program runs.
struct PeersInForce
{
    std::size_t count = 0;
    std::string leftOut; ///< in words: whose pre-shared key cannot be used, and why; empty when nobody is left out
};

/// "pilot" or "observer"; nullopt for anything else.
std::optional<channel::PeerRole> peerRoleFromText(std::string_view text);
std::string_view peerRoleText(channel::PeerRole role);

/// "1,2,40" (1..255 each) or "any", which gives none.
Result<std::vector<std::uint8_t>, InputError> systemIdsFromText(std::string_view text);
std::string systemIdsText(const std::vector<std::uint8_t> &ids);

} // namespace skyseal::keys
