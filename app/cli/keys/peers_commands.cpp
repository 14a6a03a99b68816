// The subcommands for known peers. Programs that run with the same file apply each change at once.
#include "app/cli/keys/keys_subcommand.h"
#include "app/cli/keys/keys_subcommands.h"
#include "app/cli/keys/named_input.h"
#include "core/base/json_writer.h"
#include "core/keys/file_io.h"
#include "core/keys/peer_line.h"
#include "core/keys/peers_file.h"
#include "core/keys/public_key_text.h"

#include <QtCore/QFileInfo>

namespace skyseal::app {

using keys::PeerEntry;
using keys::PeersFile;

namespace {

InputError noSuchPeer(const std::string &name)
{
    return {"there is no peer named \"" + name + "\"", {}};
}

/// Changes the peers file. A damaged or unwritable file and a refused change give different exit statuses.
int edit(const KeysSubcommand &command, const std::string &file,
         const std::function<Result<void, InputError>(PeersFile &)> &change)
{
    bool refused = false;
    const auto edited = keys::editPeers(file, [&](PeersFile &peers) {
        auto changed = change(peers);
        refused = !changed;
        return changed;
    });
    if (edited)
        return kDone;
    return refused ? command.refuse(edited.error().text()) : command.cannotOpen(edited.error());
}

/// Changes the entry of one peer, except its name.
int editEntry(const KeysSubcommand &command, const std::string &file, const std::string &name,
              const std::function<void(PeerEntry &)> &change)
{
    return edit(command, file, [&](PeersFile &peers) -> Result<void, InputError> {
        const PeerEntry *known = peers.find(name);
        if (!known)
            return tl::unexpected(noSuchPeer(name));
        PeerEntry entry = *known;
        change(entry);
        return peers.replace(std::move(entry));
    });
}

std::optional<channel::PeerRole> readRole(Options &options, const std::string &text)
{
    const auto role = keys::peerRoleFromText(text);
    if (!role)
        options.fail("'" + text + "' is not a role: pilot or observer is expected");
    return role;
}

std::string readName(Options &options, std::string text)
{
    if (const auto fits = keys::checkPeerName(text); !fits)
        options.fail(fits.error().message.text());
    return text;
}

std::optional<std::vector<std::uint8_t>> readSystems(Options &options, const std::string &text)
{
    auto ids = keys::systemIdsFromText(text);
    if (ids)
        return std::move(*ids);
    options.fail(ids.error().message.text());
    return std::nullopt;
}

/// Texts of a subcommand that changes one property of a peer.
struct PeerChange
{
    const char *subcommand, *help;
    const char *argument, *whatItIs; ///< the argument after the peer's name
};

/// `read` parses the argument, or records a problem and returns nothing; `put` writes the value into the entry.
template<typename Read, typename Put> int changePeer(const QStringList &arguments, const PeerChange &change, Read read, Put put)
{
    KeysSubcommand command(change.subcommand, change.help);
    command.addArgument("NAME", "The peer's name.");
    command.addArgument(change.argument, change.whatItIs);
    command.addPeersOption();
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string file = command.options.required("peers");
    const auto value = read(command.options, command.argument(1));
    if (const auto status = command.options.finish())
        return *status;
    return editEntry(command, file, command.argument(0), [&](PeerEntry &entry) { put(entry, *value); });
}

/// The key from the argument or the file, or why the file cannot be read.
Result<keys::PublicKey, InputError> readPublicKey(Options &options)
{
    const QStringList given = options.arguments(0, 1);
    if (given.isEmpty() == !options.has("from")) {
        options.fail("a public key is expected, or --from FILE");
        return keys::PublicKey{};
    }
    std::string text = given.value(0).toStdString();
    if (given.isEmpty()) {
        const auto content = readNamed(options.text("from"));
        if (!content)
            return tl::unexpected(content.error());
        text = asText(*content);
    }
    const auto key = keys::publicKeyFromText(text);
    if (!key)
        options.fail((given.isEmpty() ? options.text("from") + ": " : std::string()) + key.error().message.text());
    return key.value_or(keys::PublicKey{});
}

/// As in ssh: the owner may have a new key, or this is an attack.
InputError changedKey(const PeerEntry &known, const keys::PublicKey &offered)
{
    return {"THE KEY OF '" + known.peer.name
                + "' HAS CHANGED, refused. Either the device has a new key, or this is an impersonation.\n"
                  "  known key       "
                + keys::fingerprint(known.peer.key)
                + "\n"
                  "  offered         "
                + keys::fingerprint(offered)
                + "\n"
                  "Compare the second one at the device itself. If it matches, use --replace",
            {}};
}

} // namespace

int addPeer(const QStringList &arguments)
{
    KeysSubcommand command("peers add", "Adds a peer whose fingerprint you have compared.");
    Options &options = command.options;
    options.addArgument("PUBLIC", "The peer's public key, as printed by keys show or keys export.");
    options.addValue("from", "FILE", "File of the public key, in place of PUBLIC; - for standard input.");
    command.addPeersOption();
    options.addValue("name", "NAME", "Name of the peer.");
    options.addValue("role", "pilot|observer", "Role of the peer: may command, or only observe.", "pilot");
    options.addValue("sysids", "LIST", "MAVLink system IDs that it may use, e.g. 1,2.", "any");
    options.addValue("psk", "FILE", "Pre-shared key (keys psk); both ends need the same.");
    options.addFlag("replace",
                    "Replace the key of a known peer that has changed. Its other settings are kept unless "
                    "given.");
    if (const auto status = options.parse(arguments))
        return *status;
    const std::string file = options.required("peers");
    PeerEntry entry;
    entry.peer.name = readName(options, options.required("name"));
    entry.peer.role = readRole(options, options.text("role")).value_or(channel::PeerRole::Observer);
    entry.peer.systemIds = readSystems(options, options.text("sysids")).value_or(std::vector<std::uint8_t>{});
    if (options.has("psk")) // other programs may run in another folder
        entry.presharedKeyFile = QFileInfo(QString::fromStdString(options.text("psk"))).absoluteFilePath().toStdString();
    const auto given = readPublicKey(options);
    if (const auto status = options.finish())
        return *status;
    if (!given)
        return command.cannotOpen(given.error());

    const keys::PublicKey key = entry.peer.key = *given;
    const int status = edit(command, file, [&](PeersFile &peers) -> Result<void, InputError> {
        const PeerEntry *known = peers.find(entry.peer.name);
        if (known && peers.acquaintance(entry.peer.name, key) == keys::Acquaintance::KeyChanged && !options.has("replace"))
            return tl::unexpected(changedKey(*known, key));
        if (!options.has("replace"))
            return peers.add(entry);
        if (!known)
            return tl::unexpected(noSuchPeer(entry.peer.name));
        if (!options.has("role"))
            entry.peer.role = known->peer.role;
        if (!options.has("sysids"))
            entry.peer.systemIds = known->peer.systemIds;
        if (!options.has("psk"))
            entry.presharedKeyFile = known->presharedKeyFile;
        return peers.replace(entry);
    });
    if (status == kDone)
        printLine("fingerprint " + keys::fingerprint(key));
    return status;
}

int listPeers(const QStringList &arguments)
{
    KeysSubcommand command("peers list", "Lists the known peers.");
    command.options.addValue("peers", "FILE", "File of known peers.");
    command.addJsonOption();
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string file = command.options.required("peers");
    if (const auto status = command.options.finish())
        return *status;
    const auto peers = PeersFile::load(file);
    if (!peers)
        return command.cannotOpen(peers.error());
    for (const PeerEntry &entry : peers->entries()) {
        const channel::Peer &peer = entry.peer;
        const std::string role(keys::peerRoleText(peer.role));
        const std::string systems = keys::systemIdsText(peer.systemIds);
        if (!command.options.has("json")) {
            std::string line = peer.name;
            line.append("  ").append(role).append("  ").append(systems).append("  ").append(keys::fingerprint(peer.key));
            printLine(entry.presharedKeyFile.empty() ? line : line.append("  psk"));
            continue;
        }
        JsonWriter line;
        line.beginObject().field("event", "peer").field("name", peer.name).field("role", role).field("sysids", systems);
        line.field("public", keys::publicKeyText(peer.key)).field("fingerprint", keys::fingerprint(peer.key));
        line.field("psk", !entry.presharedKeyFile.empty()).endObject();
        printLine(line.text());
    }
    return kDone;
}

int removePeer(const QStringList &arguments)
{
    KeysSubcommand command("peers revoke", "Removes a peer: its session ends at once, and it can no longer connect.");
    command.addArgument("NAME", "The peer's name.");
    command.addPeersOption();
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string file = command.options.required("peers");
    if (const auto status = command.options.finish())
        return *status;
    if (!keys::fileExists(file))
        return command.cannotOpen({"does not exist", file});
    return edit(command, file, [&](PeersFile &peers) -> Result<void, InputError> {
        if (!peers.remove(command.argument(0)))
            return tl::unexpected(noSuchPeer(command.argument(0)));
        return {};
    });
}

int renamePeer(const QStringList &arguments)
{
    KeysSubcommand command("peers rename", "Gives a peer another name.");
    command.addArgument("NAME", "The peer's name.");
    command.addArgument("NEW-NAME", "1 to 32 letters, digits, \"-\", \"_\" or \".\".");
    command.addPeersOption();
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string file = command.options.required("peers");
    const std::string name = readName(command.options, command.argument(1));
    if (const auto status = command.options.finish())
        return *status;
    return edit(command, file, [&](PeersFile &peers) { return peers.rename(command.argument(0), name); });
}

int setPeerRole(const QStringList &arguments)
{
    const PeerChange change{"peers role", "Changes the role of a peer; takes effect at once in a running session.", "ROLE",
                            "pilot (may command) or observer (may only observe)."};
    return changePeer(arguments, change, &readRole, [](PeerEntry &entry, channel::PeerRole role) { entry.peer.role = role; });
}

int setPeerSystems(const QStringList &arguments)
{
    const PeerChange change{"peers sysids", "Changes the MAVLink system IDs that a peer may use.", "LIST",
                            "System IDs from 1 to 255, separated by commas, or any."};
    return changePeer(arguments, change, &readSystems,
                      [](PeerEntry &entry, std::vector<std::uint8_t> systems) { entry.peer.systemIds = std::move(systems); });
}

} // namespace skyseal::app
