#include "core/engine/common/misreading.h"

#include "core/engine/common/question_rules.h"
#include "core/mavlink/messages.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

constexpr std::size_t kHead = 10;
/// Offset of the command id in COMMAND_LONG and COMMAND_INT.
constexpr std::size_t kCommandOffset = 28;

/// Returns true for printable characters followed by zeros.
bool isText(ByteView name)
{
    const auto end = std::find(name.begin(), name.end(), 0);
    return std::all_of(name.begin(), end, [](std::uint8_t c) { return c >= 0x20 && c < 0x7f; })
        && std::all_of(end, name.end(), [](std::uint8_t c) { return c == 0; });
}

bool namesAreText(const mavlink::Frame &frame)
{
    const ByteView payload = frame.payload();
    return std::all_of(frame.info().fields.begin(), frame.info().fields.end(), [&](const mavlink::FieldInfo &field) {
        if (field.type != mavlink::FieldType::Char || field.offset >= payload.size())
            return true;
        return isText(payload.subspan(field.offset, std::min(field.size(), payload.size() - field.offset)));
    });
}

bool actsOnAVehicle(std::uint16_t command)
{
    static const mavlink::EnumInfo *const kCommands = mavlink::Dialect::builtin().enumeration("MAV_CMD");
    return kCommands && !kCommands->nameOf(command).empty() && !isQuestion(command);
}

/// Checks the values that can appear as the command id when bytes are lost in it or before it: any two later bytes, in order.
/// Its own id is harmless where its first byte is in place, since no byte of the parameters is lost then.
bool hasCommandBehindItsCommand(const mavlink::Frame &frame)
{
    constexpr std::size_t kCommand = kHead + kCommandOffset;
    const ByteView bytes = frame.bytes();
    const auto idOf = [bytes](std::size_t low, std::size_t high) {
        return static_cast<std::uint16_t>(bytes[low] | bytes[high] << 8);
    };
    for (std::size_t low = kCommand; low < bytes.size(); ++low) {
        const bool isInPlace = low == kCommand;
        for (std::size_t high = isInPlace ? low + 2 : low + 1; high < bytes.size(); ++high) {
            const std::uint16_t id = idOf(low, high);
            if (actsOnAVehicle(id) && !(isInPlace && id == idOf(kCommand, kCommand + 1)))
                return true;
        }
    }
    return false;
}

} // namespace

bool isPlainlySaid(const mavlink::Frame &frame)
{
    return frame.version() == 2 && frame.bytes()[3] == 0 && frame.payload().size() <= frame.info().maxLength
        && namesAreText(frame);
}

bool mayBeMisread(const mavlink::Frame &frame)
{
    const ByteView rest = frame.bytes().subspan(1);
    if (std::any_of(rest.begin(), rest.end(), mavlink::isMagic))
        return true;
    const bool isCommand = frame.messageId() == mavlink::CommandLong::kId || frame.messageId() == mavlink::CommandInt::kId;
    return isCommand && hasCommandBehindItsCommand(frame);
}

} // namespace skyseal::engine
