// A whole sweep by the real programs: files that agree with each other and with the arithmetic, losses that are those of the
// link, assertions that decide the exit status, a cancel that ends in good order.
#include "core/crypto/suite.h"
#include "core/experiment/placement.h"
#include "tests/support/run_program.h"
#include "tests/support/flight.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QHash>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QSet>
#include <QtCore/QTemporaryDir>
#include <QtCore/QXmlStreamReader>
#include <QtTest/QTest>

#include <cmath>
#include <csignal>

#include <unistd.h>

using namespace skyseal::test;

namespace {

QString q(const char *text)
{
    return QString::fromUtf8(text);
}

QStringList sweep(const char *more)
{
    return QStringList{q("sweep"), q("--launches"), q("1")} + q(more).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

/// On somebody else's agent.
QStringList onLink(const Flight &flight, const char *more)
{
    return sweep(more) + QStringList{q("--link"),     q("udpin:127.0.0.1:%1").arg(flight.groundPort),
                                     q("--identity"), flight.path(q("ground.key")),
                                     q("--peers"),    flight.path(q("ground.peers"))};
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The events of one kind among the lines.
QList<QJsonObject> events(const QByteArray &out, const char *kind)
{
    QList<QJsonObject> found;
    for (const QByteArray &line : out.split('\n')) {
        const QJsonObject object = QJsonDocument::fromJson(line).object();
        if (object[QLatin1String("event")] == q(kind))
            found.append(object);
    }
    return found;
}

/// Whether nothing but unsaturated runs kept the sweep from success: a machine with other work, or without enough cores, cannot
/// make that load, and says so.
bool isDone(const RunResult &run)
{
    const bool unsaturated = run.err.contains("not saturated: ") && !run.err.contains(" failed: ")
        && !run.out.contains("\"holds\":false");
    return run.status == 0 || (run.status == 1 && unsaturated);
}

double valueOf(const QJsonObject &sample, const char *metric)
{
    return sample[QLatin1String("values")][QLatin1String(metric)].toDouble(std::nan(""));
}

/// The latency of a short run is empty if a busy machine delayed each of its few answers beyond its end. A value is never less
/// than `least` ms.
bool isLatency(const QJsonObject &sample, double least = 1e-3)
{
    const double latency = valueOf(sample, "latency");
    return std::isnan(latency) || latency >= least;
}

/// The share of a run's records, or clear frames, that the relay dropped by its own log.
double droppedShare(const QJsonObject &sample)
{
    const QJsonValue relay = sample[QLatin1String("relay")];
    const double dropped = relay[QLatin1String("dropped")].toDouble(std::nan(""));
    return dropped / (dropped + relay[QLatin1String("received")].toDouble());
}

} // namespace

class SweepTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { qunsetenv("XDG_RUNTIME_DIR"); } // as in a service or a container
    void filesAgree();
    void everySuiteIsMeasured();
    void launchesStartAnew();
    void cancelEndsTheLaunch();
    void lossIsThatOfTheLink();
    void radioSetsThePace();
    void cancelKeepsWhatThereIs();
    void nobodyAnswers();
    void bothFramings();
    void cancelOnALinkRestoresTheSuite();
    void refusalsAreTold();
    void agentTellsItsCosts();
    void plainComesBackOverABadLink();

private:
    QSet<QString> m_seeds; ///< that sweeps drew
    void checkSummaries(const QJsonObject &report);
    void checkCsv(const QJsonObject &report, const QByteArray &csv);
    void checkPage(const QJsonObject &report, const QString &page);
    void checkFigure(const QJsonObject &report, const char *metric, const char *load, const QByteArray &svg);
};

/// The summaries of a metric under a load as the page and the figures show them, in the order of the plan's arms; an empty
/// object for an arm without one.
static QList<QJsonObject> summariesOf(const QJsonObject &report, const QString &load, const QString &metric)
{
    QList<QJsonObject> out;
    for (const QJsonValue arm : report[QLatin1String("plan")][QLatin1String("arms")].toArray()) {
        out.append(QJsonObject());
        for (const QJsonValue summary : report[QLatin1String("summaries")].toArray()) {
            if (summary[QLatin1String("load")] == load && summary[QLatin1String("metric")] == metric
                && summary[QLatin1String("suite")] == arm[QLatin1String("suite")]
                && summary[QLatin1String("again")] == arm[QLatin1String("again")]
                && summary[QLatin1String("framing")] == arm[QLatin1String("framing")])
                out.last() = summary.toObject();
        }
    }
    return out;
}

/// The frames or records of a run that a share is of; 0 for what is no share.
static double sharedBy(const QJsonObject &sample, const QString &metric)
{
    const auto grown = [&sample](const char *kind) {
        const auto at = [&](const char *edge) {
            return sample[QLatin1String("counted")][QLatin1String(edge)][QLatin1String(kind)][QLatin1String("good")].toDouble();
        };
        return at("end") - at("begin");
    };
    if (metric == QLatin1String("loss"))
        return valueOf(sample, "packets");
    return metric == QLatin1String("record_loss") ? grown("rx") : metric == QLatin1String("record_loss_up") ? grown("tx") : 0;
}

/// A number as people read it, "1,234.5", and what half a unit of its last digit is.
static std::pair<double, double> shown(QString text)
{
    text = text.remove(QLatin1Char(',')).section(QLatin1Char(' '), 0, 0);
    const qsizetype decimals = text.contains(QLatin1Char('.')) ? text.size() - text.indexOf(QLatin1Char('.')) - 1 : 0;
    // Without an interval three digits are shown.
    return {text.toDouble(),
            std::max(0.5 * std::pow(10, -static_cast<double>(decimals)), 0.005 * std::abs(text.toDouble()) * (decimals == 0))};
}

void SweepTest::checkSummaries(const QJsonObject &report)
{
    int checked = 0;
    for (const QJsonValue summary : report[QLatin1String("summaries")].toArray()) {
        QList<double> values;
        double frames = 0;
        for (const QJsonValue sample : report[QLatin1String("samples")].toArray()) {
            bool same = true;
            for (const char *key : {"condition", "load", "suite", "framing", "again"})
                same = same && sample[QLatin1String(key)] == summary[QLatin1String(key)];
            const double value = sample[QLatin1String("values")][summary[QLatin1String("metric")].toString()].toDouble(
                std::nan(""));
            same = same && sample[QLatin1String("valid")].toBool();
            if (same && std::isfinite(value)) {
                values.append(value);
                frames += sharedBy(sample.toObject(), summary[QLatin1String("metric")].toString());
            }
        }
        QCOMPARE(summary[QLatin1String("n")].toInt(), static_cast<int>(values.size()));
        double mean = 0;
        for (const double value : values)
            mean += value / static_cast<double>(values.size());
        QVERIFY(std::abs(mean - summary[QLatin1String("mean")].toDouble()) <= 1e-9 * std::abs(mean));
        QCOMPARE(*std::max_element(values.begin(), values.end()), summary[QLatin1String("max")].toDouble());
        if (summary[QLatin1String("metric")].toString().endsWith(QLatin1String("memory"))) {
            // Resident memory is one process's through all runs, a session's is measured once.
            QVERIFY(summary[QLatin1String("ci95_low")].isNull() && summary[QLatin1String("ci95_high")].isNull());
        } else if (frames > 0 && summary[QLatin1String("max")].toDouble() == 0) {
            QVERIFY(std::abs(summary[QLatin1String("ci95_high")].toDouble() - (1 - std::pow(0.05, 1 / frames))) < 1e-9);
            QCOMPARE(summary[QLatin1String("ci95_low")].toDouble(), 0.0);
        } else if (values.size() == 2) { // t for one degree of freedom is 12.7062
            const double half = 12.7062047 * std::abs(values[0] - values[1]) / 2;
            const double high = frames > 0 ? std::min(1.0, mean + half) : mean + half;
            QVERIFY(std::abs(summary[QLatin1String("ci95_high")].toDouble() - high) <= 1e-6 * (std::abs(mean) + half));
        }
        ++checked;
    }
    QVERIFY(checked > 40);
}

/// The cells of a line; those with a comma stand in quotes (RFC 4180).
QByteArrayList csvCells(const QByteArray &line)
{
    QByteArrayList out{QByteArray()};
    bool isQuoted = false;
    for (const char c : line) {
        if (c == '"')
            isQuoted = !isQuoted;
        else if (c == ',' && !isQuoted)
            out.append(QByteArray());
        else
            out.last().append(c);
    }
    return out;
}

void SweepTest::checkCsv(const QJsonObject &report, const QByteArray &csv)
{
    const QByteArrayList lines = csv.trimmed().split('\n');
    const QJsonArray samples = report[QLatin1String("samples")].toArray();
    QCOMPARE(lines.size(), samples.size() + 1);
    const QByteArrayList names = lines[0].split(',');
    for (qsizetype i = 0; i < samples.size(); ++i) {
        const QByteArrayList cells = csvCells(lines[i + 1]);
        QCOMPARE(cells.size(), names.size());
        for (const QJsonValue metric : report[QLatin1String("metrics")].toArray()) {
            const QString key = metric[QLatin1String("key")].toString();
            const qsizetype column = names.indexOf(key.toUtf8());
            QVERIFY2(column > 0, qPrintable(key));
            const QJsonValue value = samples[i][QLatin1String("values")][key];
            QCOMPARE(cells[column].isEmpty(), value.isNull());
            if (!value.isNull())
                QCOMPARE(cells[column].toDouble(), value.toDouble());
        }
    }
}

void SweepTest::checkPage(const QJsonObject &report, const QString &page)
{
    int checked = 0;
    for (const char *load : {"natural", "saturated"}) {
        const qsizetype begin = page.indexOf(q("<h2>Results: link clean; %1 load").arg(q(load)));
        const qsizetype means = page.indexOf(q("<h3>Means</h3>"), begin);
        QVERIFY(begin > 0 && means > begin);
        const QString table = page.mid(means, page.indexOf(q("</table>"), means) - means);
        for (const QJsonValue metric : report[QLatin1String("metrics")].toArray()) {
            const QString unit = metric[QLatin1String("unit")].toString();
            const QString title = metric[QLatin1String("title")].toString() + (unit.isEmpty() ? QString() : q(", ") + unit);
            const qsizetype row = table.indexOf(q("<tr><td>%1</td>").arg(title.toHtmlEscaped()));
            const QStringList cells = row < 0 ? QStringList()
                                              : table.mid(row, table.indexOf(q("</tr>"), row) - row).split(q("<td>")).mid(2);
            const QList<QJsonObject> summaries = summariesOf(report, q(load), metric[QLatin1String("key")].toString());
            for (qsizetype arm = 0; arm < summaries.size(); ++arm) {
                const QString cell = cells.value(arm, q("–")).section(QLatin1Char('<'), 0, 0);
                QCOMPARE(cell.startsWith(q("–")), summaries[arm].isEmpty());
                if (summaries[arm].isEmpty())
                    continue;
                const auto [value, rounding] = shown(cell);
                const double mean = summaries[arm][QLatin1String("mean")].toDouble();
                QVERIFY2(std::abs(value - mean) <= rounding * 1.001,
                         qPrintable(title + q(": ") + cell + q(" for ") + QString::number(mean, 'g', 12)));
                ++checked;
            }
        }
    }
    QVERIFY(checked > 100);
}

void SweepTest::checkFigure(const QJsonObject &report, const char *metric, const char *load, const QByteArray &svg)
{
    QList<double> widths;
    QXmlStreamReader xml(svg);
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == q("rect")
            && xml.attributes().hasAttribute(q("stroke")))
            widths.append(xml.attributes().value(q("width")).toDouble());
    }
    QList<double> means;
    for (const QJsonObject &summary : summariesOf(report, q(load), q(metric))) {
        if (!summary.isEmpty())
            means.append(summary[QLatin1String("mean")].toDouble());
    }
    QCOMPARE(widths.size(), means.size());
    if (means.isEmpty())
        return; // no valid run under this load
    const double scale = *std::max_element(widths.begin(), widths.end()) / *std::max_element(means.begin(), means.end());
    for (qsizetype i = 0; i < means.size(); ++i)
        QVERIFY2(std::abs(widths[i] - means[i] * scale) < 0.2, metric); // in tenths of a pixel, from zero
}

