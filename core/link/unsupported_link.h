// Link of a type that is not in this build (serial without Qt SerialPort): open() fails with NotSupported.
#pragma once

#include "core/link/link.h"

namespace skyseal::link {

class UnsupportedLink final : public Link
{
    Q_OBJECT

public:
    using Link::Link;

    void open() override
    {
        setState(LinkState::Failed,
                 {LinkErrorCode::NotSupported, url().toText(),
                  std::string("this program was built without ") + url().type().scheme + " links"});
    }
    void close() override { setState(LinkState::Closed); }
    void send(const Address &, ByteView) override { ++m_counters.txDropped; }
    void flush() override {}
};

} // namespace skyseal::link
