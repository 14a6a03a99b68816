// The address of a gateway's control socket: unix:PATH.
#pragma once

#include "app/common/options.h"

#include <QtCore/QString>

namespace skyseal::app {

/// --control
inline void declareControl(Options &options, const char *help)
{
    options.addValue("control", "unix:PATH", help);
}

/// The path of the socket; records a problem if the option is not one.
inline QString readControl(Options &options)
{
    const QString url = QString::fromStdString(options.text("control"));
    QString path = url.section(QLatin1Char(':'), 1);
    if (!url.startsWith(QLatin1String("unix:/")) || path.size() < 2)
        options.fail("--control '" + url.toStdString() + "': unix:/PATH is expected");
    return path;
}

} // namespace skyseal::app
