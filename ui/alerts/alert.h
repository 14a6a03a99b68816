// One thing that the operator should notice now, as a value.
#pragma once

#include <QtCore/QString>

#include <compare>
#include <cstdint>

namespace skyseal::ui {

enum class AlertKind : std::uint8_t {
    LinkLost,
    Failsafe,
    AircraftNear,
    LowBattery,
    ValueLimit,
    ForgedFrames,
    ReplayedFrames,
    NotRecording,
    CountersNotStored, ///< of handshakes, here
    AgentNotStoring,   ///< counters of handshakes, beside the vehicle
    KeysCloned,
    ModeChanged,
    UnknownAgent,
    SuiteSwitch
};

/// Shown in the colour of the lock that is under attack, although nothing is lost: all of these were refused.
constexpr bool isAttack(AlertKind kind)
{
    return kind == AlertKind::ForgedFrames || kind == AlertKind::ReplayedFrames;
}

enum class AlertSeverity : std::uint8_t { Information, Warning, Severe };

/// There is one alert of each kind and vehicle; for limits, of each value.
struct AlertId
{
    AlertKind kind{};
    std::uint8_t systemId = 0; ///< 0: of no vehicle
    std::uint16_t value = 0;   ///< number of the value in the grid, for its limits
    auto operator<=>(const AlertId &) const = default;
};

struct Alert
{
    AlertId id;
    AlertSeverity severity{};
    QString text;            ///< a few words, with the count
    QString details;         ///< a sentence
    std::uint64_t count = 1; ///< frames, or repetitions
    double since = 0;        ///< seconds on the clock of the list
    bool ongoing = false;    ///< a state that lasts; otherwise an event
    /// Subject of an ongoing alert; another one is announced like a new alert, even if the former one was dismissed: the
    /// address of an aircraft, the state of a failing autopilot.
    std::uint64_t subject = 0;
    bool operator==(const Alert &) const = default;
};

} // namespace skyseal::ui
