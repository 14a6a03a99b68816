#include "core/link/link_url.h"

#include "core/link/address_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace skyseal::link {

static constexpr std::array kSchemes{LinkScheme::UdpIn, LinkScheme::UdpOut, LinkScheme::Tcp,
                                     LinkScheme::TcpIn, LinkScheme::Serial, LinkScheme::Tlog};
static constexpr std::uint32_t kDefaultBaud = 57600; // what telemetry radios come with
static constexpr std::uint32_t kSlowBaud = 230400;   // telemetry radios; the wire to a companion computer is faster
static constexpr std::size_t kLongestName = 253;     // RFC 1035 2.3.4, in text

const char *name(LinkScheme scheme)
{
    switch (scheme) {
    case LinkScheme::UdpIn: return "udpin";
    case LinkScheme::UdpOut: return "udpout";
    case LinkScheme::Tcp: return "tcp";
    case LinkScheme::TcpIn: return "tcpin";
    case LinkScheme::Serial: return "serial";
    case LinkScheme::Tlog: return "tlog";
    }
    return "";
}

/// One run over one text; offsets into it become the columns of errors.
class LinkUrlParser
{
public:
    LinkUrlParser(std::string_view text, std::string_view unnamedHost) : m_text(text), m_unnamedHost(unnamedHost) {}

    Result<LinkUrl, InputError> run()
    {
        if (m_text.size() > 4096)
            return error(0, "a link URL is at most 4096 characters long");
        const auto odd = std::find_if(m_text.begin(), m_text.end(),
                                      [](char c) { return static_cast<unsigned char>(c) < 0x20; });
        if (odd != m_text.end())
            return error(static_cast<std::size_t>(odd - m_text.begin()), "a link URL cannot hold control characters");
        const std::size_t colon = m_text.find(':');
        const auto scheme = colon == m_text.npos ? std::nullopt : schemeOf(m_text.substr(0, colon));
        if (!scheme)
            return error(0, "a link URL starts with udpin:, udpout:, tcp:, tcpin:, serial: or tlog:");
        m_url.m_scheme = *scheme;
        std::size_t at = colon + 1;
        if (m_text.substr(at, 2) == "//")
            at += 2;
        switch (*scheme) {
        case LinkScheme::Serial: return serial(at);
        case LinkScheme::Tlog: return tlog(at);
        default: return network(at);
        }
    }

private:
    static std::optional<LinkScheme> schemeOf(std::string_view word)
    {
        for (const LinkScheme scheme : kSchemes) {
            const std::string_view known = name(scheme);
            if (std::equal(word.begin(), word.end(), known.begin(), known.end(),
                           [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; }))
                return scheme;
        }
        return std::nullopt;
    }

    tl::unexpected<InputError> error(std::size_t at, std::string message) const
    {
        return tl::unexpected(InputError{std::move(message), std::string(m_text.substr(0, 200)), 1, at + 1});
    }

    /// A whole decimal number of `digits`, or nothing.
    static std::optional<std::uint32_t> number(std::string_view digits)
    {
        std::uint32_t value = 0;
        const char *const end = digits.data() + digits.size();
        const auto [next, failure] = std::from_chars(digits.data(), end, value);
        return failure == std::errc() && next == end && !digits.empty() ? std::optional(value) : std::nullopt;
    }

    Result<LinkUrl, InputError> serial(std::size_t at)
    {
        std::string_view device = m_text.substr(at);
        m_url.m_baud = kDefaultBaud;
        if (const std::size_t colon = device.rfind(':'); colon != device.npos) {
            const auto baud = number(device.substr(colon + 1));
            if (!baud || *baud < 300 || *baud > 12'000'000)
                return error(at + colon + 1, "the baud rate is a number from 300 to 12000000");
            m_url.m_baud = *baud;
            device = device.substr(0, colon);
        }
        if (device.empty())
            return error(at, "the device is missing, as in serial:/dev/ttyUSB0:57600");
        m_url.m_path = device;
        return m_url;
    }

