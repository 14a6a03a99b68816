// skyseal-cli impair: simulates a bad radio link between two programs.
#include "app/cli/commands.h"
#include "app/common/exit_status.h"
#include "app/common/format.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/own_ports.h"
#include "app/common/process.h"
#include "core/engine/headless/relay_report.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QElapsedTimer>

#include <functional>

namespace skyseal::app {

namespace {

using Direction = link::Impairer::Direction;

void declareImpairOptions(Options &options)
{
    options.addLink("listen", "The link to one side, e.g. udpin:127.0.0.1:14560.", isLive);
    options.addLink("to", "The link to the other side, e.g. udpout:127.0.0.1:14550.", isLive);
    options.addValue("loss", "P", "Share of datagrams that are lost, 0 to 1.", "0");
    options.addValue("duplicate", "P", "Share that is duplicated.", "0");
    options.addValue("reorder", "P", "Share that arrives after later datagrams.", "0");
    options.addValue("corrupt", "P", "Share with damaged bits.", "0");
    options.addValue("delay", "MS", "Delay in milliseconds.", "0");
    options.addValue("jitter", "MS", "Random additional delay, up to this many milliseconds.", "0");
    options.addValue("rate", "BAUD", "Bit rate of a simulated serial line (8N1); 0 = no limit.", "0");
    options.addValue("seed", "N", "Seed, to repeat the same impairments for the same traffic.", "1");
    options.addValue("duration", "S", "Exit after this many seconds.");
    options.addFlag("json", "One JSON object per line on stdout.");
    options.addFlag(
        "drops",
        "With --json: print a line for each datagram that is dropped, with the number of all datagrams, records and "
        "clear frames dropped so far.");
    options.addFlag(
        "datagrams",
        "With --json: print a line for each received datagram, with its fate and its unencrypted content, and one for each "
        "copy that is sent. The relay waits for a reader that does not keep up; without this option, it drops lines instead.");
}

impair::ImpairmentSettings readSettings(Options &options)
{
    const auto milliseconds = [&options](const char *name) {
        return std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(options.number(name, 0, 3.6e6)));
    };
    impair::ImpairmentSettings out;
    out.loss = options.number("loss", 0, 1);
    out.duplicate = options.number("duplicate", 0, 1);
    out.reorder = options.number("reorder", 0, 1);
    out.corrupt = options.number("corrupt", 0, 1);
    out.delay = milliseconds("delay");
    out.jitter = milliseconds("jitter");
    out.baud = static_cast<decltype(out.baud)>(options.wholeNumber("rate", 0, 1'000'000'000));
    out.seed = options.wholeNumber("seed", 0, UINT64_MAX);
    return out;
}

std::string summaryText(const link::Impairer &impairer)
{
    const auto direction = [&impairer](const char *arrow, Direction which) {
        const impair::Counters counters = impairer.totals(which).counters;
        const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
        return format("%s %llu in, %llu out, %llu lost, %llu twice, %llu damaged", arrow, count(counters.offered),
                      count(counters.delivered), count(counters.lost + counters.queueFull), count(counters.duplicated),
                      count(counters.corrupted));
    };
    return direction("->", Direction::Forward) + "; " + direction("<-", Direction::Backward);
}

using Elapsed = std::function<std::chrono::milliseconds()>;

enum class LogLevel : std::uint8_t { None, Drops, All };

/// Keeps the account of all datagrams, and prints a line for those that the level selects: a log of all is whole, while each
/// line of a dropped datagram has the sums so far, so that a later one makes up for it.
void logDatagrams(link::Impairer &impairer, engine::RelayAccount &account, LogLevel level, const Elapsed &elapsed,
                  UnblockedOutput &output)
{
    impairer.setLog([&account, level, elapsed, &output](Direction direction, TimePoint, const impair::Treatment &treatment,
                                                        ByteView datagram) {
        const engine::DatagramContents contents = engine::contentsOf(datagram);
        engine::RelayLosses &losses = account[static_cast<std::size_t>(direction)];
        losses.add(treatment, contents);
        if (level == LogLevel::All)
            printLine(engine::arrivalJson(direction, elapsed(), treatment, contents));
        else if (level == LogLevel::Drops && treatment.dropped())
            output.print(engine::dropJson(direction, elapsed(), treatment, losses));
    });
    if (level == LogLevel::All) {
        impairer.setDeliveryLog([elapsed](Direction direction, TimePoint, std::uint64_t sequence) {
            printLine(engine::deliveryJson(direction, elapsed(), sequence));
        });
    }
}

} // namespace

int runImpair(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli impair");
    Options options(name, QStringLiteral("Relays datagrams between two links like a bad radio link."));
    declareImpairOptions(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    const auto listen = options.url("listen");
    const auto to = options.url("to");
    if (listen && to)
        refuseOwnPorts(options, "the relay", {{"listen", *listen}, {"to", *to}});
    const impair::ImpairmentSettings settings = readSettings(options);
    const double duration = options.has("duration") ? options.number("duration", 0, 1e6) : 0;
    if (const auto status = options.finish())
        return *status;

    const bool json = options.has("json");
    engine::RelayAccount account;
    link::Impairer impairer(*listen, *to, settings);
    QElapsedTimer clock;
    clock.start();
    const auto elapsed = [&clock] { return std::chrono::milliseconds(clock.elapsed()); };
    UnblockedOutput output;
    const auto statsLine = [&](const char *event) { return engine::statsJson(event, impairer, account, elapsed()); };
    const LogLevel level = options.has("datagrams") ? LogLevel::All : options.has("drops") ? LogLevel::Drops : LogLevel::None;
    if (json)
        logDatagrams(impairer, account, level, elapsed, output);
    int status = kDone;
    QObject::connect(&impairer, &link::Impairer::linkStateChanged, qApp, [&](link::Link &link) {
        if (link.state() == link::LinkState::Failed) {
            complain(name, link.url().toText() + ": " + link.error().sentence());
            status = kCannotOpen;
            QCoreApplication::exit(status);
        }
    });
    QTimer everySecond;
    QObject::connect(&everySecond, &QTimer::timeout, qApp, [&] {
        if (level == LogLevel::All)
            printLine(statsLine("stats"));
        else
            output.print(statsLine("stats"));
    });
    StopSignals signals;
    QObject::connect(&signals, &StopSignals::stopRequested, qApp, [] { QCoreApplication::exit(kDone); });
    if (options.has("duration"))
        QTimer::singleShot(std::chrono::milliseconds(static_cast<qint64>(duration * 1000)), qApp,
                           [] { QCoreApplication::exit(kDone); });
    QTimer::singleShot(0, qApp, [&] {
        impairer.open();
        if (json)
            everySecond.start(1000);
        else
            remark("relaying " + listen->toText() + " to " + to->toText());
    });
    QCoreApplication::exec();
    if (status == kDone && json)
        output.printLast(statsLine("summary"));
    else if (status == kDone)
        remark(summaryText(impairer));
    impairer.close();
    return status;
}

} // namespace skyseal::app
