#include "app/common/sweep_setting.h"

#include "core/experiment/setting.h"

#include <QtCore/QDateTime>

namespace skyseal::app {

experiment::Setting describeSetting(const char *version, const QString &command)
{
    experiment::Setting out;
    out.emplace_back("skyseal", version);
    out.emplace_back("time", QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString());
    out.emplace_back("command_line", command.toStdString());
    for (auto &entry : experiment::machineSetting())
        out.push_back(std::move(entry));
    out.emplace_back("qt", qVersion());
    return out;
}

} // namespace skyseal::app