void SweepTest::filesAgree()
{
    QTemporaryDir folder;
    QStringList arguments = sweep(
        "--suites none,chacha20-poly1305,rc4 --impair clean --seconds 0.5 --warm-up 0.2 --repeats 2 --json --expect "
        "loss(*,natural)<=0.2 --expect packets(none,natural)>=1 --expect "
        "frame_rate(rc4,natural)<=1000");
    arguments << q("--out") << folder.filePath(q("out"));
    const QStringList older{q("out/figures/switch-natural-3.svg"), q("out/figures/switch-natural-3.png")};
    const QStringList others{q("out/figures/own.png"), q("out/figures/packets-natural-draft.svg")};
    QVERIFY(QDir(folder.path()).mkpath(q("out/figures")));
    for (const QString &name : older + others)
        QVERIFY(QFile(folder.filePath(name)).open(QIODevice::WriteOnly));
    QFile before(folder.filePath(q("out/sweep.json")));
    QVERIFY(before.open(QIODevice::WriteOnly) && before.write("{\"schema\": \"skyseal-sweep\", \"schema_version\": 2}") > 0);
    before.close();
    const RunResult run = runProgram("skyseal-cli", arguments, {}, 240000);
    QVERIFY2(isDone(run), run.err.constData());
    QVERIFY2(!run.err.contains("QStandardPaths"), run.err.constData());
    for (const QString &name : older)
        QVERIFY(!QFile::exists(folder.filePath(name))); // of another sweep
    for (const QString &name : others)
        QVERIFY2(QFile::exists(folder.filePath(name)), qPrintable(name));
    QCOMPARE(events(run.out, "run").size(), 4 * 2 * 2); // three suites and one of them again, two loads, two repeats
    QCOMPARE(events(run.out, "expect").size(), 3 + 1 + 1);
    const QByteArray json = contentOf(folder.filePath(q("out/sweep.json")));
    const QJsonObject report = QJsonDocument::fromJson(json).object();
    QCOMPARE(report[QLatin1String("schema")].toString(), q("skyseal-sweep"));
    QCOMPARE(report[QLatin1String("schema_version")].toInt(), 4);
    const QString seed = report[QLatin1String("plan")][QLatin1String("seed")].toString();
    QVERIFY(report[QLatin1String("setting")][QLatin1String("command_line")].toString().endsWith(q(" --seed ") + seed));
    QVERIFY(!m_seeds.contains(seed));
    m_seeds << seed;
    QVERIFY(!report[QLatin1String("placement")].toString().isEmpty());
    QVERIFY(!report[QLatin1String("trends")].toArray().isEmpty());
    QVERIFY(report[QLatin1String("complete")].toBool());
    for (const char *key :
         {"skyseal", "command_line", "processor", "processor_features", "libsodium", "openssl", "qt", "build"})
        QVERIFY2(!report[QLatin1String("setting")][QLatin1String(key)].toString().isEmpty(), key);
    int answered = 0, woken = 0;
    double packets = 0;
    for (const QJsonValue sample : report[QLatin1String("samples")].toArray()) {
        const QJsonObject object = sample.toObject();
        const bool plain = object[QLatin1String("suite")] == q("none");
        QVERIFY2(object[QLatin1String("problem")].isUndefined(), qPrintable(object[QLatin1String("problem")].toString()));
        packets += valueOf(object, "packets");
        QVERIFY(valueOf(object, "agent_cpu") >= 0 && valueOf(object, "agent_memory") > 1e6);
        QVERIFY(valueOf(object, "cpu") > 0 && valueOf(object, "cpu") <= valueOf(object, "cpu_process") * 1.05);
        QVERIFY2(isLatency(object), QJsonDocument(object).toJson().constData());
        answered += valueOf(object, "latency") > 0;
        QVERIFY(object[QLatin1String("relay")].isUndefined()); // a clean link has none
        const bool saturated = object[QLatin1String("load")] == q("saturated");
        QVERIFY(saturated || object[QLatin1String("valid")].toBool());
        QCOMPARE(object[QLatin1String("valid")].toBool(),
                 !saturated || valueOf(object, "cpu") >= 95 || valueOf(object, "agent_cpu") >= 95);
        QCOMPARE(object[QLatin1String("valid")].toBool(), object[QLatin1String("invalid")].isUndefined());
        for (const char *metric : {"meter_cpu", "simulator_cpu"})
            QVERIFY2(valueOf(object, metric) > 0, metric);
        // A program that has work all the time, under the saturated load or on a busy machine, never wakes up, and one that
        // the machine does not run for so long has no CPU time.
        for (const char *metric :
             {"wake_ups", "agent_wake_ups", "preemptions", "agent_preemptions", "other_cpu", "steal", "load_begin", "load_end"})
            QVERIFY2(valueOf(object, metric) >= 0, metric);
        woken += !saturated && valueOf(object, "wake_ups") > 0 && valueOf(object, "agent_wake_ups") > 0
            && valueOf(object, "agent_cpu") > 0;
        QCOMPARE(valueOf(object, "readings"), 1.0); // the last probe; nothing in between, in no arm
        // A report of the agent may be a datagram without a frame, and there are few of them beside the frames.
        QVERIFY(valueOf(object, "frames_per_datagram") > (plain ? 0.98 : 0.8));
        QCOMPARE(std::isnan(valueOf(object, "open_p50")), plain);
        QVERIFY(plain ? valueOf(object, "overhead") == 0 : valueOf(object, "overhead") > 1);
        double messages = 0;
        for (const QJsonValue frames : object[QLatin1String("messages")].toObject())
            messages += frames.toDouble();
        const QJsonValue counted = object[QLatin1String("counted")];
        QCOMPARE(messages,
                 counted[QLatin1String("end")][QLatin1String("mavlink")][QLatin1String("frames")].toDouble()
                     - counted[QLatin1String("begin")][QLatin1String("mavlink")][QLatin1String("frames")].toDouble());
        QVERIFY(saturated || object[QLatin1String("messages")][QLatin1String("30")].toDouble() > 0); // attitudes
    }
    QVERIFY(report[QLatin1String("message_mix")][0][QLatin1String("share")][QLatin1String("30")].toDouble() > 0.01);
    QVERIFY2(answered > 4 * 2 * 2 / 2, qPrintable(QString::number(answered))); // the vehicle answers five times a second
    QVERIFY2(woken > 4 * 2 / 2, qPrintable(QString::number(woken)));
    QVERIFY(packets >= 4 * 2 * 2 * 10);
    checkSummaries(report);
    checkCsv(report, contentOf(folder.filePath(q("out/sweep.csv"))));
    const QByteArray page = contentOf(folder.filePath(q("out/report.html")));
    checkPage(report, QString::fromUtf8(page));
    for (const char *metric : {"packets", "cpu_per_frame", "open_p50", "wire_per_frame"}) {
        for (const char *load : {"natural", "saturated"})
            checkFigure(report, metric, load, contentOf(folder.filePath(q("out/figures/%1-%2.svg").arg(q(metric), q(load)))));
    }
    QVERIFY(page.contains("<svg") && page.contains("rc4 (insecure)"));
    for (const char *figure : {"packets-natural", "packets-saturated", "cpu-natural", "latency-saturated"}) {
        QVERIFY2(contentOf(folder.filePath(q("out/figures/%1.svg").arg(q(figure)))).startsWith("<svg"), figure);
#ifdef SKYSEAL_HAVE_FIGURES
        QVERIFY2(contentOf(folder.filePath(q("out/figures/%1.png").arg(q(figure)))).startsWith("\x89PNG"), figure);
        QVERIFY2(contentOf(folder.filePath(q("out/figures/%1.pdf").arg(q(figure)))).startsWith("%PDF"), figure);
#endif
    }
#ifdef SKYSEAL_HAVE_FIGURES
    QVERIFY(contentOf(folder.filePath(q("out/report.pdf"))).startsWith("%PDF"));
#endif
    QCOMPARE(report[QLatin1String("comparisons")].toArray().isEmpty(), false);
    QCOMPARE(report[QLatin1String("noise")].toArray().isEmpty(), false);
}

