// skyseal-cli param, mission, fence, rally, logs and ftp over a sealed link through a relay that delays and loses: what comes
// back is what was sent, the progress is shown, and loss costs time but no error.
#include "tests/support/test_runner.h"
#include "vehicle_command_rig.h"

#include <QtCore/QFile>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal::test;

namespace {

QByteArray planItem(int sequence, int frame, int command, double firstParameter, double altitude)
{
    const double step = sequence * 0.0001;
    return QByteArray::number(sequence) + "\t0\t" + QByteArray::number(frame) + '\t' + QByteArray::number(command) + '\t'
        + QByteArray::number(firstParameter) + "\t0\t0\t0\t" + QByteArray::number(47.3977 + step, 'f', 8) + '\t'
        + QByteArray::number(8.5455 - step, 'f', 8) + '\t' + QByteArray::number(altitude) + "\t1\n";
}

/// A mission (home first), a fence (a polygon and a circle) or rally points, as an ArduCopter keeps them.
QByteArray planFile(const QString &kind, int items)
{
    QByteArray out("QGC WPL 110\n");
    if (kind == QLatin1String("mission")) {
        out += planItem(0, 0, 16, 0, 488);
        for (int i = 1; i < items; ++i)
            out += planItem(i, 3, 16, i % 3, 15 + i);
    } else if (kind == QLatin1String("fence")) {
        for (int i = 0; i < items - 1; ++i)
            out += planItem(i, 0, 5001, items - 1, 0);
        out += planItem(items - 1, 0, 5004, 30, 0);
    } else {
        for (int i = 0; i < items; ++i)
            out += planItem(i, 3, 5100, 0, 20 + i);
    }
    return out;
}

/// The items of a file, without what the vehicle decides: which one is current, and home.
QByteArrayList plannedItems(const QByteArray &file, const QString &kind)
{
    QByteArrayList out;
    for (const QByteArray &line : file.split('\n').mid(1)) {
        QByteArrayList columns = line.split('\t');
        if (columns.size() != 12 || (kind == QLatin1String("mission") && columns[0] == "0"))
            continue;
        columns.removeAt(1);
        out << columns.join('\t');
    }
    return out;
}

QByteArray readBack(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A copy of a parameter file without the rates of the streams, which each station sets as it begins to listen.
QString withoutStreamRates(const QString &path)
{
    QByteArray out;
    for (const QByteArray &line : readBack(path).split('\n')) {
        if (!line.startsWith("SR0_") && !line.isEmpty())
            out += line + '\n';
    }
    QFile copy(path + QStringLiteral(".kept"));
    return copy.open(QIODevice::WriteOnly) && copy.write(out) == out.size() ? copy.fileName() : QString();
}

} // namespace

class RadioTransferTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void plansComeBack_data();
    void plansComeBack();
    void progressIsShown_data();
    void progressIsShown();
    void lossCostsNoError_data();
    void lossCostsNoError();

private:
    VehicleCommandRig m_far; ///< 200 ms there and back
};

void RadioTransferTest::initTestCase()
{
    QVERIFY(m_far.start(words("--delay 100")));
}

void RadioTransferTest::plansComeBack_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<int>("count");
    QTest::newRow("mission") << QStringLiteral("mission") << 20;
    QTest::newRow("fence") << QStringLiteral("fence") << 12;
    QTest::newRow("rally") << QStringLiteral("rally") << 6;
}

