#include "ui/text/one_way.h"

#include <QtCore/QCoreApplication>

namespace skyseal::ui {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::OneWay)
};

} // namespace

std::optional<OneWay> oneWayOf(const ViewState &view)
{
    if (!view.link || view.vehicle->session)
        return std::nullopt;
    if (view.link->url.starts_with("tlog:"))
        return OneWay{Text::tr("A recording"),
                      Text::tr("What is shown was recorded earlier. Nothing of it is live, and nothing can be sent."),
                      Text::tr("it is a recording"), true};
    if (view.link->listenOnly)
        return OneWay{Text::tr("Not sealed, only listened to"),
                      Text::tr("This stream is protected as MAVSec's published code does it, which is insecure: who is "
                               "on the way can change it. Nothing is sent to it."),
                      Text::tr("its link is only listened to")};
    return std::nullopt;
}

} // namespace skyseal::ui
