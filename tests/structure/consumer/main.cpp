// An outside program: repairs a cube whose sides are grids, decimates it, and has the result verified.
#include <foldless/decimate/decimate.h>
#include <foldless/repair/repair.h>
#include <foldless/verify/verify.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>

namespace {

constexpr int grid = 4; // cells along an edge of the cube

// Collects the vertices of a mesh by their integer coordinates, each once.
class CubeBuilder {
public:
    // The side of the cube where the coordinate `axis` is `level` (0 or grid), its faces outwards.
    void add_side(int axis, int level) {
        for (int a = 0; a < grid; ++a) {
            for (int b = 0; b < grid; ++b) {
                const std::int32_t corner[4] = {vertex(axis, level, a, b), vertex(axis, level, a + 1, b),
                                                vertex(axis, level, a + 1, b + 1), vertex(axis, level, a, b + 1)};
                add_face(corner[0], corner[1], corner[2], level == 0);
                add_face(corner[0], corner[2], corner[3], level == 0);
            }
        }
    }

    foldless::Scan take() { return std::move(scan_); }

private:
    std::int32_t vertex(int axis, int level, int a, int b) {
        std::array<int, 3> point{};
        point[axis] = level;
        point[(axis + 1) % 3] = a;
        point[(axis + 2) % 3] = b;
        const auto [entry, is_new] = index_.try_emplace(point, static_cast<std::int32_t>(scan_.positions.size()));
        if (is_new) {
            scan_.positions.emplace_back(point[0], point[1], point[2]);
        }
        return entry->second;
    }

    void add_face(std::int32_t a, std::int32_t b, std::int32_t c, bool reversed) {
        scan_.faces.push_back(reversed ? foldless::Triangle{a, c, b} : foldless::Triangle{a, b, c});
    }

    foldless::Scan scan_;
    std::map<std::array<int, 3>, std::int32_t> index_;
};

foldless::Scan cube() {
    CubeBuilder builder;
    for (int axis = 0; axis < 3; ++axis) {
        builder.add_side(axis, 0);
        builder.add_side(axis, grid);
    }
    return builder.take();
}

// Differs where any bit of the base mesh differs.
unsigned long long digest(const foldless::BaseMesh& base) {
    unsigned long long sum = 0xcbf29ce484222325;
    const auto add = [&sum](const auto& number) {
        unsigned char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        for (const unsigned char byte : bytes) {
            sum = (sum ^ byte) * 0x100000001b3;
        }
    };
    for (const auto* vectors : {&base.positions, &base.directions}) {
        for (const foldless::Vec3& vector : *vectors) {
            add(vector[0]), add(vector[1]), add(vector[2]);
        }
    }
    for (const foldless::Triangle& face : base.faces) {
        add(face);
    }
    for (const foldless::Range& range : base.ranges) {
        add(range.lo), add(range.hi);
    }
    return sum;
}

} // namespace

int main() {
    const foldless::Scan scan = foldless::repair(cube()).scan;
    const foldless::DecimateResult result = foldless::decimate(scan);
    const foldless::VerifyResult proof = foldless::verify(result.base, scan);
    std::printf("%zu faces in, %zu faces out, %zu violations, digest %016llx\n", scan.faces.size(),
                result.base.faces.size(), proof.violation_total(), digest(result.base));
    return proof.certified() && result.base.faces.size() < scan.faces.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
