#include "app/common/config_file.h"

#include "core/base/printable.h"
#include "core/keys/file_io.h"

namespace skyseal::app {

namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(kBlanks);
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

} // namespace

Result<std::vector<ConfigLine>, InputError> parseConfig(std::string_view text, const std::string &source)
{
    std::vector<ConfigLine> out;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.empty() || line.front() == '#')
            continue;
        const auto wrong = [&](std::string problem) {
            return tl::unexpected(InputError{std::move(problem), source, number, 0});
        };
        if (!isPrintable(line))
            return wrong("control characters or invalid UTF-8");
        const std::size_t equals = line.find('=');
        const std::string_view name = trimmed(line.substr(0, equals));
        if (equals == std::string_view::npos || name.empty())
            return wrong("NAME = VALUE is expected");
        out.push_back({number, std::string(name), std::string(trimmed(line.substr(equals + 1)))});
    }
    return out;
}

Result<std::vector<ConfigLine>, InputError> readConfig(const std::string &path)
{
    const auto content = keys::readFile(path, keys::FileAccess::Trusted);
    if (!content)
        return tl::unexpected(content.error());
    return parseConfig({reinterpret_cast<const char *>(content->data()), content->size()}, path);
}

} // namespace skyseal::app
