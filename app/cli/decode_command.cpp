// skyseal-cli decode: prints a recording or raw MAVLink, one message per line.
#include "app/cli/commands.h"
#include "app/cli/log_input.h"
#include "app/common/mavsec_options.h"
#include "app/common/exit_status.h"
#include "app/common/format.h"
#include "app/common/options.h"
#include "app/common/output.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/mavsec_cipher.h"
#include "core/engine/common/mavsec_stream.h"
#include "core/log/decode.h"
#include "core/mavlink/signing_key.h"
#include "core/mavlink/user_dialect.h"

namespace skyseal::app {

namespace {

void declareDecodeOptions(Options &options)
{
    options.addArgument("FILE", "A .tlog or raw MAVLink bytes; - reads standard input.");
    options.addFlag("json", "One JSON object per line on stdout.");
    options.addValue("dialect", "XML", "Definition of further messages (MAVLink XML).");
    options.addValue("signing-key", "FILE",
                     "Key of signed frames: 32 bytes, or 64 hex digits. Frames with an invalid signature are reported as bad.");
    options.addResearchValue("framing", "plain|mavsec2019",
                             "Protection of the frames: none, or that of the published code of the MAVSec paper.", "plain");
    MavsecOptions::declare(options);
}

void checkFraming(Options &options)
{
    const std::string framing = options.text("framing");
    if (framing != "plain" && framing != "mavsec2019")
        options.fail("--framing '" + framing + "': plain or mavsec2019 is expected");
    if (framing == "mavsec2019" && options.has("signing-key")) // its signatures cover the encrypted payloads
        options.fail("--signing-key: not with --framing mavsec2019");
}

/// The built-in dialect, extended by the user's messages if there are any.
Result<mavlink::Dialect, InputError> readDialect(const std::string &file)
{
    return file.empty() ? mavlink::Dialect::builtin() : mavlink::loadUserDialect(file);
}

} // namespace

int runDecode(const QStringList &arguments)
{
    const QString name = QStringLiteral("skyseal-cli decode");
    Options options(name, QStringLiteral("Shows MAVLink, one message per line."));
    declareDecodeOptions(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList files = options.arguments(1, 1);
    checkFraming(options);
    const MavsecOptions mavsec = MavsecOptions::read(options);
    if (const auto status = options.finish())
        return *status;

    const auto dialect = readDialect(options.text("dialect"));
    if (!dialect) {
        complain(name, dialect.error().text());
        return kCannotOpen;
    }
    tlog::DecodeOptions how;
    how.json = options.has("json");
    Result<Key32, InputError> key;
    if (options.has("signing-key")) {
        key = mavlink::readSigningKey(options.text("signing-key"));
        if (!key) {
            complain(name, key.error().text());
            return kCannotOpen;
        }
        how.signingKey = &*key;
    }
    std::optional<engine::MavsecStream> encrypted;
    if (mavsec.isChosen()) {
        auto cipher = mavsec.cipher();
        if (!cipher) {
            complain(name, cipher.error().text());
            return kCannotOpen;
        }
        encrypted.emplace(std::move(*cipher), *dialect);
        how.open = [&encrypted](const mavlink::Frame &frame) { return encrypted->open(frame); };
    }
    LogInput input;
    if (const auto problem = input.open(files[0])) {
        complain(name, *problem);
        return kCannotOpen;
    }
    // Flushes only when no input is pending: live with a pipe, and efficient with a file.
    const auto counts = tlog::decode(input.stream(), *dialect, how, [&](std::string_view line) {
        printOwnText(printable(line));
        return input.stream().rdbuf()->in_avail() > 0 || flushOutput();
    });
    flushOutput();
    if (!how.json)
        remark(counted(counts.messages, "message") + ", " + std::to_string(counts.bad) + " bad");
    if (counts.messages > 0)
        return kDone;
    complain(name, files[0].toStdString() + (counts.bad == 0 ? ": is empty" : ": contains no valid MAVLink message"));
    return kNotReached;
}

} // namespace skyseal::app
