// A station without sockets: records the requests of the window; a test (or the gallery) emits snapshots and events.
#pragma once

#include "scripted_views.h"
#include "ui/station_interface.h"

#include <utility>

namespace skyseal::ui {

class FakeStation : public StationInterface
{
    Q_OBJECT

public:
    using StationInterface::StationInterface;

    Result<LinkId, InputError> addLink(const std::string &url) override
    {
        if (url.find(':') == std::string::npos)
            return tl::unexpected(InputError{"\"" + url + "\" is no link URL", {}});
        addedLinks.push_back(url);
        return LinkId{static_cast<std::uint32_t>(addedLinks.size())};
    }
    Result<LinkId, InputError> addMavsecLink(const std::string &url, const engine::MavsecSettings &settings) override
    {
        mavsecLinks.emplace_back(url, settings);
        return LinkId{1000 + static_cast<std::uint32_t>(mavsecLinks.size())};
    }
    void serve(std::vector<engine::ServeConfig> links) override { served = std::move(links); }
    void removeLink(LinkId link) override { removedLinks.push_back(link); }
    void switchSuite(channel::SessionId session, crypto::SuiteId suite) override { switches.emplace_back(session, suite); }
    void setAllowResearch(bool allow) override { allowResearch = allow; }
    void setWeakestSuite(crypto::SuiteId suite) override { weakest = suite; }
    void allowPlaintext(std::uint8_t systemId) override { allowedClear.push_back(systemId); }
    void forgetVehicle(std::uint8_t systemId) override { forgotten.push_back(systemId); }
    vehicle::RequestId perform(std::uint8_t systemId, vehicle::Request request) override
    {
        if (const auto *command = std::get_if<vehicle::VehicleCommand>(&request)) {
            commands.emplace_back(systemId, *command);
            if (vehicle::changesMode(*command))
                Q_EMIT modeChangeSent(systemId);
        } else if (const auto *write = std::get_if<vehicle::WriteParameter>(&request))
            written.emplace_back(write->name, write->value);
        else if (const auto *mission = std::get_if<vehicle::WriteMission>(&request))
            missionWrites.emplace_back(systemId, mission->items);
        requests.push_back(std::move(request));
        return vehicle::RequestId{static_cast<std::uint32_t>(requests.size())};
    }
    void setInspecting(bool on) override { inspecting = on; }
    void chooseFields(std::vector<engine::FieldChoice> choices) override { chosenFields = std::move(choices); }
    void setRecording(bool on) override { recording = on; }
    std::optional<channel::PublicKey> publicKey() const override { return key; }
    Result<void, InputError> startReplay(const std::string &url) override
    {
        replays.push_back(url);
        return {};
    }
    void controlReplay(const engine::ReplayCommand &command) override { replayCommands.push_back(command); }
    void endReplay() override { ++replaysEnded; }
    void listRecordings(const std::string &folder) override { listedFolders.push_back(folder); }
    void stopListing() override { ++listingsStopped; }

    void show(const engine::Snapshot &snapshot);
    /// Those of scripted_snapshots.h, for tests that change nothing of them but the state of a vehicle.
    void showSealed(double time, const ChangeState &change = {});
    /// Vehicles 1 and 2 in one session: `change` is of the first one's state, `changeSecond` of the other's.
    void showTwoSealed(double time, const ChangeState &change = {}, const ChangeState &changeSecond = {});
    void showPlain(double time);
    void showWaiting();
    void showPendingApproval();
    void notify(const engine::Event &event) { Q_EMIT eventOccurred(event); }
    void showReplay(const engine::Snapshot &snapshot);
    void notifyReplay(const engine::Event &event) { Q_EMIT replayEventOccurred(event); }

    std::vector<std::pair<std::string, engine::MavsecSettings>> mavsecLinks;
    std::vector<std::string> addedLinks;
    std::vector<std::string> replays;
    std::vector<engine::ReplayCommand> replayCommands;
    int replaysEnded = 0;
    std::vector<std::string> listedFolders;
    int listingsStopped = 0;
    std::vector<engine::ServeConfig> served; ///< the newest request
    std::vector<LinkId> removedLinks;
    std::vector<std::pair<channel::SessionId, crypto::SuiteId>> switches;
    std::vector<std::pair<std::uint8_t, vehicle::VehicleCommand>> commands;
    std::vector<vehicle::Request> requests; ///< all of them; commands and writes also stand in the lists below
    std::vector<std::uint8_t> allowedClear;
    std::vector<std::uint8_t> forgotten;
    std::vector<std::pair<std::string, double>> written;
    std::vector<std::pair<std::uint8_t, std::vector<vehicle::MissionItem>>> missionWrites;
    std::vector<engine::FieldChoice> chosenFields; ///< the newest request
    bool allowResearch = false, inspecting = false, recording = false;
    crypto::SuiteId weakest = crypto::SuiteId::Rc4;
    std::optional<channel::PublicKey> key;
};

} // namespace skyseal::ui
