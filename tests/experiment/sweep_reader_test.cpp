// A sweep that was written and read is the same one, to the last byte of its report; what does not fit its plan is refused;
// sweeps of several machines are joined only where they are of one setting.
#include "core/experiment/sweep_reader.h"
#include "core/experiment/analysis.h"
#include "core/experiment/html_report.h"
#include "core/experiment/message_mix.h"
#include "core/experiment/pooled_report.h"
#include "core/experiment/random_effects.h"
#include "core/experiment/sweep_csv.h"
#include "core/experiment/sweep_json.h"
#include "tests/support/test_runner.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QXmlStreamReader>
#include <QtTest/QTest>

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <tuple>

using namespace skyseal;
using namespace skyseal::experiment;
using crypto::SuiteId;

namespace {

/// Three arms and the first suite again, in three launches; RC4 costs `rc4` times what the others do.
Results sweepOf(double rc4, unsigned seed)
{
    Results out;
    out.plan.arms = armsOf({SuiteId::None, SuiteId::ChaCha20, SuiteId::Rc4}, {experiment::ArmFraming::Sealed}, true);
    out.plan.loads = {Load::Natural, Load::Saturated};
    out.plan.launches = 3;
    out.plan.repeats = 2;
    out.plan.seed = seed;
    out.setting = {
        {"processor", "of test " + std::to_string(seed)}, {"commit", "abc"}, {"a key", "<b>\"&"}, {"message_mix", "one"}};
    out.placement = "left to the system";
    out.contextBytes = {{SuiteId::ChaCha20, 400.5}, {SuiteId::Rc4, 1100}};
    out.complete = true;
    out.seconds = 123.456789012345;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.005);
    for (const Run &run : schedule(out.plan)) {
        Sample sample;
        sample.run = run;
        sample.order = static_cast<unsigned>(out.samples.size());
        sample.start = 7.1 * sample.order;
        sample.seconds = 5.000123;
        for (const Metric metric :
             {Metric::Packets, Metric::CpuPerFrame, Metric::AgentCpuPerFrame, Metric::Latency, Metric::Memory})
            sample.values[metric] = 1234.5 * std::exp(noise(random)) * (out.plan.arms[run.arm].suite == SuiteId::Rc4 ? rc4 : 1);
        sample.values[Metric::Loss] = 0;
        sample.end.mavlink.taken = 1'000'000'000'000'000 + sample.order;
        sample.end.rx.good = 55;
        sample.messages = {{0, 20}, {30, 600 + sample.order}, {33, 400}, {11'000'000, 3}}; // heartbeats, attitudes, positions
        out.samples.push_back(sample);
    }
    out.samples[1].problem = "no vehicle was heard";
    out.samples[1].values = {};
    out.samples[2].invalid = "not saturated: nothing reached 95 %";
    out.samples[2].attempts = 3;
    out.samples[3].values[Metric::OtherCpu] = 55;
    return out;
}

const std::vector<Verdict> kNone;

std::string pageOf(const Results &results)
{
    const auto figures = figuresOf(results);
    return htmlReport({results, figures, kNone, paperClaims(results)});
}

QByteArray jsonOf(const Results &results)
{
    return QByteArray::fromStdString(sweepJson(results, {}));
}

std::string errorOf(const QJsonObject &report)
{
    const auto read = readSweep(QJsonDocument(report).toJson());
    return read ? std::string() : read.error().text();
}

} // namespace

class SweepReaderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatWasWrittenIsRead();
    void bareArmsAreRead();
    void olderVersionsAreReadable();
    void whatAFileDoesNotHoldStaysUnknown();
    void othersAreRefused();
    void damageIsNoCrash();
    void randomEffectsAgreeWithSciPy();
    void machinesAreJoined();
    void twoMachinesStandAlone();
    void daysOfAMachineAreNested();
    void pooledTableIsComplete();
    void otherSettingsAreRefused();
    void messageMixIsThatOfTheReference();
    void otherMessagesAreRefused();
    void longNamesFitTheFigure();
    void sweepsOfOtherProgramsAreRefused();
};

