// Settings in force while a measurement replaces the configured protection, and when sessions must end for it.
#include "core/engine/station/security_settings.h"

#include "tests/support/test_runner.h"

#include <QtTest/QTest>

using namespace skyseal;
using namespace skyseal::engine;
using crypto::SuiteId;

namespace {

const std::vector<SuiteId> kSuites{SuiteId::ChaCha20Poly1305, SuiteId::Aes256Ctr, SuiteId::Rc4};

SecuritySettings settings(bool allowInline = false)
{
    return {SecureMode::Preferred, {.suites = kSuites, .allowInline = allowInline}, SuiteId::Aes256Ctr};
}

} // namespace

class SecuritySettingsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void protectionReplacesModeAndFraming();
    void sessionsEndOnlyWhereTheyDoNotFit_data();
    void sessionsEndOnlyWhereTheyDoNotFit();
    void firstSuiteInOrderOfPrecedence();
    void weakSuitesComeBack();
};

void SecuritySettingsTest::protectionReplacesModeAndFraming()
{
    SecuritySettings it = settings(true);
    it.setProtection(Protection::Plain);
    QCOMPARE(int(it.mode()), int(SecureMode::Off));
    QVERIFY(it.isPlain());
    it.setProtection(Protection::Sealed);
    QCOMPARE(int(it.mode()), int(SecureMode::Required));
    QVERIFY(!it.policy().allowInline);
    it.setProtection(Protection::Inline);
    QVERIFY(it.policy().allowInline && it.policy().preferInline);
    it.setProtection(std::nullopt);
    QCOMPARE(int(it.mode()), int(SecureMode::Preferred));
    QVERIFY(it.policy().allowInline && !it.policy().preferInline);
}

void SecuritySettingsTest::sessionsEndOnlyWhereTheyDoNotFit_data()
{
    QTest::addColumn<int>("before");
    QTest::addColumn<int>("after");
    QTest::addColumn<bool>("configuredInline");
    QTest::addColumn<bool>("end");
    constexpr int kNone = -1, kPlain = int(Protection::Plain), kSealed = int(Protection::Sealed),
                  kInline = int(Protection::Inline);
    QTest::newRow("configured to plain") << kNone << kPlain << false << true;
    QTest::newRow("configured to sealed") << kNone << kSealed << false << false;
    QTest::newRow("configured with inline to sealed") << kNone << kSealed << true << true;
    QTest::newRow("sealed to inline") << kSealed << kInline << false << true;
    QTest::newRow("inline to inline") << kInline << kInline << false << false;
    QTest::newRow("inline to configured") << kInline << kNone << false << true;
    QTest::newRow("plain to sealed: there are none") << kPlain << kSealed << false << false;
    QTest::newRow("plain to configured: there are none") << kPlain << kNone << false << false;
}

void SecuritySettingsTest::sessionsEndOnlyWhereTheyDoNotFit()
{
    QFETCH(int, before);
    QFETCH(int, after);
    QFETCH(bool, configuredInline);
    QFETCH(bool, end);
    const auto protection = [](int number) {
        return number < 0 ? std::nullopt : std::optional(static_cast<Protection>(number));
    };
    SecuritySettings it = settings(configuredInline);
    it.setProtection(protection(before));
    QCOMPARE(it.setProtection(protection(after)), end);
}

void SecuritySettingsTest::firstSuiteInOrderOfPrecedence()
{
    SecuritySettings it = settings();
    QVERIFY(it.takeFirstSuite() == SuiteId::Aes256Ctr); // the preferred one
    it.setNextSuite(SuiteId::ChaCha20);
    QVERIFY(it.takeFirstSuite() == SuiteId::ChaCha20);
    QVERIFY(it.takeFirstSuite() == SuiteId::Aes256Ctr); // for one session only
    it.setNextSuite(SuiteId::ChaCha20);
    it.holdSuite(SuiteId::Aes256Gcm);
    QVERIFY(it.takeFirstSuite() == SuiteId::Aes256Gcm);
    it.holdSuite(std::nullopt);
    QVERIFY(it.takeFirstSuite() == SuiteId::Aes256Ctr); // the next suite was consumed by the session before
}

void SecuritySettingsTest::weakSuitesComeBack()
{
    SecuritySettings it = settings();
    it.setWeakestSuite(SuiteId::ChaCha20Poly1305);
    QVERIFY(it.policy().suites.size() < kSuites.size());
    it.setWeakestSuite(SuiteId::Rc4);
    QVERIFY(it.policy().suites == kSuites);
}

SKYSEAL_TEST(SecuritySettingsTest)
#include "security_settings_test.moc"
