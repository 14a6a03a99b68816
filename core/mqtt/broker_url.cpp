#include "core/mqtt/broker_url.h"

#include "core/base/printable.h"

#include <arpa/inet.h>

#include <charconv>

namespace skyseal::mqtt {

namespace {

tl::unexpected<InputError> wrong(std::string problem, std::string_view url)
{
    return tl::unexpected(InputError{std::move(problem), printable(url)});
}

/// Takes "HOST", "HOST:PORT" or "[IPV6]:PORT" apart; the port is empty if it was left out. Returns false if brackets do not
/// match.
bool splitHost(std::string_view text, std::string_view &host, std::string_view &port)
{
    port = {};
    if (text.starts_with('[')) {
        const std::size_t end = text.find(']');
        if (end == std::string_view::npos)
            return false;
        host = text.substr(1, end - 1);
        text.remove_prefix(end + 1);
        if (text.starts_with(':'))
            port = text.substr(1);
        return text.empty() || !port.empty();
    }
    const std::size_t colon = text.find(':');
    host = text.substr(0, colon);
    if (colon != std::string_view::npos)
        port = text.substr(colon + 1);
    return colon == std::string_view::npos || !port.empty();
}

bool readPort(std::string_view text, std::uint16_t &port)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    return error == std::errc() && end == text.data() + text.size() && port != 0;
}

/// MQTT 3.1.1, section 4.7: wildcards stand in filters only, and topics that begin with $ are the broker's.
const char *problemOfPrefix(std::string_view prefix)
{
    if (prefix.size() > BrokerUrl::kLongestPrefix)
        return "the prefix of the topics is longer than 128 bytes";
    if (!isPrintable(prefix) || prefix.find_first_of("+# ?") != std::string_view::npos)
        return "the prefix of the topics may hold printable characters without spaces, '+', '#' and '?'";
    if (prefix.starts_with('$') || prefix.starts_with('/') || prefix.ends_with('/')
        || prefix.find("//") != std::string_view::npos)
        return "the prefix of the topics begins with '$', or has an empty level";
    return nullptr;
}

} // namespace

Result<BrokerUrl, InputError> BrokerUrl::parse(std::string_view text)
{
    BrokerUrl out;
    std::string_view rest = text;
    if (rest.starts_with("mqtts://")) {
        rest.remove_prefix(8);
    } else if (rest.starts_with("mqtt://")) {
        rest.remove_prefix(7);
        out.tls = false;
        out.port = kPort;
    } else {
        return wrong("mqtts://HOST[:PORT][/PREFIX] is expected, or mqtt:// without TLS", text);
    }
    const std::size_t slash = rest.find('/');
    const std::string_view authority = rest.substr(0, slash);
    if (authority.find('@') != std::string_view::npos)
        return wrong("the user and the password belong into the file of --mqtt-login", "mqtt URL");
    std::string_view host, port;
    if (!splitHost(authority, host, port) || host.empty() || !isPrintable(host) || host.find(' ') != std::string_view::npos)
        return wrong("a host is expected behind ://, and [ ] around an IPv6 address", text);
    if (!port.empty() && !readPort(port, out.port))
        return wrong("a port from 1 to 65535 is expected", text);
    out.host = host;
    if (slash == std::string_view::npos || slash + 1 == rest.size())
        return out;
    const std::string_view prefix = rest.substr(slash + 1);
    if (const char *problem = problemOfPrefix(prefix))
        return wrong(problem, text);
    out.prefix = prefix;
    return out;
}

std::string BrokerUrl::toText() const
{
    const bool isIpv6 = host.find(':') != std::string::npos;
    return (tls ? "mqtts://" : "mqtt://") + (isIpv6 ? '[' + host + ']' : host) + ':' + std::to_string(port) + '/' + prefix;
}

bool BrokerUrl::isLoopback() const
{
    in_addr v4{};
    in6_addr v6{};
    if (::inet_pton(AF_INET, host.c_str(), &v4) == 1)
        return (ntohl(v4.s_addr) >> 24) == 127;
    if (::inet_pton(AF_INET6, host.c_str(), &v6) == 1)
        return IN6_IS_ADDR_LOOPBACK(&v6);
    return host == "localhost";
}

} // namespace skyseal::mqtt
