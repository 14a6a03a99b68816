// What a person writes to name a link: udpin:HOST:PORT, udpout:HOST:PORT, tcp:HOST:PORT, tcpin:HOST:PORT,
// serial:/dev/NAME:BAUD, tlog:FILE; each also with "//" after the scheme.
#pragma once

#include "core/base/result.h"
#include "core/link/link_traits.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace skyseal::link {

enum class LinkScheme : std::uint8_t { UdpIn, UdpOut, Tcp, TcpIn, Serial, Tlog };

/// "udpin", "udpout", …
const char *name(LinkScheme scheme);

/// A link that can at least be tried: its existence proves that the text was well formed.
class LinkUrl
{
public:
    /// IPv6 literals stand in brackets. What may be left out: the host of a listening link ("udpin:14550" listens on
    /// `unnamedHost`) and the baud rate of a serial one (57600). Port 0 of a listening link lets the system choose.
    /// The error's column points at the part of `text` that is wrong.
    static Result<LinkUrl, InputError> parse(std::string_view text, std::string_view unnamedHost = kAnyHost);

    /// Where a listening link listens when no host is named: a station hears its vehicles on every interface; the clear side
    /// of an agent is for programs of the same machine.
    static constexpr std::string_view kAnyHost = "0.0.0.0";
    static constexpr std::string_view kLoopback = "127.0.0.1";

    LinkScheme scheme() const { return m_scheme; }
    LinkTraits traits() const;
    bool isListening() const { return traits().isListening; }
    /// Name or address without brackets; empty for serial and tlog.
    const std::string &host() const { return m_host; }
    std::uint16_t port() const { return m_port; }
    /// Device of a serial link, file of a log; empty for the others.
    const std::string &path() const { return m_path; }
    std::uint32_t baud() const { return m_baud; }

    /// The same link on another port, to offer when one is taken.
    LinkUrl withPort(std::uint16_t port) const;
    /// The one canonical spelling; parses back to an equal value.
    std::string toText() const;

    bool operator==(const LinkUrl &) const = default;

private:
    friend class LinkUrlParser;
    LinkUrl() = default;

    LinkScheme m_scheme = LinkScheme::UdpIn;
    std::uint16_t m_port = 0;
    std::uint32_t m_baud = 0;
    std::string m_host;
    std::string m_path;
};

} // namespace skyseal::link
