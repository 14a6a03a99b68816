#include "app/common/sweep_setting.h"

#include "app/common/sweep_files.h"
#include "core/experiment/setting.h"

#include <QtCore/QCryptographicHash>
#include <QtCore/QDateTime>
#include <QtCore/QFile>

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
    for (const char *name : {"skyseal-cli", "skyseal-air", "skyseal-sim"}) {
        QFile program(programPath(QString::fromLatin1(name)));
        QCryptographicHash hash(QCryptographicHash::Sha256);
        if (program.open(QIODevice::ReadOnly) && hash.addData(&program))
            out.emplace_back("sha256_" + std::string(name), hash.result().toHex().toStdString());
    }
    return out;
}

} // namespace skyseal::app
