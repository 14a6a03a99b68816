#include "core/engine/common/sealed_systems.h"

#include "core/base/hex.h"
#include "core/keys/file_io.h"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace skyseal::engine {

Result<SealedSystems, InputError> readSealedSystems(const std::string &path)
{
    SealedSystems out;
    if (!keys::fileExists(path))
        return out;
    const auto bytes = keys::readFile(path, keys::FileAccess::Trusted);
    if (!bytes)
        return tl::unexpected(bytes.error());
    std::istringstream text{std::string(asText(*bytes))};
    std::size_t number = 0;
    for (std::string line; std::getline(text, line);) {
        ++number;
        const std::size_t blank = line.find(' ');
        unsigned system = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + std::min(blank, line.size()), system);
        const auto key = blank == std::string::npos ? std::nullopt : fromHex(std::string_view(line).substr(blank + 1));
        if (error != std::errc() || end != line.data() + blank || system > 255 || !key
            || key->size() != channel::PublicKey{}.size())
            return tl::unexpected(
                InputError{sentence("Reason", "a system ID and a public key in hex are expected"), path, number, 1});
        channel::PublicKey peer{};
        std::copy(key->begin(), key->end(), peer.begin());
        out[peer].set(system);
    }
    return out;
}

Result<void, InputError> writeSealedSystems(const std::string &path, const SealedSystems &systems)
{
    std::string text;
    for (const auto &[peer, spoken] : systems) {
        for (std::size_t system = 0; system < spoken.size(); ++system) {
            if (spoken.test(system))
                text += std::to_string(system) + " " + toHex(peer) + "\n";
        }
    }
    return keys::replaceFile(path, asBytes(text));
}

} // namespace skyseal::engine
