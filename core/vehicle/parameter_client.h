// Client of the parameter protocol: reads the whole list, and checks each write by the value that the vehicle reports.
//
// The list comes as one file, @PARAM/param.pck by MAVLink FTP, of an ArduPilot that does not say it lacks FTP; otherwise, or
// if it does not open the file soon, by PARAM_REQUEST_LIST. Parameters that are lost then are requested by index while the
// others still arrive (RequestWindow). Single reads and writes are repeated when the measured round trip has passed without an
// answer.
// https://mavlink.io/en/services/parameter.html
#pragma once

#include "core/vehicle/ftp_client.h"
#include "core/vehicle/micro_protocol.h"
#include "core/vehicle/parameter_store.h"
#include "core/vehicle/repetition.h"
#include "core/vehicle/request_window.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace skyseal::vehicle {

class ParameterClient : public MicroProtocol
{
public:
    /// Without an answer for so long, the list is requested again; with a single one, it has ended.
    static constexpr Duration kListTimeout = std::chrono::seconds(1);
    static constexpr Duration kGiveUp = std::chrono::seconds(10); ///< without a new parameter, then the read fails
    /// A parameter is lost when so many later ones arrived: datagrams overtake each other.
    static constexpr std::size_t kReordered = 8;
    /// The list has ended when nothing came for several of its intervals, and at least for so long.
    static constexpr Duration kLeastPause = std::chrono::milliseconds(50);
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
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;

    const ParameterStore &store() const { return m_store; }
    std::optional<TransferProgress> progress() const override;

private:
    /// A write, or the read of a single parameter.
    struct Exchange
    {
        RequestId id{};
        std::string name;
        std::optional<double> value{}; ///< to write
        bool written = false;          ///< a write was sent, not only the question for its type
        int reports = 0;
        std::optional<Parameter> reported{}; ///< the vehicle's parameter, while its value differs from the request
    };

    /// Integers travel as their bytes (PX4) or as floats (ArduPilot).
    bool isBytewise() const;
    double decode(float raw, std::uint8_t type) const;
    float encode(double value, std::uint8_t type) const;
    bool isReadingList() const { return m_giveUp != kNever; }
    bool isReadingFile() const { return m_openDue != kNever || m_isFileOpen; }
    bool readFile(TimePoint now);
    void handleFile(TimePoint now);
    bool take(TimePoint now, const FileResult &file);
    void read(TimePoint now, RequestId id);
    void exchange(TimePoint now, RequestId id, const std::string &name, std::optional<double> value);
    void handleValue(TimePoint now, const mavlink::ParamValue &value);
    void noteIndex(TimePoint now, std::uint16_t index, std::uint16_t count);
    void beginList(TimePoint now);
    void requestList(TimePoint now);
    void reportList();
    void requestGaps(TimePoint now);
    void noteInterval(TimePoint now);
    void handleListDeadline(TimePoint now);
    void giveUp();
    void handleExchangeDeadline(TimePoint now);
    void beginExchange(TimePoint now);
    void sendExchange(TimePoint now);
    bool checkExchange(TimePoint now, const Parameter &parameter);
    void finishExchange(TimePoint now, ParameterResult result);

    FtpClient &m_files;
    std::optional<FileResult> m_file{}; ///< has ended
    TimePoint m_openDue = kNever;       ///< the file is not open
    bool m_isFileOpen = false;
    bool m_hasNoFile = false; ///< as the vehicle has shown
    ParameterStore m_store;
    RequestId m_read{};
    RequestWindow m_window;    ///< of the read in progress, or the latest one
    std::size_t m_reached = 0; ///< the list has come this far
    TimePoint m_latest{};      ///< arrival of the latest value
    Duration m_interval{};     ///< between values of the list: the mean and its variation, as of round trips
    Duration m_variation{};
    TimePoint m_listDeadline = kNever;     ///< the list has paused, or is not answered
    TimePoint m_giveUp = kNever;           ///< kNever while nothing is read
    std::deque<Exchange> m_exchanges;      ///< the first one is in progress
    Repetition m_repetition{kSlowestPace}; ///< of its message
    TimePoint m_exchangeGiveUp = kNever;
};

} // namespace skyseal::vehicle
