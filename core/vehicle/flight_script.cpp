#include "core/vehicle/flight_script.h"

#include "core/vehicle/script_tokens.h"
#include "core/base/ascii.h"

#include <array>
#include <charconv>
#include <cmath>

namespace skyseal::vehicle {

namespace {

using Action = decltype(FlightStep::action);
using ParsedAction = Result<Action, InputError>;

tl::unexpected<InputError> fail(const ScriptTokens &tokens, const Reason &expected)
{
    return tl::make_unexpected(tokens.error(expected));
}

template<typename T> Action commandOf(const T &command)
{
    return VehicleCommand(command);
}

/// Of a command with one number.
template<typename T> Action commandWith(double number)
{
    return VehicleCommand(T{number});
}

/// A step without arguments.
template<typename T> ParsedAction parsePlain(ScriptTokens &)
{
    return commandOf(T{});
}

template<typename T> ParsedAction parseArming(ScriptTokens &tokens)
{
    T out;
    if (!tokens.atEnd()) {
        if (!equalIgnoringCase(tokens.peek(), "force"))
            return fail(tokens, "'force' or the end of the step");
        tokens.take();
        out.force = true;
    }
    return commandOf(out);
}

ParsedAction parseMode(ScriptTokens &tokens)
{
    if (tokens.atEnd())
        return fail(tokens, "a mode's name");
    return commandOf(SetMode{std::string(tokens.take())});
}

ParsedAction parseTakeOff(ScriptTokens &tokens)
{
    return tokens.number("an altitude in metres above home, over 0 and up to 10000", 0.01, 10000).map(commandWith<TakeOff>);
}

/// Two numbers: latitude and longitude, in degrees.
template<typename T> Result<T, InputError> parsePlace(ScriptTokens &tokens)
{
    const auto latitude = tokens.number("a latitude in degrees, -90 to 90", -90, 90);
    if (!latitude)
        return tl::make_unexpected(latitude.error());
    const auto longitude = tokens.number("a longitude in degrees, -180 to 180", -180, 180);
    if (!longitude)
        return tl::make_unexpected(longitude.error());
    T out;
    out.latitude = *latitude;
    out.longitude = *longitude;
    return out;
}

Result<double, InputError> parseAltitude(ScriptTokens &tokens)
{
    return tokens.number("an altitude in metres above home, -500 to 10000", -500, 10000);
}

/// The place, and its altitude.
template<typename T> ParsedAction parsePlaceAbove(ScriptTokens &tokens, bool mayEndBefore)
{
    auto place = parsePlace<T>(tokens);
    if (!place)
        return tl::make_unexpected(place.error());
    if (mayEndBefore && tokens.atEnd())
        return commandOf(*place);
    const auto altitude = parseAltitude(tokens);
    if (!altitude)
        return tl::make_unexpected(altitude.error());
    place->altitudeRelative = *altitude;
    return commandOf(*place);
}

ParsedAction parseGoTo(ScriptTokens &tokens)
{
    return parsePlaceAbove<GoTo>(tokens, false);
}

ParsedAction parseChangeAltitude(ScriptTokens &tokens)
{
    return parseAltitude(tokens).map(commandWith<ChangeAltitude>);
}

ParsedAction parsePointing(ScriptTokens &tokens)
{
    if (equalIgnoringCase(tokens.peek(), "none")) {
        tokens.take();
        return commandOf(StopPointing{});
    }
    return parsePlaceAbove<PointAt>(tokens, true);
}

ParsedAction parseSetHome(ScriptTokens &tokens)
{
    return parsePlace<SetHome>(tokens).map(commandOf<SetHome>);
}

ParsedAction parseSpeed(ScriptTokens &tokens)
{
    return tokens.number("a speed in metres a second, over 0 and up to 1000", 0.01, 1000).map(commandWith<ChangeSpeed>);
}

ParsedAction parseItem(ScriptTokens &tokens)
{
    return tokens.wholeNumber("the number of a mission item, 0 to 65535", 0, 65535).map([](auto index) {
        return commandOf(SetCurrentMissionItem{static_cast<std::uint16_t>(index)});
    });
}

ParsedAction parseRaw(ScriptTokens &tokens)
{
    RawCommand out;
    const auto number = tokens.wholeNumber("the number of a MAV_CMD, 0 to 65535", 0, 65535);
    if (!number)
        return tl::make_unexpected(number.error());
    out.command = static_cast<std::uint16_t>(*number);
    for (std::size_t i = 0; i < std::size(out.parameters) && !tokens.atEnd(); ++i) {
        const auto value = tokens.number("a parameter, a number", -3.4e38, 3.4e38);
        if (!value)
            return tl::make_unexpected(value.error());
        out.parameters[i] = static_cast<float>(*value);
    }
    return commandOf(out);
}

ParsedAction parseSleep(ScriptTokens &tokens)
{
    return tokens.duration("a time in seconds, 0 to 86400").map([](Duration time) { return Action(Sleep{time}); });
}

ParsedAction parseParam(ScriptTokens &tokens)
{
    const auto [component, name] = parameterName(tokens.peek());
    if (name.empty() || name.size() > 16)
        return fail(tokens, "a parameter's name, up to 16 characters");
    tokens.take();
    const auto value = tokens.number("the parameter's value, a number", -3.4e38, 3.4e38);
    if (!value)
        return tl::make_unexpected(value.error());
    return Action(WriteParameter{name, *value, component});
}

constexpr std::pair<std::string_view, ComparisonOperator> kComparisons[] = {
    // Longer ones first, so that ">=" is not taken for ">".
    {">=", ComparisonOperator::AtLeast},  {"<=", ComparisonOperator::AtMost}, {"==", ComparisonOperator::Equal},
    {"!=", ComparisonOperator::NotEqual}, {">", ComparisonOperator::Greater}, {"<", ComparisonOperator::Less}};

Result<WaitUntil, InputError> parseComparison(ScriptTokens &tokens)
{
    WaitUntil out;
    const std::string_view name = tokens.peekName();
    out.field = findStateField(name);
    if (!out.field) {
        std::string names;
        for (const StateField &field : stateFields())
            names += (names.empty() ? "" : ", ") + std::string(field.name);
        return fail(tokens, sentence("Reason", "a field's name (%1)")(names));
    }
    tokens.skip(name.size());
    bool found = false;
    for (const auto &[sign, comparison] : kComparisons) {
        if (!found && tokens.takeIf(sign)) {
            out.comparison = comparison;
            found = true;
        }
    }
    if (!found)
        return fail(tokens, sentence("Reason", "one of >= <= > < == !="));
    const bool isText = out.field->kind == StateField::Kind::Text;
    if (isText) {
        if (out.comparison != ComparisonOperator::Equal && out.comparison != ComparisonOperator::NotEqual)
            return tl::make_unexpected(
                tokens.errorBefore(sentence("Reason", "== or !=, since %1 is a text")(std::string(name))));
        if (tokens.atEnd())
            return fail(tokens, sentence("Reason", "a value to compare %1 with")(std::string(name)));
        out.text = std::string(tokens.take());
    } else if (out.field->kind == StateField::Kind::Flag
               && (equalIgnoringCase(tokens.peek(), "true") || equalIgnoringCase(tokens.peek(), "false"))) {
        out.number = equalIgnoringCase(tokens.take(), "true");
    } else {
        const auto value = tokens.number(sentence("Reason", "a number to compare %1 with")(std::string(name)), -1e300, 1e300);
        if (!value)
            return tl::make_unexpected(value.error());
        out.number = *value;
    }
    return out;
}

ParsedAction parseWait(ScriptTokens &tokens)
{
    auto out = parseComparison(tokens);
    if (!out)
        return tl::make_unexpected(out.error());
    if (!tokens.atEnd()) {
        const auto timeout = tokens.duration("a time-out in seconds, 0 to 86400, or the end of the step");
        if (!timeout)
            return tl::make_unexpected(timeout.error());
        out->timeout = *timeout;
    }
    return Action(*out);
}

constexpr std::pair<std::string_view, ParsedAction (*)(ScriptTokens &)> kVerbs[] = {
    {"mode", parseMode},
    {"arm", parseArming<Arm>},
    {"disarm", parseArming<Disarm>},
    {"takeoff", parseTakeOff},
    {"land", parsePlain<Land>},
    {"rtl", parsePlain<ReturnToLaunch>},
    {"goto", parseGoTo},
    {"altitude", parseChangeAltitude},
    {"pause", parsePlain<Loiter>},
    {"loiter", parsePlain<Loiter>}, // as "pause", for older scripts
    {"roi", parsePointing},
    {"sethome", parseSetHome},
    {"speed", parseSpeed},
    {"wait", parseWait},
    {"sleep", parseSleep},
    {"param", parseParam},
    {"item", parseItem},
    {"start", parsePlain<StartMission>},
    {"reboot", parsePlain<Reboot>},
    {"command", parseRaw}};

/// Takes "12:" off the front when it is there.
Result<std::optional<std::uint8_t>, InputError> parsePrefix(ScriptTokens &tokens)
{
    const std::size_t digits = tokens.digitsBeforeColon();
    if (digits == 0)
        return std::optional<std::uint8_t>();
    unsigned number = 0;
    const std::string_view text = tokens.rest().substr(0, digits);
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
    if (parsed.ec != std::errc() || number < 1 || number > 255)
        return fail(tokens, "a system ID from 1 to 255 before the colon");
    tokens.skip(digits);
    tokens.takeIf(":");
    return std::optional<std::uint8_t>(static_cast<std::uint8_t>(number));
}

Result<FlightStep, InputError> parseStep(ScriptTokens &tokens)
{
    FlightStep step;
    const auto prefix = parsePrefix(tokens);
    if (!prefix)
        return tl::make_unexpected(prefix.error());
    step.systemId = *prefix;
    step.column = tokens.column();
    step.text = std::string(tokens.rest());
    for (const auto &[verb, parse] : kVerbs) {
        if (!equalIgnoringCase(tokens.peek(), verb))
            continue;
        tokens.take();
        ParsedAction action = parse(tokens);
        if (!action)
            return tl::make_unexpected(action.error());
        if (!tokens.atEnd())
            return fail(tokens, "the end of the step");
        step.action = std::move(*action);
        return step;
    }
    std::string verbs;
    for (const auto &entry : kVerbs)
        verbs += (verbs.empty() ? "" : ", ") + std::string(entry.first);
    return fail(tokens, "one of " + verbs);
}

} // namespace

Result<WaitUntil, InputError> parseCondition(std::string_view condition, std::size_t column)
{
    ScriptTokens tokens(condition, column, 0);
    auto out = parseComparison(tokens);
    if (out && !tokens.atEnd())
        return fail(tokens, sentence("Reason", "the end of the condition"));
    return out;
}

Result<std::vector<FlightStep>, InputError> parseFlightScript(std::string_view script)
{
    if (script.size() > kMaxScriptLength)
        return tl::make_unexpected(
            InputError{"the script is longer than " + std::to_string(kMaxScriptLength) + " characters", {}});
    std::vector<FlightStep> steps;
    std::size_t begin = 0;
    while (begin <= script.size()) {
        const std::size_t end = std::min(script.find(';', begin), script.size());
        ScriptTokens tokens(script.substr(begin, end - begin), begin + 1, steps.size() + 1);
        begin = end + 1;
        if (tokens.atEnd())
            continue;
        if (steps.size() == kMaxScriptSteps)
            return tl::make_unexpected(tokens.error("no more than " + std::to_string(kMaxScriptSteps) + " steps"));
        auto step = parseStep(tokens);
        if (!step)
            return tl::make_unexpected(step.error());
        steps.push_back(std::move(*step));
    }
    if (steps.empty())
        return tl::make_unexpected(InputError{"the script has no steps", {}});
    return steps;
}

} // namespace skyseal::vehicle
