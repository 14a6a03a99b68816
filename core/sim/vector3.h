// Three components and the few operations that flight mechanics needs. Frames are named where the values are declared:
// NED (north, east, down) for the world, FRD (forward, right, down) for the body.
#pragma once

#include <cmath>

namespace skyseal::sim {

struct Vector3
{
    double x = 0;
    double y = 0;
    double z = 0;

    Vector3 operator+(const Vector3 &o) const { return {x + o.x, y + o.y, z + o.z}; }
    Vector3 operator-(const Vector3 &o) const { return {x - o.x, y - o.y, z - o.z}; }
    Vector3 operator-() const { return {-x, -y, -z}; }
    Vector3 operator*(double k) const { return {x * k, y * k, z * k}; }
    Vector3 &operator+=(const Vector3 &o) { return *this = *this + o; }
    bool operator==(const Vector3 &) const = default;

    double length() const { return std::sqrt(x * x + y * y + z * z); }
    /// Length of the horizontal part.
    double horizontal() const { return std::sqrt(x * x + y * y); }
    /// The same vector with its horizontal part cut to `limit`.
    Vector3 horizontalLimited(double limit) const
    {
        const double size = horizontal();
        return size > limit ? Vector3{x * limit / size, y * limit / size, z} : *this;
    }
    bool finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
};

inline Vector3 cross(const Vector3 &a, const Vector3 &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace skyseal::sim