void SweepReaderTest::whatWasWrittenIsRead()
{
    const Results results = sweepOf(1.2, 7);
    const auto read = readSweep(jsonOf(results));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->schemaVersion, kSweepSchemaVersion);
    QCOMPARE(jsonOf(read->results), jsonOf(results));
    QCOMPARE(sweepCsv(read->results), sweepCsv(results));
    QCOMPARE(ratiosCsv(read->results), ratiosCsv(results));
    QCOMPARE(pageOf(read->results), pageOf(results));
    const auto figures = figuresOf(results), again = figuresOf(read->results);
    QCOMPARE(again.size(), figures.size());
    for (std::size_t i = 0; i < figures.size(); ++i)
        QVERIFY(figures[i].name == again[i].name && figures[i].svg == again[i].svg);
}

/// Without what later versions added: launches, validity.
void SweepReaderTest::bareArmsAreRead()
{
    Results results = sweepOf(1.2, 7);
    results.plan.arms = armsOf({SuiteId::None, SuiteId::ChaCha20, SuiteId::Rc4}, {std::begin(kFramings), std::end(kFramings)},
                               false);
    for (Sample &sample : results.samples)
        sample.run.arm = sample.run.arm == 2 ? 3 : sample.run.arm == 3 ? 5 : sample.run.arm; // ChaCha20 in each framing
    QCOMPARE(fullName(results.plan.arms[5]), std::string("chacha20 bare"));
    const auto read = readSweep(jsonOf(results));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(read->results.plan.arms == results.plan.arms);
    QCOMPARE(jsonOf(read->results), jsonOf(results));
    const QJsonObject report = QJsonDocument::fromJson(jsonOf(results)).object();
    const QJsonObject bare = report[QLatin1String("plan")][QLatin1String("arms")][5].toObject();
    QCOMPARE(bare[QLatin1String("framing")].toString(), QStringLiteral("bare"));
    QVERIFY(bare[QLatin1String("insecure")].toBool());
    // What the HMAC adds: the same cipher in place over the bare one.
    int pairs = 0;
    for (const QJsonValue one : report[QLatin1String("comparisons")].toArray())
        pairs += one[QLatin1String("first_framing")] == QLatin1String("bare")
            && one[QLatin1String("second_framing")] == QLatin1String("inline");
    QVERIFY(pairs > 0);
    const std::string page = pageOf(read->results);
    for (const char *text : {"bare: INSECURE, as in the paper", "with and without their HMAC", "not in this framing"})
        QVERIFY2(page.find(text) != std::string::npos, text);
}

void SweepReaderTest::olderVersionsAreReadable()
{
    for (const int version : {2, 3}) {
        QJsonObject report = QJsonDocument::fromJson(jsonOf(sweepOf(1.2, 7))).object();
        report[QLatin1String("schema_version")] = version;
        QJsonArray samples;
        for (const QJsonValue value : report[QLatin1String("samples")].toArray()) {
            QJsonObject sample = value.toObject();
            if (sample[QLatin1String("launch")].toInt() > 0)
                continue;
            for (const char *key : {"launch", "valid", "attempts", "invalid", "disturbances"})
                sample.remove(QLatin1String(key));
            samples.append(sample);
        }
        report[QLatin1String("samples")] = samples;
        QJsonObject plan = report[QLatin1String("plan")].toObject();
        plan.remove(QLatin1String("launches"));
        plan.remove(QLatin1String("margin"));
        report[QLatin1String("plan")] = plan;
        for (const char *key : {"context_bytes", "setting_keys", "claims", "placement"})
            report.remove(QLatin1String(key));
        const auto read = readSweep(QJsonDocument(report).toJson());
        QVERIFY2(read, read ? "" : read.error().text().c_str());
        QCOMPARE(read->results.plan.launches, 1u);
        QCOMPARE(read->results.samples.size(), std::size_t(samples.size()));
        QVERIFY(pageOf(read->results).find("All programs were started once only") != std::string::npos);
    }
}

