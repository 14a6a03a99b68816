// A link without traffic of its own, for tests that hand in what it would have received.
#pragma once

#include "core/link/link.h"
#include "tests/support/addresses.h"

#include <string>

namespace skyseal::test {

class IdleLink final : public link::Link, private link::LinkListener
{
public:
    IdleLink(const std::string &url, LinkId id) : Link(urlOf(url), id, *this, {}) {}
    void open() override {}
    void close() override {}
    void send(const Address &, ByteView) override {}
    void flush() override {}

private:
    void linkReceived(link::Link &, std::span<const link::ReceivedBlock>) override {}
};

} // namespace skyseal::test
