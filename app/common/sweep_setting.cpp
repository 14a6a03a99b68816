#include "app/common/sweep_setting.h"

#include "app/common/sweep_files.h"
#include "core/experiment/setting.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QCryptographicHash>
#include <QtCore/QDateTime>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

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
    QStringList programs;
    for (const char *name : {"skyseal-cli", "skyseal-air", "skyseal-sim"})
        programs << programPath(QString::fromLatin1(name));
    const QString own = QCoreApplication::applicationFilePath(); // the station that measures, which may be the window
    if (const QString name = QFileInfo(own).fileName(); !name.isEmpty() && name != QLatin1String("skyseal-cli"))
        programs << own;
    for (const QString &path : std::as_const(programs)) {
        QFile program(path);
        QCryptographicHash hash(QCryptographicHash::Sha256);
        if (program.open(QIODevice::ReadOnly) && hash.addData(&program))
            out.emplace_back("sha256_" + QFileInfo(path).fileName().toStdString(), hash.result().toHex().toStdString());
    }
    return out;
}

std::string messageMix(const std::optional<link::LinkUrl> &link, const std::optional<link::LinkUrl> &autopilot,
                       const std::string &flight)
{
    if (link)
        return "that of the vehicle on " + link->toText();
    if (!autopilot)
        return "that of the simulated vehicle of this version";
    return "the streams that a station requests of an autopilot, "
        + (flight.empty() ? std::string("in the state in which it is") : "in the flight '" + flight + "'");
}

} // namespace skyseal::app
