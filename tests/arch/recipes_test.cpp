// Follows six recipes of core/README.md, with the examples in tests/arch/recipes: the files that a recipe adds and edits go to
// a folder that the compiler searches before the source tree, and every file that they concern must compile. The number of
// edited files is the cost of adding one more, and the recipe must name each of them.
#include "tests/arch/content_of.h"
#include "tests/support/test_runner.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>

namespace {

QString q(const char *text)
{
    return QString::fromLatin1(text);
}

const QString kTree = q(SKYSEAL_SOURCE_DIR "/");

/// The compiler's command for a file of the tree, or for another file of its library where several are compiled as one.
QStringList commandFor(const QString &file)
{
    static const QJsonArray kCommands =
        QJsonDocument::fromJson(contentOf(q(SKYSEAL_BUILD_DIR "/compile_commands.json")).toUtf8()).array();
    const auto first = [](auto &&matches) {
        const auto found = std::ranges::find_if(kCommands, matches);
        return found == kCommands.end() ? QStringList() : QProcess::splitCommand((*found)[q("command")].toString());
    };
    QStringList out = first([&](const QJsonValue &entry) { return entry[q("file")].toString() == kTree + file; });
    for (QString folder = QFileInfo(file).path(); out.isEmpty() && folder != q("."); folder = QFileInfo(folder).path())
        out = first([&](const QJsonValue &entry) {
            return entry[q("command")].toString().contains(q(" -o ") + folder + q("/CMakeFiles/skyseal_"));
        });
    return out;
}

/// The tree with the changes of a recipe.
class ChangedTree
{
public:
    /// Adds the example with this file's name.
    void add(const QString &file)
    {
        write(file, contentOf(kTree + q("tests/arch/recipes/") + QFileInfo(file).fileName()));
        m_added << file;
    }

    /// Inserts `line` behind `anchor`, which the file contains once.
    void insert(const QString &file, const char *anchor, const char *line)
    {
        QString text = contentOf(m_edited.contains(file) ? m_folder.filePath(file) : kTree + file);
        QVERIFY2(text.count(q(anchor)) == 1, qPrintable(file + q(": ") + q(anchor)));
        write(file, text.replace(q(anchor), q(anchor) + q(line)));
        if (!m_edited.contains(file))
            m_edited << file;
    }

    /// Compiles `file` with the options of `like`, a file of the tree; returns the errors.
    QString errorsIn(const QString &file, const QString &like) const
    {
        const QStringList command = commandFor(like);
        if (command.isEmpty())
            return q("no command to compile ") + like;
        QStringList arguments;
        for (qsizetype i = 1; i < command.size(); ++i) {
            const QString &argument = command[i];
            if (argument == q("-o") || argument == q("-c") || argument == q("-include") || argument == q("-Xclang"))
                ++i; // neither an output nor precompiled headers, which contain the unchanged tree
            else if (argument.startsWith(q("-D"))) // splitCommand() leaves the backslashes before the quotes of a text
                arguments << QString(argument).replace(QLatin1Char('\\'), QLatin1Char('"'));
            else if (argument != q("-Winvalid-pch") && argument != q("-fpch-preprocess"))
                arguments << argument;
        }
        const bool changed = m_added.contains(file) || m_edited.contains(file);
        arguments = QStringList{q("-I"), m_folder.path()} + arguments
            + QStringList{q("-fsyntax-only"), changed ? m_folder.filePath(file) : kTree + file};
        QProcess compiler;
        compiler.setProcessChannelMode(QProcess::MergedChannels);
        compiler.start(command.front(), arguments);
        compiler.waitForFinished(-1);
        return compiler.exitCode() == 0 ? QString() : QString::fromUtf8(compiler.readAll());
    }
    QString errorsIn(const QString &file) const { return errorsIn(file, file); }

    const QStringList &added() const { return m_added; }
    const QStringList &edited() const { return m_edited; }

private:
    void write(const QString &file, const QString &text)
    {
        QVERIFY(!text.isEmpty());
        const QString path = m_folder.filePath(file);
        QVERIFY(QDir().mkpath(QFileInfo(path).path()));
        QFile out(path);
        QVERIFY(out.open(QIODevice::WriteOnly) && out.write(text.toUtf8()) > 0);
    }

