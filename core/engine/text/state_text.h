// Texts for people for the enums and numbers that the engine reports. Translated through QCoreApplication; without a
// translator (command lines) they are English. Scripts read the fixed keywords of headless/event_names.h instead.
#pragma once

#include "core/channel/events.h"
#include "core/engine/common/link_snapshot.h"

#include <QtCore/QString>

#include <string_view>

namespace skyseal::engine {

/// The name of a suite, with the word "insecure" for research suites.
QString suiteText(crypto::SuiteId suite);
/// "quadrotor", "plane", …, by MAV_TYPE.
QString vehicleTypeText(std::uint8_t type);
/// "listening", "connected", …
QString linkPhaseText(LinkPhase phase);
/// Why a session ended.
QString downReasonText(channel::DownReason reason);
/// Why a switch was rolled back.
QString switchFailureText(channel::SwitchFailure failure);
/// Why a handshake was refused.
QString refusalText(channel::RefusalReason reason);
/// Duration of a switch until both ends agreed: "0.4 ms", "42 ms".
QString switchTimeText(Duration took);
/// Alternatives of names that are joined by ", ": "air-1", "air-1 or air-2", "air-1, air-2 or air-3".
QString anyOfNames(std::string_view names);

} // namespace skyseal::engine
