// The table of link types: texts that derive from it agree with it, and a further type needs its class and one row.
#include "core/link/link_type.h"
#include "core/link/make_link.h"
#include "tests/link/block_recorder.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

#include <algorithm>
#include <array>

using namespace skyseal;
using namespace skyseal::link;

namespace {

/// A link that returns each block to its sender, as an example of a further type.
class EchoLink final : public Link
{
public:
    using Link::Link;

    void open() override { setState(LinkState::Connected); }
    void close() override { setState(LinkState::Closed); }
    void send(const Address &to, ByteView block) override
    {
        Bytes copy(block.begin(), block.end());
        const ReceivedBlock back{{id(), to}, copy, TimePoint{}};
        listener().linkReceived(*this, {&back, 1});
    }
    void flush() override {}
};

std::unique_ptr<Link> makeEcho(const LinkUrl &url, LinkId id, LinkListener &listener, const LinkOptions &options)
{
    return std::make_unique<EchoLink>(url, id, listener, options);
}

} // namespace

class LinkTypeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rowsAreComplete();
    void schemesAreFoundInAnyCase();
    void formsAreFilteredByTraits();
    void manualPageListsEachType();
    void furtherTypeNeedsOneRow();
};

void LinkTypeTest::rowsAreComplete()
{
    for (const LinkType &type : linkTypes()) {
        const std::string_view scheme = type.scheme;
        QVERIFY(!scheme.empty() && std::all_of(scheme.begin(), scheme.end(), [](char c) { return c >= 'a' && c <= 'z'; }));
        QVERIFY(*type.label && *type.hint);
        QCOMPARE(type.defaultBaud > 0, type.target == LinkTarget::DeviceBaud);
        QVERIFY(!type.traits.isSlow);
        const bool sameScheme = std::count_if(linkTypes().begin(), linkTypes().end(),
                                              [&](const LinkType &other) { return other.scheme == scheme; })
            == 1;
        QVERIFY2(sameScheme, type.scheme);
        const std::string text = type.target == LinkTarget::HostPort ? type.scheme + std::string(":127.0.0.1:1")
                                                                     : type.scheme + std::string(":x");
        QCOMPARE(&LinkUrl::parse(text).value().type(), &type);
    }
}

void LinkTypeTest::schemesAreFoundInAnyCase()
{
    QCOMPARE(findLinkType("TcpIn")->scheme, "tcpin");
    QVERIFY(!findLinkType(""));
    QVERIFY(!findLinkType("udp"));
    QVERIFY(!findLinkType("udpins"));
}

void LinkTypeTest::formsAreFilteredByTraits()
{
    QCOMPARE(linkForms(),
             std::string("udpin:HOST:PORT, udpout:HOST:PORT, tcp:HOST:PORT, tcpin:HOST:PORT, "
                         "serial:/dev/NAME:BAUD or tlog:FILE"));
    QCOMPARE(linkForms([](const LinkTraits &traits) { return traits.isListening; }),
             std::string("udpin:HOST:PORT or tcpin:HOST:PORT"));
    QCOMPARE(linkForms([](const LinkTraits &traits) { return traits.isRecording; }), std::string("tlog:FILE"));
}

void LinkTypeTest::manualPageListsEachType()
{
    QFile page(QStringLiteral(SKYSEAL_SOURCE_DIR "/packaging/man/skyseal-links.7"));
    QVERIFY(page.open(QIODevice::ReadOnly));
    static const QRegularExpression entry(QStringLiteral("^\\.TP\n\\.B (.*)\n(.*)$"), QRegularExpression::MultilineOption);
    auto found = entry.globalMatch(QString::fromUtf8(page.readAll()));
    for (const LinkType &type : linkTypes()) {
        QVERIFY2(found.hasNext(), type.scheme);
        const auto match = found.next();
        QCOMPARE(match.captured(1).toStdString(), type.syntax());
        QCOMPARE(match.captured(2), QString::fromUtf8(type.hint));
    }
    QVERIFY(!found.hasNext());
}

void LinkTypeTest::furtherTypeNeedsOneRow()
{
    const std::array types{linkTypes()[0],
                           LinkType{"echo", LinkTarget::HostPort, {.hasOneRemote = true}, "Echo", "Returns.", makeEcho}};
    const auto url = LinkUrl::parse("echo:[::1]:7", LinkUrl::kAnyHost, types);
    QVERIFY(url.has_value());
    QCOMPARE(url->toText(), std::string("echo:[::1]:7"));
    QVERIFY(url->traits().isDatagramClient());
    QCOMPARE(LinkUrl::parse("pigeon:1", LinkUrl::kAnyHost, types).error().message,
             std::string("a link URL starts with udpin: or echo:"));

    test::BlockRecorder recorder;
    const auto link = makeLink(*url, LinkId{1}, recorder);
    link->open();
    QCOMPARE(link->state(), LinkState::Connected);
    QCOMPARE(link->localAddress(), std::string("[::1]:7"));
    link->send({}, Bytes{1, 2, 3});
    QCOMPARE(recorder.blocks.size(), std::size_t(1));
}

SKYSEAL_TEST(LinkTypeTest)
#include "link_type_test.moc"
