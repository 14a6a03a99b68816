// The rules of this project that a compiler does not check: arrows between layers go down only, Qt stays out of the protocol,
// secrets are compared in constant time, tests do not wait for fixed times.
#include "core/link/link_type.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QHash>
#include <QtCore/QRegularExpression>
#include <QtCore/QSet>
#include <QtTest/QTest>

using namespace skyseal;

namespace {

/// The folders that each folder may include, besides itself.
const QHash<QString, QStringList> &allowed()
{
    static const QStringList kProtocol{QStringLiteral("base"),    QStringLiteral("crypto"),  QStringLiteral("noise"),
                                       QStringLiteral("keys"),    QStringLiteral("channel"), QStringLiteral("mavlink"),
                                       QStringLiteral("vehicle"), QStringLiteral("log"),     QStringLiteral("metrics"),
                                       QStringLiteral("sim"),     QStringLiteral("impair")};
    static const QHash<QString, QStringList> kAllowed{
        {QStringLiteral("base"), {}},
        {QStringLiteral("crypto"), {QStringLiteral("base")}},
        {QStringLiteral("noise"), {QStringLiteral("base"), QStringLiteral("crypto")}},
        {QStringLiteral("keys"), {QStringLiteral("base"), QStringLiteral("crypto"), QStringLiteral("channel")}},
        {QStringLiteral("channel"), {QStringLiteral("base"), QStringLiteral("crypto"), QStringLiteral("noise")}},
        {QStringLiteral("mavlink"), {QStringLiteral("base")}},
        {QStringLiteral("vehicle"), {QStringLiteral("base"), QStringLiteral("mavlink")}},
        {QStringLiteral("log"), {QStringLiteral("base"), QStringLiteral("mavlink")}},
        {QStringLiteral("metrics"), {QStringLiteral("base")}},
        {QStringLiteral("sim"), {QStringLiteral("base"), QStringLiteral("mavlink")}},
        {QStringLiteral("impair"), {QStringLiteral("base")}},
        {QStringLiteral("overlay"), {QStringLiteral("base")}},
        {QStringLiteral("link"), kProtocol},
        {QStringLiteral("mqtt"), {QStringLiteral("base"), QStringLiteral("keys"), QStringLiteral("link")}},
        {QStringLiteral("engine"), kProtocol + QStringList{QStringLiteral("link"), QStringLiteral("mqtt")}},
        {QStringLiteral("experiment"), kProtocol + QStringList{QStringLiteral("link"), QStringLiteral("engine")}},
    };
    return kAllowed;
}

/// The folders that each folder of ui may include, besides itself and the base files in ui/ (view state, settings, station
/// interface, dock panel). Folders of panels do not include one another: code that two of them need belongs in text or theme.
const QHash<QString, QStringList> &allowedInUi()
{
    static const QString kTheme = QStringLiteral("theme"), kText = QStringLiteral("text"),
                         kSecurity = QStringLiteral("security"), kSweep = QStringLiteral("sweep");
    static const QStringList kBottom{kTheme, kText};
    static const QStringList kEverything = kBottom + QStringList{QStringLiteral("alerts"),    QStringLiteral("charts"),
                                                                 QStringLiteral("dialogs"),   QStringLiteral("flight"),
                                                                 QStringLiteral("inspector"), QStringLiteral("keys"),
                                                                 QStringLiteral("links"),     QStringLiteral("logs"),
                                                                 QStringLiteral("map"),       QStringLiteral("messages"),
                                                                 QStringLiteral("mission"),   QStringLiteral("parameters"),
                                                                 QStringLiteral("replay"),    kSecurity,
                                                                 QStringLiteral("status"),    kSweep,
                                                                 QStringLiteral("vehicles"),  QStringLiteral("values"),
                                                                 QStringLiteral("overlays"),  QStringLiteral("shortcuts")};
    static const QHash<QString, QStringList> kAllowed{
        {QString(), kBottom}, // the base files
        {kTheme, {}},
        {kText, {kTheme}},
        {QStringLiteral("alerts"), kBottom + QStringList{QStringLiteral("values")}}, // their limits raise alerts
        {QStringLiteral("dialogs"),
         kBottom + QStringList{QStringLiteral("alerts")}},                           // the settings say whether these can speak
        {QStringLiteral("flight"), kBottom + QStringList{QStringLiteral("values")}}, // they stand below the horizon
        {QStringLiteral("inspector"), kBottom},
        {QStringLiteral("keys"), kBottom},
        {QStringLiteral("links"), kBottom},
        {QStringLiteral("logs"), kBottom},
        {QStringLiteral("messages"), kBottom},
        {QStringLiteral("mission"), kBottom},
        {QStringLiteral("parameters"), kBottom},
        {QStringLiteral("replay"), kBottom},
        {QStringLiteral("shortcuts"), kBottom},
        {QStringLiteral("status"), kBottom},
        {QStringLiteral("vehicles"), kBottom + QStringList{QStringLiteral("alerts")}}, // the list counts them
        {QStringLiteral("values"), kBottom},
        {kSecurity, kBottom},
        {QStringLiteral("tiles"), {}},
        // The empty state asks to allow plain MAVLink.
        {QStringLiteral("map"), kBottom + QStringList{kSecurity, QStringLiteral("tiles"), QStringLiteral("overlays")}},
        {QStringLiteral("overlays"), kBottom + QStringList{QStringLiteral("tiles")}}, // the projection
        {kSweep, kBottom + QStringList{kSecurity}},                // a sweep takes over the choice of the suite
        {QStringLiteral("charts"), kBottom + QStringList{kSweep}}, // the diagnostics show the page of the sweep
        {QStringLiteral("window"), kEverything},
    };
    return kAllowed;
}

/// The room of a path like "ui/text/units.h" or "app/cli/main.cpp"; empty for a file that stands in no room.
QString roomOf(const QString &path)
{
    return path.count(QLatin1Char('/')) > 1 ? path.section(QLatin1Char('/'), 1, 1) : QString();
}

/// The folder within a room of a path like "app/cli/keys/pair_command.cpp"; empty for a file that stands in none.
QString folderOf(const QString &path)
{
    return path.count(QLatin1Char('/')) > 2 ? path.section(QLatin1Char('/'), 2, 2) : QString();
}

const QStringList kWithQt{QStringLiteral("link"), QStringLiteral("overlay"), QStringLiteral("engine"),
                          QStringLiteral("experiment")};

struct SourceFile
{
    QString path; ///< relative to the project's root
    QStringList lines;
};

QList<SourceFile> sources(const QStringList &folders)
{
    QList<SourceFile> out;
    for (const QString &folder : folders) {
        QDirIterator walk(QStringLiteral(SKYSEAL_SOURCE_DIR "/") + folder, {QStringLiteral("*.h"), QStringLiteral("*.cpp")},
                          QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            QFile file(walk.next());
            if (file.open(QIODevice::ReadOnly))
                out.append({QDir(QStringLiteral(SKYSEAL_SOURCE_DIR)).relativeFilePath(file.fileName()),
                            QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))});
        }
    }
    return out;
}

} // namespace

class LayersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void arrowsGoDown();
    void roomsOfTheUserInterface();
    void roomsOfThePrograms();
    void roomsOfTheEngine();
    void agentDoesNotKnowTheStation();
    void linkTypesAreKnownToTheLinksOnly();
    void protocolHasNoQt();
    void dialogsKeepNobodyFromTheWindow();
    void secretsAreComparedInConstantTime();
    void outputOfMocIsCompiledWithItsSource();
    void linesStayShort();
    void testsDoNotSleep();
    void testsHaveNoTightDeadlines();
};

void LayersTest::arrowsGoDown()
{
    static const QRegularExpression kInclude(QStringLiteral("^#include \"(core/([a-z]+)|ui|app|tests)/"));
    QStringList wrong;
    const auto files = sources({QStringLiteral("core"), QStringLiteral("ui")});
    QVERIFY(files.size() > 50);
    for (const SourceFile &file : files) {
        const bool isUi = file.path.startsWith(QLatin1String("ui/"));
        const QString layer = file.path.section(QLatin1Char('/'), 1, 1);
        for (const QString &line : file.lines) {
            const auto match = kInclude.match(line);
            if (!match.hasMatch())
                continue;
            const QString target = match.captured(2);
            const bool upward = target.isEmpty() && !(isUi && match.captured(1) == QLatin1String("ui"));
            const bool sideways = !target.isEmpty() && !isUi && target != layer && !allowed().value(layer).contains(target);
            if (upward || sideways)
                wrong << file.path + QStringLiteral(": ") + line;
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

void LayersTest::roomsOfTheUserInterface()
{
    static const QRegularExpression kInclude(QStringLiteral("^#include \"(ui/[a-z_/]+)"));
    QStringList wrong, unlisted;
    for (const SourceFile &file : sources({QStringLiteral("ui")})) {
        const QString room = roomOf(file.path);
        if (!allowedInUi().contains(room))
            unlisted << file.path;
        for (const QString &line : file.lines) {
            const auto match = kInclude.match(line);
            if (!match.hasMatch())
                continue;
            const QString target = roomOf(match.captured(1));
            if (!target.isEmpty() && target != room && !allowedInUi().value(room).contains(target))
                wrong << file.path + QStringLiteral(": ") + line;
        }
    }
    QVERIFY2(unlisted.isEmpty(), qPrintable(unlisted.join(QLatin1Char('\n'))));
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// Programs share only app/common, only the desktop program knows ui, and folders of one program do not know each other.
void LayersTest::roomsOfThePrograms()
{
    static const QRegularExpression kInclude(QStringLiteral("^#include \"((app|ui)/[a-z_/]+)"));
    QStringList wrong;
    const auto files = sources({QStringLiteral("app")});
    QVERIFY(files.size() > 20);
    for (const SourceFile &file : files) {
        const QString room = roomOf(file.path);
        for (const QString &line : file.lines) {
            const auto match = kInclude.match(line);
            if (!match.hasMatch())
                continue;
            const bool isUi = match.captured(2) == QLatin1String("ui");
            const QString target = roomOf(match.captured(1));
            const QString folder = folderOf(file.path), targetFolder = folderOf(match.captured(1));
            const bool allowed = isUi ? room == QLatin1String("skyseal") : target == room || target == QLatin1String("common");
            const bool areApart = !isUi && !folder.isEmpty() && !targetFolder.isEmpty() && folder != targetFolder;
            if (!allowed || areApart)
                wrong << file.path + QStringLiteral(": ") + line;
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// Station and agent stand beside each other on common; texts and command lines see both.
void LayersTest::roomsOfTheEngine()
{
    static const QRegularExpression kInclude(QStringLiteral("^#include \"core/engine/([a-z]+)/"));
    static const QString kCommon = QStringLiteral("common"), kStation = QStringLiteral("station"),
                         kAgent = QStringLiteral("agent"), kText = QStringLiteral("text");
    static const QHash<QString, QStringList> kAllowed{
        {kCommon, {}},
        {QStringLiteral("gateway"), {kCommon}},
        {kStation, {kCommon, QStringLiteral("gateway")}},
        {QStringLiteral("replay"), {kCommon, kStation}},
        {kAgent, {kCommon}},
        {kText, {kCommon, QStringLiteral("gateway"), kStation, kAgent}},
        {QStringLiteral("headless"), {kCommon, QStringLiteral("gateway"), kStation, kAgent, kText}},
    };
    QStringList wrong;
    for (const SourceFile &file : sources({QStringLiteral("core/engine")})) {
        const QString room = file.path.section(QLatin1Char('/'), 2, 2);
        QVERIFY2(kAllowed.contains(room), qPrintable(file.path));
        for (const QString &line : file.lines) {
            const QString target = kInclude.match(line).captured(1);
            if (!target.isEmpty() && target != room && !kAllowed.value(room).contains(target))
                wrong << file.path + QStringLiteral(": ") + line;
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// skyseal-air is installed on companion computers: no file that it includes, however indirectly, is of the station.
void LayersTest::agentDoesNotKnowTheStation()
{
    static const QRegularExpression kInclude(QStringLiteral("^#include \"((?:core|app)/[a-z0-9_/]+\\.h)\""));
    QHash<QString, QStringList> files;
    for (const SourceFile &file : sources({QStringLiteral("core"), QStringLiteral("app")}))
        files.insert(file.path, file.lines);
    QStringList open, wrong;
    for (auto it = files.cbegin(); it != files.cend(); ++it) {
        if (it.key().startsWith(QLatin1String("app/air/")) || it.key().startsWith(QLatin1String("core/engine/agent/")))
            open << it.key();
    }
    QVERIFY(open.size() > 10);
    QSet<QString> reached(open.cbegin(), open.cend());
    const auto reach = [&](const QString &from, const QString &path) {
        if (path.startsWith(QLatin1String("core/engine/station/")) || path.startsWith(QLatin1String("core/vehicle/")))
            wrong << from + QStringLiteral(" includes ") + path;
        if (files.contains(path) && !reached.contains(path)) {
            reached.insert(path);
            open << path;
        }
    };
    while (!open.isEmpty()) {
        const QString path = open.takeLast();
        for (const QString &line : files.value(path)) {
            const auto match = kInclude.match(line);
            if (!match.hasMatch())
                continue;
            const QString header = match.captured(1);
            reach(path, header);
            reach(path, header.chopped(2) + QStringLiteral(".cpp")); // its functions are linked
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// Properties of a link come from its LinkTraits (LinkSnapshot in ui): no comparison of schemes outside core/link, and no
/// mention of the scheme of recordings.
void LayersTest::linkTypesAreKnownToTheLinksOnly()
{
    QStringList schemes, recordings;
    for (const link::LinkType &type : link::linkTypes()) {
        schemes << QLatin1String(type.scheme);
        if (type.traits.isRecording)
            recordings << QLatin1String(type.scheme);
    }
    QVERIFY(!recordings.isEmpty());
    const QRegularExpression scheme(
        QStringLiteral("(starts_with|startsWith|findLinkType)\\(.*\"(%1)\\b|\"(%2):|\\bscheme *[!=]=")
            .arg(schemes.join(QLatin1Char('|')), recordings.join(QLatin1Char('|'))));
    QVERIFY(scheme.isValid());
    for (const SourceFile &file : sources({QStringLiteral("core"), QStringLiteral("ui"), QStringLiteral("app")})) {
        if (file.path.startsWith(QLatin1String("core/link/")))
            continue;
        for (const QString &line : file.lines)
            QVERIFY2(!scheme.match(line).hasMatch(), qPrintable(file.path + QStringLiteral(": ") + line));
    }
}

void LayersTest::protocolHasNoQt()
{
    static const QRegularExpression kQt(QStringLiteral("^#include <(Qt|Q[A-Z])"));
    for (const SourceFile &file : sources({QStringLiteral("core")})) {
        if (kWithQt.contains(file.path.section(QLatin1Char('/'), 1, 1)))
            continue;
        for (const QString &line : file.lines)
            QVERIFY2(!kQt.match(line).hasMatch(), qPrintable(file.path + QStringLiteral(": ") + line));
    }
}

/// A modal dialog, and each function of Qt that shows one, would keep the pilot from Land and RTL: ui/modeless.h shows them.
void LayersTest::dialogsKeepNobodyFromTheWindow()
{
    static const QRegularExpression kModal(QStringLiteral(
        "([Dd]ialog|[Bb]ox|question)\\w*(\\.|->)(exec|open)\\(\\)|setModal\\(true|setWindowModality|"
        "QMessageBox::(question|warning|information|critical|about)\\w*\\(|QFileDialog::get|QInputDialog|QColorDialog|"
        "QFontDialog|QProgressDialog"));
    QVERIFY(kModal.match(QStringLiteral("    dialog.exec();")).hasMatch());
    QVERIFY(kModal.match(QStringLiteral("    QMessageBox::warning(this, title, text);")).hasMatch());
    for (const SourceFile &file : sources({QStringLiteral("ui"), QStringLiteral("app")})) {
        for (const QString &line : file.lines)
            QVERIFY2(!kModal.match(line).hasMatch(), qPrintable(file.path + QStringLiteral(": ") + line));
    }
}

void LayersTest::secretsAreComparedInConstantTime()
{
    static const QRegularExpression kCompare(QStringLiteral("(^|[^_a-z])memcmp\\("));
    for (const SourceFile &file : sources({QStringLiteral("core/crypto"), QStringLiteral("core/noise"),
                                           QStringLiteral("core/channel"), QStringLiteral("core/keys")})) {
        for (const QString &line : file.lines)
            QVERIFY2(!kCompare.match(line).hasMatch(), qPrintable(file.path + QStringLiteral(": ") + line));
    }
}

/// Compiled apart, the output of moc would read the headers of a library once more.
void LayersTest::outputOfMocIsCompiledWithItsSource()
{
    static const QRegularExpression kMacro(QStringLiteral("\\s*Q_(OBJECT|GADGET|NAMESPACE)"));
    QHash<QString, QStringList> files;
    for (const SourceFile &file : sources({QStringLiteral("core"), QStringLiteral("ui"), QStringLiteral("app")}))
        files.insert(file.path, file.lines);
    qsizetype checked = 0;
    QStringList wrong;
    for (auto it = files.cbegin(); it != files.cend(); ++it) {
        const QString base = it.key().section(QLatin1Char('/'), -1).chopped(2);
        const QString source = it.key().chopped(2) + QStringLiteral(".cpp");
        if (!it.key().endsWith(QLatin1String(".h")) || !files.contains(source) || it->indexOf(kMacro) < 0)
            continue;
        ++checked;
        if (!files[source].contains(QStringLiteral("#include \"moc_%1.cpp\"").arg(base)))
            wrong << source;
    }
    QVERIFY(checked > 100);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

/// clang-format breaks code, but neither comments nor strings.
void LayersTest::linesStayShort()
{
    constexpr qsizetype kLongest = 128; // ColumnLimit in .clang-format
    QStringList wrong;
    for (const SourceFile &file :
         sources({QStringLiteral("core"), QStringLiteral("ui"), QStringLiteral("app"), QStringLiteral("tests")})) {
        for (const QString &line : file.lines) {
            if (line.size() > kLongest)
                wrong << file.path + QStringLiteral(": ") + line;
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

void LayersTest::testsDoNotSleep()
{
    static const QRegularExpression kSleep(
        QStringLiteral("qWait\\(|qSleep\\(|sleep_for\\(|nanosleep\\(|usleep\\(|QThread::m?sleep\\(|poll\\(nullptr"));
    static const QStringList kExempt{
        QStringLiteral("tests/arch/layers_test.cpp"),
        QStringLiteral("tests/metrics/usage_test.cpp"),        // the subject is the CPU time of a thread that pauses
        QStringLiteral("tests/engine/flood_latency_test.cpp"), // paces a flood
        QStringLiteral("tests/support/extra_cpu.cpp"),         // a load on the processor, with a period
    };
    for (const SourceFile &file : sources({QStringLiteral("tests")})) {
        if (kExempt.contains(file.path))
            continue;
        for (const QString &line : file.lines)
            QVERIFY2(!kSleep.match(line).hasMatch(), qPrintable(file.path + QStringLiteral(": ") + line));
    }
}

/// Tests wait for a condition (tests/support/eventually.h); a bound on the time fails on a busy machine. Limits are multiples
/// of kDeadlineMs, which only ends a test that hangs.
void LayersTest::testsHaveNoTightDeadlines()
{
    static const QRegularExpression kBound(QStringLiteral(
        "QTRY_(VERIFY|COMPARE)2?\\(|QVERIFY2?\\(.*elapsed\\(\\) *<|_WITH_TIMEOUT\\([^;]*\\b\\d[\\d']{2,}\\)\\s*;|"
        "waitFor(Started|Finished|ReadyRead|Exit)\\(\\d{3,}\\)|waitFor(Started|Finished|ReadyRead|Connected)\\(\\)|"
        "steadyNow\\(\\) *\\+"));
    static const QStringList kExempt{
        QStringLiteral("tests/arch/layers_test.cpp"),
        // Measures the latency of packets while other hosts flood the station, so it needs a real clock.
        QStringLiteral("tests/engine/flood_latency_test.cpp"),
    };
    for (const SourceFile &file : sources({QStringLiteral("tests")})) {
        if (kExempt.contains(file.path))
            continue;
        const QRegularExpressionMatch found = kBound.match(file.lines.join(QLatin1Char('\n')));
        QVERIFY2(!found.hasMatch(), qPrintable(file.path + QStringLiteral(": ") + found.captured()));
    }
}

SKYSEAL_TEST_APPLESS(LayersTest)
#include "layers_test.moc"
