#include <foldless/bench/inversion_cases.h>

#include <foldless/decimate/prismoid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace foldless {
namespace {

class RandomCases {
public:
    double number(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(generator_); }

    Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

    /// Uniform in the triangle.
    Vec3 barycentric() {
        const auto [lesser, greater] = std::minmax({number(0, 1), number(0, 1)});
        return {lesser, greater - lesser, 1 - greater};
    }

    double displacement() { return number(bench_range.lo, bench_range.hi); }

    /// A triangle with directions within some 20 degrees of its normal.
    BaseTriangle triangle() {
        BaseTriangle triangle{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
        for (int k = 0; k < 3; ++k) {
            triangle.v[k] += vector(0.2);
            triangle.d[k] = Vec3(0, 0, 1) + vector(0.3);
        }
        return triangle;
    }

private:
    std::mt19937_64 generator_{2002};
};

Vec3 displaced(const BaseTriangle& triangle, const Vec3& alpha, double t) {
    return alpha[0] * triangle.corner(0, t) + alpha[1] * triangle.corner(1, t) + alpha[2] * triangle.corner(2, t);
}

} // namespace

std::vector<InversionCase> inversion_cases() {
    RandomCases random;
    std::vector<InversionCase> cases(case_count);
    for (InversionCase& made : cases) {
        made.triangle = random.triangle();
        made.alpha = random.barycentric();
        made.t = random.displacement();
        made.q = displaced(made.triangle, made.alpha, made.t);
    }
    return cases;
}

std::vector<BatchCase> batch_cases() {
    constexpr std::size_t batches_per_triangle = 8;
    RandomCases random;
    std::vector<BatchCase> cases(case_count);
    for (std::size_t i = 0; i < case_count; ++i) {
        BatchCase& made = cases[i];
        made.triangle = i % batches_per_triangle == 0 ? random.triangle() : cases[i - 1].triangle;
        for (int k = 0; k < PointBatch::capacity; ++k) {
            const Vec3 alpha = random.barycentric();
            const double t = random.displacement();
            const Vec3 q = displaced(made.triangle, alpha, t);
            made.inside.push_back(q, bench_range);
            const Vec3 beside(-alpha[0], alpha[1] + alpha[0], alpha[2] + alpha[0]);
            const std::array<Vec3, 4> others{q, q, displaced(made.triangle, beside, t),
                                             displaced(made.triangle, alpha, t + std::copysign(0.4, t))};
            made.mixed.push_back(others[static_cast<std::size_t>(random.number(0, 4))], bench_range);
        }
        made.bracketed = made.inside;
        static_cast<void>(Prismoid(made.triangle, bench_range).displacements(made.bracketed, InstructionSet::scalar));
    }
    return cases;
}

std::vector<WallCase> wall_cases() {
    RandomCases random;
    std::vector<WallCase> cases(case_count);
    for (WallCase& made : cases) {
        made.triangle = random.triangle();
        const Vec3 inner = random.barycentric();
        // Mirrored at the edge from corner 1 to corner 2: the edge of the scan meets that wall near its middle.
        const Vec3 outer(-inner[0], inner[1] + inner[0], inner[2] + inner[0]);
        made.a = displaced(made.triangle, inner, random.displacement());
        made.e = displaced(made.triangle, outer, random.displacement()) - made.a;
    }
    return cases;
}

} // namespace foldless
