// Figures of memory against heaptrack's.
//
// The heap of a keyed cipher, and of one end's session: contextBytes() and sessionBytes(), which every report shows, in a run
// by itself (heaptrack keeps its books in the same heap), against the growth of heaptrack's peak between a program that holds
// some and one that holds more. heaptrack adds up what was asked for, glibc what it gave, which is up to 24 bytes more for each
// block: within 15 %, or 24 bytes.
//
// The resident set that monitor reports (as a sweep does) against the peak that heaptrack reads itself: within 15 %. Both hold
// heaptrack's own memory, since it works inside the process.
#include "tests/support/requirements.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QRegularExpression>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace skyseal::test;

namespace {

constexpr double kTolerance = 0.15;
constexpr double kOfABlock = 24;

QString q(const char *text)
{
    return QString::fromUtf8(text);
}

struct Profile
{
    QByteArray out;      ///< of the program
    double heap = 0;     ///< bytes at the peak
    double resident = 0; ///< bytes at the peak
};

/// "1.23M" behind these words.
double figureIn(const QByteArray &text, const char *words)
{
    const QRegularExpression line(QRegularExpression::escape(q(words)) + QStringLiteral(R"(:\s*([0-9.]+)([KMG]?))"));
    const auto match = line.match(QString::fromUtf8(text));
    const QString unit = match.captured(2);
    const double scale = unit == q("K") ? 1e3 : unit == q("M") ? 1e6 : unit == q("G") ? 1e9 : 1;
    return match.captured(1).toDouble() * scale;
}

std::optional<Profile> profiled(const QStringList &command)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(q("profile"));
    const RunResult run = runToItsEnd(q("heaptrack"), QStringList{q("-o"), file} + command, {}, 120000);
    if (run.status != 0)
        return std::nullopt;
    const QStringList written = QDir(folder.path()).entryList({q("profile*")});
    if (written.isEmpty())
        return std::nullopt;
    const RunResult print = runToItsEnd(q("heaptrack_print"), {q("-f"), folder.filePath(written.first())}, {}, 120000);
    return Profile{run.out, figureIn(print.out, "peak heap memory consumption"),
                   figureIn(print.out, "peak RSS (including heaptrack overhead)")};
}

} // namespace

class MemoryShareTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { SKYSEAL_REQUIRES("heaptrack"); }
    void heapIsWhatHeaptrackFinds_data();
    void heapIsWhatHeaptrackFinds();
    void residentSetIsWhatHeaptrackReads();
};

void MemoryShareTest::heapIsWhatHeaptrackFinds_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("suite");
    QTest::addColumn<int>("count");
    for (const char *suite : {"chacha20-poly1305", "aes-256-gcm", "aes-256-cbc", "rc4"}) {
        QTest::addRow("context of %s", suite) << q("contexts") << q(suite) << 10000;
        QTest::addRow("session under %s", suite) << q("sessions") << q(suite) << 20;
    }
}

void MemoryShareTest::heapIsWhatHeaptrackFinds()
{
    QFETCH(QString, what);
    QFETCH(QString, suite);
    QFETCH(int, count);
    const auto run = [&](int held) { return profiled({q(SKYSEAL_MEMORY_PROBE), what, suite, QString::number(held)}); };
    // Other temporary allocations of the program are in both peaks.
    const auto some = run(count), many = run(3 * count);
    QVERIFY(some && many && many->heap > some->heap);
    // Ours from a run by itself: heaptrack keeps its books in the same heap.
    const RunResult alone = runToItsEnd(q(SKYSEAL_MEMORY_PROBE), {what, suite, QString::number(count)});
    QVERIFY(alone.status == 0);
    const double ours = alone.out.trimmed().toDouble();
    const int ends = what == q("sessions") ? 2 : 1;
    const double theirs = (many->heap - some->heap) / (2 * count * ends);
    qInfo("%s: ours %.0f bytes, heaptrack %.0f, ratio %.3f", QTest::currentDataTag(), ours, theirs, ours / theirs);
    QVERIFY(std::abs(ours - theirs) <= std::max(kTolerance * theirs, kOfABlock));
}

void MemoryShareTest::residentSetIsWhatHeaptrackReads()
{
    const auto run = profiled({q(SKYSEAL_BIN_DIR "/skyseal-cli"), q("monitor"), q("--link"), q("udpin:127.0.0.1:0"),
                               q("--no-record"), q("--duration"), q("3"), q("--json")});
    QVERIFY(run);
    double ours = 0;
    for (const QByteArray &line : run->out.split('\n')) {
        const QJsonObject event = QJsonDocument::fromJson(line).object();
        ours = std::max(ours, event[q("process")][q("rss_bytes")].toDouble());
    }
    qInfo("resident: ours %.0f bytes, heaptrack %.0f, ratio %.3f", ours, run->resident, ours / run->resident);
    QVERIFY(ours > 1e6 && std::abs(ours / run->resident - 1) <= kTolerance);
}

SKYSEAL_TEST(MemoryShareTest)
#include "memory_share_test.moc"
