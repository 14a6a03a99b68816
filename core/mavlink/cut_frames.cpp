#include "core/mavlink/cut_frames.h"

namespace skyseal::mavlink {

std::array<CutFrames::Sender, CutFrames::kWays> &CutFrames::placesOf(const Path &from)
{
    const Address &remote = from.remote;
    std::size_t hash = static_cast<std::size_t>(from.link) * 31 + remote.port;
    for (std::size_t i = 8; i < remote.ip.size(); ++i)
        hash = hash * 31 + remote.ip[i];
    return m_places[hash % m_places.size()];
}

CutFrames::Sender *CutFrames::findKept(const Path &from)
{
    auto &places = placesOf(from);
    const auto found = std::ranges::find_if(places, [&](const Sender &one) { return one.m_size > 0 && one.m_from == from; });
    return found == places.end() ? nullptr : &*found;
}

/// The place of the sender, or the one that another sender loses to it; null if all of those are in use.
CutFrames::Sender *CutFrames::place(TimePoint now, const Path &from)
{
    auto &places = placesOf(from);
    Sender *idlest = nullptr;
    for (Sender &one : places) {
        if (one.m_used != TimePoint{} && one.m_from == from)
            return &one;
        if (!one.isEstablished(now) && (!idlest || one.m_used < idlest->m_used))
            idlest = &one;
    }
    if (idlest) {
        drop(*idlest);
        idlest->m_from = from;
        idlest->m_completed = {};
        idlest->m_failures = idlest->m_passedOver = 0;
    }
    return idlest;
}

bool CutFrames::keep(TimePoint now, const Path &from, ByteView begin)
{
    constexpr unsigned kMostDoublings = 6;
    Sender *sender = begin.size() <= kLongest ? place(now, from) : nullptr;
    if (!sender)
        return false;
    sender->m_used = now;
    // Bytes in which no frame was found cost another search together with the next datagram.
    if (sender->m_passedOver + 1 < 1U << std::min(sender->m_failures, kMostDoublings)) {
        ++sender->m_passedOver;
        return false;
    }
    sender->m_passedOver = 0;
    extend(now, *sender, begin);
    return true;
}

void CutFrames::extend(TimePoint now, Sender &sender, ByteView begin)
{
    m_kept += sender.m_size == 0;
    sender.m_used = now;
    sender.m_size = begin.size();
    std::ranges::copy(begin, sender.m_bytes.begin());
}

void CutFrames::completed(TimePoint now, Sender &sender)
{
    sender.m_completed = now;
    sender.m_failures = 0;
    drop(sender);
}

void CutFrames::failed(Sender &sender)
{
    ++sender.m_failures;
    drop(sender);
}

void CutFrames::forget(const Path &from)
{
    if (Sender *sender = find(from))
        drop(*sender);
}

void CutFrames::drop(Sender &sender)
{
    m_kept -= sender.m_size > 0;
    sender.m_size = 0;
}

} // namespace skyseal::mavlink