/// Plain MAVLink and every suite under both loads: as a sweep is that names none. Where the programs share cores, a line makes
/// the saturated load possible.
void SweepTest::everySuiteIsMeasured()
{
    QTemporaryDir folder;
    const RunResult run = runProgram(
        "skyseal-cli", sweep("--seconds 0.5 --warm-up 0.2 --repeats 1 --json --out") << folder.path(), {}, 240000);
    QVERIFY2(isDone(run), run.err.constData());
    QSet<QString> suites;
    const QList<QJsonObject> runs = events(run.out, "run");
    double packets = 0;
    int sealing = 0;
    for (const QJsonObject &sample : runs) {
        suites << sample[QLatin1String("suite")].toString();
        QVERIFY2(sample[QLatin1String("problem")].isUndefined(), qPrintable(sample[QLatin1String("problem")].toString()));
        packets += valueOf(sample, "packets");
        QVERIFY(valueOf(sample, "packets") >= 1 && valueOf(sample, "cpu") > 0 && valueOf(sample, "agent_cpu") >= 0);
        if (sample[QLatin1String("suite")] == q("none"))
            continue;
        QVERIFY(valueOf(sample, "open_p50") > 0);
        // The station sends a few records a second, which a busy machine may delay beyond the end of a run.
        QVERIFY(std::isnan(valueOf(sample, "seal_p50")) || valueOf(sample, "seal_p50") > 0);
        sealing += valueOf(sample, "seal_p50") > 0;
        QVERIFY(valueOf(sample, "record_loss") <= 0.2);
    }
    QVERIFY2(packets >= 10.0 * static_cast<double>(runs.size()), qPrintable(QString::number(packets)));
    QVERIFY2(sealing > runs.size() / 2, qPrintable(QString::number(sealing)));
    QSet<QString> all;
    for (const skyseal::crypto::SuiteInfo &suite : skyseal::crypto::suites()) {
        if (skyseal::crypto::suiteAvailable(suite.id))
            all << QString::fromLatin1(suite.name.data(), static_cast<qsizetype>(suite.name.size()));
    }
    QCOMPARE(suites, all);
    QCOMPARE(runs.size(), 2 * all.size()); // each once under each load
    const bool sharesCores = runs.first()[QLatin1String("condition")] == q("rate=921600");
    QCOMPARE(sharesCores, !skyseal::experiment::placementHere().station.has_value());
    const QJsonObject report = QJsonDocument::fromJson(contentOf(folder.filePath(q("sweep.json")))).object();
    const QString command = report[QLatin1String("setting")][QLatin1String("command_line")].toString();
    QVERIFY2(command.contains(q(" --impair rate=921600 --seed ")) == sharesCores, qPrintable(command)); // repeats it anywhere
    const auto isFull = [](const QJsonObject &sample) {
        return sample[QLatin1String("load")] == q("saturated") && valueOf(sample, "line_load") >= 95
            && sample[QLatin1String("valid")].toBool();
    };
    QCOMPARE(std::any_of(runs.begin(), runs.end(), isFull), sharesCores);
}

