#include "ui/window/place_beside.h"

#include "ui/theme/grid.h"

#include <algorithm>

namespace skyseal::ui {

QPoint placeBeside(const QSize &box, const QPoint &point, const QRect &room)
{
    constexpr int kApart = 6 * kGrid; // the mark with its label, and a frame that the window system adds
    const auto within = [](int value, int least, int most) { return std::clamp(value, least, std::max(least, most)); };
    const int lastX = room.right() + 1 - box.width(), lastY = room.bottom() + 1 - box.height();
    const int x = within(point.x() - box.width() / 2, room.left(), lastX);
    const int y = within(point.y() - box.height() / 2, room.top(), lastY);
    const QPoint places[] = {{point.x() + kApart, y},
                             {point.x() - kApart - box.width(), y},
                             {x, point.y() + kApart},
                             {x, point.y() - kApart - box.height()}};
    const auto *found = std::ranges::find_if(places, [&](const QPoint &place) { return room.contains(QRect(place, box)); });
    if (found != std::end(places))
        return *found;
    return {point.x() < room.center().x() ? std::max(room.left(), lastX) : room.left(),
            point.y() < room.center().y() ? std::max(room.top(), lastY) : room.top()};
}

} // namespace skyseal::ui