void RadioTransferTest::plansComeBack()
{
    QFETCH(QString, kind);
    QFETCH(int, count);
    const QByteArray plan = planFile(kind, count);
    const QString counted = QString::number(count) + QStringLiteral(" items");
    const QString sent = m_far.write("sent.plan", plan), back = m_far.path(QStringLiteral("back.plan"));

    const RunResult uploaded = m_far.run(kind + QStringLiteral(" upload"), {sent});
    QVERIFY2(uploaded.status == 0, uploaded.err.constData());
    QVERIFY2(uploaded.err.contains(counted.toUtf8() + " accepted by the vehicle\n"), uploaded.err.constData());
    const RunResult downloaded = m_far.run(kind + QStringLiteral(" download"), {back});
    QVERIFY2(downloaded.status == 0, downloaded.err.constData());
    QVERIFY2(downloaded.err.contains(back.toUtf8() + ": " + counted.toUtf8() + '\n'), downloaded.err.constData());
    QCOMPARE(plannedItems(readBack(back), kind), plannedItems(plan, kind));
    QCOMPARE(eventsIn(m_far.run(kind + QStringLiteral(" list --json")), QStringLiteral("item")).size(), std::size_t(count));

    const RunResult cleared = m_far.run(kind + QStringLiteral(" clear"));
    QVERIFY2(cleared.status == 0 && cleared.err.contains("cleared\n"), cleared.err.constData());
    const RunResult empty = m_far.run(kind + QStringLiteral(" list --json"));
    QCOMPARE(empty.status, 0);
    QVERIFY2(eventsIn(empty, QStringLiteral("item")).size() <= (kind == QLatin1String("mission") ? 1u : 0u), // home stays
             empty.out.constData());

    for (const char *action : {"upload", "download", "clear"}) {
        QStringList file;
        if (QLatin1String(action) != QLatin1String("clear"))
            file << (QLatin1String(action) == QLatin1String("upload") ? sent : back);
        const RunResult run = m_far.run(kind + QLatin1Char(' ') + QLatin1String(action) + QStringLiteral(" --json"), file);
        QVERIFY2(run.status == 0, run.err.constData());
        const auto events = eventsIn(run, QLatin1String(action) + QStringLiteral("ed"));
        QCOMPARE(events.size(), std::size_t(1));
        QCOMPARE(events[0][QLatin1String("items")].toInt(-1), file.isEmpty() ? 0 : count);
    }
}

void RadioTransferTest::progressIsShown_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("file"); // "in": the plan to send, "out": the file to write, or none
    QTest::addColumn<int>("items");    // of the plan; 0: none
    const auto row = [](const char *command, const char *file, int items = 0) {
        QTest::newRow(command) << QString::fromLatin1(command) << QString::fromLatin1(file) << items;
    };
    row("param list", "");
    row("logs get 1", "out"); // before the fence, which may keep the vehicle from arming
    row("ftp get /big", "out");
    // Each item of an upload takes a round trip. A download takes one for the first 8 items, one for the next 16 or so, and
    // one for the rest.
    constexpr int kUp = 6, kDown = 30;
    row("mission upload", "in", kUp);
    row("mission download", "out", kDown);
    row("fence upload", "in", kUp);
    row("fence download", "out", kDown);
    row("rally upload", "in", kUp);
    row("rally download", "out", kDown);
}

