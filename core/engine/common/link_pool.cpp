#include "core/engine/common/link_pool.h"

#include "core/link/address_text.h"
#include "core/link/make_link.h"

#include <algorithm>
#include <utility>

namespace skyseal::engine {

namespace {

LinkPhase phaseOf(link::LinkState state)
{
    switch (state) {
    case link::LinkState::Closed: return LinkPhase::Closed;
    case link::LinkState::Opening: return LinkPhase::Opening;
    case link::LinkState::Listening: return LinkPhase::Listening;
    case link::LinkState::Connected: return LinkPhase::Connected;
    case link::LinkState::Waiting: return LinkPhase::Waiting;
    case link::LinkState::Failed: return LinkPhase::Failed;
    case link::LinkState::Ended: return LinkPhase::Finished;
    }
    return LinkPhase::Failed;
}

} // namespace

LinkPool::LinkPool(link::LinkListener &listener, StateChanged stateChanged, link::LinkOptions options)
    : m_listener(listener), m_stateChanged(std::move(stateChanged)), m_options(options)
{}

LinkPool::~LinkPool()
{
    // The owner is being destroyed: it must not be called any more, and the event loop may never run again.
    for (Entry &entry : m_entries) {
        entry.link->disconnect();
        delete entry.link.release();
    }
}

link::Link &LinkPool::open(LinkId id, const link::LinkUrl &url, LinkUse use)
{
    Entry fresh;
    fresh.use = use;
    fresh.link.reset(link::makeLink(url, id, m_listener, m_options).release());
    link::Link *link = fresh.link.get();
    m_entries.push_back(std::move(fresh));
    QObject::connect(link, &link::Link::stateChanged, link, [this, link] { m_stateChanged(*link); });
    link->open();
    return *link;
}

void LinkPool::remove(LinkId id)
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [id](const Entry &e) { return e.link->id() == id; });
    if (found == m_entries.end())
        return;
    found->link->flush();
    found->link->close();
    found->link->disconnect();
    m_badFramesOfRemoved += found->badCrc;
    m_entries.erase(found);
}

const LinkPool::Entry *LinkPool::entry(LinkId id) const
{
    for (const Entry &candidate : m_entries) {
        if (candidate.link->id() == id)
            return &candidate;
    }
    return nullptr;
}

LinkPool::Entry *LinkPool::entry(LinkId id)
{
    return const_cast<Entry *>(std::as_const(*this).entry(id));
}

link::Link *LinkPool::find(LinkId id) const
{
    const Entry *found = entry(id);
    return found ? found->link.get() : nullptr;
}

bool LinkPool::isListenOnly(LinkId id) const
{
    const Entry *found = entry(id);
    return found && found->use == LinkUse::ListenOnly;
}

void LinkPool::send(const Path &to, ByteView block)
{
    Entry *target = entry(to.link);
    if (!target || target->use != LinkUse::Both)
        return;
    m_carriers.write(to, block, [&](ByteView bytes) { target->link->send(to.remote, bytes); });
    target->dirty = true;
}

bool LinkPool::isSlow(const Path &path) const
{
    if (path.carrier == Carrier::Tunnel)
        return true;
    const link::Link *link = path.carrier == Carrier::Serial ? find(path.link) : nullptr;
    return link && link->traits().isSlow;
}

void LinkPool::flush()
{
    for (Entry &candidate : m_entries) {
        if (candidate.dirty) {
            candidate.dirty = false;
            candidate.link->flush();
        }
    }
}

void LinkPool::noteRemote(LinkId id, const Address &remote)
{
    if (Entry *from = entry(id))
        from->remote = remote;
}

void LinkPool::noteUse(const Path &from)
{
    if (link::Link *link = find(from.link))
        link->noteUse(from.remote);
}

void LinkPool::countBadFrame(LinkId id, std::uint64_t count)
{
    if (Entry *from = entry(id))
        from->badCrc += count;
}

std::uint64_t LinkPool::badFrames() const
{
    std::uint64_t sum = m_badFramesOfRemoved;
    for (const Entry &candidate : m_entries)
        sum += candidate.badCrc;
    return sum;
}

LinkSnapshot LinkPool::describe(const Entry &entry) const
{
    const link::Link &link = *entry.link;
    const link::LinkCounters counters = link.counters();
    LinkSnapshot out;
    out.id = link.id();
    out.url = link.url().toText();
    out.phase = phaseOf(link.state());
    out.localAddress = link.localAddress();
    const Address remote = entry.remote == Address{} ? link.remote() : entry.remote;
    if (remote != Address{})
        out.remoteAddress = link::toText(remote);
    if (link.error().code != link::LinkErrorCode::None && link.state() != link::LinkState::Ended)
        out.problem = link.error().reason();
    out.addressInUse = link.error().code == link::LinkErrorCode::PortInUse;
    out.hostUnknown = link.error().code == link::LinkErrorCode::HostUnknown;
    out.recording = link.traits().isRecording;
    out.listenOnly = entry.use == LinkUse::ListenOnly;
    out.rxBytes = counters.rxBytes;
    out.txBytes = counters.txBytes;
    out.rxDatagrams = counters.rxBlocks;
    out.txDatagrams = counters.txBlocks;
    out.dropped = counters.rxKernelDrops + counters.rxOversized + counters.txDropped;
    out.badCrc = entry.badCrc;
    return out;
}

LinkSnapshot LinkPool::snapshot(const link::Link &link) const
{
    const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry &e) { return e.link.get() == &link; });
    return found == m_entries.end() ? LinkSnapshot{} : describe(*found);
}

std::vector<LinkSnapshot> LinkPool::snapshots(TimePoint now)
{
    std::vector<LinkSnapshot> out;
    out.reserve(m_entries.size());
    for (Entry &entry : m_entries) {
        LinkSnapshot one = describe(entry);
        entry.rxRate.add(now, one.rxBytes - entry.rxBytesSeen);
        entry.txRate.add(now, one.txBytes - entry.txBytesSeen);
        entry.rxBytesSeen = one.rxBytes;
        entry.txBytesSeen = one.txBytes;
        one.rxBytesPerSecond = entry.rxRate.perSecond(now);
        one.txBytesPerSecond = entry.txRate.perSecond(now);
        out.push_back(std::move(one));
    }
    return out;
}

} // namespace skyseal::engine
