// Negotiation over every pair of suite sets: only suites that both ends allow, never research or plain by itself, and no
// choice that differs from the initiator's own result.
#include "core/base/research.h"
#include "core/channel/handshake_payload.h"
#include "core/channel/negotiation.h"
#include "core/channel/suite_list.h"
#include "core/channel/suite_strength.h"
#include "tests/support/test_runner.h"

#include <QtTest/QTest>
#include <rapidcheck.h>

#include <algorithm>
#include <random>

using namespace skyseal;
using namespace skyseal::channel;
using crypto::SuiteId;

class NegotiationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void defaultSuiteIsFirst();
    void everyPairOfSets();
    void strippedOffersAreDetected();
    void offersSurviveTheWire();
    void unknownNumbersAreSkipped();
    void seventhSuiteTakesPart();
    void everySuiteOfThePolicyIsOffered();
    void offerIsCutToTheRoomOfTheList();
    void suiteCountFitsTheMessage();
    void payloadsOfOtherLengthsAreRefused();
    void policyWithDuplicatesAndNone();
    void weakestAllowedSuiteIsEnforced();
};

namespace {

const std::vector<SuiteId> kAll = defaultSuites();

std::vector<SuiteId> subset(unsigned bits)
{
    std::vector<SuiteId> out;
    for (std::size_t i = 0; i < kAll.size(); ++i) {
        if (bits >> i & 1)
            out.push_back(kAll[i]);
    }
    return out;
}

template<typename Check> void forEveryPair(Check check)
{
    for (unsigned a = 0; a < 64; ++a) {
        for (unsigned b = 0; b < 64; ++b) {
            for (unsigned flags = 0; flags < 16; ++flags) {
                check(offerOf(Policy{subset(a), bool(flags & 1), bool(flags & 2)}),
                      offerOf(Policy{subset(b), bool(flags & 4), bool(flags & 8)}));
            }
        }
    }
}

} // namespace

void NegotiationTest::defaultSuiteIsFirst()
{
    const SuiteOffer offer = offerOf(Policy{defaultSuites(), false, false});
    QCOMPARE(chooseSuite(offer, offer), SuiteId::ChaCha20Poly1305);
    QVERIFY(!holds(offer.suites, SuiteId::Rc4));
}

void NegotiationTest::everyPairOfSets()
{
    std::size_t pairs = 0;
    forEveryPair([&](const SuiteOffer &initiator, const SuiteOffer &responder) {
        ++pairs;
        const auto permitted = permittedSuites(initiator, responder);
        for (const SuiteId suite : kAll) {
            const bool research = crypto::suiteInfo(suite).research;
            const bool both = holds(initiator.suites, suite) && holds(responder.suites, suite)
                && (!research || (initiator.allowResearch && responder.allowResearch));
            QCOMPARE(holds(permitted, suite), both);
        }
        QCOMPARE(holds(permitted, SuiteId::None), initiator.allowPlain && responder.allowPlain);

        const auto chosen = chooseSuite(initiator, responder);
        if (!chosen) {
            QVERIFY(std::all_of(permitted.begin(), permitted.end(),
                                [](SuiteId suite) { return suite == SuiteId::None || crypto::suiteInfo(suite).research; }));
            return;
        }
        QVERIFY(holds(permitted, *chosen));
        QVERIFY(*chosen != SuiteId::None && !crypto::suiteInfo(*chosen).research);
        // the first suite of the initiator that both allow
        const auto first = std::find_if(initiator.suites.begin(), initiator.suites.end(), [&](SuiteId suite) {
            return holds(responder.suites, suite) && !crypto::suiteInfo(suite).research;
        });
        QCOMPARE(*chosen, *first);
    });
    QCOMPARE(pairs, std::size_t(64 * 64 * 16));
}

