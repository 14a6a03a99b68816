// Logs on the vehicle: the requests of the log protocol (LOG_REQUEST_LIST and the like) and their result.
#pragma once

#include "core/base/bytes.h"
#include "core/base/reason.h"
#include "core/vehicle/kept_part.h"
#include "core/vehicle/request_id.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace skyseal::vehicle {

struct OnboardLog
{
    std::uint16_t id = 0;
    std::uint32_t size = 0;        ///< bytes
    std::uint32_t timeSeconds = 0; ///< since 1970, UTC; 0 if the vehicle does not know
    bool operator==(const OnboardLog &) const = default;
};

struct ListLogs
{};
struct ReadLog
{
    std::uint16_t log = 0;
    /// Goes on from here, if the log is listed with the same size and time. The protocol has no checksum.
    std::shared_ptr<const KeptPart> kept = {};
    std::shared_ptr<PartSink> sink = {}; ///< takes what arrives
};
/// Erases all logs. The protocol has no answer; the vehicle's list tells whether it did.
struct EraseLogs
{};

enum class LogAction : std::uint8_t { List, Read, Erase };

struct LogResult
{
    RequestId id{};
    std::uint8_t systemId = 0;
    LogAction action{};
    std::uint16_t log = 0;
    bool ok = false;
    Reason reason = {};            ///< why it failed
    bool changeUnanswered = false; ///< logs are still there after an erase
    bool unfit = false;            ///< what has arrived, or was kept, is not the log: it must be read anew
    std::shared_ptr<const std::vector<OnboardLog>> entries = {}; ///< of List
    std::shared_ptr<const Bytes> content = {};                   ///< of Read
};

} // namespace skyseal::vehicle
