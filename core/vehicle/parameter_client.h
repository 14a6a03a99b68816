// Client of the parameter protocol: reads the lists of all components, and checks each write by the value that the vehicle
// reports.
//
// The list of the autopilot comes as one file, @PARAM/param.pck by MAVLink FTP, of an ArduPilot that does not say it lacks FTP;
// otherwise, or if it does not open the file soon, by PARAM_REQUEST_LIST (ParameterList). Single reads and writes are repeated
// when the measured round trip has passed without an answer; PARAM_ERROR ends them at once.
//
// Parameters belong to a component: a gimbal or a camera has a list of its own, with its own count and indexes, perhaps with
// names that the autopilot has, too. As QGroundControl does, a read without the file asks all components at once, also those
// that send no heartbeat (the CAN nodes behind a PX4). After the file, which is the autopilot's, the components that are known
// by their heartbeats are asked one by one. Many have no parameters and do not answer, and some announce more than they send:
// a read succeeds with the list of the autopilot, and says what is missing of the others. Over a satellite modem, where each
// message has its price, only the autopilot is asked.
// https://mavlink.io/en/services/parameter.html
#pragma once

#include "core/vehicle/ftp_client.h"
#include "core/vehicle/micro_protocol.h"
#include "core/vehicle/parameter_list.h"
#include "core/vehicle/parameter_store.h"
#include "core/vehicle/repetition.h"

#include <bitset>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

namespace skyseal::vehicle {

class ParameterClient : public MicroProtocol
{
public:
    static constexpr Duration kGiveUp = std::chrono::seconds(10); ///< without a new parameter, then the read fails
    /// The same of other components, which may have no parameters: the read succeeds without the rest.
    static constexpr Duration kOthersGiveUp = std::chrono::seconds(3);
    /// A component that the request to all of them may not have reached is asked again so much later: once, since an agent
    /// limits how often an observer may ask for lists.
    static constexpr Duration kOthersAgain = std::chrono::seconds(2);
    /// After a request to all components, the first value of another one may come so much later than the last of all lists.
    static constexpr Duration kSettle = std::chrono::milliseconds(200);
    /// After the first heartbeat of the autopilot, those of other components may come so much later.
    static constexpr Duration kHeartbeats = std::chrono::milliseconds(1500);
    /// A single read or write fails after so many attempts without the answer, and not before so long.
    static constexpr int kExchangeAttempts = 5;
    static constexpr Duration kExchangeGiveUp = std::chrono::seconds(12);
    /// The vehicle keeps its own value when it has reported it so often. The first report may be from before the write.
    static constexpr int kReports = 3;
    static constexpr Duration kSlowestPace = std::chrono::seconds(1); ///< of its messages

    /// The file of all parameters, and how long the vehicle may take to open it before the list is requested instead.
    static constexpr const char *kFile = "@PARAM/param.pck";
    static constexpr Duration kOpenTimeout = std::chrono::seconds(1);

    /// Reads the file by `files`, which must live as long.
    ParameterClient(VehicleContext &context, FtpClient &files) : MicroProtocol(context), m_files(files) {}

    /// ReadParameters, ReadParameter and WriteParameter. Writes and reads of single ones are carried out one after the other.
    bool perform(TimePoint now, RequestId id, const Request &request) override;
    /// Of the autopilot or another component of the vehicle.
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleHeartbeat(TimePoint now) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;

    const ParameterStore &store() const { return m_store; }
    std::optional<TransferProgress> progress() const override;

private:
    /// A write, or the read of a single parameter.
    struct Exchange
    {
        RequestId id{};
        Parameter parameter{}; ///< name and component
        bool isWrite = false;  ///< of the value of `parameter`
        bool written = false;  ///< a write was sent, not only the question for its type
        int reports = 0;
        std::optional<Parameter> reported{}; ///< the vehicle's parameter, while its value differs from the request

        bool isOf(const Parameter &other) const
        {
            return parameter.componentId == other.componentId && parameter.name == other.name;
        }
    };

    bool isBytewise(std::uint8_t component) const;
    std::uint8_t componentOf(const mavlink::Frame &frame) const;
    void handleValue(TimePoint now, std::uint8_t component, const mavlink::ParamValue &value);
    void handleError(TimePoint now, std::uint8_t component, const mavlink::ParamError &error);

    // The lists.
    bool isReadingFile() const { return m_openDue != kNever || m_isFileOpen; }
    bool readFile(TimePoint now);
    void handleFile(TimePoint now);
    bool take(TimePoint now, const FileResult &file);
    void read(TimePoint now, RequestId id);
    void beginLists(TimePoint now);
    bool beginOthers(TimePoint now, TimePoint request);
    void sendRequests(TimePoint now);
    void checkRead(TimePoint now);
    Reason failureOfList() const;
    Reason failureOfOthers() const;
    void endRead(TimePoint now, Reason failure);

    // Single parameters.
    void exchange(TimePoint now, Exchange exchange);
    void handleExchangeDeadline(TimePoint now);
    void beginExchange(TimePoint now);
    void sendExchange(TimePoint now);
    bool needsType(const Parameter &wanted) const;
    ParameterResult resultOf(const Exchange &exchange, Reason failure) const;
    bool checkExchange(TimePoint now, const Parameter &parameter);
    void finishExchange(TimePoint now, ParameterResult result);

    FtpClient &m_files;
    std::optional<FileResult> m_file{}; ///< has ended
    TimePoint m_openDue = kNever;       ///< the file is not open
    bool m_isFileOpen = false;
    bool m_hasNoFile = false; ///< as the vehicle has shown
    ParameterStore m_store;
    std::optional<RequestId> m_read{};              ///< in progress
    ParameterList m_list;                           ///< of the autopilot
    std::map<std::uint8_t, ParameterList> m_others; ///< by component, of the read in progress
    bool m_askedAll = false, m_isFileTaken = false; ///< in the read in progress
    TimePoint m_settled = kNever;                   ///< all lists have ended; then the read has, too
    TimePoint m_heardSince = kNever;                ///< the first heartbeat
    std::bitset<256> m_bytewise{};                  ///< components that have sent integers as their bytes
    std::deque<Exchange> m_exchanges;               ///< the first one is in progress
    Repetition m_repetition{kSlowestPace};          ///< of its message
    TimePoint m_exchangeGiveUp = kNever;
};

} // namespace skyseal::vehicle