void NegotiationTest::strippedOffersAreDetected()
{
    // If an attacker could change the offers (they are hashed into the session), the initiator's own result and the responder's
    // choice would differ, or be a suite that both allow.
    QVERIFY(rc::check([] {
        const auto bits = rc::gen::inRange(0u, 64u);
        const SuiteOffer initiator = offerOf(Policy{subset(*bits), *rc::gen::arbitrary<bool>(), false});
        const SuiteOffer responder = offerOf(Policy{subset(*bits), *rc::gen::arbitrary<bool>(), false});
        SuiteOffer stripped = initiator; // the changed offer
        std::erase_if(stripped.suites, [&](SuiteId) { return *rc::gen::arbitrary<bool>(); });
        const auto choice = chooseSuite(stripped, responder);
        const auto expected = chooseSuite(initiator, responder);
        if (choice && choice == expected)
            RC_ASSERT(holds(permittedSuites(initiator, responder), *choice));
        else if (choice)
            RC_ASSERT(choice != expected); // detected: the handshake ends with OfferTampered
    }));
}

void NegotiationTest::offersSurviveTheWire()
{
    QVERIFY(rc::check([] {
        auto suites = kAll;
        std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
        std::shuffle(suites.begin(), suites.end(), random);
        suites.resize(*rc::gen::inRange<std::size_t>(0, suites.size() + 1));
        const SuiteOffer offer{suites, *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()};
        const ConnectionId connection{*rc::gen::arbitrary<std::uint16_t>()};

        const auto first = FirstPayload::read(FirstPayload{connection, offer, kGreatestCounter - 0x1122334455}.write());
        RC_ASSERT(first && first->offer == offer && first->connection == connection);
        RC_ASSERT(first->counter == kGreatestCounter - 0x1122334455u);
        const auto answer = AnswerPayload::read(AnswerPayload{connection, offer, SuiteId::Aes256Gcm}.write());
        RC_ASSERT(answer && answer->offer == offer && answer->connection == connection);
        RC_ASSERT(answer->chosen == SuiteId::Aes256Gcm);
    }));
}

void NegotiationTest::unknownNumbersAreSkipped()
{
    auto bytes = FirstPayload{ConnectionId{1}, {{SuiteId::Aes256Gcm}, false, false}, 1}.write();
    const SuiteListField field = packSuiteNumbers(std::vector<std::uint8_t>{9, 1, 255, 2, 14, 15});
    std::copy(field.begin(), field.end(), bytes.begin() + 3);
    const auto payload = FirstPayload::read(bytes);
    QVERIFY(payload);
    QCOMPARE(payload->offer.suites, (std::vector<SuiteId>{SuiteId::ChaCha20Poly1305, SuiteId::Aes256Gcm}));
    bytes[0] = 0xfc; // the four flags without a meaning
    QVERIFY(FirstPayload::read(bytes) && !FirstPayload::read(bytes)->offer.allowResearch);
    auto answer = AnswerPayload{ConnectionId{1}, {{SuiteId::Aes256Gcm}, false, false}, SuiteId::Aes256Gcm}.write();
    std::copy(field.begin(), field.end(), answer.begin() + 3);
    QVERIFY(AnswerPayload::read(answer));
    QCOMPARE(AnswerPayload::read(answer)->offer.suites, payload->offer.suites);
}

void NegotiationTest::seventhSuiteTakesPart()
{
    // Two ends of a later build share a seventh suite: it passes through this list, wherever it stands.
    for (const std::uint8_t seventh : {std::uint8_t(7), std::uint8_t(14), std::uint8_t(15), std::uint8_t(255)}) {
        if (crypto::suiteFromNumber(seventh))
            continue;
        for (std::size_t at = 0; at <= kAll.size(); ++at) {
            std::vector<std::uint8_t> numbers;
            for (const SuiteId suite : kAll)
                numbers.push_back(static_cast<std::uint8_t>(suite));
            numbers.insert(numbers.begin() + static_cast<std::ptrdiff_t>(at), seventh);
            const auto field = packSuiteNumbers(numbers);
            QCOMPARE(unpackSuiteNumbers(field), numbers);
        }
    }
}

void NegotiationTest::everySuiteOfThePolicyIsOffered()
{
    const std::vector<SuiteId> all = crypto::sealedSuites();
    std::size_t halves = 0;
    for (const SuiteId suite : all)
        halves += suiteNumberHalves(static_cast<std::uint8_t>(suite));
    constexpr std::size_t kSpareHalves = 3; // one more suite, of any number
    QVERIFY2(halves + kSpareHalves <= kSuiteListHalves, "widen the suite list of an offer before adding a suite");
    const SuiteOffer offer = offerOf(Policy{all, true, false});
    QCOMPARE(offer.suites, all);
    QCOMPARE(FirstPayload::read(FirstPayload{ConnectionId{1}, offer, 1}.write())->offer.suites, all);
    QCOMPARE(AnswerPayload::read(AnswerPayload{ConnectionId{1}, offer, all.front()}.write())->offer.suites, all);
}

