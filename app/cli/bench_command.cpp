// skyseal-cli bench: measures sealing and opening on this machine, with and without AES instructions.
#include "app/cli/commands.h"
#include "app/common/exit_status.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "app/common/sweep_setting.h"
#include "core/base/json_writer.h"
#include "core/experiment/cipher_bench.h"
#include "core/experiment/setting.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QProcess>

#include <algorithm>
#include <charconv>

namespace skyseal::app {

namespace {

const QString kBenchName = QStringLiteral("skyseal-cli bench");
constexpr std::size_t kMostBytes = 1100;

// Masks of CPU features for OpenSSL (OPENSSL_ia32cap(3): AES-NI is bit 57, PCLMULQDQ bit 33; vector AES bits 9 and 10
// of the second word). On ARM OPENSSL_armcap=0 masks all.
#if defined(__x86_64__)
constexpr const char *kMaskName = "OPENSSL_ia32cap", *kMask = "~0x200000200000000:~0x60000000000";
#else
constexpr const char *kMaskName = "OPENSSL_armcap", *kMask = "0";
#endif

struct BenchPlan
{
    std::vector<crypto::SuiteId> suites;
    std::vector<std::size_t> sizes;
    bool with = true, without = true;
    bool json = false;
};

std::vector<std::size_t> readSizes(Options &options)
{
    std::vector<std::size_t> out;
    const std::string text = options.text("sizes");
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        std::size_t size = 0;
        const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, size);
        if (error != std::errc() || stop != text.data() + end || size < 1 || size > kMostBytes) {
            options.fail("--sizes '" + text + "': whole numbers from 1 to " + std::to_string(kMostBytes)
                         + ", separated by commas, are expected");
            break;
        }
        out.push_back(size);
        begin = end + 1;
    }
    return out;
}

BenchPlan readBenchPlan(Options &options)
{
    BenchPlan out;
    out.suites = options.suites("suites");
    if (options.text("suites") == "all")
        std::erase_if(out.suites, [](crypto::SuiteId suite) { return !crypto::suiteAvailable(suite); });
    if (std::find(out.suites.begin(), out.suites.end(), crypto::SuiteId::None) != out.suites.end())
        options.fail("--suites none: plain MAVLink is not sealed");
    out.sizes = readSizes(options);
    const std::string aes = options.text("aes");
    out.with = aes != "without";
    out.without = aes != "with";
    if (aes != "both" && aes != "with" && aes != "without")
        options.fail("--aes '" + aes + "': with, without or both is expected");
    out.json = options.has("json");
    return out;
}

std::string settingEvent(bool aes, const experiment::Setting &setting)
{
    JsonWriter json;
    json.beginObject().field("event", "setting").field("aes_instructions", aes);
    for (const auto &[key, value] : setting)
        json.field(key, value);
    return json.endObject().text();
}

/// Measures in this process. The output states whether OpenSSL uses AES instructions, not whether they were requested.
bool measure(const BenchPlan &plan, bool asked, const QString &command)
{
    bool ok = true;
    const bool aes = experiment::opensslUsesAes().value_or(asked);
    const experiment::Setting setting = describeSetting(SKYSEAL_CLI_VERSION, command);
    for (const Reason &warning : experiment::warningsOf(setting))
        remark(warning.text());
#if !defined(__OPTIMIZE__)
    remark("this build is not optimized: its figures are not meaningful");
#endif
    if (plan.json) {
        printLine(settingEvent(aes, setting));
    } else {
        printLine(aes         ? "With the processor's AES instructions:"
                      : asked ? "Without AES instructions, which this processor does not have:"
                              : "Without AES instructions:");
        for (const std::string &line : experiment::benchHeader())
            printLine(line);
    }
    for (const crypto::SuiteId suite : plan.suites) {
        const experiment::SuiteCosts costs = experiment::benchSuite(suite, plan.sizes);
        for (const std::string &line : plan.json ? experiment::benchEvents(costs, aes) : experiment::benchText(costs))
            printLine(line);
        ok = ok && !costs.failed;
    }
    return ok;
}

/// True if this process runs in the environment required for the measurement.
bool isPrepared(bool aes)
{
    return aes ? !qEnvironmentVariableIsSet(kMaskName) : qgetenv(kMaskName) == kMask;
}

/// The libraries detect CPU features at their start, so a separate process is needed; its output is forwarded.
int measureInChild(const QStringList &arguments, bool aes)
{
    QProcess child;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    if (aes)
        environment.remove(QLatin1String(kMaskName));
    else
        environment.insert(QLatin1String(kMaskName), QLatin1String(kMask));
    child.setProcessEnvironment(environment);
    child.setProcessChannelMode(QProcess::ForwardedChannels);
    QStringList own = arguments;
    own << QStringLiteral("--aes") << (aes ? QStringLiteral("with") : QStringLiteral("without"));
    child.start(QCoreApplication::applicationFilePath(), QStringList{QStringLiteral("bench")} + own);
    if (!child.waitForFinished(-1) || child.exitStatus() != QProcess::NormalExit) {
        complain(kBenchName, "the measurement process failed: " + child.errorString().toStdString());
        return kNotReached;
    }
    return child.exitCode();
}

} // namespace

int runBench(const QStringList &arguments)
{
    Options options(kBenchName, QStringLiteral("Measures sealing and opening for each suite and size."));
    options.addValue("suites", "LIST", "Suites, separated by commas.", "all");
    options.addValue("sizes", "LIST", "Plaintext sizes in bytes, separated by commas.", "9,28,64,255,1000");
    options.addValue("aes", "with|without|both",
                     "Use the CPU's AES instructions. Without them, the figures apply to a companion "
                     "computer that has none.",
                     "both");
    options.addFlag("json", "One JSON object per line on stdout.");
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    const BenchPlan plan = readBenchPlan(options);
    if (const auto status = options.finish())
        return *status;
    const QString command = kBenchName + QLatin1Char(' ') + arguments.join(QLatin1Char(' '));
    bool ok = true, first = true, here = false;
    for (const bool aes : {true, false}) {
        if (aes ? !plan.with : !plan.without)
            continue;
        if (!first && !plan.json)
            printLine("");
        first = false;
        // A mask set by the user would falsify either.
        here = isPrepared(aes);
        ok = (here ? measure(plan, aes, command) : measureInChild(arguments, aes) == kDone) && ok;
    }
    if (!plan.json && ok && here)
        printOwnText(
            "\ncipher: the library's cipher alone; bare: the library's cipher and authentication; suite: as implemented here; "
            "record: a complete record\nof a session; x: record over bare. CPU time, the fastest of 15 rounds.");
    return ok ? kDone : kNotReached;
}

} // namespace skyseal::app
