// Two real sweeps of one setting, one after the other: the confidence intervals of the same suite meet, and the A/A pair within
// each is reported as no difference. Wants a machine that does nothing else meanwhile.
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

using namespace skyseal::test;

namespace {

QString q(const char *text)
{
    return QString::fromUtf8(text);
}

QJsonObject sweep(const QString &folder, const char *seed)
{
    QStringList arguments{q("sweep"),     q("--launches"), q("5"),         q("--suites"), q("chacha20-poly1305,aes-256-gcm"),
                          q("--seconds"), q("2"),          q("--repeats"), q("1"),        q("--seed"),
                          q(seed),        q("--out"),      folder};
    if (runProgram("skyseal-cli", arguments, {}, 900000).status != 0)
        return {};
    QFile file(folder + q("/sweep.json"));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

QString placeOf(const QJsonObject &summary)
{
    QStringList parts;
    for (const char *key : {"load", "suite", "metric"})
        parts << summary[q(key)].toString();
    return parts.join(QLatin1Char(' ')) + (summary[q("again")].toBool() ? q(" again") : QString());
}

} // namespace

class AgreementTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_first = sweep(m_folder.filePath(q("first")), "1");
        m_second = sweep(m_folder.filePath(q("second")), "2");
        QVERIFY(!m_first.isEmpty() && !m_second.isEmpty());
    }
    void intervalsMeet();
    void ratiosMeet();
    void sameSuiteTwiceIsNoDifference();

private:
    QTemporaryDir m_folder;
    QJsonObject m_first, m_second;
};

void AgreementTest::intervalsMeet()
{
    QHash<QString, QJsonObject> second;
    for (const QJsonValue summary : m_second[q("summaries")].toArray())
        second.insert(placeOf(summary.toObject()), summary.toObject());
    int compared = 0;
    QStringList apart;
    for (const QJsonValue value : m_first[q("summaries")].toArray()) {
        const QJsonObject a = value.toObject(), b = second.value(placeOf(a));
        if (a[q("n")].toInt() < 5 || b[q("n")].toInt() < 5 || a[q("ci95_low")].isNull())
            continue;
        ++compared;
        const auto edge = [](const QJsonObject &summary, const char *key) { return summary[q(key)].toDouble(); };
        if (edge(a, "ci95_low") > edge(b, "ci95_high") || edge(b, "ci95_low") > edge(a, "ci95_high"))
            apart << QStringLiteral("%1: %2 to %3, then %4 to %5")
                         .arg(placeOf(a))
                         .arg(edge(a, "ci95_low"))
                         .arg(edge(a, "ci95_high"))
                         .arg(edge(b, "ci95_low"))
                         .arg(edge(b, "ci95_high"));
    }
    qInfo("%d pairs of intervals, %lld do not meet\n%s", compared, static_cast<long long>(apart.size()),
          qPrintable(apart.join(QLatin1Char('\n'))));
    QVERIFY(compared > 80);
    QVERIFY2(apart.size() <= compared / 20, "more than one in twenty");
}

/// The result of a sweep. Its intervals come from the launches, which differ between two sweeps as they do within one.
void AgreementTest::ratiosMeet()
{
    const auto key = [](const QJsonObject &one) {
        return QStringList{one[q("load")].toString(), one[q("metric")].toString(), one[q("second")].toString()}.join(
            QLatin1Char(' '));
    };
    QHash<QString, QJsonObject> second;
    for (const QJsonValue one : m_second[q("comparisons")].toArray())
        second.insert(key(one.toObject()), one.toObject());
    int compared = 0;
    QStringList apart;
    for (const QJsonValue value : m_first[q("comparisons")].toArray()) {
        const QJsonObject a = value.toObject(), b = second.value(key(a));
        if (!a[q("ci95_low")].isDouble() || !b[q("ci95_low")].isDouble())
            continue;
        QCOMPARE(a[q("unit")].toString(), q("launch"));
        ++compared;
        if (a[q("ci95_low")].toDouble() > b[q("ci95_high")].toDouble()
            || b[q("ci95_low")].toDouble() > a[q("ci95_high")].toDouble())
            apart << key(a);
    }
    qInfo("%d pairs of ratios, %lld do not meet\n%s", compared, static_cast<long long>(apart.size()),
          qPrintable(apart.join(QLatin1Char('\n'))));
    QVERIFY(compared > 20);
    QVERIFY2(apart.size() <= compared / 20, "more than one in twenty");
}

void AgreementTest::sameSuiteTwiceIsNoDifference()
{
    // Of a sweep, not of its pairs: they are of the same runs, so that one disturbance shows in several of them.
    int compared = 0, sweeps = 0;
    QStringList differing;
    for (const QJsonObject &report : {m_first, m_second}) {
        const qsizetype before = differing.size();
        for (const QJsonValue noise : report[q("noise")].toArray()) {
            ++compared;
            if (noise[q("significant")].toBool())
                differing << QStringLiteral("%1 %2: %3, %4, p = %5")
                                 .arg(noise[q("load")].toString(), noise[q("metric")].toString())
                                 .arg(noise[q("first_mean")].toDouble())
                                 .arg(noise[q("second_mean")].toDouble())
                                 .arg(noise[q("p")].toDouble());
        }
        sweeps += differing.size() > before;
    }
    qInfo("%d A/A pairs, %lld differ, in %d sweeps\n%s", compared, static_cast<long long>(differing.size()), sweeps,
          qPrintable(differing.join(QLatin1Char('\n'))));
    QVERIFY(compared > 40);
    QVERIFY2(sweeps <= 1, "one sweep in twenty at most shows any difference by chance: both are hardly that");
}

SKYSEAL_TEST(AgreementTest)
#include "agreement_test.moc"
