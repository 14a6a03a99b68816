// State of one vehicle as plain values in the units for display. Nothing is erased when a link is lost: values are
// kept and get an age.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/enums.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/request_id.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::vehicle {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Position
{
    double latitude = kUnknown;  ///< degrees
    double longitude = kUnknown; ///< degrees
    double altitude = kUnknown;  ///< metres above mean sea level
    bool known() const { return !std::isnan(latitude) && !std::isnan(longitude); }
};

/// One status text of the vehicle, joined if it came in chunks.
struct StatusText
{
    std::uint64_t number = 0; ///< rises by one per vehicle, so that a reader sees which are new
    std::uint8_t severity = mavlink::MAV_SEVERITY_INFO;
    std::string text;
    WallTime time{};
};

/// Frames of one component counted by their sequence numbers, modulo 256.
struct SequenceCounters
{
    std::uint64_t frames = 0;
    std::uint64_t lost = 0;
    std::uint64_t late = 0;
    std::uint64_t duplicate = 0;
};

/// How far a transfer of a request has come: items, bytes or records, as its protocol counts them.
struct TransferProgress
{
    RequestId id{};
    std::uint64_t done = 0;
    std::uint64_t total = 0; ///< 0 while it is not known
};

/// An aircraft that the vehicle's ADS-B receiver has heard.
struct Aircraft
{
    std::uint32_t address = 0; ///< ICAO, 24 bits
    std::string callsign;      ///< empty: unknown
    Position position;
    double heading = kUnknown;     ///< degrees, 0..360
    double groundSpeed = kUnknown; ///< metres a second
    double climb = kUnknown;       ///< metres a second
    double age = 0;                ///< seconds since the receiver heard it
    bool simulated = false;
};

/// Another component of the vehicle's system, such as a camera, a gimbal or a companion computer, as its newest HEARTBEAT says.
struct Component
{
    std::uint8_t id = 0;        ///< MAV_COMPONENT
    std::uint8_t type = 0;      ///< MAV_TYPE
    std::uint8_t autopilot = 0; ///< MAV_AUTOPILOT
    TimePoint heard{};
    double age = 0; ///< seconds since that HEARTBEAT
};

/// The radio that carries the link of the vehicle, by its RADIO_STATUS. Signal and noise are 0..254 in units of the radio.
struct RadioState
{
    double signal = kUnknown, remoteSignal = kUnknown; ///< here, and at the other end
    double noise = kUnknown, remoteNoise = kUnknown;
    double buffer = kUnknown; ///< percent of the transmit buffer that are free
};

/// One battery, as its BATTERY_STATUS says.
struct Battery
{
    std::uint8_t id = 0;
    std::uint8_t function = 0; ///< MAV_BATTERY_FUNCTION
    double voltage = kUnknown; ///< volts, of all cells
    double current = kUnknown; ///< amperes
    double percent = kUnknown; ///< that remain
};

struct VehicleState
{
    std::uint8_t systemId = 0;
    std::uint8_t componentId = 1;    ///< of the autopilot
    std::uint8_t mavlinkVersion = 2; ///< of its frames, and of those to it: 1 or 2
    std::uint8_t type = 0;           ///< MAV_TYPE
    std::uint8_t autopilot = 0;      ///< MAV_AUTOPILOT
    std::string mode;                ///< as the vehicle, ArduPilot or PX4 name it, see modeName(); "MODE(17)" when not known
    std::uint8_t baseMode = 0;       ///< MAV_MODE_FLAG
    std::uint32_t customMode = 0;
    std::vector<OwnMode> ownModes;  ///< as the vehicle names them; empty if it does not
    std::vector<std::string> modes; ///< that can be asked for
    bool verticalTakeOff = false;   ///< of a plane: its modes, EXTENDED_SYS_STATE or Q_ENABLE say that it hovers as well
    std::uint8_t systemStatus = 0;  ///< MAV_STATE
    bool armed = false;
    std::optional<bool> preArmOk;           ///< whether its checks pass (SYS_STATUS); nullopt: the vehicle does not say
    std::vector<std::string> preArmReasons; ///< for which it would not arm, as it says them; see PreArmReasons

    double roll = kUnknown, pitch = kUnknown, yaw = kUnknown;                ///< radians
    double rollSpeed = kUnknown, pitchSpeed = kUnknown, yawSpeed = kUnknown; ///< radians a second
    Position position;
    Position home;
    double altitudeRelative = kUnknown; ///< metres above home
    double groundSpeed = kUnknown;      ///< metres a second
    double airSpeed = kUnknown;
    double climb = kUnknown;
    double heading = kUnknown;      ///< degrees, 0..360
    double throttle = kUnknown;     ///< percent
    double distanceHome = kUnknown; ///< metres
    double flightTime = 0;          ///< seconds armed and off the ground, of this flight
    bool takeOffSeen = true;        ///< false: the vehicle flew already when it was first heard; flightTime counts from then
    bool inAir = false;             ///< armed and off the ground, see FlightTimer

    double batteryVoltage = kUnknown; ///< volts, of the battery that the vehicle flies on, see Batteries
    double batteryCurrent = kUnknown; ///< amperes
    double batteryPercent = kUnknown;
    std::vector<Battery> batteries; ///< all, by rising id
    int gpsFix = -1;                ///< GPS_FIX_TYPE, -1 unknown
    int satellites = -1;
    double hdop = kUnknown;
    std::optional<bool> ekfOk;
    std::uint16_t ekfFlags = 0;
    double cpuLoad = kUnknown;   ///< the autopilot's, percent
    double vibration = kUnknown; ///< m/s², the worst axis
    int missionCurrent = -1;
    double latency = kUnknown; ///< seconds there and back by TIMESYNC, smoothed
    std::uint64_t trips = 0;   ///< answers that came
    double tripSeconds = 0;    ///< their times added up: two readings give the mean between them

    RadioState radio;
    std::string firmware;           ///< "ArduCopter 4.5.7"; empty until known
    std::uint64_t capabilities = 0; ///< MAV_PROTOCOL_CAPABILITY; known together with `firmware`
    bool knowsCapabilities() const { return !firmware.empty(); }
    TimePoint lastHeartbeat{};
    TimePoint lastMessage{};        ///< any message of the vehicle but RADIO_STATUS
    double heartbeatAge = kUnknown; ///< seconds
    double messageAge = kUnknown;   ///< seconds; values older than staleAfter are stale
    double staleAfter = 3.5;        ///< seconds; follows the rate of HIGH_LATENCY2, see HeartbeatMonitor
    bool lost = false;              ///< no message for staleAfter
    bool highLatency = false;       ///< behind a satellite modem, which sends HIGH_LATENCY2 in place of HEARTBEAT
    SequenceCounters sequence;      ///< all components
    std::vector<StatusText> texts;  ///< the last 200
    std::vector<TransferProgress> transfers;
    std::vector<Component> components; ///< the others of its system, by id; see Vehicle::kMostComponents
    std::vector<Aircraft> traffic;     ///< in the neighbourhood, see Traffic
};

} // namespace skyseal::vehicle
