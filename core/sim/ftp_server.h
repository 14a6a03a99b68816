// Vehicle side of MAVLink FTP (https://mavlink.io/en/services/ftp.html), with the choices of ArduPilot's server: the station
// names its session, a file that is not open is "not found", and a request whose answer was lost is answered again.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/ftp_message.h"
#include "core/sim/frame_queue.h"
#include "core/sim/frame_sender.h"
#include "core/sim/vehicle_files.h"

#include <array>
#include <string>

namespace skyseal::sim {

using mavlink::FtpMessage;

class FtpServer
{
public:
    static constexpr std::size_t kSessions = 4;

    FtpServer(VehicleFiles &files, FrameQueue &outbox) : m_files(files), m_outbox(outbox) {}

    void handle(TimePoint now, const FrameSender &peer, const FtpMessage &request);

    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const { return m_due; }

    /// For tests: sessions with an open file.
    std::size_t openSessions() const;

private:
    enum class Mode { Closed, Read, Write, Upload };
    struct Session
    {
        Mode mode = Mode::Closed;
        FrameSender peer;
        std::uint8_t id = 0;
        TimePoint lastUse{};
        std::string path; ///< of a file that is written
        Bytes content;    ///< of a file that is read, as it was when it was opened; or an upload so far
        // A burst, while `burstLeft` is not 0.
        std::uint32_t burstLeft = 0; ///< messages
        std::uint32_t burstOffset = 0;
        std::uint16_t burstSequence = 0;
        std::uint8_t burstSize = 0; ///< bytes a message
    };

    void answer(TimePoint now, const FrameSender &peer, const FtpMessage &request, FtpMessage &reply);
    void openFile(TimePoint now, const FrameSender &peer, const FtpMessage &request, FtpMessage &reply);
    void changeFile(const FtpMessage &request, FtpMessage &reply);
    void rename(const FtpMessage &request, FtpMessage &reply);
    void listDirectory(std::string_view path, std::uint32_t first, FtpMessage &reply);
    void readFile(const Session *session, const FtpMessage &request, FtpMessage &reply);
    void writeFile(Session *session, const FtpMessage &request, FtpMessage &reply);
    void terminate(Session *session, FtpMessage &reply);
    /// False if the request is refused, which `reply` says.
    bool beginBurst(TimePoint now, Session *session, const FtpMessage &request, FtpMessage &reply);
    void sendBurst(TimePoint now, Session &session);

    Session *find(const FrameSender &peer, std::uint8_t id);
    /// find(), for a request that keeps the session in use.
    Session *use(TimePoint now, const FrameSender &peer, std::uint8_t id);
    /// A session for a file to open; null if all are in use.
    Session *allocate(TimePoint now);
    void closeIdle(TimePoint now);
    void send(const FrameSender &peer, const FtpMessage &message);

    VehicleFiles &m_files;
    FrameQueue &m_outbox;
    std::array<Session, kSessions> m_sessions;
    std::size_t m_nextBurst = 0; ///< session whose turn it is
    TimePoint m_due = kNever;    ///< of the next message of a burst

    /// The last answers, one a station, to repeat them.
    struct Answer
    {
        FrameSender peer;
        FtpMessage message;
        bool valid = false;
    };
    std::array<Answer, kSessions> m_answers;
    std::size_t m_oldestAnswer = 0;
};

} // namespace skyseal::sim
