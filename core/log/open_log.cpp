#include "core/log/open_log.h"

#include <filesystem>

namespace skyseal::tlog {

Result<std::ifstream, Reason> openLog(const std::string &path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return tl::unexpected(error ? Reason(error.message()) : sentence("Reason", "it is not a file"));
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return tl::unexpected(Reason(sentence("Reason", "permission denied")));
    return file;
}

} // namespace skyseal::tlog
