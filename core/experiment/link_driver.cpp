#include "core/experiment/link_driver.h"

#include "core/crypto/mavsec_cipher.h"
#include "core/engine/common/mavsec_settings.h"
#include "core/engine/station/snapshot.h"

#include <utility>

namespace skyseal::experiment {

namespace {

using std::chrono::milliseconds;

constexpr Duration kSettle = milliseconds(500); ///< a new station requests much that it requests only once
constexpr Duration kSettleAgain = milliseconds(200);
constexpr Duration kMostSettle = std::chrono::seconds(2); ///< for a vehicle that does not answer TIMESYNC

} // namespace

LinkDriver::LinkDriver(engine::StationConfig config, std::optional<link::LinkUrl> link, engine::Station *borrowed,
                       std::optional<int> core, std::string bareKey)
    : m_station(std::move(config), std::move(link), borrowed, core), m_bareKey(std::move(bareKey))
{}

LinkDriver::~LinkDriver()
{
    if (m_station.isOpen() && m_station.isBorrowed())
        m_station.giveBack(suiteToResume());
}

void LinkDriver::take(const Snapshot &snapshot)
{
    m_snapshot = snapshot;
    m_measured.update(*snapshot);
}

void LinkDriver::forgetSnapshot()
{
    m_snapshot.reset();
    m_isCurrent = false;
}

double LinkDriver::snapshotTime() const
{
    return m_snapshot ? m_snapshot->time : 0;
}

const engine::SessionSnapshot *LinkDriver::session() const
{
    return m_snapshot ? m_measured.session(*m_snapshot) : nullptr;
}

bool LinkDriver::hasVehicle() const
{
    return m_snapshot && m_measured.hasVehicle(*m_snapshot);
}

/// An answer to TIMESYNC shows that the vehicle is reached as well; in plain MAVLink that takes its next heartbeat.
bool LinkDriver::isSettled(double inStage, bool isFresh) const
{
    const Duration least = isFresh ? kSettle : kSettleAgain;
    return inStage >= seconds(kMostSettle) || (inStage >= seconds(least) && m_measured.isAnswering(*m_snapshot));
}

Result<void, InputError> LinkDriver::open(engine::Protection first)
{
    m_snapshot.reset();
    m_measured.stationOpened();
    if (!m_station.isBorrowed())
        m_measured.setProtection(first, nullptr);
    return m_station.open(first);
}

void LinkDriver::setProtection(std::optional<engine::Protection> protection)
{
    if (m_measured.bareCipher())
        m_station.setBareCipher(std::nullopt);
    m_measured.setProtection(protection, m_snapshot.get());
    m_station.setProtection(protection);
}

Result<void, InputError> LinkDriver::setBareCipher(std::optional<crypto::MavsecKind> kind)
{
    std::optional<crypto::MavsecCipher> cipher;
    if (kind) {
        engine::MavsecSettings settings;
        settings.kind = *kind;
        settings.keyFile = m_bareKey;
        settings.work = crypto::MavsecWork::EachFrame;
        auto made = engine::makeMavsecCipher(settings);
        if (!made)
            return tl::unexpected(made.error());
        cipher = std::move(*made);
    }
    m_measured.setBareCipher(kind, m_snapshot.get());
    m_station.setBareCipher(std::move(cipher));
    return {};
}

bool LinkDriver::hasUnreadable() const
{
    return m_snapshot && m_snapshot->unreadable > m_unreadableBefore;
}

void LinkDriver::forgetUnreadable()
{
    m_unreadableBefore = m_snapshot ? m_snapshot->unreadable : 0;
}

void LinkDriver::setSnapshotsPerSecond(int perSecond)
{
    if (m_station.isOpen())
        m_station.setSnapshotsPerSecond(perSecond);
}

void LinkDriver::orderSwitch(double now)
{
    const engine::SessionSnapshot *up = session();
    if (up && !up->info.pending && m_switch.order(up->info.session, now))
        m_station.switchSuite(up->info.session, m_switch.wanted());
}

SuiteSwitch::Outcome LinkDriver::finishSwitch(const channel::SwitchDone &done, double now)
{
    return m_switch.finish(done, session() != nullptr, now);
}

bool LinkDriver::beginRestoring()
{
    m_isCurrent = false;
    const auto first = m_measured.firstSuite();
    if (!first || (!m_station.isBorrowed() && (m_measured.isPlain() || !session())))
        return false;
    m_switch.begin(*first);
    if (m_station.isBorrowed())
        setProtection(std::nullopt);
    holdSuite();
    return true;
}

void LinkDriver::takeAfterOrders(const Snapshot &snapshot)
{
    take(snapshot);
    m_isCurrent = true;
}

bool LinkDriver::isRestoringOver() const
{
    return isRestored() || (!session() && !m_station.isBorrowed());
}

/// A link that is not known to be back on its first suite goes over to it, at the latest with the next session.
std::optional<crypto::SuiteId> LinkDriver::suiteToResume() const
{
    return isRestored() ? std::nullopt : m_measured.firstSuite();
}

} // namespace skyseal::experiment
