// The state of a vehicle's pre-arm checks, and what to do about the common reasons of ArduPilot and PX4.
#pragma once

#include "ui/view_state.h"

#include <QtCore/QString>

namespace skyseal::ui {

enum class PreArm : std::uint8_t {
    Unknown, ///< the vehicle does not say, or has not been heard for a while
    Ok,      ///< the vehicle says that its checks pass
    Refused, ///< there are reasons, or the vehicle says that a check fails
    Armed
};

PreArm preArmOf(const ViewState &view);
/// "Pre-arm: ok", "Pre-arm: unknown", "Pre-arm: 3 reasons", …
QString preArmText(const ViewState &view);
/// The widest of these texts.
QString widestPreArmText();
/// The same as a sentence.
QString preArmSentence(const ViewState &view);
/// Advice for a reason in the vehicle's words, in one line.
QString preArmRemedy(const QString &reason);

} // namespace skyseal::ui
