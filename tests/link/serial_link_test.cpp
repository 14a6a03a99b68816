// The serial link on a pseudo-terminal whose other end the test holds: both directions, a missing device, and a device that is
// unplugged and plugged in again.
#include "tests/link/block_recorder.h"
#include "tests/support/eventually.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cstdlib>

#include <fcntl.h>
#include <unistd.h>

using namespace skyseal;
using namespace skyseal::link;
using namespace skyseal::test;

namespace {

/// The other end of the serial line.
class PseudoTerminal
{
public:
    PseudoTerminal() : m_fd(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        if (m_fd < 0 || ::grantpt(m_fd) != 0 || ::unlockpt(m_fd) != 0)
            qFatal("no pseudo-terminal");
    }
    ~PseudoTerminal() { ::close(m_fd); }
    PseudoTerminal(const PseudoTerminal &) = delete;
    PseudoTerminal &operator=(const PseudoTerminal &) = delete;

    std::string device() const { return ::ptsname(m_fd); }
    bool write(std::string_view text) { return ::write(m_fd, text.data(), text.size()) == ssize_t(text.size()); }
    const std::string &read()
    {
        std::array<char, 4096> buffer;
        for (ssize_t length; (length = ::read(m_fd, buffer.data(), buffer.size())) > 0;)
            m_heard.append(buffer.data(), std::size_t(length));
        return m_heard;
    }

private:
    int m_fd;
    std::string m_heard;
};

} // namespace

class SerialLinkTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void carriesBothWays();
    void bytesPassUnchanged();
    void missingDeviceIsReportedAndRetried();
    void unpluggedDeviceIsReported();

private:
    static LinkOptions quick()
    {
        LinkOptions out;
        out.retryFirst = std::chrono::milliseconds(20);
        out.retryMax = std::chrono::milliseconds(50);
        return out;
    }
};

void SerialLinkTest::carriesBothWays()
{
    PseudoTerminal radio;
    BlockRecorder recorder;
    const auto link = openLink("serial:" + radio.device() + ":57600", recorder, quick(), LinkId{5});
    QCOMPARE(link->state(), LinkState::Connected);
    QVERIFY(link->isStream());
    QCOMPARE(link->localAddress(), radio.device() + ":57600");
    QCOMPARE(recorder.joined, (std::vector<Path>{{LinkId{5}, {}}}));
    QVERIFY(radio.write("from the radio"));
    EVENTUALLY_EQUAL(recorder.stream(), std::string("from the radio"));
    link->send({}, asBytes("to the radio"));
    link->flush();
    EVENTUALLY_EQUAL(radio.read(), std::string("to the radio"));
    link->close();
    QCOMPARE(recorder.left, recorder.joined);
}

void SerialLinkTest::bytesPassUnchanged()
{
    PseudoTerminal radio;
    BlockRecorder recorder;
    const auto link = openLink("serial:" + radio.device() + ":57600", recorder, quick());
    std::string all;
    for (int i = 0; i < 256; ++i)
        all.push_back(static_cast<char>(i));
    QVERIFY(radio.write(all));
    EVENTUALLY_EQUAL(recorder.stream(), all);
    link->send({}, asBytes(all));
    link->flush();
    EVENTUALLY_EQUAL(radio.read(), all);
}

void SerialLinkTest::missingDeviceIsReportedAndRetried()
{
    QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("radio"));
    BlockRecorder recorder;
    const auto link = openLink("serial:" + name.toStdString(), recorder, quick());
    QCOMPARE(link->state(), LinkState::Waiting);
    QCOMPARE(link->error().code, LinkErrorCode::DeviceMissing);
    QCOMPARE(link->error().sentence(), "there is no device " + name.toStdString());
    PseudoTerminal radio;
    QVERIFY(QFile::link(QString::fromStdString(radio.device()), name));
    EVENTUALLY_EQUAL(link->state(), LinkState::Connected);
    QVERIFY(radio.write("here"));
    EVENTUALLY_EQUAL(recorder.stream(), std::string("here"));
}

void SerialLinkTest::unpluggedDeviceIsReported()
{
    auto radio = std::make_unique<PseudoTerminal>();
    BlockRecorder recorder;
    const auto link = openLink("serial:" + radio->device() + ":57600", recorder, quick());
    QCOMPARE(link->state(), LinkState::Connected);
    radio.reset();
    EVENTUALLY_EQUAL(link->state(), LinkState::Waiting);
    QCOMPARE(link->error().code, LinkErrorCode::DeviceMissing);
    QCOMPARE(recorder.left.size(), std::size_t(1));
    link->send({}, asBytes("lost"));
    QCOMPARE(link->counters().txDropped, std::uint64_t(1));
}

SKYSEAL_TEST(SerialLinkTest)
#include "serial_link_test.moc"
