// No branch and no address depends on a key where records are opened and secrets compared: Valgrind follows undefined keys
// through the probe. That it would notice is shown by a comparison that stops early, and by RC4, whose tables are indexed by
// its key: that is one reason why it is there for research alone.
#include <QtCore/QProcess>
#include <QtCore/QStandardPaths>
#include <QtTest/QTest>

class ConstantTimeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void keysDecideNothing_data();
    void keysDecideNothing();
    void secretBranchIsCaught_data();
    void secretBranchIsCaught();

private:
    static constexpr int kCaught = 99;
    int probe(const QStringList &arguments);
    QString m_valgrind;
    QByteArray m_words;
};

void ConstantTimeTest::initTestCase()
{
    m_valgrind = QStandardPaths::findExecutable(QStringLiteral("valgrind"));
#if defined(SKYSEAL_SANITIZED) || !__has_include(<valgrind/memcheck.h>)
    QSKIP("Valgrind cannot run a program that has a sanitizer, or its header was missing when this was built");
#endif
    if (m_valgrind.isEmpty())
        QSKIP("Valgrind is not installed");
}

int ConstantTimeTest::probe(const QStringList &arguments)
{
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(m_valgrind,
                  QStringList{QStringLiteral("-q"), QStringLiteral("--error-exitcode=%1").arg(kCaught),
                              QStringLiteral("--suppressions=" SKYSEAL_SOURCE_DIR "/tests/crypto/constant_time.supp"),
                              QStringLiteral(SKYSEAL_PROBE)}
                      + arguments);
    const bool ended = process.waitForFinished(100000) && process.exitStatus() == QProcess::NormalExit;
    m_words = process.readAll();
    return ended ? process.exitCode() : -1;
}

void ConstantTimeTest::keysDecideNothing_data()
{
    QTest::addColumn<QStringList>("arguments");
    for (const char *suite : {"chacha20-poly1305", "aes-256-gcm", "aes-256-ctr", "aes-256-cbc", "chacha20"})
        QTest::addRow("open %s", suite) << QStringList{QStringLiteral("open"), QLatin1String(suite)};
    for (const char *suite : {"aes-256-ctr", "aes-256-cbc", "chacha20"})
        QTest::addRow("inline %s", suite) << QStringList{QStringLiteral("inline"), QLatin1String(suite)};
    QTest::newRow("compare") << QStringList{QStringLiteral("compare")};
}

void ConstantTimeTest::keysDecideNothing()
{
    QFETCH(QStringList, arguments);
    const int status = probe(arguments);
    QVERIFY2(status == 0 && m_words.contains("done"), m_words.constData());
}

void ConstantTimeTest::secretBranchIsCaught_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("a comparison that stops early") << QStringList{QStringLiteral("self-test")};
    QTest::newRow("rc4") << QStringList{QStringLiteral("open"), QStringLiteral("rc4")};
}

void ConstantTimeTest::secretBranchIsCaught()
{
    QFETCH(QStringList, arguments);
    QCOMPARE(probe(arguments), kCaught);
    QVERIFY2(m_words.contains("ninitialised value"), m_words.constData());
}

QTEST_GUILESS_MAIN(ConstantTimeTest)
#include "constant_time_test.moc"
