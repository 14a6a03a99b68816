// skyseal-cli mission, fence and rally: the plans of a vehicle, as files of the form "QGC WPL 110".
#include "app/cli/commands.h"
#include "app/cli/transfer/transfer_options.h"
#include "app/common/exit_status.h"
#include "app/common/format.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/vehicle/mission_file.h"

namespace skyseal::app {

namespace {

using vehicle::MissionItem;
using vehicle::MissionResult;
using vehicle::MissionType;
using Items = std::vector<MissionItem>;

/// One transfer, whose items go to a function that returns what went wrong.
class PlanTask : public VehicleTask
{
public:
    using Take = std::function<std::string(const Items &)>;

    PlanTask(const TaskSettings &settings, vehicle::Request request, Take take)
        : VehicleTask(settings), m_request(std::move(request)), m_take(std::move(take))
    {}

protected:
    void start(const vehicle::VehicleState &) override { ask(std::move(m_request)); }
    void planEnded(const MissionResult &result) override
    {
        finish(result.ok && result.items ? m_take(*result.items) : result.reason);
    }

private:
    vehicle::Request m_request;
    Take m_take;
};

/// A sentence for people or an event for machines, of a transfer that has succeeded.
void tell(bool json, const char *event, std::size_t items, const std::string &sentence)
{
    if (!json)
        return remark(sentence);
    JsonWriter out;
    out.beginObject().field("event", event).field("items", std::uint64_t(items)).endObject();
    printLine(out.text());
}

void show(const MissionItem &item, bool json)
{
    if (!json) {
        const auto p = [&item](int i) { return static_cast<double>(item.parameters[i]); };
        printLine(format("%u %s command %u frame %u %g %g %g %g %.7f %.7f %g", unsigned(item.sequence),
                         item.current ? "current" : "-", unsigned(item.command), unsigned(item.frame), p(0), p(1), p(2), p(3),
                         item.latitude, item.longitude, static_cast<double>(item.altitude)));
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

int runList(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(name, QStringLiteral("Reads the items from the vehicle and prints them."));
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(settings, vehicle::ReadMission{type}, [settings](const Items &items) {
            for (const MissionItem &item : items)
                show(item, settings.json);
            return std::string();
        });
    });
}

int runDownload(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(name, QStringLiteral("Reads the items from the vehicle and saves them in a file (QGC WPL 110)."));
    options.addArgument("FILE", "File to write; an existing one is replaced.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QString file = options.arguments(1, 1).value(0);
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(settings, vehicle::ReadMission{type}, [=](const Items &items) {
            std::string problem = writeWhole(file, vehicle::missionText(items));
            if (problem.empty())
                tell(settings.json, "downloaded", items.size(), file.toStdString() + ": " + counted(items.size(), "item"));
            return problem;
        });
    });
}

int runUpload(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(
        name,
        QStringLiteral("Replaces the items on the vehicle by those of a file (QGC WPL 110). On ArduPilot item 0 of a "
                       "mission is the home position."));
    options.addArgument("FILE", "File to read.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList files = options.arguments(1, 1);
    if (const auto status = options.finish())
        return *status;
    const auto text = readWhole(files[0]);
    if (!text) {
        complain(name, text.error());
        return kCannotOpen;
    }
    const auto items = vehicle::parseMission(*text, files[0].toStdString());
    if (!items) {
        complain(name, items.error().text());
        return kCannotOpen;
    }
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(settings, vehicle::WriteMission{*items, type}, [settings](const Items &written) {
            tell(settings.json, "uploaded", written.size(), counted(written.size(), "item") + " accepted by the vehicle");
            return std::string();
        });
    });
}

int runClear(const QString &name, const QStringList &arguments, MissionType type)
{
    Options options(name, QStringLiteral("Removes all items from the vehicle."));
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<PlanTask>(settings, vehicle::ClearMission{type}, [settings](const Items &) {
            tell(settings.json, "cleared", 0, "cleared");
            return std::string();
        });
    });
}

int runPlan(const char *plan, const QStringList &arguments, MissionType type)
{
    const QString action = arguments.value(0);
    const QString command = QStringLiteral("skyseal-cli ") + QLatin1String(plan);
    const QString name = command + QLatin1Char(' ') + action;
    const QStringList rest = arguments.mid(1);
    if (action == QLatin1String("list"))
        return runList(name, rest, type);
    if (action == QLatin1String("download") || action == QLatin1String("read"))
        return runDownload(name, rest, type);
    if (action == QLatin1String("upload") || action == QLatin1String("write"))
        return runUpload(name, rest, type);
    if (action == QLatin1String("clear"))
        return runClear(name, rest, type);
    if (action == QLatin1String("--help") || action == QLatin1String("-h")) {
        printOwnText(std::string("Usage: skyseal-cli ") + plan
                     + " list|download FILE|upload FILE|clear [options]\nEach command has --help.");
        return kDone;
    }
    complain(command, "list, download, upload or clear is expected");
    return kUsage;
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
