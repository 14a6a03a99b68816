#include "ui/value_choice.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

namespace skyseal::ui {

namespace {

struct ValueChoiceText
{
    Q_DECLARE_TR_FUNCTIONS(skyseal::ui::ValueChoice)
};

constexpr QLatin1String kSource("source"), kCaption("caption"), kDecimals("decimals"), kLow("low"), kHigh("high"),
    kLine("line"), kUnit("unit");

tl::expected<std::optional<double>, QString> readLimit(const QJsonObject &object, QLatin1String key)
{
    const QJsonValue value = object.value(key);
    if (value.isUndefined())
        return std::optional<double>();
    if (!value.isDouble())
        return tl::unexpected(ValueChoiceText::tr("\"%1\" is not a number").arg(key));
    return std::optional(value.toDouble());
}

tl::expected<ValueChoice, QString> readChoice(const QJsonValue &value)
{
    const QJsonObject object = value.toObject();
    const QString id = object.value(kSource).toString();
    const auto source = findValueSource(id);
    if (!source)
        return tl::unexpected(ValueChoiceText::tr("there is no value \"%1\"").arg(id.left(80)));
    ValueChoice out{.source = *source};
    const QJsonValue caption = object.value(kCaption), decimals = object.value(kDecimals), line = object.value(kLine);
    out.caption = caption.toString();
    if (!(caption.isUndefined() || caption.isString()) || out.caption.size() > kLongestCaption)
        return tl::unexpected(ValueChoiceText::tr("\"caption\" is not text of at most %1 characters").arg(kLongestCaption));
    out.decimals = decimals.toInt(decimals.isUndefined() ? -1 : -2);
    if (out.decimals < -1 || out.decimals > kMostDecimals)
        return tl::unexpected(ValueChoiceText::tr("\"decimals\" is not a number from 0 to %1").arg(kMostDecimals));
    const auto low = readLimit(object, kLow), high = readLimit(object, kHigh);
    if (!low || !high)
        return tl::unexpected(low ? high.error() : low.error());
    out.low = *low;
    out.high = *high;
    if (out.low && out.high && *out.low >= *out.high)
        return tl::unexpected(ValueChoiceText::tr("\"low\" is not below \"high\""));
    if (!(line.isUndefined() || line.isBool()))
        return tl::unexpected(ValueChoiceText::tr("\"line\" is neither true nor false"));
    out.line = line.toBool();
    const QJsonValue unit = object.value(kUnit);
    out.unitText = unit.toString();
    if (!(unit.isUndefined() || unit.isString()) || out.unitText.size() > kLongestUnit)
        return tl::unexpected(ValueChoiceText::tr("\"unit\" is not text of at most %1 characters").arg(kLongestUnit));
    return out;
}

} // namespace

ValueUnit ValueChoice::shownUnit() const
{
    ValueUnit out = source.unit();
    if (source.takesUnit())
        out.name = unitText;
    return out;
}

LimitSide ValueChoice::sideOf(double number) const
{
    if (low && number < *low)
        return LimitSide::Low;
    return high && number > *high ? LimitSide::High : LimitSide::Within;
}

bool ValueChoice::operator==(const ValueChoice &other) const
{
    return source.id() == other.source.id() && caption == other.caption && decimals == other.decimals && low == other.low
        && high == other.high && line == other.line && unitText == other.unitText;
}

ValueChoices defaultValues()
{
    ValueChoices out;
    for (const char *name : {"alt_rel", "heading", "ground_speed", "distance_home", "climb", "flight_time", "battery_a", "hdop",
                             "ekf_ok", "throttle"})
        out.push_back({.source = {.state = vehicle::findStateField(name)}});
    return out;
}

QString toText(const ValueChoices &choices)
{
    QJsonArray out;
    for (const ValueChoice &choice : choices) {
        QJsonObject object{{kSource, choice.source.id()}};
        if (!choice.caption.isEmpty())
            object.insert(kCaption, choice.caption);
        if (choice.decimals >= 0)
            object.insert(kDecimals, choice.decimals);
        if (choice.low)
            object.insert(kLow, *choice.low);
        if (choice.high)
            object.insert(kHigh, *choice.high);
        if (choice.line)
            object.insert(kLine, true);
        if (!choice.unitText.isEmpty())
            object.insert(kUnit, choice.unitText);
        out.append(object);
    }
    return QString::fromUtf8(QJsonDocument(out).toJson(QJsonDocument::Compact));
}

tl::expected<ValueChoices, QString> readValueChoices(const QString &text)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(text.toUtf8(), &error);
    if (!document.isArray())
        return tl::unexpected(error.error ? ValueChoiceText::tr("not JSON: %1").arg(error.errorString())
                                          : ValueChoiceText::tr("not a list"));
    const QJsonArray entries = document.array();
    if (entries.size() > static_cast<qsizetype>(kMostValues))
        return tl::unexpected(ValueChoiceText::tr("more than %1 values").arg(kMostValues));
    ValueChoices out;
    for (const QJsonValue entry : entries) {
        auto choice = readChoice(entry);
        if (!choice)
            return tl::unexpected(ValueChoiceText::tr("value %1: %2").arg(out.size() + 1).arg(choice.error()));
        out.push_back(std::move(*choice));
    }
    return out;
}

} // namespace skyseal::ui
