// One sentence for each event of the channel and of a link: the same for the station and the agent, in the window and on the
// command line. Translated through QCoreApplication; English without a translator. Any thread.
#pragma once

#include "core/channel/events.h"
#include "core/engine/common/link_snapshot.h"
#include "core/engine/common/peer_names.h"
#include "core/mavlink/enums.h"

#include <QtCore/QString>

namespace skyseal::engine {

struct EventText
{
    /// Remedial action. Each program adds its own way to take it: a menu or an option.
    enum class Remedy : std::uint8_t { None, AllowPlaintext, PairAgent };

    QString sentence; ///< starts with a capital letter, ends without a full stop
    std::uint8_t severity = mavlink::MAV_SEVERITY_INFO;
    std::uint8_t systemId = 0; ///< of the vehicle that the event concerns; 0 = this device
    /// Another event or another place reports it as well, so that lists of events omit it.
    bool isRoutine = false;
    Remedy remedy = Remedy::None;

    /// For lists without a column for the vehicle: "Vehicle 1: …".
    QString line() const;
};

/// An event that lists of events omit.
EventText routineText(const QString &sentence, std::uint8_t systemId = 0);
/// `names` must have noted the event.
EventText channelEventText(const channel::Event &event, const PeerNames &names);
EventText linkText(const LinkSnapshot &link);
/// For what shows the state: the sentence of the event that reports it.
QString unknownAgentText(const QString &address);
QString peerCannotStoreText(const QString &peer);

} // namespace skyseal::engine
