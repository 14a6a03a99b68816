#include "ui/text/one_way.h"

#include "core/engine/station/vehicle_snapshot.h"
#include "ui/text/recorded_link.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct OneWayText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::OneWay)
};

} // namespace

std::optional<OneWay> oneWayOf(const ViewState &view)
{
    if (!view.link || view.vehicle->session)
        return std::nullopt;
    if (view.link->recording)
        return OneWay{OneWayText::tr("Replay"),
                      OneWayText::tr("The values come from a recorded log. They are not live, and nothing can be sent.")
                          + QLatin1Char(' ') + recordedLinkOf(view, *view.vehicle).value_or(RecordedLink{}).sentence(),
                      OneWayText::tr("it is a replay"), true};
    if (view.link->listenOnly)
        return OneWay{OneWayText::tr("Not sealed, receive only"),
                      OneWayText::tr("This stream is protected as in the published MAVSec code, which is insecure: anyone on "
                                     "the path can change it. Nothing is sent."),
                      OneWayText::tr("its link is receive-only")};
    return std::nullopt;
}

} // namespace skyseal::ui
