#include "core/link/link_url.h"

#include "core/link/address_text.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace skyseal::link {

static constexpr std::uint32_t kSlowBaud = 230400; // telemetry radios; the wire to a companion computer is faster
static constexpr std::size_t kLongestName = 253;   // RFC 1035 2.3.4, in text
static constexpr std::size_t kLongestLabel = 63;

/// Parses one text; offsets into it become the columns of errors.
class LinkUrlParser
{
public:
    static Result<LinkUrl, InputError> parse(std::string_view text, std::string_view unnamedHost,
                                             std::span<const LinkType> types)
    {
        if (text.size() > 4096)
            return errorIn(text, 0, sentence("Reason", "a link URL is at most 4096 characters long"));
        const auto control = std::find_if(text.begin(), text.end(),
                                          [](char c) { return static_cast<unsigned char>(c) < 0x20; });
        if (control != text.end())
            return errorIn(text, static_cast<std::size_t>(control - text.begin()),
                           sentence("Reason", "a link URL cannot hold control characters"));
        const std::size_t colon = text.find(':');
        const LinkType *type = colon == text.npos ? nullptr : findLinkType(text.substr(0, colon), types);
        if (!type)
            return errorIn(text, 0, sentence("Reason", "a link URL starts with %1")(schemes(types)));
        const std::size_t at = colon + 1 + (text.substr(colon + 1, 2) == "//" ? 2 : 0);
        LinkUrlParser parser(text, unnamedHost, *type);
        switch (type->target) {
        case LinkTarget::HostPort: return parser.network(at);
        case LinkTarget::DeviceBaud: return parser.device(at);
        case LinkTarget::File: break;
        }
        return parser.file(at);
    }

private:
    LinkUrlParser(std::string_view text, std::string_view unnamedHost, const LinkType &type)
        : m_text(text), m_unnamedHost(unnamedHost), m_url(type)
    {}

    static std::string schemes(std::span<const LinkType> types)
    {
        std::string out;
        for (const LinkType &type : types)
            out.append(out.empty() ? "" : &type == &types.back() ? " or " : ", ").append(type.scheme).append(1, ':');
        return out;
    }

    static tl::unexpected<InputError> errorIn(std::string_view text, std::size_t at, Reason message)
    {
        return tl::unexpected(InputError{std::move(message), std::string(text.substr(0, 200)), 1, at + 1});
    }

    tl::unexpected<InputError> error(std::size_t at, Reason message) const { return errorIn(m_text, at, std::move(message)); }

    const char *scheme() const { return m_url.type().scheme; }

    /// The value of `digits` if they are one decimal number that fits.
    static std::optional<std::uint32_t> number(std::string_view digits)
    {
        std::uint32_t value = 0;
        const char *const end = digits.data() + digits.size();
        const auto [next, failure] = std::from_chars(digits.data(), end, value);
        return failure == std::errc() && next == end && !digits.empty() ? std::optional(value) : std::nullopt;
    }

    Result<LinkUrl, InputError> device(std::size_t at)
    {
        std::string_view device = m_text.substr(at);
        m_url.m_baud = m_url.type().defaultBaud;
        if (const std::size_t colon = device.rfind(':'); colon != device.npos) {
            const auto baud = number(device.substr(colon + 1));
            if (!baud || *baud < 300 || *baud > 12'000'000)
                return error(at + colon + 1, sentence("Reason", "the baud rate is a number from 300 to 12000000"));
            m_url.m_baud = *baud;
            device = device.substr(0, colon);
        }
        if (device.empty())
            return error(at, sentence("Reason", "the device is missing, as in %1:/dev/ttyUSB0:57600")(scheme()));
        m_url.m_path = device;
        return m_url;
    }

    Result<LinkUrl, InputError> file(std::size_t at)
    {
        if (at == m_text.size())
            return error(at, sentence("Reason", "the file is missing, as in %1:flight.%1")(scheme()));
        m_url.m_path = m_text.substr(at);
        return m_url;
    }

    Result<LinkUrl, InputError> network(std::size_t at)
    {
        const std::string_view rest = m_text.substr(at);
        std::size_t portAt = 0;
        std::string_view host;
        bool bracketed = false;
        if (!rest.empty() && rest.front() == '[') {
            const std::size_t close = rest.find(']');
            if (close == rest.npos)
                return error(at, sentence("Reason", "the IPv6 address lacks its closing bracket"));
            host = rest.substr(1, close - 1);
            bracketed = true;
            if (close + 1 >= rest.size() || rest[close + 1] != ':')
                return error(at + close + 1, missingPort());
            portAt = close + 2;
        } else {
            const std::size_t colon = rest.find(':');
            if (colon == rest.npos) {
                // The URL of a listening link may consist of its port alone.
                if (!m_url.isListening() || rest.empty() || rest.find_first_not_of("0123456789") != rest.npos)
                    return error(m_text.size(), missingPort());
            } else {
                host = rest.substr(0, colon);
                portAt = colon + 1;
                if (rest.find(':', portAt) != rest.npos)
                    return error(at, sentence("Reason", "an IPv6 address must be in brackets, as in [::1]:14550"));
            }
        }
        if (const auto failed = takeHost(at, host, bracketed))
            return tl::unexpected(*failed);
        return takePort(at + portAt, rest.substr(portAt));
    }

    Reason missingPort() const { return sentence("Reason", "the port is missing, as in %1")(m_url.type().syntax()); }

