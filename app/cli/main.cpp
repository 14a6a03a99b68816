// skyseal-cli: the station without a display. This file selects the command; each has its own file.
#include "app/cli/commands.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/process.h"
#include "core/crypto/init_crypto.h"

#include <QtCore/QCoreApplication>

#include <cstdio>

using namespace skyseal::app;

namespace {

struct Command
{
    const char *name;
    const char *summary;
    int (*run)(const QStringList &arguments);
};

constexpr Command kCommands[] = {
    {"monitor", "monitors vehicles, switches ciphers, runs flight scripts", runMonitor},
    {"gateway", "serves other ground stations and programs through the sealed link", runGateway},
    {"status", "shows the state of a running gateway", runStatus},
    {"switch", "switches the sessions of a running gateway to another suite", runSwitch},
    {"revoke", "removes a peer from the list of a running gateway", runRevoke},
    {"param", "reads, writes, saves and restores parameters", runParam},
    {"mission", "reads, writes and clears the mission", runMission},
    {"fence", "reads, writes and clears the fence", runFence},
    {"rally", "reads, writes and clears the rally points", runRally},
    {"ftp", "lists, reads, writes and removes files on a vehicle", runFtp},
    {"logs", "lists, reads and erases the flight logs of a vehicle", runLogs},
    {"sweep", "measures and compares the cost of each cipher suite", runSweep},
    {"report", "writes the report of a sweep again, or one report over several sweeps", runReport},
    {"bench", "measures sealing and opening on this machine, with and without AES instructions", runBench},
    {"decode", "decodes MAVLink bytes or a .tlog, one message per line", runDecode},
    {"impair", "relays datagrams with loss, delay, duplication, reordering and corruption", runImpair},
    {"keys", "manages private keys and files of known peers", runKeys},
    {"log", "summarizes, verifies and exports .tlog files", runLog},
    {"selftest", "runs known-answer tests of the sealed link", runSelfTest},
};

void printHelp(std::FILE *out)
{
    std::fputs("Usage: skyseal-cli COMMAND [options]\nThe ground station without a display.\n\nCommands:\n", out);
    for (const Command &command : kCommands)
        std::fprintf(out, "  %-10s %s\n", command.name, command.summary);
    std::fputs("\nskyseal-cli COMMAND --help describes a command. Exit status: 0 done, 1 not reached, 2 usage,\n"
               "3 a link or file could not be opened, or a result could not be written.\n",
               out);
}

} // namespace

int main(int argc, char **argv)
{
    protectKeysInMemory();
    QCoreApplication application(argc, argv);
    const QStringList arguments = application.arguments().mid(1);
    const QString name = arguments.value(0);
    const QString program = QStringLiteral("skyseal-cli");
    if (name == QLatin1String("--help") || name == QLatin1String("-h") || name == QLatin1String("help")) {
        printHelp(stdout);
        return finishOutput(program, kDone);
    }
    if (name == QLatin1String("--version")) {
        std::printf("skyseal-cli " SKYSEAL_VERSION "\n");
        return finishOutput(program, kDone);
    }
    for (const Command &command : kCommands) {
        if (name != QLatin1String(command.name))
            continue;
        if (!skyseal::crypto::initCrypto()) {
            complain(program, "the system provides no randomness");
            return kCannotOpen;
        }
        return finishOutput(program + QLatin1Char(' ') + name, command.run(arguments.mid(1)));
    }
    complain(program,
             name.isEmpty() ? "a command is missing; skyseal-cli --help lists them"
                            : "no command is named '" + name.toStdString() + "'; skyseal-cli --help lists them");
    return kUsage;
}
