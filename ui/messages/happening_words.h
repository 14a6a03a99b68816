// A happening as a line of the console; nothing for those that other panels show better.
#pragma once

#include "core/engine/happening.h"

#include <QtCore/QString>

#include <optional>

namespace skyseal::ui {

struct HappeningLine
{
    QString text;
    std::uint8_t severity = 6; ///< MAV_SEVERITY
    std::uint8_t systemId = 0;
};

std::optional<HappeningLine> happeningLine(const engine::Happening &happening);

} // namespace skyseal::ui
