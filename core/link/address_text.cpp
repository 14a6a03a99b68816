#include "core/link/address_text.h"

#include <algorithm>
#include <charconv>

namespace skyseal::link {

static constexpr std::array<std::uint8_t, 12> kMappedPrefix{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff};

bool isIpv4(const Address &address)
{
    return std::equal(kMappedPrefix.begin(), kMappedPrefix.end(), address.ip.begin());
}

bool isSameHost(const Address &a, const Address &b)
{
    return isIpv4(a) == isIpv4(b) && std::equal(a.ip.begin(), a.ip.begin() + (isIpv4(a) ? 16 : 8), b.ip.begin());
}

bool isAnyAddress(const Address &address)
{
    return std::all_of(address.ip.begin() + (isIpv4(address) ? 12 : 0), address.ip.end(), [](auto byte) { return byte == 0; });
}

Address ipv4(std::uint32_t hostOrder, std::uint16_t port)
{
    Address out;
    std::copy(kMappedPrefix.begin(), kMappedPrefix.end(), out.ip.begin());
    for (std::size_t i = 0; i < 4; ++i)
        out.ip[12 + i] = static_cast<std::uint8_t>(hostOrder >> (24 - 8 * i));
    out.port = port;
    return out;
}

Address fromQt(const QHostAddress &host, std::uint16_t port)
{
    // toIPv4Address() alone would also convert :: to 0.0.0.0.
    if (host.protocol() == QAbstractSocket::IPv4Protocol)
        return ipv4(host.toIPv4Address(), port);
    Address out;
    const Q_IPV6ADDR six = host.toIPv6Address();
    std::copy(std::begin(six.c), std::end(six.c), out.ip.begin());
    out.port = port;
    return out;
}

QHostAddress toQt(const Address &address)
{
    if (!isIpv4(address))
        return QHostAddress(address.ip.data());
    quint32 four = 0;
    for (std::size_t i = 12; i < 16; ++i)
        four = four << 8 | address.ip[i];
    return QHostAddress(four);
}

std::string hostText(const Address &address)
{
    return toQt(address).toString().toStdString();
}

std::string toText(const Address &address)
{
    std::string out = hostText(address);
    if (!isIpv4(address))
        out.insert(0, 1, '[').push_back(']');
    return out.append(1, ':').append(std::to_string(address.port));
}

static std::optional<std::uint32_t> parseIpv4(std::string_view text)
{
    std::uint32_t out = 0;
    const char *at = text.data();
    const char *const end = text.data() + text.size();
    for (int part = 0; part < 4; ++part) {
        if (part > 0 && (at == end || *at++ != '.'))
            return std::nullopt;
        std::uint8_t value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || next - at > 3 || (next - at > 1 && *at == '0'))
            return std::nullopt;
        out = out << 8 | value;
        at = next;
    }
    return at == end ? std::optional(out) : std::nullopt;
}

std::optional<Address> parseHost(std::string_view host, std::uint16_t port)
{
    if (const auto four = parseIpv4(host))
        return ipv4(*four, port);
    if (host.find(':') == host.npos || host.find_first_not_of("0123456789abcdefABCDEF:.") != host.npos)
        return std::nullopt;
    QHostAddress six;
    if (!six.setAddress(QString::fromLatin1(host.data(), static_cast<qsizetype>(host.size()))))
        return std::nullopt;
    return fromQt(six, port);
}

std::optional<Address> parseAddress(std::string_view text)
{
    const std::size_t colon = text.rfind(':');
    if (colon == text.npos)
        return std::nullopt;
    std::uint16_t port = 0;
    const char *const end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data() + colon + 1, end, port);
    if (error != std::errc() || next != end)
        return std::nullopt;
    std::string_view host = text.substr(0, colon);
    const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (bracketed)
        host = host.substr(1, host.size() - 2);
    const auto out = parseHost(host, port);
    if (out && bracketed == isIpv4(*out) && host.find(':') == host.npos)
        return std::nullopt;
    if (out && !bracketed && host.find(':') != host.npos)
        return std::nullopt;
    return out;
}

} // namespace skyseal::link