    std::optional<InputError> takeHost(std::size_t at, std::string_view host, bool bracketed)
    {
        const auto literal = parseHost(host, 0);
        if (bracketed) {
            if (host.find('%') != host.npos)
                return error(at, sentence("Reason", "an IPv6 address with a zone (%) is not supported")).value();
            if (!literal || host.find(':') == host.npos)
                return error(at, sentence("Reason", "\"%1\" is not an IPv6 address")(std::string(host))).value();
        } else if (host.empty()) {
            if (!m_url.isListening())
                return error(at, sentence("Reason", "the host is missing, as in %1")(m_url.type().syntax())).value();
            m_url.m_host = m_unnamedHost;
            return std::nullopt;
        } else if (!literal) {
            if (host.find_first_not_of("0123456789.") == host.npos)
                return error(at, sentence("Reason", "\"%1\" is not an IPv4 address")(std::string(host))).value();
            if (!isHostName(host))
                return error(at, sentence("Reason", "\"%1\" is not a host name or address")(std::string(host.substr(0, 60))))
                    .value();
        }
        m_url.m_host = literal ? hostText(*literal) : std::string(host);
        return std::nullopt;
    }

    static bool isNameCharacter(char c)
    {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    }

    /// Labels with dots between them, and perhaps one at the end (RFC 1123 2.1; underscores occur in local networks).
    static bool isHostName(std::string_view host)
    {
        if (host.size() > kLongestName)
            return false;
        if (host.ends_with('.'))
            host.remove_suffix(1);
        for (bool last = false; !last;) {
            const std::size_t dot = host.find('.');
            const std::string_view label = host.substr(0, dot);
            if (label.empty() || label.size() > kLongestLabel || label.front() == '-' || label.back() == '-'
                || !std::all_of(label.begin(), label.end(), isNameCharacter))
                return false;
            last = dot == host.npos;
            host.remove_prefix(last ? host.size() : dot + 1);
        }
        return true;
    }

    Result<LinkUrl, InputError> takePort(std::size_t at, std::string_view digits)
    {
        const std::uint32_t lowest = m_url.isListening() ? 0 : 1;
        const auto port = number(digits);
        if (digits.empty())
            return error(at, missingPort());
        if (!port || *port > 65535 || *port < lowest)
            return error(at,
                         sentence("Reason", "the port \"%1\" is not a number from %2 to 65535")(
                             std::string(digits.substr(0, 20)), lowest));
        m_url.m_port = static_cast<std::uint16_t>(*port);
        return m_url;
    }

    std::string_view m_text;
    std::string_view m_unnamedHost;
    LinkUrl m_url;
};

Result<LinkUrl, InputError> LinkUrl::parse(std::string_view text, std::string_view unnamedHost, std::span<const LinkType> types)
{
    return LinkUrlParser::parse(text, unnamedHost, types);
}

std::string LinkUrl::ofRecording(std::string_view file)
{
    const auto types = linkTypes();
    const auto type = std::find_if(types.begin(), types.end(), [](const LinkType &each) { return each.traits.isRecording; });
    return std::string(type->scheme) + ':' + std::string(file);
}

LinkTraits LinkUrl::traits() const
{
    LinkTraits out = m_type->traits;
    out.isSlow = m_type->target == LinkTarget::DeviceBaud && m_baud <= kSlowBaud;
    return out;
}

/// nullopt for a host name.
static std::optional<Address> literalAddress(const LinkUrl &url)
{
    return parseHost(url.host() == "localhost" ? LinkUrl::kLoopback : std::string_view(url.host()), url.port());
}

bool LinkUrl::reaches(const LinkUrl &listening) const
{
    if (isListening() || !listening.isListening() || traits().isStream != listening.traits().isStream)
        return false;
    const auto target = literalAddress(*this), bound = literalAddress(listening);
    if (!target || !bound || target->port != bound->port || isIpv4(*target) != isIpv4(*bound))
        return false;
    const auto isLocal = [](const Address &address) { return isAnyAddress(address) || toQt(address).isLoopback(); };
    return target->ip == bound->ip || ((isAnyAddress(*target) || isAnyAddress(*bound)) && isLocal(*target) && isLocal(*bound));
}

bool LinkUrl::sharesPort(const LinkUrl &other) const
{
    if (!isListening() || !other.isListening() || traits().isStream != other.traits().isStream)
        return false;
    const auto one = literalAddress(*this), two = literalAddress(other);
    return one && two && one->port != 0 && one->port == two->port && isIpv4(*one) == isIpv4(*two)
        && (one->ip == two->ip || isAnyAddress(*one) || isAnyAddress(*two));
}

std::string LinkUrl::toText() const
{
    const std::string scheme = std::string(m_type->scheme) + ':';
    // A path that starts with two slashes needs the long spelling, or they would be taken for it.
    const std::string path = (m_path.starts_with("//") ? "//" : "") + m_path;
    switch (m_type->target) {
    case LinkTarget::DeviceBaud: return scheme + path + ':' + std::to_string(m_baud);
    case LinkTarget::File: return scheme + path;
    case LinkTarget::HostPort: break;
    }
    const bool isIpv6 = m_host.find(':') != m_host.npos;
    return scheme + (isIpv6 ? '[' + m_host + ']' : m_host) + ':' + std::to_string(m_port);
}

} // namespace skyseal::link
