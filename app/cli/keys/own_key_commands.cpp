// The subcommands for a device's own key: create, show, export, import, set the passphrase.
#include "core/crypto/passphrase.h"
#include "core/crypto/x25519.h"
#include "app/cli/keys/keys_subcommand.h"
#include "app/cli/keys/keys_subcommands.h"
#include "app/cli/keys/named_input.h"
#include "app/cli/qr_text.h"
#include "app/common/passphrase_input.h"
#include "core/base/json_writer.h"
#include "core/base/secret_bytes.h"
#include "core/crypto/system_random.h"
#include "core/keys/file_io.h"
#include "core/keys/public_key_text.h"
#include "core/keys/secret_file.h"

namespace skyseal::app {

namespace {

/// `sealed`: whether the file is sealed, if that is to be printed.
void printKey(const keys::PublicKey &key, bool json, std::optional<bool> sealed = {})
{
    if (!json) {
        printLine("public      " + keys::publicKeyText(key));
        printLine("fingerprint " + keys::fingerprint(key));
        if (sealed.value_or(false))
            printLine("sealed with a passphrase");
        return;
    }
    JsonWriter line;
    line.beginObject().field("event", "key").field("public", keys::publicKeyText(key));
    line.field("fingerprint", keys::fingerprint(key));
    if (sealed)
        line.field("sealed", *sealed);
    line.endObject();
    printLine(line.text());
}

/// The passphrase of a new file, if requested.
class NewPassphrase
{
public:
    static void declare(Options &options)
    {
        options.addFlag("passphrase", "Seal the key with a passphrase; prompts for it.");
        PassphraseInput::declare(options, "new-", "the new passphrase");
    }
    void read(Options &options)
    {
        m_input = PassphraseInput::read(options, "new-");
        m_wanted = options.has("passphrase") || m_input.isGiven();
    }
    Result<void, InputError> ask(const std::string &file)
    {
        if (!m_wanted)
            return {};
        auto chosen = m_input.choose(file);
        if (!chosen)
            return tl::unexpected(chosen.error());
        m_passphrase.emplace(std::move(*chosen));
        return {};
    }
    keys::Sealing sealing() const { return {m_passphrase ? &*m_passphrase : nullptr}; }

private:
    PassphraseInput m_input;
    bool m_wanted = false;
    std::optional<crypto::Passphrase> m_passphrase;
};

} // namespace

int newKey(const QStringList &arguments)
{
    KeysSubcommand command("new", "Creates a private key in a new file that only its owner can read.");
    command.options.addValue("out", "FILE", "File of the private key.");
    NewPassphrase::declare(command.options);
    command.addJsonOption();
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string file = command.options.required("out");
    NewPassphrase passphrase;
    passphrase.read(command.options);
    if (const auto status = command.options.finish())
        return *status;
    if (keys::fileExists(file)) // before asking for a passphrase
        return command.cannotOpen({"exists already and is not overwritten", file});
    if (const auto asked = passphrase.ask(file); !asked)
        return command.cannotOpen(asked.error());
    crypto::SystemRandom random;
    const auto publicKey = keys::writeNewIdentity(file, random, passphrase.sealing());
    if (!publicKey)
        return command.cannotOpen(publicKey.error());
    printKey(*publicKey, command.options.has("json"));
    return kDone;
}

int showKey(const QStringList &arguments)
{
    KeysSubcommand command("show", "Shows the public key of a private key file, for its peers. Does not need the passphrase.");
    command.addArgument("FILE", "File of the private key.");
    command.addJsonOption();
    if (canShowQr())
        command.options.addFlag("qr", "Show the public key as a QR code.");
    if (const auto status = command.parse(arguments))
        return *status;
    if (const auto status = command.options.finish())
        return *status;
    const auto facts = keys::readIdentityFacts(command.argument(0));
    if (!facts)
        return command.cannotOpen(facts.error());
    const bool json = command.options.has("json");
    printKey(facts->publicKey, json, facts->sealed);
    if (canShowQr() && command.options.has("qr"))
        std::fputs(qrText(keys::publicKeyText(facts->publicKey)).c_str(), json ? stderr : stdout);
    return kDone;
}

int exportKey(const QStringList &arguments)
{
    KeysSubcommand command("export", "Writes the public key, to be copied to the other end.");
    command.addArgument("FILE", "File of the private key.");
    command.options.addValue("out", "PUBLIC-FILE", "File to write, which must not exist yet; without it, standard output.");
    if (const auto status = command.parse(arguments))
        return *status;
    if (const auto status = command.options.finish())
        return *status;
    const auto facts = keys::readIdentityFacts(command.argument(0));
    if (!facts)
        return command.cannotOpen(facts.error());
    const std::string text = keys::publicKeyText(facts->publicKey);
    if (!command.options.has("out")) {
        printLine(text);
        return kDone;
    }
    const auto written = keys::createFile(command.options.text("out"), asBytes(text + "\n"));
    return written ? kDone : command.cannotOpen(written.error());
}

int importKey(const QStringList &arguments)
{
    KeysSubcommand command("import",
                           "Copies a private key, e.g. from a USB stick, into a new file that only its owner "
                           "can read.");
    command.addArgument("FROM", "File of the private key, which should be deleted afterwards; - for standard input.");
    command.options.addValue("out", "FILE", "File to write, which must not exist yet.");
    PassphraseInput::declare(command.options);
    NewPassphrase::declare(command.options);
    command.addJsonOption();
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string from = command.argument(0);
    const std::string file = command.options.required("out");
    const PassphraseInput input = PassphraseInput::read(command.options);
    NewPassphrase passphrase;
    passphrase.read(command.options);
    if (const auto status = command.options.finish())
        return *status;
    auto content = readNamed(from);
    if (!content)
        return command.cannotOpen(content.error());
    const auto pair = keys::parseIdentity(asText(*content), from, input.ask());
    wipeSecret(*content);
    if (!pair)
        return command.cannotOpen(pair.error());
    if (const auto asked = passphrase.ask(file); !asked)
        return command.cannotOpen(asked.error());
    crypto::SystemRandom random;
    if (const auto written = keys::writeIdentity(file, *pair, random, passphrase.sealing()); !written)
        return command.cannotOpen(written.error());
    printKey(pair->publicKey, command.options.has("json"));
    return kDone;
}

int changePassphrase(const QStringList &arguments)
{
    KeysSubcommand command("passphrase", "Sets, changes or removes the passphrase of a private key.");
    command.addArgument("FILE", "File of the private key.");
    command.options.addFlag("remove", "Remove the passphrase: the key is then readable from the file.");
    PassphraseInput::declare(command.options);
    PassphraseInput::declare(command.options, "new-", "the new passphrase");
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string file = command.argument(0);
    const PassphraseInput input = PassphraseInput::read(command.options);
    const PassphraseInput next = PassphraseInput::read(command.options, "new-");
    const bool remove = command.options.has("remove");
    if (remove && next.isGiven())
        command.options.fail("--remove and a new passphrase exclude each other");
    if (const auto status = command.options.finish())
        return *status;
    const auto pair = keys::loadIdentity(file, input.ask());
    if (!pair)
        return command.cannotOpen(pair.error());
    std::optional<crypto::Passphrase> passphrase;
    if (!remove) {
        auto chosen = next.choose(file);
        if (!chosen)
            return command.cannotOpen(chosen.error());
        passphrase.emplace(std::move(*chosen));
    }
    crypto::SystemRandom random;
    const auto written = keys::rewriteIdentity(file, *pair, random, {passphrase ? &*passphrase : nullptr});
    return written ? kDone : command.cannotOpen(written.error());
}

int newPresharedKey(const QStringList &arguments)
{
    KeysSubcommand command(
        "psk",
        "Creates a pre-shared key: an additional secret of two devices. Both need a copy of the file, for peers add "
        "--psk.");
    command.options.addValue("out", "FILE", "File to write, which must not exist yet.");
    if (const auto status = command.parse(arguments))
        return *status;
    const std::string file = command.options.required("out");
    if (const auto status = command.options.finish())
        return *status;
    crypto::SystemRandom random;
    const auto made = keys::writeNewPresharedKey(file, random);
    return made ? kDone : command.cannotOpen(made.error());
}

} // namespace skyseal::app