void SweepReaderTest::whatAFileDoesNotHoldStaysUnknown()
{
    // A whole file of the newest version has nothing that is unknown.
    QJsonObject report = QJsonDocument::fromJson(jsonOf(sweepOf(1.2, 7))).object();
    QVERIFY(readSweep(QJsonDocument(report).toJson())->results.unknown.empty());
    report[QLatin1String("schema_version")] = 3;
    report.remove(QLatin1String("context_bytes"));
    const auto third = readSweep(QJsonDocument(report).toJson());
    QVERIFY(third && third->results.samples[0].isJudged && third->results.samples[0].isCounted);
    QCOMPARE(third->results.unknown.size(), std::size_t(1));
    QVERIFY2(third->results.unknown[0].find("empty: context_bytes, source.") != std::string::npos,
             third->results.unknown[0].c_str());
    // Only version 1 had no framing for each arm.
    QJsonObject plan = report[QLatin1String("plan")].toObject();
    QJsonArray arms = plan[QLatin1String("arms")].toArray();
    QJsonObject arm = arms[1].toObject();
    arm.remove(QLatin1String("framing"));
    arms[1] = arm;
    plan[QLatin1String("arms")] = arms;
    report[QLatin1String("plan")] = plan;
    QVERIFY(errorOf(report).find("an arm of the plan is unknown") != std::string::npos);
}

void SweepReaderTest::othersAreRefused()
{
    const QJsonObject report = QJsonDocument::fromJson(jsonOf(sweepOf(1.2, 7))).object();
    QVERIFY(errorOf(report).empty());
    const auto with = [&report](const char *key, const QJsonValue &value) {
        QJsonObject changed = report;
        changed[QLatin1String(key)] = value;
        return errorOf(changed);
    };
    QVERIFY(with("schema", QStringLiteral("other")).find("another schema") != std::string::npos);
    QVERIFY(with("schema_version", 0).find("version is 0") != std::string::npos);
    QVERIFY(with("schema_version", 99).find("version is 99") != std::string::npos);
    QVERIFY(with("plan", QJsonObject()).find("no arms") != std::string::npos);
    QJsonObject sample = report[QLatin1String("samples")].toArray().first().toObject();
    for (const auto &[key, value] :
         {std::pair("suite", QJsonValue(QStringLiteral("aes-256-gcm"))), std::pair("repeat", QJsonValue(2)),
          std::pair("launch", QJsonValue(3)), std::pair("repeat", QJsonValue(-1)),
          std::pair("condition", QJsonValue(QStringLiteral("loss=0.1")))}) {
        QJsonObject changed = sample;
        changed[QLatin1String(key)] = value;
        QVERIFY2(with("samples", QJsonArray{changed}).find("not one of its plan") != std::string::npos, key);
    }
    QVERIFY(with("expectations", QJsonArray{QJsonObject{{QStringLiteral("expectation"), QStringLiteral("nonsense")}}})
                .find("assertion")
            != std::string::npos);
}

/// Bytes of a real file changed, cut and doubled: an error or a sweep, and in both cases no more.
void SweepReaderTest::damageIsNoCrash()
{
    const QByteArray whole = jsonOf(sweepOf(1.2, 7));
    std::mt19937 random(20261124);
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
        QByteArray damaged = whole;
        for (int changes = 0; changes <= i % 4; ++changes)
            damaged[qsizetype(random() % std::size_t(damaged.size()))] = static_cast<char>(random() % 128);
        if (i % 10 == 0)
            damaged.truncate(qsizetype(random() % std::size_t(damaged.size())));
        const auto read = readSweep(damaged);
        refused += !read;
        if (read)
            QVERIFY(!sweepCsv(read->results).empty());
    }
    QVERIFY(refused > 30);
}

