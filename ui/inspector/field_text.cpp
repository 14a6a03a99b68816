#include "ui/inspector/field_text.h"

#include "core/mavlink/field_value.h"
#include "ui/text/vehicle_text.h"

#include <QtCore/QStringList>

namespace skyseal::ui {

using mavlink::FieldType;

namespace {

QString enumText(const mavlink::EnumInfo &info, std::uint64_t value)
{
    if (!info.bitmask) {
        const std::string_view name = info.nameOf(value);
        return fromStd(name);
    }
    QStringList set;
    for (const mavlink::EnumEntry &entry : info.entries)
        if (entry.value && (value & entry.value) == entry.value)
            set << fromStd(entry.name);
    return set.join(QStringLiteral(" | "));
}

} // namespace

QString fieldText(const mavlink::FieldInfo &field, ByteView payload, const mavlink::Dialect &dialect)
{
    if (field.type == FieldType::Char && field.arrayLength)
        return fromStd(mavlink::fieldText(payload, field));
    const mavlink::EnumInfo *names = field.enumName.empty() ? nullptr : dialect.enumeration(field.enumName);
    QStringList parts;
    for (std::size_t i = 0; i < field.elements(); ++i) {
        const mavlink::FieldValue value = mavlink::fieldValue(payload, field, i);
        const QString number = fromStd(mavlink::toText(value));
        const QString name = names ? enumText(*names, value.bits()) : QString();
        parts << (name.isEmpty() ? number : QStringLiteral("%1 (%2)").arg(number, name));
    }
    return parts.join(QLatin1Char(' '));
}

} // namespace skyseal::ui
