#include "core/log/tlog_entry.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

namespace skyseal::tlog {

namespace {

constexpr std::uint64_t kYear2200 = 7'258'118'400'000'000; // µs since 1970

} // namespace

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
    const auto microseconds = reader.bigEndian<std::uint64_t>();
    if (!reader.ok() || microseconds > kYear2200)
        return std::nullopt;
    return WallTime(std::chrono::microseconds(static_cast<std::int64_t>(microseconds)));
}

} // namespace skyseal::tlog