void SweepReaderTest::randomEffectsAgreeWithSciPy()
{
    std::ifstream in(SKYSEAL_SOURCE_DIR "/tests/data/vectors/sweep_models.txt");
    std::vector<MachineEffect> machines;
    int checked = 0;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "effects")
            machines.clear();
        if (kind == "machine") {
            machines.emplace_back();
            words >> machines.back().estimate >> machines.back().error;
        }
        if (kind != "pooled")
            continue;
        RandomEffects expected;
        words >> expected.variance >> expected.mean >> expected.error >> expected.low >> expected.high >> expected.predictionLow
            >> expected.predictionHigh;
        const auto found = pooled(machines);
        QVERIFY(found);
        QVERIFY2(std::abs(found->variance - expected.variance) < 1e-6 * expected.variance + 1e-12, line.c_str());
        for (const auto member : {&RandomEffects::mean, &RandomEffects::error, &RandomEffects::low, &RandomEffects::high,
                                  &RandomEffects::predictionLow, &RandomEffects::predictionHigh})
            QVERIFY2(std::abs((*found).*member - expected.*member) < 1e-6, line.c_str());
        ++checked;
        machines.pop_back();
        while (machines.size() >= kLeastMachines)
            machines.pop_back();
        QVERIFY(!pooled(machines));
    }
    QCOMPARE(checked, 3);
}

void SweepReaderTest::machinesAreJoined()
{
    std::vector<Machine> machines;
    for (const auto &[label, rc4] : {std::pair("desk", 1.2), std::pair("board", 1.3), std::pair("laptop", 1.25)})
        machines.push_back({label, kSweepSchemaVersion, sweepOf(rc4, 1 + static_cast<unsigned>(machines.size()))});
    QVERIFY2(mismatchOf(machines).empty(), mismatchOf(machines).c_str());
    const std::string csv = pooledCsv(machines);
    const std::size_t at = csv.find("\"clean\",saturated,cpu_per_frame,\"rc4 sealed\",\"all machines\",");
    QVERIFY(at != std::string::npos);
    const std::string line = csv.substr(at, csv.find('\n', at) - at);
    const double ratio = QByteArray::fromStdString(line).split(',').at(5).toDouble();
    QVERIFY2(std::abs(ratio - 1.25) < 0.02, line.c_str());
    const std::string page = pooledHtml(machines);
    for (const char *part : {"all machines", ">board<", "of test 2", "prediction interval", "&lt;b&gt;"})
        QVERIFY2(page.find(part) != std::string::npos, part);
    QVERIFY(page.find("<b>\"") == std::string::npos);
    // Reports do not depend on what was computed before.
    QCOMPARE(pooledHtml(machines), page);
}

void SweepReaderTest::twoMachinesStandAlone()
{
    const std::vector<Machine> machines{{"desk", 4, sweepOf(1.2, 1)}, {"board", 4, sweepOf(1.3, 2)}};
    const std::string csv = pooledCsv(machines);
    QVERIFY(csv.find("\"board\"") != std::string::npos && csv.find("all machines") == std::string::npos);
    QVERIFY(pooledHtml(machines).find("each stands alone") != std::string::npos);
}

/// Three days of one machine weigh as much as one day of another, and say nothing of further machines.
void SweepReaderTest::daysOfAMachineAreNested()
{
    std::vector<Machine> machines;
    unsigned seed = 0;
    for (const auto &[label, processor, rc4] : {std::tuple("monday", "desk, 2400 MHz", 1.2),
                                                {"tuesday", "desk, 1800 MHz", 1.2},
                                                {"wednesday", "desk, 2400 MHz", 1.2},
                                                {"board", "arm", 1.3},
                                                {"laptop", "mobile", 1.25}}) {
        machines.push_back({label, kSweepSchemaVersion, sweepOf(rc4, ++seed)});
        machines.back().results.setting[0].second = processor;
    }
    QCOMPARE(daysOfMachines(machines).size(), std::size_t(3));
    const auto common = [](const std::vector<Machine> &of) {
        const std::string csv = pooledCsv(of);
        const std::size_t at = csv.find("\"clean\",saturated,cpu_per_frame,\"rc4 sealed\",\"all machines\",");
        return at == std::string::npos ? std::nan("") : QByteArray::fromStdString(csv.substr(at)).split(',').at(5).toDouble();
    };
    QVERIFY2(std::abs(common(machines) - 1.25) < 0.01, qPrintable(QString::number(common(machines))));
    QVERIFY(pooledHtml(machines).find("monday, tuesday, wednesday are days of one machine") != std::string::npos);
    const std::vector<Machine> days(machines.begin(), machines.begin() + 3);
    QVERIFY(std::isnan(common(days)));
    QVERIFY(pooledHtml(days).find("each stands alone") != std::string::npos);
    for (Machine &machine : machines)
        machine.results.source = machine.label; // another autopilot each
    QCOMPARE(daysOfMachines(machines).size(), std::size_t(5));
}

