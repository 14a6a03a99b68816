#include "app/cli/transfer/transfer_options.h"

#include "app/cli/json_report.h"
#include "app/cli/people_report.h"
#include "app/cli/station_options.h"
#include "app/cli/station_run.h"
#include "app/common/exit_status.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/base/save_file.h"

#include <QtCore/QFile>

namespace skyseal::app {

namespace {

/// Events of links and sessions. The results are the task's own.
class TransferReport final : public engine::RunListener
{
public:
    explicit TransferReport(bool json) : m_json(json) {}

    void eventOccurred(const engine::Event &event) override
    {
        if (m_json)
            return m_jsonReport.eventOccurred(event);
        m_peers.note(event);
        const bool isResult = std::holds_alternative<vehicle::ParameterResult>(event)
            || std::holds_alternative<vehicle::MissionResult>(event) || std::holds_alternative<vehicle::FileResult>(event)
            || std::holds_alternative<vehicle::LogResult>(event);
        if (const std::string line = isResult ? std::string() : eventLine(event, m_peers); !line.empty())
            remark(line);
    }
    void stepEnded(const vehicle::StepReport &) override {}
    void secondPassed(const engine::Snapshot &, double) override {}
    void ended(const engine::Snapshot &, double) override {}

private:
    const bool m_json;
    JsonReport m_jsonReport;
    engine::PeerNames m_peers;
};

} // namespace

void declareTransfer(Options &options)
{
    options.addLink("link", "Link to the vehicle or its agent, e.g. udpin:0.0.0.0:14550. May be given several times.", isLive);
    options.addResearchValue("secure", "required|off",
                             "required: accept only a sealed vehicle (default with --identity); off: use no sealed links.");
    declareKeys(options);
    options.addValue("sysid", "ID", "System ID of the vehicle; required if there are several.");
    options.addValue("find-within", "S", "Give up if the vehicle is not heard within this many seconds.", "30");
    options.addFlag(
        "heartbeat",
        "Send the heartbeat of a ground station, for vehicles that wait for one before they send. It arms the failsafe "
        "for a lost ground station, which acts when the heartbeat ends.");
    options.addFlag("json", "One JSON object per line on stdout.");
}

int runTransfer(const QString &program, Options &options,
                const std::function<std::shared_ptr<VehicleTask>(const TaskSettings &)> &makeTask)
{
    options.required("link");
    TaskSettings settings;
    settings.json = options.has("json");
    if (options.has("sysid"))
        settings.systemId = static_cast<std::uint8_t>(options.wholeNumber("sysid", 1, 255));
    settings.findWithin = options.seconds("find-within", 0.1, 86400);
    StationRun run{.program = program, .links = options.urls("link"), .json = settings.json};
    const std::string secure = options.has("secure") ? options.text("secure")
        : options.has("identity") || !kResearch      ? "required"
                                                     : "off";
    if (secure != "required" && secure != "off")
        options.fail("--secure '" + secure + "': required or off is expected");
    run.config.secure = secure == "required" ? engine::SecureMode::Required : engine::SecureMode::Off;
    run.config.record = false;
    run.config.lowBandwidth = true; // the link is for the transfer
    run.config.ownHeartbeat = options.has("heartbeat");
    run.config.snapshotsPerSecond = 10;
    readKeys(options, run.config);
    if (const auto status = options.finish())
        return *status;
    run.plan.sessionRequired = run.config.secure == engine::SecureMode::Required;
    run.plan.task = makeTask(settings);
    run.report = std::make_unique<TransferReport>(settings.json);
    return runStation(std::move(run));
}

Result<std::string, std::string> readWhole(const QString &file, qint64 most)
{
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly))
        return tl::unexpected(file.toStdString() + ": " + in.errorString().toStdString());
    const QByteArray content = in.read(most + 1);
    if (in.error() != QFileDevice::NoError)
        return tl::unexpected(file.toStdString() + ": " + in.errorString().toStdString());
    if (content.size() > most)
        return tl::unexpected(file.toStdString() + ": is larger than " + std::to_string(most) + " bytes");
    return content.toStdString();
}

std::string writeWhole(const QString &file, std::string_view content)
{
    const auto saved = saveFile(file.toStdString(), asBytes(content));
    return saved ? std::string() : saved.error().text();
}

std::optional<int> checkTarget(const QString &program, const Options &options, const QString &file)
{
    if (const auto status = options.finish())
        return status;
    const auto out = NewFile::saving(file.toStdString());
    if (out)
        return std::nullopt;
    complain(program, out.error().text());
    return kCannotOpen;
}

void reportTransfer(bool json, const char *event, const char *kind, std::size_t count, const std::string &sentence)
{
    if (!json)
        return remark(sentence);
    JsonWriter out;
    out.beginObject().field("event", event).field(kind, std::uint64_t(count)).endObject();
    printLine(out.text());
}

} // namespace skyseal::app
