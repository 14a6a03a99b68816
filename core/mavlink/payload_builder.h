// Builds the payload of any message field by field, by the tables; the counterpart of fieldValue().
#pragma once

#include "core/mavlink/field_value.h"

#include <array>

namespace skyseal::mavlink {

/// A payload of zeros to fill (the field of the protocol version is already set). To write it as a frame:
/// `writer.write(info.id, info.crcExtra, info.minLength, builder.payload(), out)`.
class PayloadBuilder
{
public:
    explicit PayloadBuilder(const MessageInfo &info) : m_info(&info)
    {
        for (const FieldInfo &field : info.fields) {
            if (field.isMavlinkVersion)
                setFieldValue(bytes(), field, 0, FieldValue::fromBits(field.type, 3));
        }
    }

    const MessageInfo &info() const { return *m_info; }
    bool set(const FieldInfo &field, std::size_t index, FieldValue value)
    {
        return setFieldValue(bytes(), field, index, value);
    }
    bool setText(const FieldInfo &field, std::string_view text) { return setFieldText(bytes(), field, text); }
    /// All bytes of the message with its extensions.
    ByteView payload() const { return ByteView(m_bytes).first(m_info->maxLength); }

private:
    MutableByteView bytes() { return MutableByteView(m_bytes).first(m_info->maxLength); }

    const MessageInfo *m_info;
    std::array<std::uint8_t, 255> m_bytes{};
};

} // namespace skyseal::mavlink