/// An arm that the first sweep has not, what is insecure, and a description of each column.
void SweepReaderTest::pooledTableIsComplete()
{
    std::vector<Machine> machines{{"desk", 4, sweepOf(1.2, 1)}, {"board", 4, sweepOf(1.3, 2)}, {"laptop", 4, sweepOf(1.3, 3)}};
    Results &first = machines.front().results;
    QCOMPARE(int(first.plan.arms[2].suite), int(SuiteId::Rc4));
    first.plan.arms.erase(first.plan.arms.begin() + 2);
    std::erase_if(first.samples, [](const Sample &sample) { return sample.run.arm == 2; });
    for (Sample &sample : first.samples)
        sample.run.arm -= sample.run.arm > 2;
    QVERIFY2(mismatchOf(machines).empty(), mismatchOf(machines).c_str());
    const QStringList lines = QString::fromStdString(pooledCsv(machines)).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    const QStringList columns = lines.first().split(QLatin1Char(','));
    QStringList described;
    for (const QString &line : QString::fromStdString(pooledColumnsCsv()).split(QLatin1Char('\n'), Qt::SkipEmptyParts).mid(1))
        described << line.section(QLatin1Char(','), 0, 0);
    QCOMPARE(columns, described);
    const qsizetype insecure = columns.indexOf(QStringLiteral("insecure"));
    int rc4 = 0;
    for (const QString &line : lines.mid(1)) {
        const QStringList cells = line.split(QLatin1Char(','));
        QCOMPARE(cells.size(), columns.size());
        const bool isRc4 = line.contains(QLatin1String("\"rc4 sealed\""));
        rc4 += isRc4;
        QCOMPARE(cells[insecure], isRc4 ? QStringLiteral("1") : QStringLiteral("0"));
        QVERIFY(line.contains(QLatin1String("all machines")) || line.contains(QLatin1String("\"abc\"")));
    }
    QVERIFY(rc4 >= 2);
    QVERIFY(pooledHtml(machines).find("rc4 sealed is not in desk.") != std::string::npos);
    int marked = 0;
    for (const ReportFigure &figure : forestsOf(machines))
        marked += figure.svg.find("rc4 sealed (insecure)") != std::string::npos;
    QVERIFY(marked > 0);
}

/// Every text lies within the column of 88 mm, by the width that its characters take at most.
void SweepReaderTest::longNamesFitTheFigure()
{
    const std::string name = "an-äußerst-long-name-of-a-folder/";
    const std::vector<Machine> machines{
        {name + "desk", 4, sweepOf(1.2, 1)}, {name + "board", 4, sweepOf(1.3, 2)}, {name + "laptop", 4, sweepOf(1.3, 3)}};
    for (const ReportFigure &figure : forestsOf(machines)) {
        QXmlStreamReader xml(QString::fromStdString(figure.svg));
        int shortened = 0;
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement || xml.name() != QLatin1String("text"))
                continue;
            const double size = xml.attributes().value(QLatin1String("font-size")).toDouble();
            const double x = xml.attributes().value(QLatin1String("x")).toDouble();
            const QString anchor = xml.attributes().value(QLatin1String("text-anchor")).toString(),
                          text = xml.readElementText();
            const double width = 0.65 * size * static_cast<double>(text.size());
            shortened += text.contains(QChar(0x2026));
            if (anchor == QLatin1String("end"))
                QVERIFY2(x - width > -2 && x <= 333, qPrintable(text));
        }
        QVERIFY(!xml.hasError());
        QCOMPARE(shortened, 3);
        for (const char *end : {"/desk<", "/board<", "/laptop<"})
            QVERIFY2(figure.svg.find(end) != std::string::npos, figure.svg.c_str());
    }
    QVERIFY(pooledCsv(machines).find(name + "laptop") != std::string::npos); // in full
}

