// Any bytes as a dialect definition of a user: read or refused, soon and without harm.
#include "core/mavlink/user_dialect.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

using namespace skyseal::mavlink;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const std::string kFile =
        (std::filesystem::temp_directory_path() / ("dialect_fuzz_" + std::to_string(getpid()) + ".xml")).string();
    std::ofstream(kFile, std::ios::binary).write(reinterpret_cast<const char *>(data), static_cast<std::streamsize>(size));
    const auto dialect = loadUserDialect(kFile);
    std::filesystem::remove(kFile);
    if (!dialect)
        return dialect.error().message.empty() ? std::abort(), 0 : 0;
    for (const MessageInfo &message : dialect->messages()) {
        if (dialect->find(message.id) != &message || message.minLength > message.maxLength)
            std::abort();
        for (const FieldInfo &field : message.fields) {
            if (field.offset + field.size() > message.maxLength)
                std::abort();
        }
    }
    return 0;
}