    QTemporaryDir m_folder;
    QStringList m_added, m_edited;
};

/// The section "### Add …" of the map.
QString recipe(const char *title)
{
    const QString map = contentOf(kTree + q("core/README.md"));
    const qsizetype begin = map.indexOf(q("### Add ") + q(title));
    return begin < 0 ? QString() : map.mid(begin, map.indexOf(q("\n### "), begin + 1) - begin);
}

void addPing(ChangedTree &tree)
{
    for (const char *file : {"core/vehicle/ping.h", "core/vehicle/ping_client.h", "core/vehicle/ping_client.cpp"})
        tree.add(q(file));
    tree.insert(q("core/vehicle/request.h"), "#include \"core/vehicle/parameter.h\"\n", "#include \"core/vehicle/ping.h\"\n");
    tree.insert(q("core/vehicle/request.h"), "std::variant<VehicleCommand, ", "Ping, ");
    tree.insert(q("core/vehicle/event.h"), "#include \"core/vehicle/parameter.h\"\n", "#include \"core/vehicle/ping.h\"\n");
    tree.insert(q("core/vehicle/event.h"), "using Event = std::variant<CommandResult, ", "PingResult, ");
    tree.insert(
        q("core/vehicle/request_failure.cpp"), "    Reason reason;\n",
        "    Event operator()(const Ping &) const { return PingResult{.id = id, .systemId = systemId, .reason = reason}; }\n");
    tree.insert(q("core/vehicle/vehicle_parts.h"), "#include \"core/vehicle/parameter_client.h\"\n",
                "#include \"core/vehicle/ping_client.h\"\n");
    tree.insert(q("core/vehicle/vehicle_parts.h"), "    MissionClient mission{context};\n", "    PingClient ping{context};\n");
    tree.insert(q("core/vehicle/CMakeLists.txt"), " parameter_store.cpp request.cpp", " ping_client.cpp");
    tree.insert(q("core/engine/headless/event_json.cpp"), "[](const vehicle::ParameterResult &) { return std::string(); },",
                " [](const vehicle::PingResult &) { return std::string(); },");
}

void addTextOfPing(ChangedTree &tree)
{
    tree.insert(
        q("core/engine/text/event_text.cpp"), "    explicit Describe(const PeerNames &names) : m_names(names) {}\n",
        "    EventText operator()(const vehicle::PingResult &e) const { return {reasonText(e.reason), kInfo, e.systemId}; }\n");
}

void checkThatRecipeNames(const QString &text, const QStringList &files)
{
    QVERIFY(!text.isEmpty());
    for (const QString &file : files)
        QVERIFY2(text.contains(QFileInfo(file).fileName()), qPrintable(file));
}

} // namespace

class RecipesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void microProtocolTakesSevenEdits();
    void eventWithoutATextDoesNotCompile();
    void cipherSuiteTakesOneEdit();
    void linkTypeTakesTwoEdits();
    void dockPanelTakesThreeEdits();
    void chartedQuantityTakesOneEdit();
    void commandTakesThreeEdits();
};

void RecipesTest::microProtocolTakesSevenEdits()
{
    ChangedTree tree;
    addPing(tree);
    addTextOfPing(tree);
    QCOMPARE(tree.edited().size(), 7);
    QCOMPARE(tree.added().size(), 3);
    checkThatRecipeNames(recipe("a MAVLink micro-protocol client"), tree.edited());
    const QString client = q("core/vehicle/mission_client.cpp"); // a neighbour with the same options
    QCOMPARE(tree.errorsIn(q("core/vehicle/ping_client.cpp"), client), QString());
    // The edited files, and some that pass requests and events on unchanged.
    for (const char *file :
         {"core/vehicle/request_failure.cpp", "core/vehicle/vehicle_parts.cpp", "core/vehicle/vehicle.cpp",
          "core/engine/station/fleet.cpp", "core/engine/text/event_text.cpp", "core/engine/headless/event_json.cpp"})
        QCOMPARE(tree.errorsIn(q(file)), QString());
}

void RecipesTest::eventWithoutATextDoesNotCompile()
{
    ChangedTree tree;
    addPing(tree);
    QVERIFY(tree.errorsIn(q("core/engine/text/event_text.cpp")).contains(q("PingResult")));
}

void RecipesTest::cipherSuiteTakesOneEdit()
{
    ChangedTree tree;
    tree.add(q("core/crypto/suites/dummy.cpp"));
    tree.insert(q("core/crypto/suite.cpp"), "SuiteInfo rc4Suite();\n", "SuiteInfo dummySuite();\n");
    tree.insert(q("core/crypto/suite.cpp"), "            chaCha20Suite(),\n", "            dummySuite(),\n");
    QCOMPARE(tree.edited().size(), 1);
    checkThatRecipeNames(recipe("a cipher suite"), tree.edited());
    QCOMPARE(tree.errorsIn(q("core/crypto/suites/dummy.cpp"), q("core/crypto/suites/rc4.cpp")), QString());
    QCOMPARE(tree.errorsIn(q("core/crypto/suite.cpp")), QString());
}