/// Each launch is a process of its own, in the order that the seed decides; the report is written again from sweep.json with
/// the same bytes.
void SweepTest::launchesStartAnew()
{
    QTemporaryDir folder;
    const QString first = folder.filePath(q("first")), again = folder.filePath(q("again")),
                  joined = folder.filePath(q("joined"));
    const RunResult run = runProgram("skyseal-cli",
                                     q("sweep --launches 3 --repeats 1 --suites none,aes-256-gcm --load natural --seconds 0.5 "
                                       "--warm-up 0.2 --seed 11 --json --expect packets(none)>=1 --out")
                                             .split(QLatin1Char(' '))
                                         << first,
                                     {}, 240000);
    QVERIFY2(run.status == 0, run.err.constData());
    const QJsonObject report = QJsonDocument::fromJson(contentOf(first + q("/sweep.json"))).object();
    QCOMPARE(report[QLatin1String("plan")][QLatin1String("launches")].toInt(), 3);
    const QJsonArray samples = report[QLatin1String("samples")].toArray();
    QCOMPARE(samples.size(), 3 * 3); // two suites, and one of them again
    QCOMPARE(events(run.out, "run").size(), 9);
    QCOMPARE(events(run.out, "end").size(), 1);
    double last = -1;
    for (qsizetype i = 0; i < samples.size(); ++i) {
        QCOMPARE(samples[i][QLatin1String("launch")].toInt(), int(i) / 3);
        QCOMPARE(samples[i][QLatin1String("order")].toInt(), int(i));
        QVERIFY(samples[i][QLatin1String("start")].toDouble() > last);
        last = samples[i][QLatin1String("start")].toDouble();
        // Counters begin anew with the programs.
        if (i % 3 == 0)
            QVERIFY(
                samples[i][QLatin1String("counted")][QLatin1String("begin")][QLatin1String("mavlink")][QLatin1String("frames")]
                    .toDouble()
                < 3000);
    }
    bool compared = false;
    for (const QJsonValue pair : report[QLatin1String("comparisons")].toArray()) {
        if (pair[QLatin1String("metric")] != q("cpu_per_frame"))
            continue;
        QCOMPARE(pair[QLatin1String("unit")].toString(), q("launch"));
        QCOMPARE(pair[QLatin1String("units")].toInt(), 3);
        QVERIFY(pair[QLatin1String("ci95_low")].toDouble() < pair[QLatin1String("ratio")].toDouble());
        compared = true;
    }
    QVERIFY(compared);
    QVERIFY(!report[QLatin1String("context_bytes")].toObject().isEmpty());
    for (const char *program : {"sha256_skyseal-cli", "sha256_skyseal-air", "sha256_skyseal-sim"})
        QCOMPARE(report[QLatin1String("setting")][QLatin1String(program)].toString().size(), 64);

    const RunResult written = runProgram("skyseal-cli", {q("report"), first, q("--out"), again}, {}, 120000);
    QVERIFY2(written.status == 0, written.err.constData());
    QStringList names{q("sweep.json"), q("sweep.csv"),          q("sweep-columns.csv"),
                      q("ratios.csv"), q("ratios-columns.csv"), q("report.html")};
    for (const QString &figure : QDir(first + q("/figures")).entryList({q("*.svg")}))
        names << q("figures/") + figure;
#ifdef SKYSEAL_HAVE_FIGURES
    names << q("report.pdf");
#endif
    QVERIFY(names.size() > 8);
    for (const QString &name : names) {
        const QByteArray content = contentOf(first + QLatin1Char('/') + name);
        QVERIFY(!content.isEmpty());
        QVERIFY2(content == contentOf(again + QLatin1Char('/') + name), qPrintable(name));
    }
    const RunResult copy = runProgram("skyseal-cli", {q("report"), first, again, q("--out"), joined}, {}, 120000);
    QCOMPARE(copy.status, 1);
    QVERIFY2(copy.err.contains("are the same sweep"), copy.err.constData());
    QByteArray later = contentOf(again + q("/sweep.json"));
    later.replace(report[QLatin1String("setting")][QLatin1String("time")].toString().toUtf8(), "2020-02-02T00:00:00Z");
    QFile file(again + q("/sweep.json"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(later) == later.size());
    file.close();
    const RunResult two = runProgram("skyseal-cli", {q("report"), first, again, q("--out"), joined}, {}, 120000);
    QVERIFY2(two.status == 0, two.err.constData());
    QVERIFY(contentOf(joined + q("/report.html")).contains("each stands alone"));
#ifdef SKYSEAL_HAVE_FIGURES
    QVERIFY(contentOf(joined + q("/report.pdf")).startsWith("%PDF"));
#endif
    const RunResult none = runProgram("skyseal-cli", {q("report"), folder.path(), q("--out"), joined}, {}, 120000);
    QCOMPARE(none.status, 3);
    QVERIFY(none.err.contains("sweep.json"));
}

void SweepTest::cancelEndsTheLaunch()
{
    QTemporaryDir folder;
    Program process(
        q("skyseal-cli"),
        q("sweep --launches 20 --repeats 1 --suites none,aes-256-gcm --load natural --seconds 0.5 --warm-up 0.2 --json "
          "--out")
                .split(QLatin1Char(' '))
            << folder.path());
    QVERIFY2(!process.waitFor(q("run")).isEmpty(), process.errors().constData());
    process.terminate();
    QCOMPARE(process.waitForExit(), 1);
    QVERIFY(process.errors().contains("cancelled"));
    const QJsonObject report = QJsonDocument::fromJson(contentOf(folder.filePath(q("sweep.json")))).object();
    QVERIFY(!report[QLatin1String("complete")].toBool());
    QVERIFY(!report[QLatin1String("samples")].toArray().isEmpty());
}

void SweepTest::lossIsThatOfTheLink()
{
    // Saturated, so that there are records enough for the share to be near the probability.
    const RunResult run = runProgram(
        "skyseal-cli",
        sweep("--suites none,aes-256-gcm --load saturated --seconds 2 --warm-up 0.3 --repeats 2 --no-noise "
              "--impair loss=0.05 --json --expect loss<=0.01"),
        {}, 240000);
    QCOMPARE(run.status, 1); // and the assertion notices, also where no run of that load is valid
    QVERIFY(!events(run.out, "expect").at(0)[QLatin1String("holds")].toBool());
    QCOMPARE(events(run.out, "run").size(), 4);
    double dropped = 0;
    for (const QJsonObject &sample : events(run.out, "run")) {
        // Each arm, also after a change between clear and sealed, which takes long there: the load is not a tenth of this.
        QVERIFY2(valueOf(sample, "packets") > 3000, QJsonDocument(sample).toJson().constData());
        QVERIFY2(std::abs(valueOf(sample, "loss") - 0.05) < 0.025, QJsonDocument(sample).toJson().constData());
        // The edges in the relay's log are as far from those of the run as a busy machine delays their reading.
        const bool plain = sample[QLatin1String("suite")] == QLatin1String("none");
        QVERIFY2(std::abs(valueOf(sample, plain ? "loss" : "record_loss") - droppedShare(sample)) < 0.0125,
                 QJsonDocument(sample).toJson().constData());
        dropped += droppedShare(sample) / 4;
    }
    QVERIFY2(std::abs(dropped - 0.05) < 0.02, qPrintable(QString::number(dropped)));
}

void SweepTest::radioSetsThePace()
{
    const RunResult run = runProgram(
        "skyseal-cli",
        sweep("--suites chacha20-poly1305,aes-256-gcm --load saturated --seconds 3 --warm-up 2 --repeats 1 "
              "--no-noise --impair rate=57600,delay=20 --json"),
        {}, 240000);
    // Also the second one, which is switched to through a queue of seconds.
    QVERIFY2(isDone(run), run.err.constData());
    QCOMPARE(events(run.out, "run").size(), 2);
    int answered = 0;
    for (const QJsonObject &sample : events(run.out, "run")) {
        // 57,600 baud are 5,760 bytes a second. On a busy machine the relay delivers in bursts at the ends of the interval;
        // without the radio it is a thousand times as much.
        const double rate = valueOf(sample, "wire_rate");
        QVERIFY2(rate > 3000 && rate < 9000, qPrintable(QString::number(rate)));
        // A line that is not full is no saturated one, whatever the machine does meanwhile.
        QVERIFY2(std::abs(valueOf(sample, "line_load") - rate / 57.6) < 1, qPrintable(QString::number(rate)));
        QCOMPARE(sample[QLatin1String("valid")].toBool(), valueOf(sample, "line_load") >= 95);
        QVERIFY(isLatency(sample, 40));
        answered += valueOf(sample, "latency") >= 40;
    }
    QVERIFY(answered > 0);
}

void SweepTest::cancelKeepsWhatThereIs()
{
    QTemporaryDir folder;
    QProcess process;
    QStringList arguments = sweep("--suites none,aes-256-gcm --seconds 1 --warm-up 0.3 --repeats 50 --load natural --json");
    process.start(q(SKYSEAL_BIN_DIR "/skyseal-cli"), arguments << q("--out") << folder.path());
    QVERIFY(process.waitForStarted(kDeadlineMs));
    QByteArray out;
    while (events(out, "run").isEmpty() && process.waitForReadyRead(kDeadlineMs))
        out += process.readAllStandardOutput();
    QVERIFY2(!events(out, "run").isEmpty(), (out + process.readAllStandardError()).constData());
    process.terminate();
    QVERIFY(process.waitForFinished(kDeadlineMs));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("cancelled"));
    const QJsonObject report = QJsonDocument::fromJson(contentOf(folder.filePath(q("sweep.json")))).object();
    QVERIFY(!report[QLatin1String("complete")].toBool());
    QVERIFY(!report[QLatin1String("samples")].toArray().isEmpty());
    const QString seed = report[QLatin1String("plan")][QLatin1String("seed")].toString();
    QVERIFY(!seed.isEmpty() && !m_seeds.contains(seed)); // of each sweep another one
    m_seeds << seed;
}

