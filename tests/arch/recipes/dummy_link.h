// Example of a link type, for recipes_test: whatever is sent comes back. It is no part of the product.
#pragma once

#include "core/link/link.h"

namespace skyseal::link {

class DummyLink final : public Link
{
public:
    using Link::Link;

    void open() override { setState(LinkState::Connected); }
    void close() override { setState(LinkState::Closed); }
    void send(const Address &to, ByteView block) override;
    void flush() override {}
};

} // namespace skyseal::link
