// skyseal-cli keys: makes and shows private keys, and keeps the files of known peers.
#include "app/cli/commands.h"
#include "app/cli/qr_text.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/crypto/system_random.h"
#include "core/keys/peers_file.h"
#include "core/keys/public_key_text.h"
#include "core/keys/secret_file.h"

namespace skyseal::app {

namespace {

int cannotOpen(const QString &name, const InputError &error)
{
    complain(name, error.text());
    return kCannotOpen;
}

void showKey(const keys::PublicKey &key, bool json)
{
    if (json) {
        JsonWriter line;
        line.beginObject()
            .field("event", "key")
            .field("public", keys::publicKeyText(key))
            .field("fingerprint", keys::fingerprint(key));
        line.endObject();
        printLine(line.text());
    } else {
        printLine("public      " + keys::publicKeyText(key));
        printLine("fingerprint " + keys::fingerprint(key));
    }
}

int newKey(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli keys new");
    Options options(name, QStringLiteral("Makes a private key. The file must not exist yet; only its owner may read it."));
    options.addValue("out", "FILE", "File of the private key.");
    options.addFlag("json", "One JSON object on stdout.");
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    const std::string file = options.required("out");
    if (const auto status = options.finish())
        return *status;
    crypto::SystemRandom random;
    const auto pair = keys::writeNewIdentity(file, random);
    if (!pair)
        return cannotOpen(name, pair.error());
    showKey(pair->publicKey, options.has("json"));
    return kDone;
}

int showKeyFile(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli keys show");
    Options options(name, QStringLiteral("Shows the public part of a private key: what other ends need to know."));
    options.addArgument("FILE", "File of the private key.");
    options.addFlag("json", "One JSON object on stdout.");
    if (canShowQr())
        options.addFlag("qr", "Shows the public key as a QR code.");
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList files = options.arguments(1, 1);
    if (const auto status = options.finish())
        return *status;
    const auto pair = keys::loadIdentity(files[0].toStdString());
    if (!pair)
        return cannotOpen(name, pair.error());
    showKey(pair->publicKey, options.has("json"));
    if (canShowQr() && options.has("qr"))
        std::fputs(qrText(keys::publicKeyText(pair->publicKey)).c_str(), options.has("json") ? stderr : stdout);
    return kDone;
}

int addPeer(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli keys peers add");
    Options options(name, QStringLiteral("Adds a peer whose fingerprint you have compared."));
    options.addArgument("PUBLIC", "Its public key, as keys show prints it there.");
    options.addValue("peers", "FILE", "File of known peers; made when it is missing.");
    options.addValue("name", "NAME", "How it is to be called here.");
    options.addValue("role", "pilot|observer", "What it may do: command, or only look.", "pilot");
    options.addValue("sysids", "LIST", "MAVLink system ids that it may speak as, e.g. 1,2.", "any");
    options.addFlag("replace", "Replaces the peer of that name: its key has changed, and you know why.");
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList given = options.arguments(1, 1);
    const std::string file = options.required("peers");
    keys::PeerEntry entry;
    entry.peer.name = options.required("name");
    if (const auto role = keys::peerRoleFromText(options.text("role")))
        entry.peer.role = *role;
    else
        options.fail("--role '" + options.text("role") + "': pilot or observer is expected");
    if (auto ids = keys::systemIdsFromText(options.text("sysids")))
        entry.peer.systemIds = std::move(*ids);
    else
        options.fail("--sysids: " + ids.error().message);
    if (!given.isEmpty()) {
        if (const auto key = keys::publicKeyFromText(given[0].toStdString()))
            entry.peer.key = *key;
        else
            options.fail(key.error().message);
    }
    if (const auto status = options.finish())
        return *status;

    auto peers = keys::PeersFile::loadOrEmpty(file);
    if (!peers)
        return cannotOpen(name, peers.error());
    const keys::PublicKey key = entry.peer.key;
    const auto added = options.has("replace") ? peers->replace(std::move(entry)) : peers->add(std::move(entry));
    if (!added) {
        complain(name, file + ": " + added.error().message);
        return kNotReached;
    }
    if (const auto saved = peers->save(file); !saved)
        return cannotOpen(name, saved.error());
    printLine("fingerprint " + keys::fingerprint(key));
    return kDone;
}

int removePeer(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli keys peers remove");
    Options options(name, QStringLiteral("Removes a peer: it cannot connect any more."));
    options.addArgument("NAME", "The peer's name.");
    options.addValue("peers", "FILE", "File of known peers.");
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList given = options.arguments(1, 1);
    const std::string file = options.required("peers");
    if (const auto status = options.finish())
        return *status;
    auto peers = keys::PeersFile::load(file);
    if (!peers)
        return cannotOpen(name, peers.error());
    if (!peers->remove(given[0].toStdString())) {
        complain(name, file + ": no peer is named '" + given[0].toStdString() + "'");
        return kNotReached;
    }
    const auto saved = peers->save(file);
    return saved ? kDone : cannotOpen(name, saved.error());
}

int listPeers(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli keys peers list");
    Options options(name, QStringLiteral("Lists the known peers."));
    options.addValue("peers", "FILE", "File of known peers.");
    options.addFlag("json", "One JSON object a line on stdout.");
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    const std::string file = options.required("peers");
    if (const auto status = options.finish())
        return *status;
    const auto peers = keys::PeersFile::load(file);
    if (!peers)
        return cannotOpen(name, peers.error());
    for (const keys::PeerEntry &entry : peers->entries()) {
        const channel::Peer &peer = entry.peer;
        const std::string role(keys::peerRoleText(peer.role));
        if (!options.has("json")) {
            printLine(peer.name + "  " + role + "  " + keys::systemIdsText(peer.systemIds) + "  "
                      + keys::fingerprint(peer.key));
            continue;
        }
        JsonWriter line;
        line.beginObject().field("event", "peer").field("name", peer.name).field("role", role);
        line.field("sysids", keys::systemIdsText(peer.systemIds)).field("public", keys::publicKeyText(peer.key));
        line.field("fingerprint", keys::fingerprint(peer.key)).endObject();
        printLine(line.text());
    }
    return kDone;
}

int usage(const char *words)
{
    complain(QStringLiteral("skyseal-cli keys"), words);
    return kUsage;
}

} // namespace

int runKeys(const QStringList &arguments)
{
    const QString action = arguments.value(0);
    const QStringList rest = arguments.mid(1);
    if (action == QLatin1String("new"))
        return newKey(rest);
    if (action == QLatin1String("show"))
        return showKeyFile(rest);
    if (action == QLatin1String("peers")) {
        const QString what = rest.value(0);
        if (what == QLatin1String("add"))
            return addPeer(rest.mid(1));
        if (what == QLatin1String("remove"))
            return removePeer(rest.mid(1));
        if (what == QLatin1String("list"))
            return listPeers(rest.mid(1));
        return usage("peers is followed by add, remove or list");
    }
    if (action == QLatin1String("--help") || action == QLatin1String("-h")) {
        printLine(
            "Usage: skyseal-cli keys new --out FILE\n"
            "       skyseal-cli keys show FILE [--qr] [--json]\n"
            "       skyseal-cli keys peers add --peers FILE --name NAME [--role pilot|observer] [--sysids LIST] PUBLIC\n"
            "       skyseal-cli keys peers remove --peers FILE NAME\n"
            "       skyseal-cli keys peers list --peers FILE [--json]\n"
            "Each explains itself with --help.");
        return kDone;
    }
    return usage("new, show or peers is expected; --help explains them");
}

} // namespace skyseal::app
