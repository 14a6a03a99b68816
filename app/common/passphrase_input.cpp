#include "app/common/passphrase_input.h"

#include "core/crypto/passphrase.h"
#include "app/common/terminal_prompt.h"
#include "core/base/secret_bytes.h"
#include "core/keys/file_io.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace skyseal::app {

using crypto::Passphrase;

namespace {

constexpr int kAttempts = 3;
constexpr std::uint64_t kLargestDescriptor = 1 << 20;

/// The first line of the bytes, which are wiped.
Result<Passphrase, InputError> passphraseOf(MutableByteView bytes, const std::string &source)
{
    std::size_t size = 0;
    while (size < bytes.size() && bytes[size] != '\n' && bytes[size] != '\r')
        ++size;
    auto passphrase = Passphrase::fromBytes(ByteView(bytes).first(size));
    wipeSecret(bytes);
    if (passphrase)
        return std::move(*passphrase);
    return tl::unexpected(
        InputError{size == 0 ? "has no passphrase in its first line" : "has a passphrase of more than 1024 bytes", source});
}

Result<Passphrase, InputError> fromDescriptor(int descriptor)
{
    const std::string source = "descriptor " + std::to_string(descriptor);
    SecretBytes<Passphrase::kMaxLength + 2> line;
    const MutableByteView room = line.mutableView();
    std::size_t size = 0;
    // One byte at a time: the data after the line is left to other readers of the descriptor.
    while (size < room.size()) {
        const ssize_t count = ::read(descriptor, room.data() + size, 1);
        if (count < 0 && errno == EINTR)
            continue;
        if (count < 0)
            return tl::unexpected(InputError{std::string("cannot be read: ") + std::strerror(errno), source});
        if (count == 0 || room[size] == '\n')
            break;
        ++size;
    }
    return passphraseOf(room.first(size), source);
}

} // namespace

void PassphraseInput::declare(Options &options, const char *which, const char *whose)
{
    options.addValue((std::string(which) + "passphrase-file").c_str(), "FILE",
                     ("File whose first line is " + std::string(whose) + "; - for standard input.").c_str());
    options.addValue((std::string(which) + "passphrase-fd").c_str(), "N", "Open descriptor to read it from.");
    options.addAlternatives((std::string(which) + "passphrase-file").c_str(), (std::string(which) + "passphrase-fd").c_str());
}

PassphraseInput PassphraseInput::read(Options &options, const char *which)
{
    const std::string file = std::string(which) + "passphrase-file";
    const std::string descriptor = std::string(which) + "passphrase-fd";
    PassphraseInput out;
    out.m_which = which;
    if (options.has(file.c_str()))
        out.m_file = options.required(file.c_str());
    if (out.m_file == "-") {
        out.m_file.clear();
        out.m_descriptor = STDIN_FILENO;
    }
    if (options.has(descriptor.c_str()))
        out.m_descriptor = static_cast<int>(options.wholeNumber(descriptor.c_str(), 0, kLargestDescriptor));
    if (options.has(file.c_str()) && options.has(descriptor.c_str()))
        options.fail("--" + file + " and --" + descriptor + " exclude each other");
    return out;
}

Result<Passphrase, InputError> PassphraseInput::readGiven() const
{
    if (m_descriptor >= 0)
        return fromDescriptor(m_descriptor);
    auto content = keys::readFile(m_file, keys::FileAccess::Private);
    if (!content)
        return tl::unexpected(content.error());
    return passphraseOf(*content, m_file);
}

keys::AskPassphrase PassphraseInput::ask() const
{
    return [input = *this](const std::string &file, int attempt) -> Result<Passphrase, InputError> {
        const InputError wrong{"wrong passphrase, or the file was changed", file};
        if (input.isGiven())
            return attempt == 0 ? input.readGiven() : tl::unexpected(wrong);
        if (attempt >= kAttempts)
            return tl::unexpected(wrong);
        return askAtTerminal(attempt == 0 ? "Passphrase of " + file + ": " : "Wrong passphrase. Try again: ", file,
                             input.m_which);
    };
}

Result<Passphrase, InputError> PassphraseInput::once(const std::string &question) const
{
    return isGiven() ? readGiven() : askAtTerminal(question, "the terminal", m_which);
}

Result<Passphrase, InputError> PassphraseInput::choose(const std::string &file) const
{
    if (isGiven())
        return readGiven();
    auto first = askAtTerminal("New passphrase of " + file + ": ", file, m_which);
    if (!first)
        return first;
    const auto second = askAtTerminal("Repeat the passphrase: ", file, m_which);
    if (!second)
        return tl::unexpected(second.error());
    if (!first->equals(*second))
        return tl::unexpected(InputError{"the two passphrases differ", file});
    return first;
}

} // namespace skyseal::app
