// The text that names a link: SCHEME:HOST:PORT, SCHEME:DEVICE:BAUD or SCHEME:FILE, by the table of link types; also
// with "//" after the scheme.
#pragma once

#include "core/base/result.h"
#include "core/link/link_type.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace skyseal::link {

/// A well-formed link URL. Plain value.
class LinkUrl
{
public:
    /// IPv6 literals stand in brackets. Optional parts: the host of a listening link ("udpin:14550" listens on
    /// `unnamedHost`) and the baud rate of a serial link (the type's default). With port 0 on a listening link, the system
    /// chooses the port. The error's column points at the invalid part of `text`. The URL refers to its row of `types`, which
    /// must outlive it.
    static Result<LinkUrl, InputError> parse(std::string_view text, std::string_view unnamedHost = kAnyHost,
                                             std::span<const LinkType> types = linkTypes());

    /// Hosts for a listening link whose URL has none: all interfaces for a station, which waits for vehicles; the loopback
    /// interface for the plain side of an agent.
    static constexpr std::string_view kAnyHost = "0.0.0.0";
    static constexpr std::string_view kLoopback = "127.0.0.1";

    /// The text of a URL that replays the recording `file`; parse() checks it.
    static std::string ofRecording(std::string_view file);

    const LinkType &type() const { return *m_type; }
    LinkTraits traits() const;
    bool isListening() const { return m_type->traits.isListening; }
    /// Whether what this link sends arrives at `listening`, a link of the same machine. Of host names, only localhost is known.
    bool reaches(const LinkUrl &listening) const;
    /// Whether both listen on one port of this machine, so that only one of them can be opened.
    bool sharesPort(const LinkUrl &other) const;
    /// Name or address without brackets; empty unless the target is HostPort.
    const std::string &host() const { return m_host; }
    std::uint16_t port() const { return m_port; }
    /// Device or file; empty when the target is HostPort.
    const std::string &path() const { return m_path; }
    /// Bit/s; 0 unless the target is DeviceBaud.
    std::uint32_t baud() const { return m_baud; }

    /// The canonical spelling; parses back to an equal value.
    std::string toText() const;

    bool operator==(const LinkUrl &) const = default;

private:
    friend class LinkUrlParser;
    explicit LinkUrl(const LinkType &type) : m_type(&type) {}

    const LinkType *m_type;
    std::uint16_t m_port = 0;
    std::uint32_t m_baud = 0;
    std::string m_host;
    std::string m_path;
};

} // namespace skyseal::link