void NegotiationTest::offerIsCutToTheRoomOfTheList()
{
    std::vector<std::uint8_t> numbers{14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1};
    SuiteOffer offer;
    for (const std::uint8_t number : numbers)
        offer.suites.push_back(static_cast<SuiteId>(number));
    const Policy policy{offer.suites, true, false};
    numbers.resize(kSuiteListHalves);

    const auto bytes = FirstPayload{ConnectionId{1}, offer, 1}.write();
    SuiteListField field{};
    std::copy_n(bytes.begin() + 3, field.size(), field.begin());
    QCOMPARE(unpackSuiteNumbers(field), numbers);

    if constexpr (kResearch) { // otherwise a policy may name only suites of the table
        offer.suites.resize(kSuiteListHalves);
        QCOMPARE(offerOf(policy).suites, offer.suites);
    }
}

void NegotiationTest::suiteCountFitsTheMessage()
{
    for (const std::uint64_t counter : {std::uint64_t(0), std::uint64_t(41), kGreatestCounter})
        QCOMPARE(NumberPayload::read(NumberPayload{counter}.write())->lastSeen, counter);
    QCOMPARE(NumberPayload::read(NumberPayload{UINT64_MAX}.write())->lastSeen, kGreatestCounter);
}

void NegotiationTest::payloadsOfOtherLengthsAreRefused()
{
    const Bytes bytes(40);
    for (std::size_t length = 0; length <= bytes.size(); ++length) {
        QCOMPARE(FirstPayload::read(ByteView(bytes).first(length)).has_value(), length == FirstPayload::kLength);
        QCOMPARE(AnswerPayload::read(ByteView(bytes).first(length)).has_value(), length == AnswerPayload::kLength);
        QCOMPARE(NumberPayload::read(ByteView(bytes).first(length)).has_value(), length == NumberPayload::kLength);
    }
}

void NegotiationTest::policyWithDuplicatesAndNone()
{
    using enum SuiteId;
    const Policy policy{{None, Aes256Gcm, Aes256Gcm, Rc4, ChaCha20, None}, false, true};
    QCOMPARE(offerOf(policy).suites, (std::vector<SuiteId>{Aes256Gcm, ChaCha20}));
    QVERIFY(offerOf(policy).allowPlain);
}

void NegotiationTest::weakestAllowedSuiteIsEnforced()
{
    using enum SuiteId;
    const std::vector list{ChaCha20Poly1305, Aes256Gcm, Aes256Ctr, Aes256Cbc, ChaCha20, Rc4};
    QCOMPARE(notWeakerThan(Rc4, list), list);
    QCOMPARE(notWeakerThan(Aes256Gcm, list), (std::vector{ChaCha20Poly1305, Aes256Gcm}));
    QCOMPARE(notWeakerThan(ChaCha20, list), (std::vector{ChaCha20Poly1305, Aes256Gcm, Aes256Ctr, ChaCha20}));
    // Research suites and plain MAVLink are weaker than every other suite.
    for (const crypto::SuiteInfo &info : crypto::suites()) {
        if (info.id != None)
            QCOMPARE(info.strength <= crypto::suiteInfo(Rc4).strength, info.research);
    }
    for (const SuiteId weakest : kAll) {
        for (unsigned bits = 0; bits < 64; ++bits) {
            const SuiteOffer here = offerOf(Policy{notWeakerThan(weakest, kAll), true, false});
            const SuiteOffer there = offerOf(Policy{subset(bits), true, true});
            for (const bool initiator : {true, false}) {
                const auto both = initiator ? permittedSuites(here, there) : permittedSuites(there, here);
                for (const SuiteId suite : both)
                    QVERIFY(crypto::suiteInfo(suite).strength >= crypto::suiteInfo(weakest).strength);
            }
        }
    }
}

SKYSEAL_TEST(NegotiationTest)
#include "negotiation_test.moc"
