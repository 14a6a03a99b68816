#include "core/experiment/sweep_station.h"

#include "core/crypto/mavsec_cipher.h"
#include "core/experiment/placement.h"

#include <QtCore/QTimer>

namespace skyseal::experiment {

namespace {

constexpr Duration kLatencyEvery = std::chrono::milliseconds(200);

engine::StationConfig measuring(engine::StationConfig config)
{
    config.secure = engine::SecureMode::Required;
    config.record = false;
    config.timeSyncEvery = kLatencyEvery;
    config.diagnostics = false; // nobody watches, and they cost the thread that is measured
    return config;
}

} // namespace

SweepStation::SweepStation(engine::StationConfig config, std::optional<link::LinkUrl> link, engine::Station *borrowed,
                           std::optional<int> core)
    : m_config(measuring(std::move(config))), m_link(std::move(link)), m_borrowed(borrowed), m_core(core)
{}

Result<void, InputError> SweepStation::open(engine::Protection first)
{
    if (m_borrowed) {
        m_station = m_borrowed;
        listen();
        connect(m_station, &QObject::destroyed, this, [this] {
            m_station = nullptr;
            Q_EMIT lost();
        });
        return {};
    }
    const OnCore onCore(m_core); // threads begin where their creator runs
    auto station = engine::Station::create(m_config);
    if (!station)
        return tl::unexpected(station.error());
    m_own = std::move(*station);
    m_station = m_own.get();
    listen();
    connect(m_station, &engine::Station::stopped, this, [this] {
        m_own.release()->deleteLater(); // it is the sender of this signal
        m_station = nullptr;
        QTimer::singleShot(0, this, &SweepStation::closed);
    });
    setProtection(first);
    m_station->addLink(*m_link);
    return {};
}

void SweepStation::listen()
{
    connect(m_station, &engine::Station::snapshotReady, this, &SweepStation::snapshotReady);
    connect(m_station, &engine::Station::probeTaken, this, &SweepStation::probeTaken);
    connect(m_station, &engine::Station::eventOccurred, this, &SweepStation::eventOccurred);
    m_station->setMeasuring(true);
}

void SweepStation::setSnapshotsPerSecond(int perSecond)
{
    if (!m_borrowed)
        m_station->setSnapshotsPerSecond(perSecond);
}

void SweepStation::setProtection(std::optional<engine::Protection> protection)
{
    m_station->holdSuite(std::nullopt);
    m_station->setProtection(protection);
}

void SweepStation::setBareCipher(std::optional<crypto::MavsecCipher> cipher)
{
    m_station->setBareCipher(std::move(cipher));
}

void SweepStation::close(std::optional<crypto::SuiteId> resume)
{
    if (m_own)
        return m_station->stop();
    giveBack(resume);
    QTimer::singleShot(0, this, &SweepStation::closed);
}

void SweepStation::giveBack(std::optional<crypto::SuiteId> resume)
{
    setProtection(std::nullopt);
    if (resume)
        m_station->resumeSuite(*resume);
    m_station->setMeasuring(false);
    m_station->requestCosts(false);
    disconnect(m_station, nullptr, this, nullptr);
    m_station = nullptr;
}

} // namespace skyseal::experiment

#include "moc_sweep_station.cpp"