void SweepTest::nobodyAnswers()
{
    const RunResult run = runProgram("skyseal-cli", sweep("--link udpin:192.0.2.1:14550 --identity /nonexistent --peers x"));
    QCOMPARE(run.status, 3);
    QVERIFY(run.err.contains("/nonexistent"));
}

void SweepTest::bothFramings()
{
    const RunResult run = runProgram("skyseal-cli",
                                     sweep("--suites none,aes-256-gcm,chacha20 --framing both --load natural "
                                           "--seconds 1 --warm-up 0.2 --repeats 1 --json --expect loss<=0.001 "
                                           "--expect overhead(chacha20,inline)!=overhead(chacha20,sealed)"),
                                     {}, 120000);
    QVERIFY2(run.status == 0, run.err.constData());
    QStringList framings;
    for (const QJsonObject &sample : events(run.out, "run")) {
        framings << sample[QLatin1String("suite")].toString() + QLatin1Char(' ') + sample[QLatin1String("framing")].toString();
        QVERIFY(valueOf(sample, "packets") >= 10);
        if (framings.last() != QLatin1String("none plain")) {
            QVERIFY(valueOf(sample, "open_p50") > 0 && valueOf(sample, "seal_p50") > 0);
            QCOMPARE(valueOf(sample, "record_loss"), 0.0);
        }
    }
    framings.sort();
    QCOMPARE(framings, QStringList({q("aes-256-gcm sealed"), q("chacha20 inline"), q("chacha20 sealed"), q("none plain")}));
}