void SweepReaderTest::sweepsOfOtherProgramsAreRefused()
{
    const auto said = [](const char *commit, const char *oneHash, const char *otherHash, const char *otherTime = "2026-02-02") {
        std::vector<Machine> machines{{"desk", 4, sweepOf(1.2, 1)}, {"board", 4, sweepOf(1.2, 1)}};
        for (Machine &machine : machines) {
            Setting &setting = machine.results.setting;
            setting[1].second = commit;
            const bool isFirst = &machine == &machines.front();
            setting.emplace_back("time", isFirst ? "2026-01-01" : otherTime);
            if (const char *hash = isFirst ? oneHash : otherHash)
                setting.emplace_back("sha256_skyseal-cli", hash);
        }
        return mismatchOf(machines);
    };
    for (const char *commit : {"abc-changed", "unknown", ""}) {
        QCOMPARE(said(commit, "12", "12"), std::string());
        QVERIFY2(said(commit, "12", "34").find("SHA-256 differs") != std::string::npos, said(commit, "12", "34").c_str());
        QVERIFY(said(commit, nullptr, nullptr).find("SHA-256 is not recorded") != std::string::npos);
    }
    QCOMPARE(said("abc", "12", "34"), std::string()); // built for another machine
    // The same sweep twice.
    QVERIFY(said("abc", "12", "12", "2026-01-01").find("desk and board are the same sweep") != std::string::npos);
}

void SweepReaderTest::otherSettingsAreRefused()
{
    const Machine one{"desk", 4, sweepOf(1.2, 1)};
    const auto refused = [&one](const char *what, auto change) {
        Machine other{"board", 4, sweepOf(1.2, 2)};
        change(other);
        const std::string said = mismatchOf({one, other});
        return said.find(what) != std::string::npos && said.find("desk") != std::string::npos
            && said.find("board") != std::string::npos;
    };
    QVERIFY(refused("schema version", [](Machine &machine) { machine.schemaVersion = 3; }));
    QVERIFY(
        refused("framing", [](Machine &machine) { machine.results.plan.arms[1].framing = experiment::ArmFraming::Inline; }));
    QVERIFY(refused("load", [](Machine &machine) { machine.results.plan.loads = {Load::Natural}; }));
    QVERIFY(refused("link", [](Machine &machine) { machine.results.plan.conditions = {*parseCondition("loss=0.1")}; }));
    QVERIFY(refused("warm-up", [](Machine &machine) { machine.results.plan.warmUp *= 2; }));
    QVERIFY(refused("commit", [](Machine &machine) { machine.results.setting[1].second = "def"; }));
    QVERIFY(refused("message mix", [](Machine &machine) { machine.results.setting.pop_back(); }));
}

