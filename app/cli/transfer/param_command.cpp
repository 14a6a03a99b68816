// skyseal-cli param: reads, writes, saves and restores the parameters of a vehicle.
#include "app/cli/commands.h"
#include "app/cli/transfer/actions.h"
#include "app/cli/transfer/transfer_options.h"
#include "app/common/exit_status.h"
#include "app/common/format.h"
#include "app/common/output.h"
#include "core/base/json_writer.h"
#include "core/vehicle/parameter_file.h"

#include <algorithm>
#include <deque>
#include <tuple>
#include <variant>

namespace skyseal::app {

namespace {

using vehicle::Parameter;
using vehicle::ParameterResult;
using Parameters = std::vector<Parameter>;

/// Begins the JSON of an event about a parameter. `vehicle`: to which it belongs.
JsonWriter beginJson(const char *event, const Parameter &parameter, const vehicle::VehicleState &vehicle)
{
    JsonWriter out;
    out.beginObject().field("event", event).field("sysid", unsigned(vehicle.systemId));
    out.field("compid", unsigned(parameter.componentId ? parameter.componentId : vehicle.componentId));
    out.field("name", parameter.name);
    return out;
}

void printParameter(const Parameter &parameter, const vehicle::VehicleState &vehicle, bool json)
{
    if (!json) {
        printLine(parameterLabel(parameter) + " " + vehicle::valueText(parameter));
        return;
    }
    JsonWriter out = beginJson("parameter", parameter, vehicle);
    out.field("value", parameter.value).field("type", unsigned(parameter.type)).endObject();
    printLine(out.text());
}

void printFailure(const Parameter &parameter, const vehicle::VehicleState &vehicle, const std::string &reason, bool json)
{
    if (!json)
        return remark(parameterLabel(parameter) + ": " + reason);
    JsonWriter out = beginJson("failed", parameter, vehicle);
    out.field("reason", reason).endObject();
    printLine(out.text());
}

/// Says what of a list that was read is missing.
void remarkMissing(const ParameterResult &list)
{
    if (list.ok && !list.reason.empty())
        remark(list.reason.text());
}

/// Reads or writes single parameters, one after the other.
class Exchange : public VehicleTask
{
public:
    using Step = std::variant<vehicle::ReadParameter, vehicle::WriteParameter>;

    Exchange(const TaskSettings &settings, std::deque<Step> steps) : VehicleTask(settings), m_steps(std::move(steps)) {}

protected:
    void start(const vehicle::VehicleState &state) override
    {
        m_vehicle = state;
        next();
    }
    void parameterEnded(const ParameterResult &result) override
    {
        if (result.ok)
            printParameter(result.parameter, m_vehicle, isJson());
        else
            fail(result.parameter, result.reason.text());
        next();
    }

    void add(Step step) { m_steps.push_back(std::move(step)); }
    void fail(const Parameter &parameter, const std::string &reason)
    {
        printFailure(parameter, m_vehicle, reason, isJson());
        ++m_failed;
    }
    void countFailure() { ++m_failed; }
    void next()
    {
        if (m_steps.empty())
            return finish(m_failed == 0 ? std::string() : counted(m_failed, "parameter") + " failed");
        const Step step = std::move(m_steps.front());
        m_steps.pop_front();
        std::visit([this](const auto &request) { ask(request); }, step);
    }

    vehicle::VehicleState m_vehicle{};

private:
    std::deque<Step> m_steps;
    std::uint64_t m_failed = 0;
};

/// Reads the whole list, and hands it to a function that returns why it could not be saved.
class ReadAll : public VehicleTask
{
public:
    using Take = std::function<std::string(const Parameters &, const vehicle::VehicleState &)>;

