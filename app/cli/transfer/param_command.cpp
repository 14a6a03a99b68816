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
#include <cmath>
#include <deque>

namespace skyseal::app {

namespace {

using vehicle::Parameter;
using vehicle::ParameterResult;
using Parameters = std::vector<Parameter>;

void printParameter(const Parameter &parameter, std::uint8_t systemId, bool json)
{
    if (!json) {
        printLine(parameter.name + " " + vehicle::valueText(parameter));
        return;
    }
    JsonWriter out;
    out.beginObject().field("event", "parameter").field("sysid", unsigned(systemId)).field("name", parameter.name);
    out.field("value", parameter.value).field("type", unsigned(parameter.type)).endObject();
    printLine(out.text());
}

void printFailure(const std::string &name, std::uint8_t systemId, const std::string &reason, bool json)
{
    if (!json)
        return remark(name + ": " + reason);
    JsonWriter out;
    out.beginObject().field("event", "failed").field("sysid", unsigned(systemId)).field("name", name);
    out.field("reason", reason).endObject();
    printLine(out.text());
}

/// Reads or writes single parameters, one after the other.
class Exchange : public VehicleTask
{
public:
    struct Step
    {
        std::string name;
        std::optional<double> value{}; ///< to write
    };

    Exchange(const TaskSettings &settings, std::deque<Step> steps) : VehicleTask(settings), m_steps(std::move(steps)) {}

protected:
    void start(const vehicle::VehicleState &) override { next(); }
    void parameterEnded(const ParameterResult &result) override
    {
        if (result.ok) {
            printParameter(result.parameter, systemId(), isJson());
        } else {
            printFailure(result.parameter.name, systemId(), result.reason.text(), isJson());
            ++m_failed;
        }
        next();
    }

    void add(Step step) { m_steps.push_back(std::move(step)); }
    void countFailure() { ++m_failed; }
    void next()
    {
        if (m_steps.empty())
            return finish(m_failed == 0 ? std::string() : counted(m_failed, "parameter") + " failed");
        const Step step = std::move(m_steps.front());
        m_steps.pop_front();
        if (step.value)
            ask(vehicle::WriteParameter{step.name, *step.value});
        else
            ask(vehicle::ReadParameter{step.name});
    }

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

bool differs(const Parameter &wanted, const Parameter &present)
{
    if (std::isnan(wanted.value) && std::isnan(present.value))
        return false;
    return wanted.value != present.value && static_cast<float>(wanted.value) != static_cast<float>(present.value);
}

/// The parameter of this name in a list that is sorted by name; null if there is none.
const Parameter *findIn(const Parameters &sorted, const std::string &name)
{
    const auto found = std::ranges::lower_bound(sorted, name, {}, &Parameter::name);
    return found != sorted.end() && found->name == name ? &*found : nullptr;
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
        m_autopilot = state.componentId;
        ask(vehicle::ReadParameters{});
    }
    void parameterEnded(const ParameterResult &result) override
    {
        if (result.action != vehicle::ParameterAction::ReadList)
            return Exchange::parameterEnded(result);
        if (!result.ok || !result.all)
            return finish(result.reason.text());
        std::size_t compared = 0;
        for (const Parameter &wanted : m_file) {
            if (wanted.componentId == 0 || wanted.componentId == m_autopilot) {
                compare(wanted, findIn(*result.all, wanted.name));
                ++compared;
                continue;
            }
            printFailure(
                wanted.name, systemId(),
                format("of component %u: only the autopilot's parameters are read and written", unsigned(wanted.componentId)),
                isJson());
            countFailure();
        }
        if (!isJson() && m_differ == 0)
            remark(counted(compared, "parameter") + ", no difference");
        next();
    }

private:
    void compare(const Parameter &wanted, const Parameter *present)
    {
        if (!present) {
            printFailure(wanted.name, systemId(), "the vehicle has no such parameter", isJson());
            return countFailure();
        }
        if (!differs(wanted, *present))
            return;
        ++m_differ;
        if (m_writes)
            return add({wanted.name, wanted.value});
        if (!isJson()) {
            printLine(wanted.name + " " + vehicle::valueText(*present) + " (file: " + vehicle::valueText(wanted) + ")");
            return;
        }
        JsonWriter out;
        out.beginObject().field("event", "difference").field("sysid", unsigned(systemId())).field("name", wanted.name);
        out.field("value", present->value).field("file", wanted.value).endObject();
        printLine(out.text());
    }

    const Parameters m_file;
    const bool m_writes;
    std::uint8_t m_autopilot = 0; ///< component
    std::uint64_t m_differ = 0;
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
                printParameter(parameter, vehicle.systemId, settings.json);
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
            if (problem.empty())
                reportTransfer(settings.json, "downloaded", "parameters", all.size(),
                               file.toStdString() + ": " + counted(all.size(), "parameter"));
            return problem;
        });
    });
}

int getParameters(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Reads single parameters."));
    options.addArgument("NAME...", "Names of parameters.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    std::deque<Exchange::Step> steps;
    for (const QString &one : options.arguments(1, 1000))
        steps.push_back({one.toStdString()});
    return runTransfer(name, options,
                       [&](const TaskSettings &settings) { return std::make_shared<Exchange>(settings, steps); });
}

int setParameters(const QString &name, const QStringList &arguments)
{
    Options options(name, QStringLiteral("Writes parameters, and reads back the values of the vehicle."));
    options.addArgument("NAME=VALUE...", "Parameters and their values.");
    declareTransfer(options);
    if (const auto status = options.parse(arguments))
        return *status;
    std::deque<Exchange::Step> steps;
    for (const QString &one : options.arguments(1, 1000)) {
        bool isNumber = false;
        const double value = one.section(QLatin1Char('='), 1).toDouble(&isNumber);
        const std::string parameter = one.section(QLatin1Char('='), 0, 0).toStdString();
        if (!isNumber || parameter.empty() || parameter.size() > 16)
            options.fail("'" + one.toStdString() + "': NAME=VALUE is expected");
        steps.push_back({parameter, value});
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
