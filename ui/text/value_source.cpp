#include "ui/text/value_source.h"

#include "ui/text/vehicle_text.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <string>

namespace skyseal::ui {

namespace {

struct Label
{
    std::string_view name; ///< of the state field
    const char *title, *caption;
    Measure measure = Measure::Plain; ///< where the unit alone does not say it
    int decimals = -1;                ///< < 0: those of the unit
};

/// The translations' context, with the labels of the derived quantities.
struct ValueSourceText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ValueSource)

public:
    // clang-format off
    static constexpr Label kLabels[] = {
        {"sysid", QT_TR_NOOP("MAVLink system ID"), QT_TR_NOOP("system")},
        {"mode", QT_TR_NOOP("Flight mode"), QT_TR_NOOP("mode")},
        {"armed", QT_TR_NOOP("Armed"), QT_TR_NOOP("armed")},
        {"roll", QT_TR_NOOP("Roll, right wing down positive"), QT_TR_NOOP("roll")},
        {"pitch", QT_TR_NOOP("Pitch, nose up positive"), QT_TR_NOOP("pitch")},
        {"yaw", QT_TR_NOOP("Yaw"), QT_TR_NOOP("yaw")},
        {"lat", QT_TR_NOOP("Latitude"), QT_TR_NOOP("lat"), Measure::Plain, 6},
        {"lon", QT_TR_NOOP("Longitude"), QT_TR_NOOP("lon"), Measure::Plain, 6},
        {"alt_rel", QT_TR_NOOP("Altitude above home"), QT_TR_NOOP("alt")},
        {"ground_speed", QT_TR_NOOP("Ground speed"), QT_TR_NOOP("speed")},
        {"battery_v", QT_TR_NOOP("Battery voltage"), QT_TR_NOOP("battery"), Measure::Plain, 1},
        {"battery_percent", QT_TR_NOOP("Battery, remaining"), QT_TR_NOOP("battery")},
        {"gps_fix", QT_TR_NOOP("GPS fix"), QT_TR_NOOP("GPS")},
        {"satellites", QT_TR_NOOP("Satellites in use"), QT_TR_NOOP("satellites")},
        {"ekf_ok", QT_TR_NOOP("EKF, the estimate of attitude and position"), QT_TR_NOOP("EKF")},
        {"heartbeat_age", QT_TR_NOOP("Time since the last heartbeat"), QT_TR_NOOP("heartbeat")},
        {"alt", QT_TR_NOOP("Altitude above mean sea level"), QT_TR_NOOP("alt MSL")},
        {"climb", QT_TR_NOOP("Climb rate"), QT_TR_NOOP("climb"), Measure::Climb},
        {"heading", QT_TR_NOOP("Heading"), QT_TR_NOOP("hdg"), Measure::Heading},
        {"air_speed", QT_TR_NOOP("Airspeed"), QT_TR_NOOP("airspeed")},
        {"throttle", QT_TR_NOOP("Throttle"), QT_TR_NOOP("throttle")},
        {"battery_a", QT_TR_NOOP("Battery current"), QT_TR_NOOP("current")},
        {"hdop", QT_TR_NOOP("HDOP of the GPS"), QT_TR_NOOP("HDOP"), Measure::Plain, 1},
        {"distance_home", QT_TR_NOOP("Distance to home"), QT_TR_NOOP("home"), Measure::Distance},
        {"flight_time", QT_TR_NOOP("Flight time"), QT_TR_NOOP("time"), Measure::Duration},
        {"mission_current", QT_TR_NOOP("Current mission item"), QT_TR_NOOP("item")},
        {"custom_mode", QT_TR_NOOP("Flight mode number"), QT_TR_NOOP("mode no.")},
        {"system_status", QT_TR_NOOP("State of the system (MAV_STATE)"), QT_TR_NOOP("state")},
        {"cpu_load", QT_TR_NOOP("CPU load of the autopilot"), QT_TR_NOOP("CPU")},
        {"vibration", QT_TR_NOOP("Vibration, worst axis"), QT_TR_NOOP("vibration"), Measure::Plain, 1},
        {"latency", QT_TR_NOOP("Round-trip time of the link"), QT_TR_NOOP("latency"), Measure::Plain, 3},
        {"message_age", QT_TR_NOOP("Time since the last message"), QT_TR_NOOP("age")},
        {"lost", QT_TR_NOOP("Link lost"), QT_TR_NOOP("lost")},
        {"radio_signal", QT_TR_NOOP("Signal of the radio, in its units"), QT_TR_NOOP("signal")},
        {"radio_remote_signal", QT_TR_NOOP("Signal of the radio at the vehicle, in its units"), QT_TR_NOOP("signal there")},
        {"radio_noise", QT_TR_NOOP("Noise of the radio, in its units"), QT_TR_NOOP("noise")},
        {"radio_remote_noise", QT_TR_NOOP("Noise of the radio at the vehicle, in its units"), QT_TR_NOOP("noise there")},
        {"radio_buffer", QT_TR_NOOP("Free part of the radio's transmit buffer"), QT_TR_NOOP("buffer")},
        {"firmware", QT_TR_NOOP("Firmware"), QT_TR_NOOP("firmware")},
    };
    // clang-format on
};

const Label *labelOf(const vehicle::StateField &state)
{
    const auto *found = std::ranges::find(ValueSourceText::kLabels, state.name, &Label::name);
    return found == std::end(ValueSourceText::kLabels) ? nullptr : found;
}

