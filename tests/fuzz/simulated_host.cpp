#include "tests/fuzz/simulated_host.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QPointer>
#include <QtCore/QTimer>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <map>
#include <random>

#ifdef __clang__
#pragma clang diagnostic ignored "-Wreturn-type-c-linkage" // the wrapped symbol is a mangled C++ name
#endif
extern "C" {
int __real_clock_gettime(clockid_t clock, timespec *out);
int __wrap_clock_gettime(clockid_t clock, timespec *out);
std::chrono::steady_clock::time_point __wrap__ZNSt6chrono3_V212steady_clock3nowEv();
void __wrap__ZN6QTimer5startEi(QTimer *timer, int milliseconds);
void __wrap__ZN6QTimer4stopEv(QTimer *timer);
bool __wrap__ZNK6QTimer8isActiveEv(const QTimer *timer);
void __wrap_randombytes_buf(void *out, std::size_t size);
}

namespace skyseal::test {

namespace {

/// A timer that was started. It may be deleted since, and another one may have its address.
struct StartedTimer
{
    QPointer<QTimer> timer;
    TimePoint due;
};

std::map<const QTimer *, StartedTimer> &timers()
{
    static std::map<const QTimer *, StartedTimer> instance;
    return instance;
}

std::mt19937_64 &randomBytes()
{
    static std::mt19937_64 instance;
    return instance;
}

std::map<LinkId, link::Link *> &links()
{
    static std::map<LinkId, link::Link *> instance;
    return instance;
}

} // namespace

class HostLink final : public link::Link
{
public:
    HostLink(const link::LinkUrl &url, LinkId id, link::LinkListener &listener, const link::LinkOptions &options)
        : Link(url, id, listener, options)
    {
        links()[id] = this;
    }
    ~HostLink() override
    {
        if (links()[id()] == this)
            links().erase(id());
    }
    void open() override { setState(traits().isListening ? link::LinkState::Listening : link::LinkState::Connected); }
    void close() override { setState(link::LinkState::Closed); }
    Address remote() const override { return traits().isDatagramClient() ? SimulatedHost::remoteOf(id()) : Address{}; }
    void send(const Address &to, ByteView block) override
    {
        ++m_counters.txBlocks;
        m_counters.txBytes += block.size();
        SimulatedHost::instance().m_sent.push_back({id(), to, Bytes(block.begin(), block.end())});
    }
    void flush() override {}
    void arrive(const Address &from, ByteView bytes)
    {
        Bytes copy(bytes.begin(), bytes.end());
        const link::ReceivedBlock block{{id(), from}, copy, SimulatedHost::instance().now()};
        listener().linkReceived(*this, {&block, 1});
    }
    void reconnect(const Address &from)
    {
        listener().linkPeerLeft(*this, {id(), from});
        listener().linkPeerJoined(*this, {id(), from});
    }
};

namespace {

std::unique_ptr<link::Link> makeSimulated(const link::LinkUrl &url, LinkId id, link::LinkListener &listener,
                                          const link::LinkOptions &options)
{
    return std::make_unique<HostLink>(url, id, listener, options);
}

const link::LinkType kTypes[] = {
    {"udpin", link::LinkTarget::HostPort, {.isListening = true}, "", "", makeSimulated},
    {"udpout", link::LinkTarget::HostPort, {.hasOneRemote = true}, "", "", makeSimulated},
    {"tcpin", link::LinkTarget::HostPort, {.isStream = true, .isListening = true}, "", "", makeSimulated},
};

} // namespace

SimulatedHost &SimulatedHost::instance()
{
    static SimulatedHost instance;
    return instance;
}

void SimulatedHost::reset()
{
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the links of the last run
    timers().clear();
    m_sent.clear();
    m_now = TimePoint(std::chrono::hours(1));
    randomBytes().seed(1);
}

void SimulatedHost::advance(Duration span)
{
    const TimePoint end = m_now + span;
    for (int fired = 0; fired < 100'000; ++fired) {
        const auto next = std::min_element(timers().begin(), timers().end(),
                                           [](const auto &a, const auto &b) { return a.second.due < b.second.due; });
        if (next == timers().end() || next->second.due > end)
            break;
        m_now = std::max(m_now, next->second.due);
        const QPointer<QTimer> timer = next->second.timer;
        timers().erase(next); // All timers of the engines are single-shot.
        if (timer)
            QMetaObject::invokeMethod(timer, "timeout", Qt::DirectConnection);
    }
    m_now = std::max(m_now, end);
}

TimePoint SimulatedHost::readClock()
{
    return m_now += std::chrono::microseconds(1);
}

link::LinkUrl SimulatedHost::url(std::string_view text)
{
    auto parsed = link::LinkUrl::parse(text, link::LinkUrl::kAnyHost, kTypes);
    if (!parsed)
        std::abort();
    return *parsed;
}

Address SimulatedHost::remoteOf(LinkId link)
{
    Address out;
    out.ip = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 192, 0, 2, static_cast<std::uint8_t>(link)};
    out.port = 14550;
    return out;
}

void SimulatedHost::receive(LinkId link, const Address &from, ByteView bytes)
{
    if (const auto found = links().find(link); found != links().end())
        static_cast<HostLink *>(found->second)->arrive(from, bytes);
}

void SimulatedHost::reconnect(LinkId link, const Address &from)
{
    if (const auto found = links().find(link); found != links().end())
        static_cast<HostLink *>(found->second)->reconnect(from);
}

} // namespace skyseal::test

using skyseal::test::SimulatedHost;

int __wrap_clock_gettime(clockid_t clock, timespec *out)
{
    if (clock != CLOCK_BOOTTIME) // steadyNow()
        return __real_clock_gettime(clock, out);
    const auto now = SimulatedHost::instance().readClock().time_since_epoch();
    const auto seconds = std::chrono::floor<std::chrono::seconds>(now);
    out->tv_sec = seconds.count();
    out->tv_nsec = std::chrono::nanoseconds(now - seconds).count();
    return 0;
}

std::chrono::steady_clock::time_point __wrap__ZNSt6chrono3_V212steady_clock3nowEv()
{
    return std::chrono::steady_clock::time_point(SimulatedHost::instance().readClock().time_since_epoch());
}

void __wrap__ZN6QTimer5startEi(QTimer *timer, int milliseconds)
{
    const auto due = SimulatedHost::instance().now() + std::chrono::milliseconds(milliseconds);
    skyseal::test::timers()[timer] = {timer, due};
}

void __wrap__ZN6QTimer4stopEv(QTimer *timer)
{
    skyseal::test::timers().erase(timer);
}

bool __wrap__ZNK6QTimer8isActiveEv(const QTimer *timer)
{
    const auto found = skyseal::test::timers().find(timer);
    return found != skyseal::test::timers().end() && found->second.timer;
}

void __wrap_randombytes_buf(void *out, std::size_t size)
{
    auto *bytes = static_cast<unsigned char *>(out);
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<unsigned char>(skyseal::test::randomBytes()());
}
