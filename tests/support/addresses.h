// Links by their texts, and the ports of addresses that the system chose.
#pragma once

#include "core/link/link_url.h"

#include <QtCore/QString>

#include <cstdint>
#include <string>

namespace skyseal::test {

/// `text` must be a valid link URL.
inline link::LinkUrl urlOf(const std::string &text)
{
    return *link::LinkUrl::parse(text);
}

/// The text of a link URL on this machine.
inline QString loopback(const char *scheme, quint16 port)
{
    return QStringLiteral("%1:127.0.0.1:%2").arg(QLatin1String(scheme)).arg(port);
}

/// Of "127.0.0.1:14550".
inline std::uint16_t portOf(const std::string &address)
{
    return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

} // namespace skyseal::test
