#include "core/engine/agent/vehicle_key.h"

#include "core/base/secret_bytes.h"
#include "core/keys/file_io.h"
#include "core/mavlink/signing_key.h"

#include <sodium.h>

#include <array>

namespace skyseal::engine {

Result<VehicleKey, InputError> readVehicleKey(const std::string &path)
{
    auto content = keys::readFile(path, keys::FileAccess::Private);
    if (!content)
        return tl::unexpected(content.error());
    auto key = mavlink::parseSigningKey(*content, path);
    wipeSecret(*content);
    if (!key)
        return tl::unexpected(key.error());
    if (key->isZero())
        return tl::unexpected(InputError{"a key of zeros switches signing off", path});
    auto times = keys::SigningTimeFile::open(signingTimeFile(path));
    if (!times)
        return tl::unexpected(times.error());
    return VehicleKey{std::move(*key), std::move(*times)};
}

Result<void, InputError> writeNewVehicleKey(const std::string &path, RandomSource &random)
{
    Key32 key;
    random.fill(key.mutableView());
    std::array<char, 2 * Key32::size() + 1> text; // with the terminating zero, which is replaced by a newline
    sodium_bin2hex(text.data(), text.size(), key.view().data(), Key32::size());
    text.back() = '\n';
    auto written = keys::createFile(path, asBytes({text.data(), text.size()}));
    wipeSecret(text.data(), text.size());
    return written;
}

} // namespace skyseal::engine
