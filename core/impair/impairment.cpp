#include "core/impair/impairment.h"

#include <algorithm>

namespace skyseal::impair {

Impairment::Impairment(const ImpairmentSettings &settings, std::uint64_t stream)
    : m_settings(settings), m_random(settings.seed * 0x9e3779b97f4a7c15u + stream * 0xd1b54a32d192ed03u)
{}

double Impairment::uniform()
{
    // SplitMix64 (Steele, Lea, Flood 2014): unlike the distributions of std, the same on every platform.
    std::uint64_t z = m_random += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

static Duration scaled(Duration duration, double factor)
{
    return Duration(static_cast<Duration::rep>(static_cast<double>(duration.count()) * factor));
}

Treatment Impairment::push(TimePoint now, ByteView datagram)
{
    const bool lost = uniform() < m_settings.loss;
    const bool duplicated = uniform() < m_settings.duplicate;
    const bool heldBack = uniform() < m_settings.reorder;
    const bool corrupted = uniform() < m_settings.corrupt;
    const double where = uniform();
    const unsigned holdFor = 1 + static_cast<unsigned>(uniform() * 3);
    const Duration jitter = scaled(m_settings.jitter, uniform());
    const Duration copyJitter = scaled(m_settings.jitter, uniform());

    Treatment treatment{m_counters.offered++, datagram.size()};
    m_counters.offeredBytes += datagram.size();
    if (lost) {
        treatment.fate = Treatment::Fate::Lost;
        ++m_counters.lost;
        return treatment;
    }
    const TimePoint onLine = takeLine(now, datagram.size());
    if (onLine == kNever || m_counters.waiting + 2 > kMostWaiting) {
        treatment.fate = Treatment::Fate::QueueFull;
        ++m_counters.queueFull;
        return treatment;
    }
    const TimePoint deadline = onLine + m_settings.delay + jitter;
    treatment.duplicated = duplicated;
    treatment.heldBack = heldBack;
    treatment.corrupted = corrupted && !datagram.empty();
    m_counters.duplicated += duplicated;
    m_counters.heldBack += heldBack;
    m_counters.corrupted += treatment.corrupted;

    if (treatment.corrupted) {
        // Before the copies are made: both carry the same damage.
        const auto bit = static_cast<std::size_t>(where * static_cast<double>(datagram.size() * 8));
        m_damaged.assign(datagram.begin(), datagram.end());
        m_damaged[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
        datagram = m_damaged;
    }
    enqueue(deadline, datagram, treatment.sequence, heldBack ? holdFor : 0);
    if (duplicated)
        enqueue(onLine + m_settings.delay + copyJitter, datagram, treatment.sequence, 0);
    releaseHeld(deadline, treatment.sequence);
    return treatment;
}

TimePoint Impairment::takeLine(TimePoint now, std::size_t bytes)
{
    if (m_settings.baud == 0)
        return now;
    const double secondsPerByte = 10.0 / static_cast<double>(m_settings.baud);
    const auto lineTime = [&](std::size_t count) {
        return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(static_cast<double>(count) * secondsPerByte));
    };
    const TimePoint start = std::max(now, m_lineFree);
    if (start - now > lineTime(m_settings.lineQueueBytes))
        return kNever;
    m_lineFree = start + lineTime(bytes);
    return m_lineFree;
}

void Impairment::enqueue(TimePoint deadline, ByteView bytes, std::uint64_t sequence, unsigned holdFor)
{
    if (m_free.empty()) {
        m_free.push_back(m_slots.size());
        m_slots.emplace_back();
    }
    const std::size_t index = m_free.back();
    m_free.pop_back();
    Slot &slot = m_slots[index];
    slot.bytes.assign(bytes.begin(), bytes.end());
    slot.sequence = sequence;
    slot.order = m_order++;
    slot.deadline = deadline;
    slot.holdFor = holdFor;
    ++m_counters.waiting;
    if (holdFor > 0)
        m_held.push_back(index);
    else
        intoHeap(index);
}

void Impairment::releaseHeld(TimePoint deadline, std::uint64_t newest)
{
    std::erase_if(m_held, [&](std::size_t index) {
        Slot &slot = m_slots[index];
        if (slot.sequence == newest)
            return false;
        slot.deadline = std::max(slot.deadline, deadline);
        if (--slot.holdFor > 0)
            return false;
        slot.order = m_order++;
        intoHeap(index);
        return true;
    });
}

bool Impairment::later(std::size_t a, std::size_t b) const
{
    const Slot &left = m_slots[a];
    const Slot &right = m_slots[b];
    return left.deadline != right.deadline ? left.deadline > right.deadline : left.order > right.order;
}

void Impairment::intoHeap(std::size_t slot)
{
    m_heap.push_back(slot);
    std::push_heap(m_heap.begin(), m_heap.end(), [this](std::size_t a, std::size_t b) { return later(a, b); });
}

TimePoint Impairment::nextDeadline() const
{
    TimePoint out = m_heap.empty() ? kNever : m_slots[m_heap.front()].deadline;
    for (const std::size_t held : m_held)
        out = std::min(out, m_slots[held].deadline + kLongestHold);
    return out;
}

bool Impairment::pop(TimePoint now, Delivery &out)
{
    std::erase_if(m_held, [&](std::size_t index) {
        Slot &slot = m_slots[index];
        if (slot.deadline + kLongestHold > now)
            return false;
        slot.deadline += kLongestHold;
        intoHeap(index);
        return true;
    });
    if (m_heap.empty() || m_slots[m_heap.front()].deadline > now)
        return false;
    std::pop_heap(m_heap.begin(), m_heap.end(), [this](std::size_t a, std::size_t b) { return later(a, b); });
    const std::size_t index = m_heap.back();
    m_heap.pop_back();
    // `out` views the slot's bytes, which stay until the slot is used again.
    m_free.push_back(index);
    const Slot &slot = m_slots[index];
    --m_counters.waiting;
    ++m_counters.delivered;
    m_counters.deliveredBytes += slot.bytes.size();
    m_counters.outOfOrder += slot.sequence < m_newestOut;
    m_newestOut = std::max(m_newestOut, slot.sequence);
    out = {slot.sequence, slot.bytes};
    return true;
}

} // namespace skyseal::impair
