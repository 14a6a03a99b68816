// Escape sequences, further lines and changes of direction that others put into texts, names and file names: none reaches the
// terminal, from any program, on neither stream.
#include "core/base/printable.h"
#include "core/keys/public_key_text.h"
#include "core/mavlink/messages.h"
#include "tests/support/clear_frames.h"
#include "tests/support/heartbeat.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>
#include <QtCore/QtEndian>
#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::test;

namespace {

/// Sets the title of a terminal, clears it, begins a line, and turns the direction of the text.
const QByteArray kHostile("\x1b]0;owned\x07\x1b[2J\xc2\x9b"
                          "2J\nowned\r\xe2\x80\xaeowned\xe2\x80\x8b");

template<std::size_t Size> void fill(std::array<char, Size> &field)
{
    std::copy_n(kHostile.begin(), std::min<std::size_t>(Size, static_cast<std::size_t>(kHostile.size())), field.begin());
}

QByteArray recordingOfHostileTexts()
{
    mavlink::Statustext text;
    text.severity = mavlink::MAV_SEVERITY_WARNING;
    fill(text.text);
    mavlink::ParamValue value{.param_count = 1};
    value.param_id = {'\x1b', '[', '2', 'J', 'o', 'w', 'n', 'e', 'd'};
    QByteArray out;
    std::uint64_t time = 1'700'000'000'000'000;
    for (int i = 0; i < 20; ++i) {
        for (const QByteArray &frame : {clearHeartbeat(1, 1, false), frameOf(text, 1, 1), frameOf(value, 1, 1)}) {
            std::array<char, 8> stamp;
            qToBigEndian(time += 20'000, stamp.data());
            out.append(stamp.data(), stamp.size()).append(frame);
        }
    }
    return out;
}

} // namespace

class EscapeSequencesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void noneReachesTheTerminal_data();
    void noneReachesTheTerminal();

private:
    void write(const QString &name, const QByteArray &content) const
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        file.write(content);
    }

    QTemporaryDir m_folder;
    const QString m_name = QString::fromUtf8(kHostile);
};

void EscapeSequencesTest::initTestCase()
{
    write(QStringLiteral("flight.tlog"), recordingOfHostileTexts());
    crypto::PublicKey key{};
    key[0] = 9;
    const QByteArray name = QByteArray(kHostile).replace('\n', "").replace('\r', "").left(30);
    write(QStringLiteral("hostile.peers"), name + " pilot any " + QByteArray::fromStdString(keys::publicKeyText(key)) + "\n");
    write(m_name, recordingOfHostileTexts());
}

void EscapeSequencesTest::noneReachesTheTerminal_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QStringList>("arguments");
    const auto row = [](const char *name, const char *program, const QStringList &arguments) {
        QTest::newRow(name) << QString::fromLatin1(program) << arguments;
    };
    const auto list = [](const char *words) { return QString::fromLatin1(words).split(QLatin1Char(' ')); };
    const QString log = m_folder.filePath(QStringLiteral("flight.tlog")), other = m_folder.filePath(m_name),
                  peers = m_folder.filePath(QStringLiteral("hostile.peers"));
    const QStringList replay = list("monitor --secure off --duration 2 --no-record --link") << QStringLiteral("tlog:") + log;
    row("texts of a vehicle", "skyseal-cli", replay);
    row("texts of a vehicle, JSON", "skyseal-cli", replay + list("--json"));
    row("decoded texts", "skyseal-cli", list("decode") << log);
    row("decoded texts, JSON", "skyseal-cli", list("decode --json") << log);
    row("file name, JSON", "skyseal-cli", list("log info --json") << other);
    row("name of a missing file", "skyseal-cli", list("log verify") << other + m_name);
    row("name of a missing export", "skyseal-cli", list("log export --out /nonexistent/owned") << other + m_name);
    row("name in a list of peers", "skyseal-cli", list("keys peers list --peers") << peers);
    row("name of a peer", "skyseal-cli", list("keys peers revoke --peers") << peers << m_name);
    row("option", "skyseal-cli", list("monitor") << QStringLiteral("--") + m_name);
    row("command", "skyseal-cli", QStringList{m_name});
    row("link of a station", "skyseal-cli", list("monitor --link") << QStringLiteral("serial:/dev/") + m_name);
    row("key of an agent", "skyseal-air",
        list("--vehicle udpin:127.0.0.1:0 --ground udpout:127.0.0.1:9 --peers")
            << peers << QStringLiteral("--identity") << other);
    row("link of an agent", "skyseal-air", list("--ground udpout:127.0.0.1:9 --vehicle") << m_name);
    row("link of a simulator", "skyseal-sim", list("--link") << m_name);
    row("device of a simulator", "skyseal-sim", list("--link") << QStringLiteral("serial:/dev/") + m_name);
}

void EscapeSequencesTest::noneReachesTheTerminal()
{
    QFETCH(QString, program);
    QFETCH(QStringList, arguments);
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QStringLiteral(SKYSEAL_BIN_DIR "/") + program, arguments);
    QVERIFY(process.waitForStarted(kDeadlineMs));
    process.closeWriteChannel();
    QByteArray said;
    // A program that tries a missing device again and again does not end.
    EVENTUALLY((said += process.readAll()).contains("owned") || process.state() == QProcess::NotRunning);
    if (process.state() != QProcess::NotRunning)
        process.terminate();
    EVENTUALLY(process.state() == QProcess::NotRunning);
    said += process.readAll();
    QVERIFY2(said.contains("owned"), said.constData()); // the text was printed at all
    for (const QByteArray &line : said.split('\n')) {
        QVERIFY2(isPrintable(line.toStdString()), qPrintable(QString::fromLatin1(line.toHex())));
        QVERIFY2(!line.startsWith("owned"), line.constData()); // no line of its own
    }
}

SKYSEAL_TEST(EscapeSequencesTest)
#include "escape_sequences_test.moc"
