#include "tests/engine/engine_rig.h"

#include "core/channel/timing.h"
#include "core/link/steady_now.h"
#include "tests/support/eventually.h"

#include <QtCore/QCoreApplication>

#include <cstdio>
#include <cstdlib>

namespace skyseal::test {

std::string loopbackAddress(std::uint16_t port)
{
    return "127.0.0.1:" + std::to_string(port);
}

Patience::Patience() : m_deadline(kDeadlineMs) {}

void Patience::check() const
{
    if (m_deadline.hasExpired()) {
        std::fprintf(stderr, "the engine did not deliver all frames\n");
        std::abort();
    }
}

void bringUp(BareEnd &end, crypto::SuiteId suite)
{
    const Patience patience;
    const auto turn = [&] {
        QCoreApplication::processEvents();
        end.pump();
        patience.check();
    };
    while (!end.up())
        turn();
    const auto session = [&end] { return end.sessionInfo(); };
    while (session().lastReceived <= session().since) // A record shows that the session is up at the other end.
        turn();
    if (session().suite == suite)
        return;
    end.switchSuite(suite);
    while (session().suite != suite)
        turn();
    // Until both ends have deleted the keys of the previous epoch, as during the time between two switches. Nothing reports it.
    const Duration settling = channel::Timing().oldKeysLinger + std::chrono::milliseconds(500);
    for (const TimePoint switched = steadyNow(); steadyNow() - switched < settling;)
        turn();
}

} // namespace skyseal::test
