// Receives the frames of one link that carries MAVSec's published encryption (mavsec_stream.h), decrypts them, and passes
// them on. Such a link has its own sink, so that no other link needs a check for it. I/O thread.
#pragma once

#include "core/engine/common/ingress.h"
#include "core/engine/common/mavsec_stream.h"

#include <functional>

namespace skyseal::engine {

class MavsecSink final : public IngressSink
{
public:
    using Deliver = std::function<void(const link::ReceivedBlock &, const mavlink::Frame &)>;

    /// `deliver` receives the decrypted frames; `rest`, which must outlive this object, everything else.
    MavsecSink(MavsecStream stream, IngressSink &rest, Deliver deliver)
        : m_stream(std::move(stream)), m_rest(rest), m_deliver(std::move(deliver))
    {}

    void takeClear(const link::Link &link, const link::ReceivedBlock &block, const mavlink::ScanItem &item) override
    {
        if (item.frame)
            m_deliver(block, m_stream.open(*item.frame));
        else
            m_rest.takeClear(link, block, item);
    }
    void takeUnusable(const link::Link &link, Unusable what) override { m_rest.takeUnusable(link, what); }

private:
    MavsecStream m_stream;
    IngressSink &m_rest;
    Deliver m_deliver;
};

} // namespace skyseal::engine
