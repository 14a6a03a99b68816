// Client of the log protocol: LOG_REQUEST_LIST → LOG_ENTRY*, LOG_REQUEST_DATA → LOG_DATA*, one request at a time.
// https://mavlink.io/en/messages/common.html#LOG_REQUEST_LIST
//
// A log is a row of chunks of 90 bytes; a shorter one ends it. Its data is requested in pieces, which the vehicle sends at its
// own pace; lost parts of a piece are requested in runs when it has paused, and the next piece follows when it is complete.
// The size that the vehicle announces is bounded, and so is what can arrive ahead.
//
// As in ArduPilot's AP_Logger_MAVLinkLogTransfer.cpp and PX4's mavlink_log_handler.cpp: ArduPilot drops requests for data
// while it answers one, so that the first of several runs is answered, and the others as far as it has ended by then. In PX4 a
// request replaces the one before: it is sent from one lost chunk to the next (LogSweep). ArduPilot numbers logs from 1;
// it answers a list that begins after the last one, or ends before the first one, with entries of no logs up to 65535. It
// serves logs only while disarmed.
#pragma once

#include "core/vehicle/arrival_pace.h"
#include "core/vehicle/log_content.h"
#include "core/vehicle/log_sweep.h"
#include "core/vehicle/micro_protocol.h"
#include "core/vehicle/rtt_estimator.h"

#include <map>
#include <memory>
#include <string>

namespace skyseal::vehicle {

class LogClient : public MicroProtocol
{
public:
    static constexpr std::size_t kChunk = LogContent::kChunk;
    static constexpr std::size_t kPiece = LogContent::kPiece;
    static constexpr std::size_t kMostRuns = 48;   ///< lost runs that are requested again at a time
    static constexpr std::size_t kAskedTwice = 16; ///< up to this many runs are requested twice at a time: the last ones decide
    static constexpr std::size_t kLong = 64;       ///< a longer run is requested once
    static constexpr int kStreamCopies = 2;        ///< of a request to a vehicle of which each replaces the one before
    /// After this many requests in a row without an answer, the next ones are made more and more slowly.
    static constexpr int kPatience = 2;
    static constexpr std::size_t kFirstOnes = 4; ///< chunks of an answer of which one measures the round trip
    static constexpr std::size_t kMostBytes = 512u << 20;
    static constexpr std::size_t kMostLogs = 2048;                ///< of a list
    static constexpr Duration kGiveUp = std::chrono::seconds(12); ///< without progress
    /// A piece has ended when nothing came for several of its intervals, and at least for so long.
    static constexpr Duration kLeastPause = std::chrono::milliseconds(50);
    /// The vehicle may erase for so long before its list is empty.
    static constexpr Duration kEraseTimeout = std::chrono::seconds(30);

    using MicroProtocol::MicroProtocol;

    /// ListLogs, ReadLog, EraseLogs and CancelTransfer. Fails at once while another request is in progress.
    bool perform(TimePoint now, RequestId id, const Request &request) override;
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;
    std::optional<TransferProgress> progress() const override;

private:
    enum class Phase : std::uint8_t { Idle, Listing, Reading };

    bool begin(TimePoint now, RequestId id, LogAction action, ReadLog log = {});
    void handleEntry(TimePoint now, const mavlink::LogEntry &entry);
    void handleListed(TimePoint now);
    bool beginPart(const OnboardLog &log);
    bool takeKept();
    void handleData(TimePoint now, const mavlink::LogData &data);
    void requestList(TimePoint now);
    void requestPiece(TimePoint now);
    void requestRuns();
    void steer(TimePoint now);
    void requestStream(std::size_t first);
    void requestRun(const LogContent::Run &run);
    void rest(TimePoint now);
    void finish(bool ok, Reason reason = {}, bool changeUnanswered = false, bool unfit = false);
    void finishUnfit(Reason reason) { finish(false, std::move(reason), false, true); }

    RequestId m_request{};
    Phase m_phase = Phase::Idle;
    LogAction m_action{};
    std::uint16_t m_log = 0;
    std::map<std::uint16_t, OnboardLog> m_entries;
    std::optional<std::uint16_t> m_announced; ///< logs of the list
    std::shared_ptr<const KeptPart> m_kept;
    std::shared_ptr<PartSink> m_sink;
    LogContent m_content;
    LogSweep m_sweep;                ///< of vehicles other than ArduPilot
    std::size_t m_lastRequested = 0; ///< the chunk that ends the run requested last
    RttEstimator m_rtt;
    ArrivalPace m_pace;                          ///< of the messages of an answer
    TimePoint m_requested{};                     ///< time of the request
    std::optional<std::size_t> m_firstRequested; ///< the chunk that begins the answer to it, if it was not requested before
    int m_silent = 0;                            ///< requests in a row without an answer
    TimePoint m_repeat = kNever;
    TimePoint m_deadline = kNever;
};

} // namespace skyseal::vehicle
