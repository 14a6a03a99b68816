// One sentence for each event of the station, the same in the window and on the command line. Translated through
// QCoreApplication; English without a translator. Any thread.
#pragma once

#include "core/engine/common/peer_names.h"
#include "core/engine/station/event.h"

#include <QtCore/QString>

namespace skyseal::engine {

struct EventText
{
    /// Action that helps. Each program adds how to take it there: by a menu or by an option.
    enum class Remedy : std::uint8_t { None, AllowPlaintext, PairAgent };

    QString sentence;          ///< starts with a capital letter, ends without a full stop
    std::uint8_t severity = 6; ///< MAV_SEVERITY
    std::uint8_t systemId = 0; ///< of the vehicle that the event is about; 0 = this device
    /// Another event or another place reports it as well: lists of events leave it out.
    bool isRoutine = false;
    Remedy remedy = Remedy::None;

    /// For lists without a column for the vehicle: "Vehicle 1: …".
    QString line() const;
};

/// `names` must have noted the event.
EventText eventText(const Event &event, const PeerNames &names);
EventText linkText(const LinkSnapshot &link);

} // namespace skyseal::engine