bool isText(const mavlink::FieldInfo &field)
{
    return field.type == mavlink::FieldType::Char;
}

bool isFloating(const mavlink::FieldInfo &field)
{
    return field.type == mavlink::FieldType::Float || field.type == mavlink::FieldType::Double;
}

std::vector<ValueSource> allSources()
{
    std::vector<ValueSource> out;
    for (const vehicle::StateField &state : vehicle::stateFields())
        out.push_back({.state = &state});
    std::vector<const mavlink::MessageInfo *> messages;
    for (const mavlink::MessageInfo &message : mavlink::Dialect::builtin().messages())
        messages.push_back(&message);
    std::ranges::sort(messages, {}, &mavlink::MessageInfo::name);
    for (const mavlink::MessageInfo *message : messages) {
        for (const mavlink::FieldInfo &field : message->fields) {
            if (!isText(field))
                out.push_back({.message = message, .field = &field});
        }
    }
    return out;
}

} // namespace

QString ValueSource::id() const
{
    if (state)
        return fromStd(state->name);
    QString name = fromStd(message->name) + QLatin1Char('.') + fromStd(field->name);
    if (field->arrayLength)
        name += QStringLiteral("[%1]").arg(element);
    return name;
}

QString ValueSource::title() const
{
    const Label *label = state ? labelOf(*state) : nullptr;
    return label ? ValueSourceText::tr(label->title) : id();
}

QString ValueSource::caption() const
{
    const Label *label = state ? labelOf(*state) : nullptr;
    return label ? ValueSourceText::tr(label->caption) : id().section(QLatin1Char('.'), -1);
}

QString ValueSource::description() const
{
    if (state)
        return ValueSourceText::tr("derived by the station: %1").arg(id());
    QStringList parts{fromStd(mavlink::nameOf(field->type))};
    if (field->arrayLength)
        parts << ValueSourceText::tr("%1 elements").arg(field->arrayLength);
    if (!field->enumName.empty())
        parts << fromStd(field->enumName);
    return parts.join(QStringLiteral(" · "));
}

QString ValueSource::sourceUnit() const
{
    return fromStd(state ? state->unit : field->units);
}

ValueUnit ValueSource::unit() const
{
    if (!state)
        return valueUnit(field->units, !isFloating(*field));
    ValueUnit unit = valueUnit(state->unit, state->kind != vehicle::StateField::Kind::Number);
    if (const Label *label = labelOf(*state)) {
        if (label->measure != Measure::Plain)
            unit.measure = label->measure;
        if (label->decimals >= 0)
            unit.decimals = label->decimals;
    }
    return unit;
}

bool ValueSource::takesUnit() const
{
    const ValueUnit own = unit();
    return isNumber() && own.measure == Measure::Plain && own.name.isEmpty();
}

bool ValueSource::isNumber() const
{
    using Kind = vehicle::StateField::Kind;
    if (state) // the fix and the state of the EKF are numbers that stand for words
        return state->kind != Kind::Text && state->kind != Kind::Flag && state->name != "gps_fix" && state->name != "ekf_ok";
    const mavlink::EnumInfo *names = field->enumName.empty() ? nullptr
                                                             : mavlink::Dialect::builtin().enumeration(field->enumName);
    return !names || names->bitmask;
}

std::optional<engine::FieldChoice> ValueSource::fieldChoice() const
{
    if (!field)
        return std::nullopt;
    return engine::FieldChoice{message->id, field, element};
}

std::optional<ValueSource> findValueSource(const QString &id)
{
    const qsizetype dot = id.indexOf(QLatin1Char('.'));
    if (dot < 0) {
        const vehicle::StateField *state = vehicle::findStateField(id.toStdString());
        return state ? std::optional(ValueSource{.state = state}) : std::nullopt;
    }
    const mavlink::MessageInfo *message = mavlink::Dialect::builtin().find(id.left(dot).toStdString());
    if (!message)
        return std::nullopt;
    QString name = id.mid(dot + 1);
    std::uint8_t element = 0;
    const qsizetype bracket = name.indexOf(QLatin1Char('['));
    if (bracket >= 0) {
        bool ok = name.endsWith(QLatin1Char(']'));
        const uint index = ok ? QStringView(name).mid(bracket + 1).chopped(1).toUInt(&ok) : 0;
        if (!ok || index > 255)
            return std::nullopt;
        element = static_cast<std::uint8_t>(index);
        name.truncate(bracket);
    }
    const mavlink::FieldInfo *field = message->field(name.toStdString());
    if (!field || isText(*field) || element >= field->elements() || (bracket >= 0) != (field->arrayLength > 0))
        return std::nullopt;
    return ValueSource{.message = message, .field = field, .element = element};
}

std::span<const ValueSource> valueSources()
{
    static const std::vector<ValueSource> kSources = allSources();
    return kSources;
}

QString enumEntryText(const mavlink::FieldInfo &field, mavlink::FieldValue value)
{
    const mavlink::EnumInfo *names = field.enumName.empty() ? nullptr : mavlink::Dialect::builtin().enumeration(field.enumName);
    if (!names || names->bitmask)
        return {};
    QString text = fromStd(names->nameOf(value.bits()));
    const QString prefix = fromStd(names->name) + QLatin1Char('_');
    if (text.startsWith(prefix))
        text.remove(0, prefix.size());
    return text.replace(QLatin1Char('_'), QLatin1Char(' '));
}

} // namespace skyseal::ui
