#include "core/log/tlog_entry.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

namespace skyseal::tlog {

namespace {

constexpr WallTime kYear2200{std::chrono::microseconds(7'258'118'400'000'000)};

} // namespace

bool isPlausible(WallTime time)
{
    return time >= WallTime() && time <= kYear2200;
}

MutableByteView writeEntry(MutableByteView out, WallTime time, ByteView frame)
{
    const auto microseconds = time.time_since_epoch().count();
    ByteWriter writer(out);
    writer.bigEndian(microseconds > 0 ? static_cast<std::uint64_t>(microseconds) : std::uint64_t(0));
    writer.bytes(frame);
    return writer.ok() ? writer.written() : MutableByteView();
}

std::optional<WallTime> readTime(ByteView bytes)
{
    ByteReader reader(bytes);
    const WallTime time(std::chrono::microseconds(reader.bigEndian<std::int64_t>()));
    return reader.ok() && isPlausible(time) ? std::optional(time) : std::nullopt;
}

} // namespace skyseal::tlog
