// Home: where the vehicle returns to. The first fix and every arming set it, until the operator places it.
#pragma once

#include "core/sim/vector3.h"

#include <optional>

namespace skyseal::sim {

class Home
{
public:
    /// m, NED from the origin; nullopt before the first fix.
    const std::optional<Vector3> &position() const { return m_position; }
    /// The origin before the first fix.
    Vector3 orOrigin() const { return m_position.value_or(Vector3{}); }

    /// Where the vehicle stands, unless the operator has placed home.
    void follow(const Vector3 &place)
    {
        if (!m_placed)
            m_position = place;
    }
    /// By request of the operator.
    void place(const Vector3 &place)
    {
        m_position = place;
        m_placed = true;
    }

private:
    std::optional<Vector3> m_position;
    bool m_placed = false;
};

} // namespace skyseal::sim
