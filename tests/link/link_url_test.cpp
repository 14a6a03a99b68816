// Link URLs: accepted forms, errors for other texts, and the canonical text, which parses back.
#include "core/link/address_text.h"
#include "core/link/link_url.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

using namespace skyseal;
using namespace skyseal::link;

class LinkUrlTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void accepts_data();
    void accepts();
    void callerChoosesTheDefaultHost();
    void traits_data();
    void traits();
    void recordingIsReplayed();
    void reachesTheOwnPort_data();
    void reachesTheOwnPort();
    void sharesAPort();
    void refuses_data();
    void refuses();
    void canonicalTextParsesBack();
    void anyTextGivesAUrlOrAnError();
    void addressTextParsesBack();
    void addressRefusesOtherTexts();
};

void LinkUrlTest::accepts_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<std::string>("canonical");
    const auto row = [](const char *text, const char *canonical) {
        QTest::newRow(text) << std::string(text) << std::string(canonical);
    };
    row("udpin:0.0.0.0:14550", "udpin:0.0.0.0:14550");
    row("udpin://0.0.0.0:14550", "udpin:0.0.0.0:14550");
    row("udpin:14550", "udpin:0.0.0.0:14550");
    row("udpin::14550", "udpin:0.0.0.0:14550");
    row("udpin:127.0.0.1:0", "udpin:127.0.0.1:0");
    row("UDPOUT:localhost:1", "udpout:localhost:1");
    row("udpout:drone-7.example.org:65535", "udpout:drone-7.example.org:65535");
    row("udpout:[::1]:14550", "udpout:[::1]:14550");
    row("udpout:[0:0:0:0:0:0:0:1]:14550", "udpout:[::1]:14550");
    row("udpin:[::]:14550", "udpin:[::]:14550");
    row("tcp:192.168.1.4:5760", "tcp:192.168.1.4:5760");
    row("tcpin:5760", "tcpin:0.0.0.0:5760");
    row("serial:/dev/ttyUSB0:921600", "serial:/dev/ttyUSB0:921600");
    row("serial:///dev/ttyUSB0:921600", "serial:/dev/ttyUSB0:921600");
    row("serial:/dev/ttyACM0", "serial:/dev/ttyACM0:57600");
    row("serial:COM3:115200", "serial:COM3:115200");
    row("tlog:flight.tlog", "tlog:flight.tlog");
    row("tlog:///var/log/a b:c.tlog", "tlog:/var/log/a b:c.tlog");
    row("tlog:////odd", "tlog:////odd");
}

void LinkUrlTest::accepts()
{
    QFETCH(std::string, text);
    QFETCH(std::string, canonical);
    const auto url = LinkUrl::parse(text);
    QVERIFY2(url.has_value(), url ? "" : url.error().text().c_str());
    QCOMPARE(url->toText(), canonical);
    QCOMPARE(LinkUrl::parse(canonical).value(), *url);
}

void LinkUrlTest::callerChoosesTheDefaultHost()
{
    const auto parsed = [](const char *text) { return LinkUrl::parse(text, LinkUrl::kLoopback)->toText(); };
    QCOMPARE(parsed("udpin:14551"), std::string("udpin:127.0.0.1:14551"));
    QCOMPARE(parsed("udpin::14551"), std::string("udpin:127.0.0.1:14551"));
    QCOMPARE(parsed("tcpin://5760"), std::string("tcpin:127.0.0.1:5760"));
    QCOMPARE(parsed("udpin:0.0.0.0:14551"), std::string("udpin:0.0.0.0:14551"));
}

void LinkUrlTest::traits_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<LinkTraits>("traits");
    const auto row = [](const char *text, LinkTraits traits) { QTest::newRow(text) << std::string(text) << traits; };
    row("udpin:14550", {.isListening = true});
    row("udpout:h:1", {.hasOneRemote = true});
    row("tcp:h:1", {.isStream = true, .hasOneRemote = true});
    row("tcpin:1", {.isStream = true, .isListening = true});
    row("serial:/dev/ttyUSB0:57600", {.isStream = true, .hasOneRemote = true, .isSlow = true});
    row("serial:/dev/ttyUSB0:230400", {.isStream = true, .hasOneRemote = true, .isSlow = true});
    row("serial:/dev/ttyUSB0:460800", {.isStream = true, .hasOneRemote = true});
    row("tlog:a.tlog", {.isRecording = true});
}

void LinkUrlTest::traits()
{
    QFETCH(std::string, text);
    QFETCH(LinkTraits, traits);
    const LinkUrl url = LinkUrl::parse(text).value();
    QVERIFY(url.traits() == traits);
    QCOMPARE(url.traits().isDatagramServer(), text.starts_with("udpin:"));
    QCOMPARE(url.traits().isDatagramClient(), text.starts_with("udpout:"));
}