/// A sweep on an agent that it did not start, cancelled while RC4 is in use: the agent reports the switch back, and the samples
/// so far are written and marked as incomplete.
void SweepTest::cancelOnALinkRestoresTheSuite()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(q("skyseal-sim"), flight.simArguments());
    Program air(q("skyseal-air"), flight.airArguments());
    QTemporaryDir folder;
    Program process(q("skyseal-cli"),
                    onLink(flight,
                           "--allow-research --suites rc4 --seconds 1 --warm-up 0.3 --repeats 50 --no-noise "
                           "--json")
                        + QStringList{q("--out"), folder.path()});
    QVERIFY2(!process.waitFor(q("run")).isEmpty(), process.errors().constData());
    process.terminate();
    QCOMPARE(process.waitForExit(), 1);
    QVERIFY(process.errors().contains("cancelled"));
    EVENTUALLY_EQUAL(air.last(q("switch"))[QLatin1String("from")].toString(), q("rc4"));
    QCOMPARE(air.last(q("switch"))[QLatin1String("to")].toString(), q("chacha20-poly1305"));
    QCOMPARE(air.last(q("switch"))[QLatin1String("result")].toString(), q("committed"));
    const QJsonObject report = QJsonDocument::fromJson(contentOf(folder.filePath(q("sweep.json")))).object();
    QVERIFY(!report[QLatin1String("complete")].toBool());
    QVERIFY(!report[QLatin1String("samples")].toArray().isEmpty());
    QVERIFY(contentOf(folder.filePath(q("report.html"))).contains("This sweep is incomplete"));
}

