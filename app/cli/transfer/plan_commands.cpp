// skyseal-cli mission, fence and rally: the plans of a vehicle, as files of the form "QGC WPL 110".
#include "app/cli/commands.h"
#include "app/cli/transfer/actions.h"
#include "app/cli/transfer/request_task.h"
#include "app/cli/transfer/transfer_options.h"
#include "app/common/exit_status.h"
#include "app/common/format.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/base/number_text.h"
#include "core/vehicle/mission_file.h"

namespace skyseal::app {

namespace {

using vehicle::MissionItem;
using vehicle::MissionResult;
using vehicle::MissionType;
using PlanTask = RequestTask<MissionResult>;

void printItem(const MissionItem &item, bool json)
{
    if (!json) {
        std::string line = format("%u %s command %u frame %u", unsigned(item.sequence), item.current ? "current" : "-",
                                  unsigned(item.command), unsigned(item.frame));
        for (const float parameter : item.parameters)
            line += " " + significantText(static_cast<double>(parameter), 6);
        printLine(line + " " + fixedText(item.latitude, 7) + " " + fixedText(item.longitude, 7) + " "
                  + significantText(static_cast<double>(item.altitude), 6));
        return;
    }
    JsonWriter out;
    out.beginObject().field("event", "item").field("seq", unsigned(item.sequence)).field("command", unsigned(item.command));
    out.field("frame", unsigned(item.frame)).field("current", item.current).field("autocontinue", item.autoContinue);
    out.key("params").beginArray();
    for (const float parameter : item.parameters)
        out.value(parameter);
    out.endArray().field("lat", item.latitude).field("lon", item.longitude).field("alt", item.altitude).endObject();
    printLine(out.text());
}

int listItems(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(name, QStringLiteral("Reads the items from the vehicle and prints them."));
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(settings, vehicle::ReadMission{type}, [settings](const MissionResult &result) {
            for (const MissionItem &item : *result.items)
                printItem(item, settings.json);
            return std::string();
        });
    });
}

int downloadItems(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(name, QStringLiteral("Reads the items from the vehicle and saves them in a file (QGC WPL 110)."));
    options.addArgument("FILE", "File to write; an existing one is replaced.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QString file = options.arguments(1, 1).value(0);
    if (const auto status = checkTarget(name, options, file))
        return *status;
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(settings, vehicle::ReadMission{type}, [=](const MissionResult &result) {
            const std::size_t count = result.items->size();
            std::string problem = writeWhole(file, vehicle::missionText(*result.items));
            if (problem.empty())
                reportTransfer(settings.json, "downloaded", "items", count, file.toStdString() + ": " + counted(count, "item"));
            return problem;
        });
    });
}

/// Declares that the items may also replace those of another station.
void declareOverwrite(Options &options)
{
    options.addFlag("overwrite", "Also if another station changed the items while this command ran.");
}

int uploadItems(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(
        name,
        QStringLiteral("Replaces the items on the vehicle by those of a file (QGC WPL 110). On ArduPilot item 0 of a "
                       "mission is the home position; it is inserted before a mission that begins with another command."));
    options.addArgument("FILE", "File to read.");
    options.addValue("expect", "FILE",
                     "Only if the vehicle still has the items of this file, as downloaded before: they are read again first.");
    declareOverwrite(options);
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList files = options.arguments(1, 1);
    const QString expected = QString::fromStdString(options.text("expect"));
    const bool overwrite = options.has("overwrite");
    if (!expected.isEmpty() && overwrite)
        options.fail("--expect and --overwrite exclude each other");
    if (const auto status = options.finish())
        return *status;
    const auto plan = parseFile(name, files[0], vehicle::parseMission);
    if (!plan)
        return kCannotOpen;
    vehicle::MissionItems basis;
    if (!expected.isEmpty()) {
        auto aboard = parseFile(name, expected, vehicle::parseMission);
        if (!aboard)
            return kCannotOpen;
        basis = std::make_shared<const std::vector<MissionItem>>(std::move(aboard->items));
    }
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(
            settings, vehicle::WriteMission{plan->items, type, plan->withoutHome, overwrite, basis},
            [settings](const MissionResult &result) {
                const std::size_t count = result.items->size();
                reportTransfer(settings.json, "uploaded", "items", count, counted(count, "item") + " accepted by the vehicle");
                if (!result.remark.empty())
                    remark(result.remark.text());
                return std::string();
            });
    });
}

int clearItems(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(name, QStringLiteral("Removes all items from the vehicle."));
    declareOverwrite(options);
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    const bool overwrite = options.has("overwrite");
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(settings, vehicle::ClearMission{type, overwrite}, [settings](const MissionResult &) {
            reportTransfer(settings.json, "cleared", "items", 0, "cleared");
            return std::string();
        });
    });
}

int runPlan(const char *plan, const QStringList &arguments, MissionType type)
{
    const auto of = [type](int (*run)(const QString &, const QStringList &, MissionType)) {
        return [=](const QString &name, const QStringList &rest) { return run(name, rest, type); };
    };
    return runAction(QLatin1String(plan), arguments,
                     {{"list", of(listItems)},
                      {"download", of(downloadItems), "read"},
                      {"upload", of(uploadItems), "write"},
                      {"clear", of(clearItems)}},
                     "list|download FILE|upload FILE|clear");
}

} // namespace

int runMission(const QStringList &arguments)
{
    return runPlan("mission", arguments, MissionType::Mission);
}

int runFence(const QStringList &arguments)
{
    return runPlan("fence", arguments, MissionType::Fence);
}

int runRally(const QStringList &arguments)
{
    return runPlan("rally", arguments, MissionType::Rally);
}

} // namespace skyseal::app
