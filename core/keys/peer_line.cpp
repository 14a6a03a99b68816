#include "core/keys/peer_line.h"

#include "core/base/printable.h"
#include "core/base/utf8.h"
#include "core/keys/public_key_text.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace skyseal::keys {

using channel::PeerRole;

static constexpr std::string_view kBlanks = " \t\r"; // including the \r of Windows line ends
static constexpr std::string_view kPresharedKey = "psk=";
static constexpr std::size_t kMaxNameLength = 32;

static auto refuse(Reason message)
{
    return tl::unexpected(InputError{std::move(message), {}});
}

static std::vector<std::string_view> fieldsOf(std::string_view line)
{
    std::vector<std::string_view> fields;
    while (true) {
        const std::size_t first = line.find_first_not_of(kBlanks);
        if (first == std::string_view::npos)
            return fields;
        line.remove_prefix(first);
        const std::size_t length = std::min(line.find_first_of(kBlanks), line.size());
        fields.push_back(line.substr(0, length));
        line.remove_prefix(length);
    }
}

/// Text of a file for an error message, shortened.
static std::string quoted(std::string_view text)
{
    return "\"" + printable(text.substr(0, 60)) + "\"";
}

/// Blanks beyond ASCII: they look like the end of a name, or like two names.
static bool isWideBlank(char32_t character)
{
    return character == 0xA0 || character == 0x1680 || (character >= 0x2000 && character <= 0x200A) || character == 0x202F
        || character == 0x205F || character == 0x3000;
}

/// "character 3 is U+202E, a control or format character"; empty if there is none.
static Reason unprintableIn(std::string_view text)
{
    for (std::size_t position = 1; !text.empty(); ++position) {
        const Utf8Character character = firstCharacter(text);
        if (!character.valid)
            return sentence("Reason", "character %1 is not valid UTF-8")(position);
        if (const bool isBlank = isWideBlank(character.value); isBlank || isUnprintable(character.value)) {
            char code[16];
            std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(character.value));
            return (isBlank
                        ? sentence("Reason", "character %1 is %2, a blank")
                        : sentence("Reason", "character %1 is %2, a control or format character"))(position, std::string(code));
        }
        text.remove_prefix(character.length);
    }
    return {};
}

std::optional<PeerRole> peerRoleFromText(std::string_view text)
{
    if (text == "pilot")
        return PeerRole::Pilot;
    if (text == "observer")
        return PeerRole::Observer;
    return std::nullopt;
}

std::string_view peerRoleText(PeerRole role)
{
    return role == PeerRole::Pilot ? "pilot" : "observer";
}

Result<std::vector<std::uint8_t>, InputError> systemIdsFromText(std::string_view text)
{
    std::vector<std::uint8_t> ids;
    if (text == "any")
        return ids;
    const std::string whole = quoted(text);
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view part = text.substr(0, comma);
        std::uint8_t id = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), id);
        if (error != std::errc() || end != part.data() + part.size() || id == 0)
            return refuse(sentence(
                "Reason", "%1 is not a list of system IDs: numbers from 1 to 255 with commas between them, or \"any\"")(whole));
        if (std::find(ids.begin(), ids.end(), id) == ids.end())
            ids.push_back(id);
        if (comma == text.size())
            return ids;
        text.remove_prefix(comma + 1);
    }
}

std::string systemIdsText(const std::vector<std::uint8_t> &ids)
{
    std::string out;
    for (const std::uint8_t id : ids)
        out += (out.empty() ? "" : ",") + std::to_string(id);
    return out.empty() ? "any" : out;
}

bool isPeerLine(std::string_view line)
{
    const std::size_t first = line.find_first_not_of(kBlanks);
    return first != std::string_view::npos && line[first] != '#';
}

Result<PeerEntry, InputError> parsePeerLine(std::string_view line)
{
    const std::vector<std::string_view> fields = fieldsOf(line);
    if (fields.size() < 4 || fields.size() > 5)
        return refuse(
            sentence("Reason", "a peer needs a name, a role, system IDs and a public key, here are %1 fields")(fields.size()));
    PeerEntry entry;
    entry.peer.name = fields[0];
    const std::optional<PeerRole> role = peerRoleFromText(fields[1]);
    if (!role)
        return refuse(sentence("Reason", "%1 is not a role: pilot or observer")(quoted(fields[1])));
    entry.peer.role = *role;
    auto ids = systemIdsFromText(fields[2]);
    if (!ids)
        return tl::unexpected(ids.error());
    entry.peer.systemIds = std::move(*ids);
    const auto key = publicKeyFromText(fields[3]);
    if (!key)
        return tl::unexpected(key.error());
    entry.peer.key = *key;
    if (fields.size() == 5) {
        if (!fields[4].starts_with(kPresharedKey) || fields[4].size() == kPresharedKey.size())
            return refuse(sentence("Reason", "%1 is not a pre-shared key: psk=FILE")(quoted(fields[4])));
        entry.presharedKeyFile = fields[4].substr(kPresharedKey.size());
    }
    return entry;
}

std::string formatPeerLine(const PeerEntry &entry)
{
    std::string out = entry.peer.name + " " + std::string(peerRoleText(entry.peer.role)) + " "
        + systemIdsText(entry.peer.systemIds) + " " + publicKeyText(entry.peer.key);
    if (!entry.presharedKeyFile.empty())
        out.append(" ").append(kPresharedKey).append(entry.presharedKeyFile);
    return out;
}

Result<void, InputError> checkPeerName(const std::string &name)
{
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.'
            || static_cast<unsigned char>(c) >= 0x80;
    };
    if (name.empty() || name.size() > kMaxNameLength || !std::all_of(name.begin(), name.end(), fits))
        return refuse(sentence(
            "Reason",
            "%1 is not a peer's name: 1 to 32 letters, digits, \"-\", \"_\" or \".\"; one beyond ASCII counts as 2 to 4")(
            quoted(name)));
    if (name.front() == '-') // the commands that change the peer would take it for an option
        return refuse(sentence("Reason", "%1 is not a peer's name: it must not begin with \"-\"")(quoted(name)));
    if (const Reason problem = unprintableIn(name); !problem.empty())
        return refuse(sentence("Reason", "%1 is not a peer's name: %2")(quoted(name), problem));
    return {};
}

Result<void, InputError> checkPeerEntry(const PeerEntry &entry)
{
    if (auto named = checkPeerName(entry.peer.name); !named)
        return named;
    if (std::find(entry.peer.systemIds.begin(), entry.peer.systemIds.end(), 0) != entry.peer.systemIds.end())
        return refuse(sentence("Reason", "0 is not a system ID: numbers from 1 to 255"));
    if (entry.presharedKeyFile.find_first_of(" \t\r\n") != std::string::npos)
        return refuse(sentence("Reason", "%1 cannot be noted: the path of a pre-shared key must not have blanks")(
            quoted(entry.presharedKeyFile)));
    return {};
}

} // namespace skyseal::keys