    ReadAll(const TaskSettings &settings, Take take) : VehicleTask(settings), m_take(std::move(take)) {}

protected:
    void start(const vehicle::VehicleState &state) override
    {
        m_vehicle = state;
        ask(vehicle::ReadParameters{});
    }
    void parameterEnded(const ParameterResult &result) override
    {
        result.ok &&result.all ? finishSaved(m_take(*result.all, m_vehicle)) : finish(result.reason.text());
    }

private:
    Take m_take;
    vehicle::VehicleState m_vehicle;
};

/// The parameter of this component and name in a list that is sorted by both; null if there is none.
const Parameter *findIn(const Parameters &sorted, const Parameter &wanted)
{
    const auto place = [](const Parameter &parameter) { return std::tie(parameter.componentId, parameter.name); };
    const auto found = std::ranges::lower_bound(sorted, place(wanted), {}, place);
    return found != sorted.end() && place(*found) == place(wanted) ? &*found : nullptr;
}

/// Compares a file with the vehicle; writes the differences if requested. Lines that could not be read count as failures.
class Restore : public Exchange
{
public:
    Restore(const TaskSettings &settings, vehicle::ParameterFile file, bool writes)
        : Exchange(settings, {}), m_file(std::move(file.parameters)), m_writes(writes)
    {
        for (std::size_t i = 0; i < file.unread.size(); ++i)
            countFailure();
    }

protected:
    void start(const vehicle::VehicleState &state) override
    {
        m_vehicle = state;
        ask(vehicle::ReadParameters{});
    }
    void parameterEnded(const ParameterResult &result) override
    {
        if (result.action != vehicle::ParameterAction::ReadList)
            return Exchange::parameterEnded(result);
        remarkMissing(result);
        if (!result.ok || !result.all)
            return finish(result.reason.text());
        for (Parameter wanted : m_file) {
            if (wanted.componentId == m_vehicle.componentId)
                wanted.componentId = 0; // the autopilot's, as in the list
            compare(wanted, findIn(*result.all, wanted));
        }
        if (!isJson() && m_differ == 0)
            remark(counted(m_compared, "parameter") + ", no difference");
        next();
    }

private:
    void compare(const Parameter &wanted, const Parameter *present)
    {
        if (!present)
            return fail(wanted, "the vehicle has no such parameter");
        ++m_compared;
        if (hasValue(*present, wanted.value))
            return;
        ++m_differ;
        if (m_writes)
            return add(vehicle::WriteParameter{wanted.name, wanted.value, wanted.componentId});
        if (!isJson()) {
            printLine(parameterLabel(wanted) + " " + vehicle::valueText(*present) + " (file: " + vehicle::valueText(wanted)
                      + ")");
            return;
        }
        JsonWriter out = beginJson("difference", wanted, m_vehicle);
        out.field("value", present->value).field("file", wanted.value).endObject();
        printLine(out.text());
    }

    const Parameters m_file;
    const bool m_writes;
    std::uint64_t m_compared = 0, m_differ = 0;
};

int listParameters(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Reads all parameters and prints them, one NAME VALUE per line."));
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    options.arguments(0, 0);
    return runTransfer(name, options, [](const TaskSettings &settings) {
        return std::make_shared<ReadAll>(settings, [settings](const Parameters &all, const vehicle::VehicleState &vehicle) {
            for (const Parameter &parameter : all)
                printParameter(parameter, vehicle, settings.json);
            return std::string();
        });
    });
}

int saveParameters(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Reads all parameters and saves them in a file."));
    options.addArgument("FILE", "File to write; an existing one is replaced.");
    options.addValue("format", "plain|qgc", "plain: NAME,VALUE lines; qgc: the five columns of QGroundControl.", "plain");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QString file = options.arguments(1, 1).value(0);
    const std::string form = options.text("format");
    if (form != "plain" && form != "qgc")
        options.fail("--format '" + form + "': plain or qgc is expected");
    if (const auto status = checkTarget(name, options, file))
        return *status;
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<ReadAll>(settings, [=](const Parameters &all, const vehicle::VehicleState &vehicle) {
            const std::string text = form == "qgc" ? vehicle::qgcParameterText(all, vehicle.systemId, vehicle.componentId)
                                                   : vehicle::parameterText(all);
            std::string problem = writeWhole(file, text);
            if (!problem.empty())
                return problem;
            const auto isOfOther = [](const Parameter &parameter) { return parameter.componentId != 0; };
            const auto others = static_cast<std::size_t>(std::ranges::count_if(all, isOfOther));
            const std::size_t leftOut = form == "qgc" ? 0 : others;
            reportTransfer(settings.json, "downloaded", "parameters", all.size() - leftOut,
                           file.toStdString() + ": " + counted(all.size() - leftOut, "parameter"));
            if (leftOut > 0)
                remark(counted(leftOut, "parameter")
                       + " of other components left out: NAME,VALUE lines cannot name them, --format qgc can");
            return problem;
        });
    });
}

