#include "ui/status/one_way.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::OneWay)
};

} // namespace

std::optional<OneWay> oneWayOf(const ViewState &view)
{
    if (!view.link || view.vehicle->session)
        return std::nullopt;
    if (view.link->url.starts_with("tlog:"))
        return OneWay{Words::tr("A recording"),
                      Words::tr("What is shown was recorded earlier. Nothing of it is live, and nothing can be sent."),
                      Words::tr("it is a recording"), true};
    if (view.link->listenOnly)
        return OneWay{Words::tr("Not sealed, only listened to"),
                      Words::tr("This stream is protected as MAVSec's published code does it, which is insecure: who is "
                                "on the way can change it. Nothing is sent to it."),
                      Words::tr("its link is only listened to")};
    return std::nullopt;
}

} // namespace skyseal::ui
