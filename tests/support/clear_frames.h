// Unsealed MAVLink frames: attack tests send them, and search captured traffic for them.
#pragma once

#include "core/mavlink/dialect.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/frame_writer.h"

#include <QtCore/QByteArray>

#include <array>
#include <cstdint>

namespace skyseal::test {

inline ByteView viewOf(const QByteArray &bytes)
{
    return {reinterpret_cast<const std::uint8_t *>(bytes.constData()), static_cast<std::size_t>(bytes.size())};
}

/// The message as a MAVLink 2 frame.
template<typename Message> QByteArray frameOf(const Message &message, std::uint8_t systemId, std::uint8_t componentId = 190)
{
    mavlink::FrameWriter writer(systemId, componentId);
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    const ByteView frame = writer.write(message, buffer);
    return QByteArray(reinterpret_cast<const char *>(frame.data()), static_cast<qsizetype>(frame.size()));
}

/// How many whole frames, with good checksums, can be read in it.
inline std::size_t framesIn(const QByteArray &bytes)
{
    mavlink::FrameScanner scanner(viewOf(bytes), mavlink::Dialect::builtin());
    std::size_t frames = 0;
    while (const auto item = scanner.next())
        frames += item->frame.has_value();
    return frames;
}

} // namespace skyseal::test
