#include "core/log/open_log.h"

#include <filesystem>

namespace skyseal::tlog {

Result<std::ifstream, std::string> openLog(const std::string &path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return tl::unexpected(error ? error.message() : "it is not a file");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return tl::unexpected(std::string("permission denied"));
    return file;
}

} // namespace skyseal::tlog
