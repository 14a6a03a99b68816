#include "app/skyseal/station_adapter.h"

#include "core/crypto/mavsec_cipher.h"
#include "core/engine/text/qt_text.h"

namespace skyseal::app {

using engine::Station;

StationAdapter::StationAdapter(std::unique_ptr<Station> station) : m_station(std::move(station))
{
    connect(&m_recordings, &RecordingList::listed, this, &StationInterface::recordingsListed);
    connect(&m_recordings, &RecordingList::read, this, &StationInterface::recordingRead);
    listen();
}

StationAdapter::~StationAdapter() = default;

void StationAdapter::listen()
{
    connect(m_station.get(), &Station::snapshotReady, this, &StationInterface::snapshotReady);
    connect(m_station.get(), &Station::eventOccurred, this, &StationInterface::eventOccurred);
    connect(m_station.get(), &Station::pairing, this, &StationAdapter::pairing);
}

Result<void, InputError> StationAdapter::exchange(const engine::StationConfig &config)
{
    m_station.reset();
    auto created = Station::create(config);
    if (!created) {
        Q_EMIT failed(engine::reasonText(created.error().reason()));
        return tl::unexpected(created.error());
    }
    m_station = std::move(*created);
    listen();
    m_station->setInspecting(m_inspecting);
    m_station->chooseFields(m_fields);
    if (!m_served.empty())
        m_station->serve(m_served);
    return {};
}

void StationAdapter::setPeers(std::vector<channel::Peer> peers)
{
    if (m_station)
        m_station->setPeers(std::move(peers));
}

Result<LinkId, InputError> StationAdapter::addLink(const std::string &url)
{
    if (!m_station)
        return tl::unexpected(InputError{sentence("Reason", "the station is not running"), url});
    const auto parsed = link::LinkUrl::parse(url);
    if (!parsed)
        return tl::unexpected(parsed.error());
    const LinkId id = m_station->addLink(*parsed);
    Q_EMIT linkAdded(*parsed);
    return id;
}

Result<LinkId, InputError> StationAdapter::addMavsecLink(const std::string &url, const engine::MavsecSettings &settings)
{
    if (!m_station)
        return tl::unexpected(InputError{sentence("Reason", "the station is not running"), url});
    const auto parsed = link::LinkUrl::parse(url);
    if (!parsed)
        return tl::unexpected(parsed.error());
    auto cipher = engine::makeMavsecCipher(settings);
    if (!cipher)
        return tl::unexpected(cipher.error());
    return m_station->addMavsecLink(*parsed, std::move(*cipher));
}

void StationAdapter::removeLink(LinkId link)
{
    if (m_station)
        m_station->removeLink(link);
}

void StationAdapter::serve(std::vector<engine::ServeConfig> served)
{
    m_served = std::move(served);
    if (m_station)
        m_station->serve(m_served);
}

void StationAdapter::switchSuite(channel::SessionId session, crypto::SuiteId suite)
{
    if (m_station)
        m_station->switchSuite(session, suite);
}

void StationAdapter::allowPlaintext(std::uint8_t systemId)
{
    if (m_station)
        m_station->allowPlaintext(systemId);
}

void StationAdapter::forgetVehicle(std::uint8_t systemId)
{
    if (m_station)
        m_station->forgetVehicle(systemId);
}

void StationAdapter::setAllowResearch(bool allow)
{
    if (m_station)
        m_station->setAllowResearch(allow);
}

void StationAdapter::setWeakestSuite(crypto::SuiteId weakest)
{
    if (m_station)
        m_station->setWeakestSuite(weakest);
}

vehicle::RequestId StationAdapter::perform(std::uint8_t systemId, vehicle::Request request)
{
    if (!m_station)
        return {};
    if (const auto *command = std::get_if<vehicle::VehicleCommand>(&request); command && vehicle::changesMode(*command))
        Q_EMIT modeChangeSent(systemId);
    return m_station->perform(systemId, std::move(request));
}

void StationAdapter::setInspecting(bool inspecting)
{
    m_inspecting = inspecting;
    if (m_station)
        m_station->setInspecting(inspecting);
    if (m_replay)
        m_replay->setInspecting(inspecting);
}

void StationAdapter::chooseFields(std::vector<engine::FieldChoice> choices)
{
    m_fields = std::move(choices);
    if (m_station)
        m_station->chooseFields(m_fields);
    if (m_replay)
        m_replay->chooseFields(m_fields);
}

void StationAdapter::setRecording(bool recording)
{
    if (m_station)
        m_station->setRecording(recording);
}

std::optional<channel::PublicKey> StationAdapter::publicKey() const
{
    return m_station ? m_station->publicKey() : std::nullopt;
}

Result<void, InputError> StationAdapter::startReplay(const std::string &url)
{
    const auto parsed = link::LinkUrl::parse(url);
    if (!parsed)
        return tl::unexpected(parsed.error());
    if (!parsed->traits().isRecording)
        return tl::unexpected(InputError{sentence("Reason", "is not a recording"), url});
    m_replay = std::make_unique<engine::Replay>(*parsed);
    connect(m_replay.get(), &engine::Replay::snapshotReady, this, &StationInterface::replaySnapshotReady);
    connect(m_replay.get(), &engine::Replay::eventOccurred, this, &StationInterface::replayEventOccurred);
    m_replay->setInspecting(m_inspecting);
    m_replay->chooseFields(m_fields);
    return {};
}

void StationAdapter::controlReplay(const engine::ReplayCommand &command)
{
    if (m_replay)
        m_replay->perform(command);
}

void StationAdapter::endReplay()
{
    m_replay.reset();
}

} // namespace skyseal::app

#include "moc_station_adapter.cpp"
