// One client of the gateway: another ground station or program. Decides which of its frames go to the vehicles and keeps
// account of the others. No I/O and no clock.
//
// A client that may only read asks questions (question_rules.h), for the version and, while no client is there that may write,
// for streams of 1 to 10 Hz (not by SET_MESSAGE_INTERVAL, whose parameters leave room for other commands). As those of an
// observer, its questions must not become another message on a line that loses bytes (misreading.h).
#pragma once

#include "core/engine/common/question_budget.h"
#include "core/engine/gateway/client_snapshot.h"
#include "core/engine/gateway/serve_config.h"
#include "core/mavlink/frame_scanner.h"

#include <optional>

namespace skyseal::engine {

/// What a client is told about frames that it may not send, at most once a minute.
struct Denial
{
    std::string message;      ///< name of the newest one
    std::uint64_t frames = 0; ///< since the last time
};

class Client
{
public:
    /// A client whose address was not configured is forgotten after so much silence.
    static constexpr Duration kForgetAfter = std::chrono::seconds(60);
    static constexpr Duration kTellEvery = std::chrono::minutes(1);

    enum class Verdict : std::uint8_t {
        Forward,
        /// The heartbeat of a client that may only read, which would count as a pilot's, or a question that could be misread.
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
    /// Call after Verdict::Deny. Returns what the client has to be told, if it is due.
    std::optional<Denial> takeDenial(TimePoint now, const mavlink::ScanItem &item);

    bool isSilent(TimePoint now) const { return now - m_heard >= kForgetAfter; }
    void noteHeard(TimePoint now) { m_heard = now; }
    TimePoint heardAt() const { return m_heard; }
    /// Whether its coming was reported, so that its going will be.
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
    TimePoint m_tellAt = TimePoint::min();
    std::uint64_t m_told = 0; ///< denied frames that the client was told of
};

} // namespace skyseal::engine