void LinkUrlTest::recordingIsReplayed()
{
    const auto url = LinkUrl::parse(LinkUrl::ofRecording("/tmp/a flight.tlog"));
    QVERIFY(url && url->traits().isRecording);
    QCOMPARE(url->path(), std::string("/tmp/a flight.tlog"));
}

void LinkUrlTest::reachesTheOwnPort_data()
{
    QTest::addColumn<std::string>("sending");
    QTest::addColumn<std::string>("listening");
    QTest::addColumn<bool>("reaches");
    const auto row = [](const char *sending, const char *listening, bool reaches) {
        QTest::addRow("%s, %s", sending, listening) << std::string(sending) << std::string(listening) << reaches;
    };
    row("udpout:127.0.0.1:14550", "udpin:0.0.0.0:14550", true);
    row("udpout:localhost:14550", "udpin:127.0.0.1:14550", true);
    row("udpout:0.0.0.0:14550", "udpin:127.0.0.1:14550", true);
    row("udpout:10.1.0.9:14550", "udpin:10.1.0.9:14550", true);
    row("udpout:[::1]:14550", "udpin:[::]:14550", true);
    row("tcp:127.0.0.1:5760", "tcpin:0.0.0.0:5760", true);
    row("udpout:127.0.0.1:14551", "udpin:0.0.0.0:14550", false);
    row("udpout:10.1.0.9:14550", "udpin:0.0.0.0:14550", false); // perhaps of another machine
    row("udpout:127.0.0.1:14550", "udpin:10.1.0.9:14550", false);
    row("udpout:0.0.0.0:14550", "udpin:10.1.0.9:14550", false);
    row("udpout:127.0.0.1:14550", "udpin:127.0.0.2:14550", false);
    row("udpout:127.0.0.1:14550", "udpin:[::]:14550", false);
    row("udpout:planner:14550", "udpin:0.0.0.0:14550", false);
    row("udpout:127.0.0.1:14550", "tcpin:0.0.0.0:14550", false);
    row("udpout:127.0.0.1:14550", "udpout:127.0.0.1:14550", false);
    row("udpin:127.0.0.1:14550", "udpin:127.0.0.1:14550", false);
    row("udpout:127.0.0.1:14550", "serial:/dev/ttyUSB0:57600", false);
    row("serial:/dev/ttyUSB0:57600", "udpin:127.0.0.1:14550", false);
}

void LinkUrlTest::reachesTheOwnPort()
{
    QFETCH(std::string, sending);
    QFETCH(std::string, listening);
    QFETCH(bool, reaches);
    QCOMPARE(LinkUrl::parse(sending)->reaches(*LinkUrl::parse(listening)), reaches);
}

void LinkUrlTest::sharesAPort()
{
    const auto share = [](const char *one, const char *other) {
        const LinkUrl first = *LinkUrl::parse(one), second = *LinkUrl::parse(other);
        return first.sharesPort(second) && second.sharesPort(first);
    };
    QVERIFY(share("udpin:127.0.0.1:14550", "udpin:127.0.0.1:14550"));
    QVERIFY(share("udpin:127.0.0.1:14550", "udpin:0.0.0.0:14550"));
    QVERIFY(share("tcpin:localhost:5760", "tcpin:5760"));
    QVERIFY(!share("udpin:127.0.0.1:14550", "udpin:127.0.0.1:14551"));
    QVERIFY(!share("udpin:127.0.0.1:14550", "udpin:127.0.0.2:14550"));
    QVERIFY(!share("udpin:127.0.0.1:0", "udpin:127.0.0.1:0"));
    QVERIFY(!share("udpin:0.0.0.0:14550", "udpin:[::]:14550"));
    QVERIFY(!share("udpin:5760", "tcpin:5760"));
    QVERIFY(!share("udpin:14550", "udpout:127.0.0.1:14550"));
    QVERIFY(!share("serial:/dev/ttyUSB0:57600", "serial:/dev/ttyUSB0:57600"));
}

