// A event as a line of the console; nothing for those that other panels show better.
#pragma once

#include "core/engine/station/event.h"

#include <QtCore/QString>

#include <optional>

namespace skyseal::ui {

struct EventLine
{
    QString text;
    std::uint8_t severity = 6; ///< MAV_SEVERITY
    std::uint8_t systemId = 0;
};

std::optional<EventLine> eventLine(const engine::Event &event);

} // namespace skyseal::ui