void SweepReaderTest::messageMixIsThatOfTheReference()
{
    Results results = sweepOf(1.2, 7);
    for (Sample &sample : results.samples) {
        if (sample.run.arm == 0 && sample.run.load == 0)
            sample.messages = {{0, 1}, {30, 60}, {33, 38}, {11'000'000, 1}};
        if (sample.run.load == 1)
            sample.messages = {{109, 5}};
    }
    results.samples[1].messages = {{109, 1'000'000}}; // it failed
    const MessageMix mix = messageMixOf(results, 0);
    QCOMPARE(mix.size(), std::size_t(4));
    QCOMPARE(mix.at(30), 0.6);
    QCOMPARE(mix.at(33), 0.38);
    QCOMPARE(messageMixOf(results, 1).at(109), 1.0);
    QCOMPARE(messageMixText(mix), std::string("ATTITUDE 60 %, GLOBAL_POSITION_INT 38 %, HEARTBEAT 1 %, message 11000000 1 %"));
    QCOMPARE(messageMixText({{30, 0.994}, {0, 0.004}, {33, 0.002}}), std::string("ATTITUDE 99.4 %, 2 others 0.6 %"));
    const std::string page = pageOf(results);
    QVERIFY(page.find("<td>messages received, natural load</td><td class=\"text\">ATTITUDE 60 %, ") != std::string::npos);
    const QJsonObject report = QJsonDocument::fromJson(jsonOf(results)).object();
    const QJsonArray written = report[QLatin1String("message_mix")].toArray();
    QCOMPARE(written.size(), 2);
    QCOMPARE(written[0][QLatin1String("load")].toString(), QStringLiteral("natural"));
    QCOMPARE(written[0][QLatin1String("share")][QLatin1String("30")].toDouble(), 0.6);
    // Where the reference has no valid run, the first arm that has one.
    for (Sample &sample : results.samples) {
        if (sample.run.arm == 0)
            sample.invalid = "not saturated";
    }
    QVERIFY(messageMixOf(results, 0).at(30) > 0.55 && messageMixOf(results, 0).at(30) < 0.6);
    // A sweep of a version that did not count is readable, has no mix, and is written as it was.
    for (Sample &sample : results.samples)
        sample.messages.clear();
    QVERIFY(!jsonOf(results).contains("\"messages\""));
    const auto old = readSweep(jsonOf(results));
    QVERIFY(old && messageMixOf(old->results, 0).empty());
    QCOMPARE(jsonOf(old->results), jsonOf(results));
    QVERIFY(pageOf(results).find("messages received") == std::string::npos);
    // Ids and counts that no writer writes.
    QJsonObject damaged = QJsonDocument::fromJson(jsonOf(sweepOf(1.2, 7))).object();
    QJsonArray samples = damaged[QLatin1String("samples")].toArray();
    QJsonObject sample = samples[0].toObject();
    sample[QLatin1String("messages")] = QJsonObject{{QStringLiteral("-1"), 5},
                                                    {QStringLiteral("16777216"), 5},
                                                    {QStringLiteral("x"), 5},
                                                    {QStringLiteral("30"), -5},
                                                    {QStringLiteral("33"), QStringLiteral("many")},
                                                    {QStringLiteral("0"), 7}};
    samples[0] = sample;
    damaged[QLatin1String("samples")] = samples;
    const auto read = readSweep(QJsonDocument(damaged).toJson());
    QVERIFY(read);
    const std::map<std::uint32_t, std::uint64_t> kept{{0, 7}, {30, 0}, {33, 0}};
    QVERIFY(read->results.samples[0].messages == kept);
}

void SweepReaderTest::otherMessagesAreRefused()
{
    const auto said = [](std::uint64_t attitudes, std::size_t load) {
        std::vector<Machine> machines{{"desk", 4, sweepOf(1.2, 1)}, {"board", 4, sweepOf(1.2, 2)}};
        for (Machine &machine : machines) {
            for (Sample &sample : machine.results.samples)
                sample.messages = {{30, 500}, {33, 500}};
        }
        for (Sample &sample : machines.back().results.samples) {
            if (sample.run.load == load)
                sample.messages = {{30, attitudes}, {33, 1000 - attitudes}};
        }
        return mismatchOf(machines);
    };
    QCOMPARE(said(500, 0), std::string());
    QCOMPARE(said(549, 0), std::string());
    QCOMPARE(said(551, 0),
             std::string("the sweeps cannot be joined: their vehicles sent other messages: under the natural load 50 % of the "
                         "frames of desk are ATTITUDE, and 55.1 % of those of board, more than 5 percentage points apart"));
    QVERIFY(!said(449, 0).empty());
    QCOMPARE(said(900, 1), std::string()); // how much of a saturated link is load, the machine decides
    // One that was never sent, and a sweep that did not count.
    std::vector<Machine> machines{{"desk", 4, sweepOf(1.2, 1)}, {"board", 4, sweepOf(1.2, 2)}};
    for (Sample &sample : machines.back().results.samples)
        sample.messages[74] = 200;
    QVERIFY(mismatchOf(machines).find("0 % of the frames of desk are VFR_HUD") != std::string::npos);
    for (Sample &sample : machines.front().results.samples)
        sample.messages.clear();
    QCOMPARE(mismatchOf(machines), std::string());
}

SKYSEAL_TEST_APPLESS(SweepReaderTest)
#include "sweep_reader_test.moc"