void SweepTest::refusalsAreTold()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(q("skyseal-sim"), flight.simArguments());
    Program air(q("skyseal-air"), flight.airArguments()); // consents neither to plain MAVLink nor to inline framing
    Program process(q("skyseal-cli"),
                    onLink(flight,
                           "--allow-plain --suites none,aes-256-ctr --framing both --seconds 0.5 "
                           "--warm-up 0.3 --repeats 1 --seed 3 --json"));
    QCOMPARE(process.waitForExit(), 1);
    QHash<QString, QString> problems;
    for (const QJsonObject &sample : process.events(q("run")))
        problems[sample[QLatin1String("suite")].toString() + QLatin1Char(' ') + sample[QLatin1String("framing")].toString()] =
            sample[QLatin1String("problem")].toString();
    QCOMPARE(problems.size(), 3);
    QVERIFY2(problems[q("aes-256-ctr sealed")].isEmpty(), qPrintable(problems[q("aes-256-ctr sealed")]));
    QVERIFY(problems[q("aes-256-ctr inline")].contains(q("inline framing")));
    QVERIFY(!problems[q("none plain")].isEmpty());
}

/// Somebody else's agent, whose process the sweep does not know: what it costs comes over the sealed link. Its memory is
/// what the kernel says of that process.
void SweepTest::agentTellsItsCosts()
{
    Flight flight;
    QVERIFY(flight.ready());
    Program sim(q("skyseal-sim"), flight.simArguments({q("--saturate")}));
    Program air(q("skyseal-air"), flight.airArguments());
    Program process(q("skyseal-cli"), onLink(flight, "--suites aes-256-gcm --seconds 4 --repeats 1 --no-noise --json"));
    QCOMPARE(process.waitForExit(), 0);
    QFile statm(q("/proc/%1/statm").arg(air.pid()));
    QVERIFY(statm.open(QIODevice::ReadOnly));
    const double resident = statm.readAll().split(' ')[1].toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE));
    const std::vector<QJsonObject> samples = process.events(q("run"));
    QCOMPARE(int(samples.size()), 1);
    const double cpu = valueOf(samples[0], "agent_cpu"), suite = valueOf(samples[0], "agent_cpu_suite");
    QVERIFY2(suite > 0 && suite < cpu && cpu < 110, qPrintable(q("%1 %2").arg(suite).arg(cpu)));
    QVERIFY2(valueOf(samples[0], "agent_seal") > 50 && valueOf(samples[0], "agent_open") > 50,
             qPrintable(q("%1 %2").arg(valueOf(samples[0], "agent_seal")).arg(valueOf(samples[0], "agent_open"))));
    QVERIFY(valueOf(samples[0], "agent_cpu_per_frame") > 100);
    const double memory = valueOf(samples[0], "agent_memory");
    QVERIFY2(std::abs(memory - resident) < 0.1 * resident, qPrintable(q("%1 %2").arg(memory).arg(resident)));
}

/// To and from plain MAVLink at each run, where every third datagram is lost, goodbyes among them.
void SweepTest::plainComesBackOverABadLink()
{
    const RunResult run = runProgram("skyseal-cli",
                                     sweep("--suites none,aes-256-gcm --load natural --seconds 0.5 --warm-up 0.3 --repeats 8 "
                                           "--seed 1 --no-noise --impair loss=0.3 --json"),
                                     {}, 200000);
    QVERIFY2(run.status == 0, run.err.constData());
    for (const QJsonObject &sample : events(run.out, "run"))
        QVERIFY2(sample[QLatin1String("problem")].isUndefined(), qPrintable(sample[QLatin1String("problem")].toString()));
}

SKYSEAL_TEST(SweepTest)
#include "sweep_test.moc"
