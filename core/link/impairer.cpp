#include "core/link/impairer.h"

#include "core/link/make_link.h"
#include "core/link/steady_now.h"

namespace skyseal::link {

Impairer::Impairer(const LinkUrl &listen, const LinkUrl &to, const impair::ImpairmentSettings &settings,
                   const LinkOptions &options)
    : m_sides{makeSide(listen, LinkId{0}, settings, options), makeSide(to, LinkId{1}, settings, options)}
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Impairer::release);
}

Impairer::Side Impairer::makeSide(const LinkUrl &url, LinkId id, const impair::ImpairmentSettings &settings,
                                  const LinkOptions &options)
{
    auto link = makeLink(url, id, *this, options);
    connect(link.get(), &Link::stateChanged, this, [this, made = link.get()] { Q_EMIT linkStateChanged(*made); });
    // Datagrams that leave through link 1 go forward; that direction uses random stream 0.
    return {std::move(link), impair::Impairment(settings, id == LinkId{1} ? 0 : 1), {}, {}};
}

void Impairer::open()
{
    for (Side &side : m_sides)
        side.link->open();
}

void Impairer::close()
{
    m_timer.stop();
    for (Side &side : m_sides)
        side.link->close();
}

Impairer::Totals Impairer::totals(Direction direction) const
{
    const Side &side = m_sides[direction == Direction::Forward ? 1 : 0];
    Totals out = side.totals;
    out.counters = side.outgoing.counters();
    return out;
}

bool Impairer::hasPeer(const Side &side) const
{
    return side.peer != Address{} || side.link->remote() != Address{};
}

void Impairer::linkPeerJoined(Link &link, const Path &path)
{
    if (link.remote() == Address{})
        m_sides[static_cast<std::size_t>(link.id())].peer = path.remote;
}

void Impairer::linkReceived(Link &link, std::span<const ReceivedBlock> blocks)
{
    const auto from = static_cast<std::size_t>(link.id());
    Side &source = m_sides[from];
    Side &target = m_sides[1 - from];
    if (link.remote() == Address{})
        source.peer = blocks.back().path.remote;
    if (!hasPeer(target)) {
        target.totals.unroutable += blocks.size();
        return;
    }
    const Direction direction = from == 0 ? Direction::Forward : Direction::Backward;
    for (const ReceivedBlock &block : blocks) {
        link.noteUse(block.path.remote); // the relay cannot judge the content, so every block counts
        take(block, direction, target);
    }
    release();
}

void Impairer::take(const ReceivedBlock &block, Direction direction, Side &target)
{
    const impair::Treatment treatment = target.outgoing.push(block.time, block.bytes);
    if (m_log)
        m_log(direction, block.time, treatment, block.bytes);
}

void Impairer::release()
{
    const TimePoint now = steadyNow();
    TimePoint next = kNever;
    for (Side &side : m_sides) {
        impair::Impairment::Delivery delivery;
        while (side.outgoing.pop(now, delivery)) {
            side.link->send(side.link->remote() == Address{} ? side.peer : Address{}, delivery.bytes);
            if (m_deliveryLog)
                m_deliveryLog(&side == &m_sides[1] ? Direction::Forward : Direction::Backward, now, delivery.sequence);
        }
        side.link->flush();
        next = std::min(next, side.outgoing.nextDeadline());
    }
    if (next == kNever)
        m_timer.stop();
    else
        m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(std::max(next - now, Duration(0))));
}

} // namespace skyseal::link

#include "moc_impairer.cpp"
