#include "core/link/dummy_link.h"

#include "core/link/steady_now.h"

namespace skyseal::link {

void DummyLink::send(const Address &to, ByteView block)
{
    Bytes copy(block.begin(), block.end());
    const ReceivedBlock received{{id(), to}, copy, steadyNow()};
    listener().linkReceived(*this, {&received, 1});
}

} // namespace skyseal::link
