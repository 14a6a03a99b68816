// Client of MAVLink FTP: one transfer at a time. https://mavlink.io/en/services/ftp.html
//
//     List:   ListDirectory 0, n, … until the end
//     Read:   OpenFileRO → (BurstReadFile → chunks)* → ReadFile of what was lost, in a window → TerminateSession →
//             CalcFileCRC32
//     Write:  CreateFile → WriteFile of every chunk, in a window → TerminateSession → CalcFileCRC32
//     Remove: RemoveFile
//
// A file of which a part is kept is read on from there, if it still has the size, and must have the checksum in the end.
//
// A file is a row of chunks of 239 bytes (FileTransfer). All chunks of a virtual file must be read with the same size
// (AP_Filesystem_Param::read()). Requests are repeated with their sequence number, by which the vehicle recognises them, when
// the measured round trip has passed without an answer. Jumps in a file are bounded, whatever the vehicle sends.
//
// As in ArduPilot's GCS_FTP.cpp and PX4's mavlink_ftp.cpp, a request with the sequence number of the one before gets the answer
// to that one, whatever it requests and whoever of this system id sent it: the first number depends on the time, so that a
// program that starts does not repeat the numbers of the one before. ArduPilot takes a session for each request whose session
// is 0, and has few: requests about paths name one. PX4 has one session, with the number 0, and says so when it opens a file.
#pragma once

#include "core/mavlink/ftp_message.h"
#include "core/vehicle/arrival_pace.h"
#include "core/vehicle/chunk_requests.h"
#include "core/vehicle/file_transfer.h"
#include "core/vehicle/micro_protocol.h"
#include "core/vehicle/repetition.h"
#include "core/vehicle/request_window.h"

#include <functional>
#include <string>

namespace skyseal::vehicle {

using mavlink::FtpMessage;

class FtpClient : public MicroProtocol
{
public:
    static constexpr std::size_t kChunk = FileTransfer::kChunk;
    static constexpr int kAttempts = 8;                           ///< of a request, then it fails
    static constexpr Duration kGiveUp = std::chrono::seconds(12); ///< without progress
    /// A request is repeated at least so often: 14 times and more before it fails. At a pace that slows down further, one
    /// request in 4,000 would fail where a quarter of all messages is lost, and a folder may need hundreds.
    static constexpr Duration kSlowestPace = std::chrono::seconds(1);
    static constexpr std::size_t kMostPath = kChunk - 1;
    /// Of requests about a path; the file that is opened may get another one.
    static constexpr std::uint8_t kSession = 1;
    /// A chunk of a burst may be so many chunks ahead of the ones before.
    static constexpr std::size_t kMostJump = 4096;
    static constexpr std::size_t kWritesUnderWay = 8;
    /// A burst has ended when nothing came for several of its intervals, and at least for so long.
    static constexpr Duration kLeastPause = std::chrono::milliseconds(100);

    using MicroProtocol::MicroProtocol;

    /// ListFolder, ReadFile, WriteFile, RemoveFile and CancelTransfer. Fails at once while another transfer is in progress.
    bool perform(TimePoint now, RequestId id, const Request &request) override;
    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override;
    /// Of a transfer that was requested of this client.
    std::optional<TransferProgress> progress() const override;

    /// For another client of the same vehicle: reads a file, whose result goes to `ended` and is not reported. Returns
    /// false, and does nothing, while another transfer is in progress.
    bool read(TimePoint now, const std::string &path, std::function<void(FileResult)> ended);
    /// Of read(): true before the vehicle has opened the file.
    bool isOpening() const { return m_ended && m_phase == Phase::Opening; }
    /// Ends read().
    void cancelRead(TimePoint now);
    TransferProgress transferred() const;

private:
    enum class Phase : std::uint8_t {
        Idle,
        Listing,
        Opening,
        Bursting,
        Reading,
        Creating,
        Writing,
        Closing,
        Checking,
        Removing
    };

    bool begin(TimePoint now, RequestId id, FileAction action, const std::string &path);
    void step(TimePoint now, Phase phase, FtpMessage message);
    void stepWithPath(TimePoint now, Phase phase, std::uint8_t opcode, std::uint32_t offset = 0);
    void transmit(TimePoint now, FtpMessage message);
    void handleStepAnswer(TimePoint now, const FtpMessage &answer);
    void handleStepRefusal(TimePoint now, const FtpMessage &nak);
    bool resetSessions(TimePoint now, std::uint8_t error);
    void handleListing(TimePoint now, const FtpMessage &answer);
    void handleOpened(TimePoint now, const FtpMessage &answer);
    void takeKept(TimePoint now);
    void burst(TimePoint now);
    void handleBurst(TimePoint now, const FtpMessage &answer);
    void fillGaps(TimePoint now);
    void requestChunks(TimePoint now);
    void handleChunkAnswer(TimePoint now, const FtpMessage &answer);
    /// Returns false if the transfer has ended.
    bool takeChunk(TimePoint now, std::uint32_t offset, ByteView data);
    bool endAt(std::size_t bytes);
    void close(TimePoint now);
    void check(TimePoint now);
    void terminate(TimePoint now, Reason reason, bool unfit = false);
    void finish(bool ok, Reason reason = {}, bool changeUnanswered = false, bool unfit = false);
    void finishUnfit(Reason reason) { finish(false, std::move(reason), false, true); }
    void finishUnchecked();
    void giveUp(TimePoint now);
    bool isTransferring() const { return m_phase == Phase::Reading || m_phase == Phase::Writing; }

    FileTransfer m_transfer;                 ///< the one in progress, or the latest one
    std::function<void(FileResult)> m_ended; ///< of read(); null of a transfer that was requested of this client
    Phase m_phase = Phase::Idle;
    std::uint8_t m_session = 0;
    bool m_wasReset = false; ///< the sessions of the vehicle were closed to make room
    FtpMessage m_refused;    ///< for which they were closed
    RequestWindow m_window;  ///< of chunks; its round trip serves all requests
    ChunkRequests m_requests;
    std::size_t m_reached = 0;             ///< chunks up to here were sent in bursts
    ArrivalPace m_pace;                    ///< of chunks of a burst
    FtpMessage m_message;                  ///< sent last, except those of the window
    std::uint16_t m_sequence = 0;          ///< of the request sent last
    Repetition m_repetition{kSlowestPace}; ///< of m_message; during a burst, of its pause
    TimePoint m_deadline = kNever;         ///< without progress, the transfer fails
};

} // namespace skyseal::vehicle