    Result<LinkUrl, InputError> tlog(std::size_t at)
    {
        if (at == m_text.size())
            return error(at, "the file is missing, as in tlog:flight.tlog");
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
                return error(at, "the IPv6 address lacks its closing bracket");
            host = rest.substr(1, close - 1);
            bracketed = true;
            if (close + 1 >= rest.size() || rest[close + 1] != ':')
                return error(at + close + 1, missingPort());
            portAt = close + 2;
        } else {
            const std::size_t colon = rest.find(':');
            if (colon == rest.npos) {
                // A listening link may name its port alone.
                if (!m_url.isListening() || rest.empty() || rest.find_first_not_of("0123456789") != rest.npos)
                    return error(m_text.size(), missingPort());
            } else {
                host = rest.substr(0, colon);
                portAt = colon + 1;
                if (rest.find(':', portAt) != rest.npos)
                    return error(at, "an IPv6 address stands in brackets, as in [::1]:14550");
            }
        }
        if (const auto failed = takeHost(at, host, bracketed))
            return tl::unexpected(*failed);
        return takePort(at + portAt, rest.substr(portAt));
    }

    std::string missingPort() const { return std::string("the port is missing, as in ") + name(m_url.m_scheme) + ":HOST:PORT"; }

    std::optional<InputError> takeHost(std::size_t at, std::string_view host, bool bracketed)
    {
        const auto literal = parseHost(host, 0);
        if (bracketed) {
            if (host.find('%') != host.npos)
                return error(at, "an IPv6 address with a zone (%) is not supported").value();
            if (!literal || host.find(':') == host.npos)
                return error(at, "\"" + std::string(host) + "\" is not an IPv6 address").value();
        } else if (host.empty()) {
            if (!m_url.isListening())
                return error(at, "the host is missing, as in " + std::string(name(m_url.m_scheme)) + ":HOST:PORT").value();
            m_url.m_host = m_unnamedHost;
            return std::nullopt;
        } else if (!literal) {
            if (host.find_first_not_of("0123456789.") == host.npos)
                return error(at, "\"" + std::string(host) + "\" is not an IPv4 address").value();
            if (host.size() > kLongestName || host.front() == '-' || host.front() == '.'
                || !std::all_of(host.begin(), host.end(), isNameCharacter))
                return error(at, "\"" + std::string(host.substr(0, 60)) + "\" is not a host name or address").value();
        }
        m_url.m_host = literal ? hostText(*literal) : std::string(host);
        return std::nullopt;
    }

    static bool isNameCharacter(char c)
    {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
    }

    Result<LinkUrl, InputError> takePort(std::size_t at, std::string_view digits)
    {
        const std::uint32_t lowest = m_url.isListening() ? 0 : 1;
        const auto port = number(digits);
        if (digits.empty())
            return error(at, missingPort());
        if (!port || *port > 65535 || *port < lowest)
            return error(at,
                         "the port \"" + std::string(digits.substr(0, 20)) + "\" is not a number from " + std::to_string(lowest)
                             + " to 65535");
        m_url.m_port = static_cast<std::uint16_t>(*port);
        return m_url;
    }

    std::string_view m_text;
    std::string_view m_unnamedHost;
    LinkUrl m_url;
};

Result<LinkUrl, InputError> LinkUrl::parse(std::string_view text, std::string_view unnamedHost)
{
    return LinkUrlParser(text, unnamedHost).run();
}

LinkTraits LinkUrl::traits() const
{
    switch (m_scheme) {
    case LinkScheme::UdpIn: return {.isListening = true};
    case LinkScheme::UdpOut: return {.hasOneRemote = true};
    case LinkScheme::Tcp: return {.isStream = true, .hasOneRemote = true};
    case LinkScheme::TcpIn: return {.isStream = true, .isListening = true};
    case LinkScheme::Serial: return {.isStream = true, .hasOneRemote = true, .isSlow = m_baud <= kSlowBaud};
    case LinkScheme::Tlog: return {.isRecording = true};
    }
    return {};
}

LinkUrl LinkUrl::withPort(std::uint16_t port) const
{
    LinkUrl out = *this;
    out.m_port = port;
    return out;
}

std::string LinkUrl::toText() const
{
    std::string out = name(m_scheme);
    out += ':';
    if (m_scheme == LinkScheme::Serial || m_scheme == LinkScheme::Tlog) {
        // A path that itself starts with two slashes needs the long spelling, or they would be taken for it.
        out += m_path.starts_with("//") ? "//" : "";
        out += m_path;
        if (m_scheme == LinkScheme::Serial)
            out.append(1, ':').append(std::to_string(m_baud));
        return out;
    }
    const bool ipv6 = m_host.find(':') != m_host.npos;
    out += ipv6 ? "[" : "";
    out += m_host;
    out += ipv6 ? "]:" : ":";
    return out.append(std::to_string(m_port));
}

} // namespace skyseal::link
