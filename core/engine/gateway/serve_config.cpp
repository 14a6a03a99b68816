#include "core/engine/gateway/serve_config.h"

#include "core/base/printable.h"
#include "core/link/address_text.h"

#include <QtCore/QString>

#include <charconv>
#include <map>

namespace skyseal::engine {

namespace {

Result<std::bitset<256>, Reason> parseSystems(std::string_view text)
{
    std::bitset<256> out;
    while (true) {
        const std::size_t comma = text.find(',');
        const std::string_view number = text.substr(0, comma);
        unsigned id = 0;
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), id);
        if (error != std::errc() || end != number.data() + number.size() || id < 1 || id > 255)
            return tl::unexpected(sentence("Reason", "sysid='%1': a system ID from 1 to 255 is expected")(std::string(number)));
        out.set(id);
        if (comma == std::string_view::npos)
            return out;
        text.remove_prefix(comma + 1);
    }
}

Result<void, Reason> setOption(ServeConfig &config, std::string_view name, std::string_view value)
{
    if (name == "write") {
        auto rights = WriteRights::parse(value);
        if (!rights)
            return tl::unexpected(rights.error());
        config.write = *rights;
    } else if (name == "sysid") {
        auto systems = parseSystems(value);
        if (!systems)
            return tl::unexpected(systems.error());
        config.systems = *systems;
    } else if (name == "from") {
        config.from = QHostAddress::parseSubnet(QString::fromUtf8(value.data(), static_cast<qsizetype>(value.size())));
        // Qt takes "10" for 10.0.0.0/8.
        if (config.from->second < 0 || !link::parseHost(value.substr(0, value.find('/')), 0))
            return tl::unexpected(sentence("Reason", "from='%1': ADDRESS/PREFIX is expected")(std::string(value)));
    } else if (name == "name") {
        if (value.empty() || !isPrintable(value))
            return tl::unexpected(
                sentence("Reason", "name='%1': a name of printable characters is expected")(printable(value)));
        config.name = value;
    } else {
        return tl::unexpected(sentence("Reason", "'%1': write, from, sysid or name is expected")(std::string(name)));
    }
    return {};
}

/// The options after the URL. A part without "=" continues the list of the previous option.
Result<std::map<std::string, std::string>, Reason> splitOptions(std::string_view text)
{
    std::map<std::string, std::string> out;
    std::string *last = nullptr;
    while (true) {
        const std::size_t comma = text.find(',');
        const std::string_view part = text.substr(0, comma);
        const std::size_t equals = part.find('=');
        if (equals != std::string_view::npos) {
            const auto [option, isNew] = out.emplace(part.substr(0, equals), part.substr(equals + 1));
            if (!isNew)
                return tl::unexpected(sentence("Reason", "%1 is given twice")(option->first));
            last = &option->second;
        } else if (last) {
            last->append(",").append(part);
        } else {
            return tl::unexpected(sentence("Reason", "'%1': OPTION=VALUE is expected")(std::string(part)));
        }
        if (comma == std::string_view::npos)
            return out;
        text.remove_prefix(comma + 1);
    }
}

bool isLoopback(const std::string &host)
{
    const auto address = link::parseHost(host, 0);
    return address ? link::toQt(*address).isLoopback() : host == "localhost";
}

} // namespace

Result<ServeConfig, Reason> ServeConfig::parse(std::string_view text, const WriteRights &unnamed)
{
    const std::size_t comma = text.find(',');
    auto url = link::LinkUrl::parse(text.substr(0, comma), link::LinkUrl::kLoopback);
    if (!url)
        return tl::unexpected(url.error().message);
    if (url->type().target != link::LinkTarget::HostPort)
        return tl::unexpected(sentence("Reason", "'%1': clients are served over UDP or TCP")(std::string(url->type().scheme)));
    ServeConfig out{.url = std::move(*url), .write = unnamed};
    if (comma != std::string_view::npos) {
        const auto options = splitOptions(text.substr(comma + 1));
        if (!options)
            return tl::unexpected(options.error());
        for (const auto &[name, value] : *options) {
            if (auto set = setOption(out, name, value); !set)
                return tl::unexpected(set.error());
        }
    }
    if (out.from && !out.url.isListening())
        return tl::unexpected(
            sentence("Reason", "from=: '%1' serves the host of its URL alone; from= is for links that listen")(
                std::string(out.url.type().scheme)));
    if (out.name.empty())
        out.name = out.url.toText();
    return out;
}

bool ServeConfig::isFrom(const Address &remote) const
{
    return !from || link::toQt(remote).isInSubnet(*from);
}

bool ServeConfig::isOpenToOthers() const
{
    return !isLoopback(url.host());
}

} // namespace skyseal::engine
