// skyseal-cli keys: manages private keys and files of known peers. This file selects the subcommand.
#include "app/cli/commands.h"
#include "app/cli/keys/keys_subcommands.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"

namespace skyseal::app {

namespace {

struct Subcommand
{
    const char *name;
    int (*run)(const QStringList &arguments);
    const char *synopsis;
};

constexpr Subcommand kOwn[] = {
    {"new", newKey, "new --out FILE [--passphrase] [--json]"},
    {"show", showKey, "show FILE [--qr] [--json]"},
    {"export", exportKey, "export FILE [--out PUBLIC-FILE]"},
    {"import", importKey, "import FROM --out FILE [--passphrase]"},
    {"passphrase", changePassphrase, "passphrase FILE [--remove]"},
    {"psk", newPresharedKey, "psk --out FILE"},
    {"pair", pairWithAgent,
     "pair --identity FILE --peers FILE [--link URL] [--as NAME] [--expect FINGERPRINT [--replace]] [--fingerprints] "
     "[--pair-passphrase] [--json]"},
};
constexpr Subcommand kPeers[] = {
    {"add", addPeer,
     "peers add --peers FILE --name NAME [--role pilot|observer] [--sysids LIST] [--psk FILE] [--replace] PUBLIC|--from FILE"},
    {"list", listPeers, "peers list --peers FILE [--json]"},
    {"rename", renamePeer, "peers rename --peers FILE NAME NEW-NAME"},
    {"role", setPeerRole, "peers role --peers FILE NAME pilot|observer"},
    {"sysids", setPeerSystems, "peers sysids --peers FILE NAME LIST"},
    {"remove", removePeer, "peers remove --peers FILE NAME"},
    {"revoke", removePeer, "peers revoke --peers FILE NAME      the same as remove"},
};

int usage(const std::string &text)
{
    complain(QStringLiteral("skyseal-cli keys"), text);
    return kUsage;
}

template<std::size_t N> std::string namesOf(const Subcommand (&commands)[N])
{
    std::string out;
    for (const Subcommand &command : commands)
        out.append(out.empty() ? "" : ", ").append(command.name);
    return out;
}

template<std::size_t N> const Subcommand *named(const Subcommand (&commands)[N], const QString &name)
{
    for (const Subcommand &command : commands) {
        if (name == QLatin1String(command.name))
            return &command;
    }
    return nullptr;
}

template<std::size_t... N> void printHelp(const Subcommand (&...commands)[N])
{
    std::string text;
    const auto list = [&text](const auto &table) {
        for (const Subcommand &command : table)
            text.append(text.empty() ? "Usage: " : "\n       ").append("skyseal-cli keys ").append(command.synopsis);
    };
    (list(commands), ...);
    printOwnText(text + "\nEach command has --help.");
}

bool asksForHelp(const QString &argument)
{
    return argument == QLatin1String("--help") || argument == QLatin1String("-h");
}

} // namespace

int runKeys(const QStringList &arguments)
{
    const QString action = arguments.value(0);
    if (asksForHelp(action)) {
        printHelp(kOwn, kPeers);
        return kDone;
    }
    if (action == QLatin1String("peers")) {
        if (asksForHelp(arguments.value(1))) {
            printHelp(kPeers);
            return kDone;
        }
        const Subcommand *command = named(kPeers, arguments.value(1));
        return command ? command->run(arguments.mid(2)) : usage("peers is followed by one of " + namesOf(kPeers));
    }
    const Subcommand *command = named(kOwn, action);
    return command ? command->run(arguments.mid(1)) : usage("one of " + namesOf(kOwn) + " or peers is expected; see --help");
}

} // namespace skyseal::app
