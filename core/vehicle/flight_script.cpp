#include "core/vehicle/flight_script.h"

#include "core/vehicle/script_tokens.h"
#include "core/base/ascii.h"

#include <array>
#include <charconv>
#include <cmath>

namespace skyseal::vehicle {

namespace {

using Action = decltype(FlightStep::action);
using StepResult = Result<Action, InputError>;

tl::unexpected<InputError> fail(const ScriptTokens &words, std::string expected)
{
    return tl::make_unexpected(words.error(std::move(expected)));
}

/// A step without arguments.
template<typename T> StepResult parsePlain(ScriptTokens &)
{
    return Action(VehicleCommand(T{}));
}

template<typename T> StepResult parseArming(ScriptTokens &words)
{
    T out;
    if (!words.atEnd()) {
        if (!equalIgnoringCase(words.peek(), "force"))
            return fail(words, "'force' or the end of the step");
        words.take();
        out.force = true;
    }
    return Action(VehicleCommand(out));
}

StepResult parseMode(ScriptTokens &words)
{
    if (words.atEnd())
        return fail(words, "a mode's name");
    return Action(VehicleCommand(SetMode{std::string(words.take())}));
}

StepResult parseTakeOff(ScriptTokens &words)
{
    const auto altitude = words.number("an altitude in metres above home, over 0 and up to 10000", 0.01, 10000);
    if (!altitude)
        return tl::make_unexpected(altitude.error());
    return Action(VehicleCommand(TakeOff{*altitude}));
}

StepResult parseGoTo(ScriptTokens &words)
{
    const auto latitude = words.number("a latitude in degrees, -90 to 90", -90, 90);
    if (!latitude)
        return tl::make_unexpected(latitude.error());
    const auto longitude = words.number("a longitude in degrees, -180 to 180", -180, 180);
    if (!longitude)
        return tl::make_unexpected(longitude.error());
    const auto altitude = words.number("an altitude in metres above home, -500 to 10000", -500, 10000);
    if (!altitude)
        return tl::make_unexpected(altitude.error());
    return Action(VehicleCommand(GoTo{*latitude, *longitude, *altitude}));
}

StepResult parseSpeed(ScriptTokens &words)
{
    const auto speed = words.number("a speed in metres a second, over 0 and up to 1000", 0.01, 1000);
    if (!speed)
        return tl::make_unexpected(speed.error());
    return Action(VehicleCommand(ChangeSpeed{*speed}));
}

StepResult parseItem(ScriptTokens &words)
{
    const auto index = words.wholeNumber("the number of a mission item, 0 to 65535", 0, 65535);
    if (!index)
        return tl::make_unexpected(index.error());
    return Action(VehicleCommand(SetCurrentMissionItem{static_cast<std::uint16_t>(*index)}));
}

StepResult parseRaw(ScriptTokens &words)
{
    RawCommand out;
    const auto number = words.wholeNumber("the number of a MAV_CMD, 0 to 65535", 0, 65535);
    if (!number)
        return tl::make_unexpected(number.error());
    out.command = static_cast<std::uint16_t>(*number);
    for (std::size_t i = 0; i < std::size(out.parameters) && !words.atEnd(); ++i) {
        const auto value = words.number("a parameter, a number", -3.4e38, 3.4e38);
        if (!value)
            return tl::make_unexpected(value.error());
        out.parameters[i] = static_cast<float>(*value);
    }
    return Action(VehicleCommand(out));
}

StepResult parseSleep(ScriptTokens &words)
{
    const auto time = words.duration("a time in seconds, 0 to 86400");
    if (!time)
        return tl::make_unexpected(time.error());
    return Action(Sleep{*time});
}

StepResult parseParam(ScriptTokens &words)
{
    const std::string_view name = words.peek();
    if (name.empty() || name.size() > 16)
        return fail(words, "a parameter's name, up to 16 characters");
    words.take();
    const auto value = words.number("the parameter's value, a number", -3.4e38, 3.4e38);
    if (!value)
        return tl::make_unexpected(value.error());
    return Action(WriteParameter{std::string(name), *value});
}

constexpr std::pair<std::string_view, Comparison> kComparisons[] = {
    // Longer ones first, so that ">=" is not taken for ">".
    {">=", Comparison::AtLeast},  {"<=", Comparison::AtMost}, {"==", Comparison::Equal},
    {"!=", Comparison::NotEqual}, {">", Comparison::Greater}, {"<", Comparison::Less}};

StepResult parseWait(ScriptTokens &words)
{
    WaitUntil out;
    const std::string_view name = words.peekName();
    out.field = findStateField(name);
    if (!out.field) {
        std::string names;
        for (const StateField &field : stateFields())
            names += (names.empty() ? "" : ", ") + std::string(field.name);
        return fail(words, "a field's name (" + names + ")");
    }
    words.skip(name.size());
    bool found = false;
    for (const auto &[sign, comparison] : kComparisons) {
        if (!found && words.takeIf(sign)) {
            out.comparison = comparison;
            found = true;
        }
    }
    if (!found)
        return fail(words, "one of >= <= > < == !=");
    const bool isText = out.field->kind == StateField::Kind::Text;
    if (isText) {
        if (out.comparison != Comparison::Equal && out.comparison != Comparison::NotEqual)
            return tl::make_unexpected(words.errorBefore("== or !=, since " + std::string(name) + " is a text"));
        if (words.atEnd())
            return fail(words, "a value to compare " + std::string(name) + " with");
        out.text = std::string(words.take());
    } else if (out.field->kind == StateField::Kind::Flag
               && (equalIgnoringCase(words.peek(), "true") || equalIgnoringCase(words.peek(), "false"))) {
        out.number = equalIgnoringCase(words.take(), "true");
    } else {
        const auto value = words.number("a number to compare " + std::string(name) + " with", -1e300, 1e300);
        if (!value)
            return tl::make_unexpected(value.error());
        out.number = *value;
    }
    if (!words.atEnd()) {
        const auto timeout = words.duration("a time-out in seconds, 0 to 86400, or the end of the step");
        if (!timeout)
            return tl::make_unexpected(timeout.error());
        out.timeout = *timeout;
    }
    return Action(out);
}

constexpr std::pair<std::string_view, StepResult (*)(ScriptTokens &)> kVerbs[] = {{"mode", parseMode},
                                                                                  {"arm", parseArming<Arm>},
                                                                                  {"disarm", parseArming<Disarm>},
                                                                                  {"takeoff", parseTakeOff},
                                                                                  {"land", parsePlain<Land>},
                                                                                  {"rtl", parsePlain<ReturnToLaunch>},
                                                                                  {"goto", parseGoTo},
                                                                                  {"speed", parseSpeed},
                                                                                  {"wait", parseWait},
                                                                                  {"sleep", parseSleep},
                                                                                  {"param", parseParam},
                                                                                  {"item", parseItem},
                                                                                  {"start", parsePlain<StartMission>},
                                                                                  {"reboot", parsePlain<Reboot>},
                                                                                  {"command", parseRaw}};

/// Takes "12:" off the front when it is there.
Result<std::optional<std::uint8_t>, InputError> parsePrefix(ScriptTokens &words)
{
    const std::size_t digits = words.digitsBeforeColon();
    if (digits == 0)
        return std::optional<std::uint8_t>();
    unsigned number = 0;
    const std::string_view text = words.rest().substr(0, digits);
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    if (parsed.ec != std::errc() || number < 1 || number > 255)
        return fail(words, "a system id from 1 to 255 before the colon");
    words.skip(digits);
    words.takeIf(":");
    return std::optional<std::uint8_t>(static_cast<std::uint8_t>(number));
}

Result<FlightStep, InputError> parseStep(ScriptTokens &words)
{
    FlightStep step;
    const auto prefix = parsePrefix(words);
    if (!prefix)
        return tl::make_unexpected(prefix.error());
    step.systemId = *prefix;
    step.column = words.column();
    step.text = std::string(words.rest());
    for (const auto &[verb, parse] : kVerbs) {
        if (!equalIgnoringCase(words.peek(), verb))
            continue;
        words.take();
        StepResult action = parse(words);
        if (!action)
            return tl::make_unexpected(action.error());
        if (!words.atEnd())
            return fail(words, "the end of the step");
        step.action = std::move(*action);
        return step;
    }
    std::string verbs;
    for (const auto &entry : kVerbs)
        verbs += (verbs.empty() ? "" : ", ") + std::string(entry.first);
    return fail(words, "one of " + verbs);
}

} // namespace

Result<std::vector<FlightStep>, InputError> parseFlightScript(std::string_view script)
{
    if (script.size() > kMaxScriptLength)
        return tl::make_unexpected(
            InputError{"the script is longer than " + std::to_string(kMaxScriptLength) + " characters", {}});
    std::vector<FlightStep> steps;
    std::size_t begin = 0;
    while (begin <= script.size()) {
        const std::size_t end = std::min(script.find(';', begin), script.size());
        ScriptTokens words(script.substr(begin, end - begin), begin + 1, steps.size() + 1);
        begin = end + 1;
        if (words.atEnd())
            continue;
        if (steps.size() == kMaxScriptSteps)
            return tl::make_unexpected(words.error("no more than " + std::to_string(kMaxScriptSteps) + " steps"));
        auto step = parseStep(words);
        if (!step)
            return tl::make_unexpected(step.error());
        steps.push_back(std::move(*step));
    }
    if (steps.empty())
        return tl::make_unexpected(InputError{"the script has no steps", {}});
    return steps;
}

} // namespace skyseal::vehicle
