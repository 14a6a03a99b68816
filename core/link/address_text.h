// Text of transport addresses, and conversion to and from Qt. IPv4 addresses are stored mapped into IPv6 (base/path.h,
// RFC 4291 2.5.5.2) and printed in dotted decimal.
#pragma once

#include "core/base/path.h"

#include <QtNetwork/QHostAddress>

#include <optional>
#include <string>
#include <string_view>

namespace skyseal::link {

/// "1.2.3.4:14550" or "[::1]:14550".
std::string toText(const Address &address);
/// The host part alone: "1.2.3.4" or "::1", without brackets.
std::string hostText(const Address &address);

/// The inverse of toText(); nullopt for any other text. Does not resolve names.
std::optional<Address> parseAddress(std::string_view text);
/// Parses strict dotted decimal IPv4, or an IPv6 literal without brackets and zone, and adds `port`; nullopt otherwise.
std::optional<Address> parseHost(std::string_view host, std::uint16_t port);

bool isIpv4(const Address &address);
/// Ports are ignored. IPv6 addresses of one host may differ in the lower 64 bits (interface identifier, RFC 4291 2.5.1).
bool isSameHost(const Address &a, const Address &b);
/// 0.0.0.0 or ::.
bool isAnyAddress(const Address &address);
Address ipv4(std::uint32_t hostOrder, std::uint16_t port);

Address fromQt(const QHostAddress &host, std::uint16_t port);
QHostAddress toQt(const Address &address);

} // namespace skyseal::link