void RadioTransferTest::progressIsShown()
{
    QFETCH(QString, command);
    QFETCH(QString, file);
    QFETCH(int, items);
    const QString kind = command.section(QLatin1Char(' '), 0, 0);
    const QString plan = m_far.write("progress.plan", planFile(kind, items)), out = m_far.path(QStringLiteral("progress.out"));
    if (command.endsWith(QLatin1String(" download")))
        QCOMPARE(m_far.run(kind + QStringLiteral(" upload"), {plan}).status, 0);
    if (kind == QLatin1String("logs")) {
        const RunResult flown = m_far.fly(QStringLiteral("wait ekf_ok==1 60; arm; sleep 3; disarm"));
        QVERIFY2(flown.status == 0, (flown.out.right(3000) + flown.err).constData());
    }
    if (kind == QLatin1String("ftp")) {
        const RunResult put = m_far.run(QStringLiteral("ftp put"),
                                        {m_far.write("big", QByteArray(30'000, 'x')), QStringLiteral("/big")});
        QVERIFY2(put.status == 0, put.err.constData());
    }
    QStringList files;
    if (!file.isEmpty())
        files << (file == QLatin1String("in") ? plan : out);

    const RunResult people = m_far.run(command, files);
    QVERIFY2(people.status == 0, people.err.constData());
    static const QRegularExpression line(QStringLiteral("^(\\d+) of (\\d+)$"), QRegularExpression::MultilineOption);
    auto lines = line.globalMatch(QString::fromUtf8(people.err));
    QVERIFY2(lines.hasNext(), people.err.constData());
    for (int before = 0; lines.hasNext();) {
        const QRegularExpressionMatch match = lines.next();
        const int done = match.captured(1).toInt(), total = match.captured(2).toInt();
        QVERIFY2(done > before && done <= total, people.err.constData());
        QVERIFY2(items == 0 || total == items, people.err.constData());
        before = done;
    }

    const RunResult script = m_far.run(command, files + QStringList{QStringLiteral("--json")});
    QVERIFY2(script.status == 0, script.err.constData());
    const auto events = eventsIn(script, QStringLiteral("progress"));
    QVERIFY2(!events.empty(), script.out.constData());
    int before = 0;
    for (const QJsonObject &event : events) {
        const int done = event[QLatin1String("done")].toInt(), total = event[QLatin1String("total")].toInt();
        QCOMPARE(event[QLatin1String("sysid")].toInt(), 1);
        QVERIFY2(done > before && done <= total, script.out.constData());
        QVERIFY2(items == 0 || total == items, script.out.constData());
        before = done;
    }
    QVERIFY2(!line.match(QString::fromUtf8(script.err)).hasMatch(), script.err.constData());
}

void RadioTransferTest::lossCostsNoError_data()
{
    QTest::addColumn<QString>("loss");
    QTest::newRow("10 %") << QStringLiteral("0.10");
    QTest::newRow("25 %") << QStringLiteral("0.25");
}

void RadioTransferTest::lossCostsNoError()
{
    QFETCH(QString, loss);
    VehicleCommandRig radio, clean;
    QVERIFY(radio.start({QStringLiteral("--loss"), loss, QStringLiteral("--delay"), QStringLiteral("25")}));
    QVERIFY(clean.start());

    const QString parameters = radio.path(QStringLiteral("all.param"));
    const RunResult saved = radio.run(QStringLiteral("param save"), {parameters, QStringLiteral("--json")});
    QVERIFY2(saved.status == 0, saved.err.constData());
    const qsizetype count = readBack(parameters).count('\n');
    QVERIFY(count >= 100);
    QVERIFY2(eventsIn(saved, QStringLiteral("failed")).empty(), saved.out.constData());
    const auto downloaded = eventsIn(saved, QStringLiteral("downloaded"));
    QVERIFY2(downloaded.size() == 1 && saved.err.isEmpty(), (saved.out + saved.err).constData());
    QCOMPARE(downloaded[0][QLatin1String("parameters")].toInteger(), count);
    const QString kept = withoutStreamRates(parameters);
    const RunResult same = clean.run(QStringLiteral("param diff"), {kept});
    QVERIFY2(same.status == 0 && same.out.isEmpty() && same.err.contains(", no difference"), (same.out + same.err).constData());
    const RunResult set = radio.run(QStringLiteral("param set WPNAV_SPEED=625 RTL_ALT=1700 --json"));
    QVERIFY2(set.status == 0 && set.err.isEmpty(), (set.out + set.err).constData());
    QCOMPARE(eventsIn(set, QStringLiteral("parameter")).size(), std::size_t(2));
    const RunResult loaded = radio.run(QStringLiteral("param load"), {kept});
    QVERIFY2(loaded.status == 0, loaded.err.constData());
    QCOMPARE(loaded.out.count('\n'), qsizetype(2)); // these two have their old values again, and no other differed

    const QString kind = QStringLiteral("mission");
    const QByteArray plan = planFile(kind, 20);
    const QString back = radio.path(QStringLiteral("back.plan"));
    for (const QStringList &transfer : {QStringList{QStringLiteral("mission upload"), radio.write("sent.plan", plan)},
                                        QStringList{QStringLiteral("mission download"), back}}) {
        const RunResult run = radio.run(transfer[0], {transfer[1], QStringLiteral("--json")});
        QVERIFY2(run.status == 0 && run.err.isEmpty(), (run.out + run.err).constData());
    }
    QCOMPARE(plannedItems(readBack(back), kind), plannedItems(plan, kind));

    QCOMPARE(radio.relay()->terminate(), 0);
    static const QRegularExpression counters(QStringLiteral("(\\d+) in, \\d+ out, (\\d+) lost"));
    auto directions = counters.globalMatch(QString::fromUtf8(radio.relay()->errors()));
    for (int direction = 0; direction < 2; ++direction) {
        QVERIFY2(directions.hasNext(), radio.relay()->errors().constData());
        const QRegularExpressionMatch match = directions.next();
        QVERIFY2(match.captured(2).toInt() > match.captured(1).toInt() * loss.toDouble() / 2, qPrintable(match.captured()));
    }
}

SKYSEAL_TEST(RadioTransferTest)
#include "radio_transfer_test.moc"
