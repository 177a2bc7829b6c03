/// \file
/// Vectors of rational numbers: an oracle for signs and error bounds.
#pragma once

#include <foldless/predicates/vector.h>

#include <gmpxx.h>

#include <array>
#include <cmath>

namespace foldless::exact {

/// Three rational components; every double is one.
struct Vector {
    mpq_class x, y, z;

    Vector(const mpq_class& x_value, const mpq_class& y_value, const mpq_class& z_value)
        : x(x_value), y(y_value), z(z_value) {}
    Vector(const Vec3& v) : x(v.x()), y(v.y()), z(v.z()) {} // NOLINT: every Vec3 is one
};

inline Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(const mpq_class& s, const Vector& a) {
    return {s * a.x, s * a.y, s * a.z};
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline mpq_class dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a_i(t) of a base triangle.
inline Vector corner(const BaseTriangle& triangle, int i, const mpq_class& t) {
    return Vector(triangle.v[i]) + t * Vector(triangle.d[i]);
}

} // namespace foldless::exact
