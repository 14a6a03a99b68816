#include "core/mavlink/cut_frames.h"

namespace skyseal::mavlink {

namespace {

/// Frames with other flags are not read in clear.
bool mayBeRead(ByteView begin)
{
    return begin.size() < 3 || begin[0] != kMagic2 || (begin[2] & ~kFlagSigned) == 0;
}

std::uint64_t hashOf(const Path &from)
{
    const std::array<std::uint8_t, 16> &ip = from.remote.ip;
    const auto end = std::uint64_t(ip[12]) << 24 | std::uint64_t(ip[13]) << 16 | std::uint64_t(ip[14]) << 8 | ip[15];
    return (end ^ std::uint64_t(from.remote.port) << 32 ^ static_cast<std::size_t>(from.link)) * 0x9e3779b97f4a7c15 >> 20;
}

} // namespace

std::span<CutFrames::Sender, CutFrames::kWays> CutFrames::placesOf(std::uint64_t hash)
{
    return std::span(m_senders).subspan(hash % (kSenders / kWays) * kWays).first<kWays>();
}

CutFrames::Sender *CutFrames::findKept(const Path &from)
{
    const std::uint64_t hash = hashOf(from);
    for (Sender &one : placesOf(hash)) {
        if (one.kept > 0 && one.hash == hash && one.from == from)
            return &one;
    }
    return nullptr;
}

/// The place of the sender, or the one that another sender loses to it; null if all of those are in use.
CutFrames::Sender *CutFrames::place(TimePoint now, const Path &from)
{
    const std::uint64_t hash = hashOf(from);
    Sender *idlest = nullptr;
    for (Sender &one : placesOf(hash)) {
        if (one.used != TimePoint{} && one.hash == hash && one.from == from)
            return &one;
        if (!one.isEstablished(now) && (!idlest || one.used < idlest->used))
            idlest = &one;
    }
    if (idlest) {
        drop(*idlest);
        *idlest = {.from = from, .hash = hash};
    }
    return idlest;
}

bool CutFrames::keep(TimePoint now, const Path &from, ByteView begin)
{
    constexpr unsigned kMostDoublings = 6;
    Sender *sender = begin.size() <= kLongest && mayBeRead(begin) ? place(now, from) : nullptr;
    if (!sender)
        return false;
    sender->used = now;
    // Bytes in which no frame was found cost another search together with the next datagram.
    if (sender->passedOver + 1 < 1U << std::min(sender->failures, kMostDoublings)) {
        ++sender->passedOver;
        return false;
    }
    sender->passedOver = 0;
    extend(now, *sender, begin);
    return true;
}

void CutFrames::extend(TimePoint now, Sender &sender, ByteView begin)
{
    m_kept += sender.kept == 0;
    sender.used = now;
    sender.kept = begin.size();
    std::copy_n(begin.data(), begin.size(), bytesOf(sender).data());
}

void CutFrames::completed(TimePoint now, Sender &sender)
{
    sender.completed = now;
    sender.failures = 0;
    drop(sender);
}

void CutFrames::failed(Sender &sender)
{
    ++sender.failures;
    drop(sender);
}

void CutFrames::forget(const Path &from)
{
    if (Sender *sender = find(from))
        drop(*sender);
}

void CutFrames::drop(Sender &sender)
{
    m_kept -= sender.kept > 0;
    sender.kept = 0;
}

} // namespace skyseal::mavlink
