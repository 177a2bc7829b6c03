/// \file
/// Random triangles and points for the tests of the predicates; the same ones in every run.
#pragma once

#include <foldless/predicates/vector.h>

#include <cmath>
#include <random>

namespace foldless {

class RandomTriangles {
public:
    explicit RandomTriangles(unsigned seed) : generator_(seed) {}

    double number(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(generator_); }

    Vec3 vector(double size = 1.0) { return {number(-size, size), number(-size, size), number(-size, size)}; }

    /// Coordinates that are multiples of 2^-bits in [-1, 1].
    Vec3 dyadic(int bits) {
        return (vector() * std::ldexp(1.0, bits)).array().round().matrix() * std::ldexp(1.0, -bits);
    }

    /// Uniform in the triangle.
    Vec3 barycentric() {
        double beta = number(0.0, 1.0);
        double gamma = number(0.0, 1.0);
        if (beta + gamma > 1.0) {
            beta = 1.0 - beta;
            gamma = 1.0 - gamma;
        }
        return {1.0 - beta - gamma, beta, gamma};
    }

    /// Corners and directions without any order: many folds, up to three solutions.
    BaseTriangle wild() { return {{vector(), vector(), vector()}, {vector(), vector(), vector()}}; }

    /// A flat triangle with directions near its normal, as a base mesh has.
    BaseTriangle tame() {
        BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
        for (Vec3& v : triangle.v) {
            v += vector(0.2);
        }
        for (Vec3& d : triangle.d) {
            d = Vec3(0, 0, 1) + vector(0.3);
        }
        return triangle;
    }

private:
    std::mt19937_64 generator_;
};

/// The direct problem: F(alpha, t) = sum alpha_i (v_i + t d_i).
inline Vec3 displaced(const BaseTriangle& triangle, const Vec3& alpha, double t) {
    return alpha[0] * triangle.corner(0, t) + alpha[1] * triangle.corner(1, t) + alpha[2] * triangle.corner(2, t);
}

} // namespace foldless
