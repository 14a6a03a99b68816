// The engine behind the windows' interface. The station can be replaced while the window lives (the demo creates its own keys).
#pragma once

#include "app/skyseal/own_files.h"
#include "app/skyseal/recording_list.h"
#include "core/engine/replay/replay.h"
#include "core/engine/station/station.h"
#include "ui/station_interface.h"

#include <memory>

namespace skyseal::app {

class StationAdapter : public ui::StationInterface
{
    Q_OBJECT

public:
    explicit StationAdapter(std::unique_ptr<engine::Station> station);
    ~StationAdapter() override;

    /// Deletes the old station first, so that its ports are free. On an error, after failed(), there is none.
    Result<void, InputError> exchange(const engine::StationConfig &config);
    engine::Station &station() { return *m_station; }
    bool isRunning() const { return m_station != nullptr; }
    /// See engine::Station.
    void setPeers(std::vector<channel::Peer> peers);

    Result<LinkId, InputError> addLink(const std::string &url) override;
    Result<LinkId, InputError> addMavsecLink(const std::string &url, const engine::MavsecSettings &settings) override;
    void removeLink(LinkId link) override;
    void serve(std::vector<engine::ServeConfig> served) override;
    void switchSuite(channel::SessionId session, crypto::SuiteId suite) override;
    void setAllowResearch(bool allow) override;
    void setWeakestSuite(crypto::SuiteId weakest) override;
    void allowPlaintext(std::uint8_t systemId) override;
    void forgetVehicle(std::uint8_t systemId) override;
    vehicle::RequestId perform(std::uint8_t systemId, vehicle::Request request) override;
    void setInspecting(bool inspecting) override;
    void chooseFields(std::vector<engine::FieldChoice> choices) override;
    void setRecording(bool recording) override;
    std::optional<channel::PublicKey> publicKey() const override;
    Result<void, InputError> startReplay(const std::string &url) override;
    void controlReplay(const engine::ReplayCommand &command) override;
    void endReplay() override;
    void listRecordings(const std::string &folder) override { m_recordings.list(folder); }
    void stopListing() override { m_recordings.stop(); }

Q_SIGNALS:
    /// A new station could not be created; the old one is deleted.
    void failed(const QString &problem);
    void pairing(const skyseal::channel::PairingEvent &event);
    void linkAdded(const skyseal::link::LinkUrl &url);

private:
    void listen();

    std::unique_ptr<engine::Station> m_station; ///< null only after failed()
    std::unique_ptr<engine::Replay> m_replay;   ///< null unless a recording is replayed
    RecordingList m_recordings{indexCacheFile().toStdString()};
    std::vector<engine::ServeConfig> m_served; ///< also by the station after an exchange
    bool m_inspecting = false;
    std::vector<engine::FieldChoice> m_fields;
};

} // namespace skyseal::app
