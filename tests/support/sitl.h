// A real autopilot for tests that require arducopter: the unmodified ArduCopter SITL that ARDUPILOT_SITL names (waf's
// build/sitl/bin/arducopter, or any prebuilt one).
#pragma once

#include "tests/support/program.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtNetwork/QUdpSocket>

#include <memory>

namespace skyseal::test {

class Sitl
{
public:
    /// `more`: further lines of parameters.
    explicit Sitl(const QByteArray &more = {}) : m_program(qEnvironmentVariable("ARDUPILOT_SITL"))
    {
        // Parameters that let a simulated vehicle arm: frame class, calibrated sensors, centered sticks.
        const char parameters[] =
            "FRAME_CLASS 1\nFRAME_TYPE 0\nBATT_MONITOR 4\nEK2_ENABLE 1\nFS_THR_ENABLE 1\n"
            "RC1_MAX 2000\nRC1_MIN 1000\nRC1_TRIM 1500\nRC2_MAX 2000\nRC2_MIN 1000\nRC2_TRIM 1500\n"
            "RC3_MAX 2000\nRC3_MIN 1000\nRC3_TRIM 1500\nRC4_MAX 2000\nRC4_MIN 1000\nRC4_TRIM 1500\n"
            "COMPASS_OFS_X 5\nCOMPASS_OFS_Y 13\nCOMPASS_OFS_Z -18\nCOMPASS_OFS2_X 5\nCOMPASS_OFS2_Y 13\nCOMPASS_OFS2_Z -18\n"
            "COMPASS_OFS3_X 5\nCOMPASS_OFS3_Y 13\nCOMPASS_OFS3_Z -18\n"
            "INS_ACCOFFS_X 0.001\nINS_ACCOFFS_Y 0.001\nINS_ACCOFFS_Z 0.001\nINS_ACCSCAL_X 1.001\nINS_ACCSCAL_Y 1.001\n"
            "INS_ACCSCAL_Z 1.001\nINS_ACC2OFFS_X 0.001\nINS_ACC2OFFS_Y 0.001\nINS_ACC2OFFS_Z 0.001\nINS_ACC2SCAL_X 1.001\n"
            "INS_ACC2SCAL_Y 1.001\nINS_ACC2SCAL_Z 1.001\n";
        QFile file(parameterFile());
        if (!file.open(QIODevice::WriteOnly) || file.write(parameters + more) < 0)
            qFatal("no folder for the parameters");
    }

    QString program() const { return m_program; }

    /// Runs it on a TCP port at `speed` times real time. Its eeprom and logs go to a temporary working directory, into which
    /// this process changes.
    std::unique_ptr<Program> start(quint16 port, int speed) const
    {
        if (!QDir::setCurrent(m_folder.path()))
            qFatal("no working directory");
        return std::make_unique<Program>(
            m_program,
            QStringList{QStringLiteral("--wipe"), QStringLiteral("--synthetic-clock"), QStringLiteral("--disable-fgview"),
                        QStringLiteral("--home"), QStringLiteral("-35.363261,149.165230,584,353"), QStringLiteral("--model"),
                        QStringLiteral("+"), QStringLiteral("--speedup"), QString::number(speed), QStringLiteral("--defaults"),
                        parameterFile(), QStringLiteral("--base-port"), QString::number(port), QStringLiteral("--rc-in-port"),
                        QString::number(m_sticks), QStringLiteral("-I0")});
    }

    /// The sticks of the pilot's transmitter go to their middle. The throttle is down before, so that LOITER descends.
    void centreSticks() const
    {
        const quint16 channels[8] = {1500, 1500, 1500, 1500, 1800, 1000, 1000, 1800};
        QUdpSocket().writeDatagram(reinterpret_cast<const char *>(channels), sizeof channels, QHostAddress::LocalHost,
                                   m_sticks);
    }

private:
    QString parameterFile() const { return m_folder.filePath(QStringLiteral("copter.parm")); }

    QTemporaryDir m_folder;
    QString m_program;
    quint16 m_sticks = freeUdpPort();
};

} // namespace skyseal::test