void LinkUrlTest::refuses_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<int>("column");
    QTest::addColumn<std::string>("says");
    const auto row = [](const char *text, int column, const char *says) {
        QTest::newRow(text) << std::string(text) << column << std::string(says);
    };
    row("", 1, "starts with udpin:");
    row("udp:1.2.3.4:5", 1, "udpin:, udpout:, tcp:, tcpin:, serial: or tlog:");
    row("14550", 1, "starts with");
    row("udpin:", 7, "the port is missing");
    row("udpin:127.0.0.1", 16, "the port is missing, as in udpin:HOST:PORT");
    row("udpin:127.0.0.1:", 17, "the port is missing");
    row("udpout:14550", 13, "the port is missing");
    row("udpout::14550", 8, "the host is missing");
    row("udpout:1.2.3.4:0", 16, "\"0\" is not a number from 1 to 65535");
    row("udpin:1.2.3.4:65536", 15, "\"65536\" is not a number from 0 to 65535");
    row("udpin:1.2.3.4:-1", 15, "is not a number");
    row("udpin:1.2.3.4:14550x", 15, "is not a number");
    row("udpin:1.2.3.256:5", 7, "not an IPv4 address");
    row("udpin:1.2.3:5", 7, "not an IPv4 address");
    row("udpin:01.2.3.4:5", 7, "not an IPv4 address");
    row("udpin:::1:14550", 7, "in brackets");
    row("udpin:[::1:14550", 7, "closing bracket");
    row("udpin:[::1]", 12, "the port is missing");
    row("udpin:[::1]x:14550", 12, "the port is missing");
    row("udpin:[1.2.3.4]:14550", 7, "not an IPv6 address");
    row("udpin:[fe80::1%eth0]:14550", 7, "zone");
    row("tcp:bad host:1", 5, "not a host name");
    row("tcp:-h:1", 5, "not a host name");
    row("tcp:a..b:1", 5, "not a host name");
    row("tcp:a-.b:1", 5, "not a host name");
    row("tcp:a.-b:1", 5, "not a host name");
    row("serial:", 8, "the device is missing");
    row("serial::57600", 8, "the device is missing");
    row("serial:/dev/ttyS0:fast", 19, "the baud rate");
    row("serial:/dev/ttyS0:0", 19, "the baud rate");
    row("tlog:", 6, "the file is missing");
    row("tlog:a\nb", 7, "control characters");
}

void LinkUrlTest::refuses()
{
    QFETCH(std::string, text);
    QFETCH(int, column);
    QFETCH(std::string, says);
    const auto url = LinkUrl::parse(text);
    QVERIFY(!url.has_value());
    QVERIFY2(url.error().message.text().find(says) != std::string::npos, url.error().text().c_str());
    QCOMPARE(int(url.error().column), column);
    QCOMPARE(url.error().source, text);
}

void LinkUrlTest::canonicalTextParsesBack()
{
    QVERIFY(rc::check("toText() of what was parsed parses to the same", [] {
        const std::string scheme = *rc::gen::elementOf(
            std::vector<std::string>{"udpin", "udpout", "tcp", "tcpin", "serial", "tlog"});
        const std::string rest = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("0123456789.:/[]-abfxyz_")));
        const auto url = LinkUrl::parse(scheme + ":" + rest);
        if (!url)
            RC_DISCARD("not a URL");
        const auto again = LinkUrl::parse(url->toText());
        RC_ASSERT(again.has_value());
        RC_ASSERT(*again == *url);
        RC_ASSERT(again->toText() == url->toText());
    }));
}

void LinkUrlTest::anyTextGivesAUrlOrAnError()
{
    QVERIFY(rc::check("any text gives a URL or a message with a column inside it", [](const std::string &text) {
        const auto url = LinkUrl::parse("udpin:" + text);
        if (url)
            return;
        RC_ASSERT(!url.error().message.empty());
        RC_ASSERT(url.error().column >= 1u && url.error().column <= text.size() + 7);
    }));
}

void LinkUrlTest::addressTextParsesBack()
{
    QVERIFY(rc::check("toText(Address) parses back", [](std::array<std::uint8_t, 16> ip, std::uint16_t port, bool four) {
        Address address{ip, port};
        if (four) {
            const Address mapped = ipv4(0, 0);
            std::copy_n(mapped.ip.begin(), 12, address.ip.begin());
        }
        RC_ASSERT(parseAddress(toText(address)) == address);
        RC_ASSERT(fromQt(toQt(address), port) == address);
    }));
    QCOMPARE(toText(ipv4(0x01020304, 14550)), std::string("1.2.3.4:14550"));
    QCOMPARE(toText(Address{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}, 5}), std::string("[::1]:5"));
    QVERIFY(isAnyAddress(parseAddress("0.0.0.0:1").value()));
    QVERIFY(isAnyAddress(parseAddress("[::]:1").value()));
    QVERIFY(!isAnyAddress(parseAddress("[::1]:1").value()));
}

void LinkUrlTest::addressRefusesOtherTexts()
{
    for (const char *text : {"", "1.2.3.4", "1.2.3.4:", ":5", "1.2.3.4:65536", "1.2.3.4.5:1", "::1:5", "[::1]", "[::1]5",
                             "[1.2.3.4]:5", "localhost:5", "1.2.3.4:5 ", "[::1%lo]:5", "1.2.3.:5", "1..2.3:5", "+1.2.3.4:5"})
        QVERIFY2(!parseAddress(text), text);
}

SKYSEAL_TEST(LinkUrlTest)
#include "link_url_test.moc"