int getParameters(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Reads single parameters."));
    options.addArgument("NAME...", "Names of parameters; COMPONENT:NAME of one that is not the autopilot's.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    std::deque<Exchange::Step> steps;
    for (const QString &one : options.arguments(1, 1000)) {
        auto [component, parameter] = vehicle::parameterName(one.toStdString());
        steps.push_back(vehicle::ReadParameter{std::move(parameter), component});
    }
    return runTransfer(name, options,
                       [&](const TaskSettings &settings) { return std::make_shared<Exchange>(settings, steps); });
}

int setParameters(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Writes parameters, and reads back the values of the vehicle."));
    options.addArgument("NAME=VALUE...", "Parameters and their values; COMPONENT:NAME of one that is not the autopilot's.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    std::deque<Exchange::Step> steps;
    for (const QString &one : options.arguments(1, 1000)) {
        bool isNumber = false;
        const double value = one.section(QLatin1Char('='), 1).toDouble(&isNumber);
        auto [component, parameter] = vehicle::parameterName(one.section(QLatin1Char('='), 0, 0).toStdString());
        if (!isNumber || parameter.empty() || parameter.size() > 16)
            options.fail("'" + one.toStdString() + "': NAME=VALUE is expected");
        steps.push_back(vehicle::WriteParameter{std::move(parameter), value, component});
    }
    return runTransfer(name, options,
                       [&](const TaskSettings &settings) { return std::make_shared<Exchange>(settings, steps); });
}

int compareParameters(const QString &name, const QStringList &arguments, bool writes)
{
    Options options(name,
                    writes ? QStringLiteral("Writes the parameters of a file that differ from those of the vehicle.")
                           : QStringLiteral("Shows the parameters that differ between a file and the vehicle."));
    options.addArgument("FILE", "A parameter file of Mission Planner, MAVProxy or QGroundControl.");
    options.addFlag("strict", "Refuse a file with a line that cannot be read, or with two values of a parameter.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    const QStringList files = options.arguments(1, 1);
    const bool isStrict = options.has("strict");
    if (const auto status = options.finish())
        return *status;
    auto file = parseFile(name, files[0], vehicle::parseParameters);
    if (!file)
        return kCannotOpen;
    for (const auto &lines : {file->unread, file->repeats}) {
        for (const InputError &line : lines)
            complain(name, line.text());
    }
    if (isStrict && !(file->unread.empty() && file->repeats.empty()))
        return kCannotOpen;
    return runTransfer(name, options, [&](const TaskSettings &settings) {
        return std::make_shared<Restore>(settings, std::move(*file), writes);
    });
}

} // namespace

int runParam(const QStringList &arguments)
{
    const auto fromFile = [](bool writes) {
        return [writes](const QString &name, const QStringList &rest) { return compareParameters(name, rest, writes); };
    };
    return runAction(QStringLiteral("param"), arguments,
                     {{"list", listParameters, "fetch"},
                      {"get", getParameters},
                      {"set", setParameters},
                      {"save", saveParameters},
                      {"load", fromFile(true)},
                      {"diff", fromFile(false)}},
                     "list|get NAME...|set NAME=VALUE...|save FILE|load FILE|diff FILE");
}

} // namespace skyseal::app
