// What must hold for any file of shapes that was read, and for the reason why one was not.
#pragma once

#include "core/base/result.h"
#include "core/overlay/overlay.h"

#include <QtCore/QByteArray>

#include <cstdint>
#include <cstdlib>

namespace skyseal::overlay {

inline QByteArray contentOf(const std::uint8_t *data, std::size_t size)
{
    return {reinterpret_cast<const char *>(data), static_cast<qsizetype>(size)};
}

inline void must(bool holds)
{
    if (!holds)
        std::abort();
}

inline void judge(const Result<Overlay, InputError> &read)
{
    if (!read) {
        must(!read.error().message.empty());
        return;
    }
    std::size_t points = 0;
    for (const OverlayShape &shape : read->shapes) {
        must(!shape.lines.empty() && shape.name.size() <= 100);
        must(shape.kind == ShapeKind::Polygon || shape.lines.size() == 1);
        for (const OverlayLine &line : shape.lines) {
            must(shape.kind == ShapeKind::Point ? line.size() == 1 : line.size() >= (shape.kind == ShapeKind::Line ? 2u : 3u));
            points += line.size();
            for (const OverlayPoint &point : line)
                must(point.latitude >= -90 && point.latitude <= 90 && point.longitude >= -180 && point.longitude <= 180);
        }
    }
    must(points <= kMostPoints);
}

} // namespace skyseal::overlay
