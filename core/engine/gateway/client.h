// One client of the gateway: another ground station or program. Decides which of its frames are forwarded to the vehicles,
// and counts the others. No I/O and no clock.
//
// A client that may only read may send questions (read-only requests, question_rules.h), AUTOPILOT_VERSION_REQUEST and, while
// no client that may write is connected, requests for rates of 1 to 10 Hz (REQUEST_DATA_STREAM, SET_MESSAGE_INTERVAL). Like
// those of an observer, its questions must not become another message on a line that loses bytes (misreading.h).
#pragma once

#include "core/engine/common/question_budget.h"
#include "core/engine/gateway/client_snapshot.h"
#include "core/engine/gateway/serve_config.h"
#include "core/mavlink/frame_scanner.h"

#include <optional>

namespace skyseal::engine {

/// Notice to a client about frames that it may not send, at most once a minute.
struct Denial
{
    std::string message;      ///< name of the newest one
    std::uint64_t frames = 0; ///< since the last time
};

class Client
{
public:
    /// A client whose address is not configured is forgotten after this time of silence.
    static constexpr Duration kForgetAfter = std::chrono::seconds(60);
    static constexpr Duration kNoticeInterval = std::chrono::minutes(1);

    enum class Verdict : std::uint8_t {
        Forward,
        /// The heartbeat of a client that may only read, which the vehicle would take for a pilot's, or a question that could
        /// be misread.
        Ignore,
        TooOften,
        NotItsSystem,
        Deny
    };

    /// `config` and `questions` must outlive this object.
    Client(const ServeConfig &config, QuestionBudget &questions) : m_config(config), m_questions(questions) {}

    /// Judges a whole frame (mavlink::isWholeFrame()) and counts it. `isVehicle`: its system id is a vehicle's. `pilotThere`: a
    /// client that may write is connected.
    Verdict judge(TimePoint now, const mavlink::ScanItem &item, bool isVehicle, bool pilotThere);
    /// Call after Verdict::Deny. Returns the notice for the client, if one is due.
    std::optional<Denial> takeDenial(TimePoint now, const mavlink::ScanItem &item);

    bool isSilent(TimePoint now) const { return now - m_heard >= kForgetAfter; }
    void noteHeard(TimePoint now) { m_heard = now; }
    TimePoint heardAt() const { return m_heard; }
    /// Whether its connection was reported, so that its end is reported as well.
    bool isReported() const { return m_reported; }
    void setReported() { m_reported = true; }
    const ServeConfig &config() const { return m_config; }
    const ClientCounters &counters() const { return m_counters; }

private:
    Verdict judgeUncounted(TimePoint now, const mavlink::ScanItem &item, bool isVehicle, bool pilotThere);

    const ServeConfig &m_config;
    QuestionBudget &m_questions;
    ClientCounters m_counters;
    TimePoint m_heard{};
    bool m_reported = false;
    TimePoint m_nextNoticeAt = TimePoint::min();
    std::uint64_t m_noticed = 0; ///< denied frames in earlier notices to the client
};

} // namespace skyseal::engine