void RecipesTest::linkTypeTakesTwoEdits()
{
    ChangedTree tree;
    tree.add(q("core/link/dummy_link.h"));
    tree.add(q("core/link/dummy_link.cpp"));
    tree.insert(q("core/link/link_type.cpp"), "#include \"core/link/tlog_link.h\"\n", "#include \"core/link/dummy_link.h\"\n");
    tree.insert(
        q("core/link/link_type.cpp"), "constexpr LinkType kTypes[] = {\n",
        "    {\"dummy\", LinkTarget::HostPort, {.hasOneRemote = true}, \"Dummy\", \"An example.\", make<DummyLink>},\n");
    tree.insert(q("core/link/CMakeLists.txt"), "tlog_link.cpp", " dummy_link.cpp");
    QCOMPARE(tree.edited().size(), 2);
    checkThatRecipeNames(recipe("a link type"), tree.edited());
    QCOMPARE(tree.errorsIn(q("core/link/dummy_link.cpp"), q("core/link/tlog_link.cpp")), QString());
    QCOMPARE(tree.errorsIn(q("core/link/link_type.cpp")), QString());
}

void RecipesTest::dockPanelTakesThreeEdits()
{
    ChangedTree tree;
    tree.add(q("ui/dummy/dummy_panel.h"));
    tree.add(q("ui/dummy/dummy_panel.cpp"));
    tree.insert(q("ui/window/panel_table.cpp"), "#include \"ui/charts/diagnostics_panel.h\"\n",
                "#include \"ui/dummy/dummy_panel.h\"\n");
    tree.insert(q("ui/window/panel_table.cpp"), "constexpr PanelRow kPanels[] = {\n",
                "    {\"dockDummy\", \"Dummy\", {kHidden, kHidden, kHidden, kRight}, make<DummyPanel>},\n");
    tree.insert(q("ui/CMakeLists.txt"), "dialogs/settings_dialog.cpp", " dummy/dummy_panel.cpp");
    tree.insert(q("tests/arch/layers_test.cpp"), "        {QStringLiteral(\"logs\"), kBottom},\n",
                "        {QStringLiteral(\"dummy\"), kBottom},\n");
    QCOMPARE(tree.edited().size(), 3);
    checkThatRecipeNames(recipe("a dock panel"), tree.edited());
    QCOMPARE(tree.errorsIn(q("ui/dummy/dummy_panel.cpp"), q("ui/messages/messages_panel.cpp")), QString());
    QCOMPARE(tree.errorsIn(q("ui/window/panel_table.cpp")), QString());
}

/// Of a value that each sample has already.
void RecipesTest::chartedQuantityTakesOneEdit()
{
    ChangedTree tree;
    tree.insert(q("ui/charts/quantities.cpp"), "std::vector<Quantity> rates()\n{\n    return {\n",
                "        {.key = \"dummy\", .title = QuantitiesText::tr(\"Dummy\"), .unit = QuantitiesText::tr(\"frames/s\"),\n"
                "         .note = QuantitiesText::tr(\"An example.\"), .group = QuantityGroupId::Rates,\n"
                "         .lines = {{{}, Stroke::Solid, {\"dummy_per_s\", read<&MetricsSample::openedFramesPerSecond>}}}},\n");
    QCOMPARE(tree.edited().size(), 1);
    checkThatRecipeNames(recipe("a charted quantity"), tree.edited());
    QCOMPARE(tree.errorsIn(q("ui/charts/quantities.cpp")), QString());
}

void RecipesTest::commandTakesThreeEdits()
{
    ChangedTree tree;
    tree.add(q("app/cli/dummy_command.cpp"));
    tree.insert(q("app/cli/commands.h"), "int runSelfTest(const QStringList &arguments);\n",
                "int runDummy(const QStringList &arguments);\n");
    tree.insert(q("app/cli/main.cpp"), "constexpr Command kCommands[] = {\n",
                "    {\"dummy\", \"is an example\", runDummy},\n");
    tree.insert(q("app/cli/CMakeLists.txt"), "decode_command.cpp", " dummy_command.cpp");
    QCOMPARE(tree.edited().size(), 3);
    checkThatRecipeNames(recipe("a command of the command line"), tree.edited());
    QCOMPARE(tree.errorsIn(q("app/cli/dummy_command.cpp"), q("app/cli/decode_command.cpp")), QString());
    QCOMPARE(tree.errorsIn(q("app/cli/main.cpp")), QString());
}

SKYSEAL_TEST_APPLESS(RecipesTest)
#include "recipes_test.moc"
