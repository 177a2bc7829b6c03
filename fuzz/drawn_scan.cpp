#include "drawn_scan.h"

#include "subdivided.h"

#include <foldless/io/float32.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace foldless::fuzz {
namespace {

/// Two triangles for each cell of a grid of this many vertices each way; the last are joined to the first if closed.
std::vector<Triangle> cells(int rows, int columns, bool closed) {
    std::vector<Triangle> faces;
    const auto at = [&](int i, int j) { return static_cast<std::int32_t>(i % rows * columns + j % columns); };
    const int open = closed ? 0 : 1;
    for (int i = 0; i < rows - open; ++i) {
        for (int j = 0; j < columns - open; ++j) {
            faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return faces;
}

Scan height_field(ByteSource& bytes, Grain grain) {
    const int rows = 2 + bytes.below(9);
    const int columns = 2 + bytes.below(9);
    Scan scan{{}, cells(rows, columns, false)};
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            scan.positions.emplace_back(i, j, 0.25 * drawn_number(bytes, grain));
        }
    }
    return scan;
}

/// Heights from a byte stream are spikes; most scans are smooth but for a few of them.
Scan waves(ByteSource& bytes) {
    Scan scan = height_field(bytes, Grain::coarse);
    const double slope = bytes.fraction(128);
    const double height = bytes.fraction(128);
    for (Vec3& p : scan.positions) {
        p.z() = height * std::sin(slope * p.x() + p.y()) + 0.0625 * p.z();
    }
    return scan;
}

Scan sphere(ByteSource& bytes, Grain grain) {
    const Scan octahedron{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    Scan scan = octahedron;
    for (int level = bytes.below(3); level > 0; --level) {
        scan = test::subdivided(scan);
    }
    for (Vec3& p : scan.positions) {
        p *= 1 + 0.0625 * drawn_number(bytes, grain);
    }
    return scan;
}

Scan torus(ByteSource& bytes, Grain grain) {
    const int around = 3 + bytes.below(8);
    const int across = 3 + bytes.below(5);
    Scan scan{{}, cells(around, across, true)};
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double u = 2 * std::numbers::pi * i / around;
            const double v = 2 * std::numbers::pi * j / across;
            const double r = 1 + 0.45 * std::cos(v);
            scan.positions.push_back(Vec3(r * std::cos(u), r * std::sin(u), 0.45 * std::sin(v)) *
                                     (1 + 0.03125 * drawn_number(bytes, grain)));
        }
    }
    return scan;
}

Scan soup(ByteSource& bytes, Grain grain) {
    Scan scan;
    const int vertices = 3 + bytes.below(20);
    for (int v = 0; v < vertices; ++v) {
        scan.positions.push_back(drawn_vector(bytes, grain));
    }
    for (int faces = bytes.below(60); faces > 0; --faces) {
        Triangle face{};
        for (std::int32_t& v : face) {
            v = bytes.below(vertices);
        }
        scan.faces.push_back(face);
    }
    return scan;
}

Scan drawn_surface(ByteSource& bytes, Grain grain) {
    switch (bytes.below(8)) {
    case 0: return soup(bytes, grain);
    case 1: return torus(bytes, grain);
    case 2: return height_field(bytes, grain);
    case 3:
    case 4: return waves(bytes);
    default: return sphere(bytes, grain);
    }
}

/// Puts a vertex into the face, somewhere over it.
void split(Scan& scan, std::size_t face, ByteSource& bytes) {
    const auto [a, b, c] = scan.faces[face];
    const auto next = static_cast<std::int32_t>(scan.positions.size());
    scan.positions.push_back(0.25 * scan.positions[a] + 0.25 * scan.positions[b] + 0.5 * scan.positions[c] +
                             0.0625 * drawn_vector(bytes, Grain::coarse));
    scan.faces[face] = {a, b, next};
    scan.faces.push_back({b, c, next});
    scan.faces.push_back({c, a, next});
}

void edit(Scan& scan, ByteSource& bytes) {
    const std::size_t face = bytes.bits<std::uint8_t>() % scan.faces.size();
    const std::size_t vertex = bytes.bits<std::uint8_t>() % scan.positions.size();
    switch (bytes.below(6)) {
    case 0: scan.faces.erase(scan.faces.begin() + static_cast<std::ptrdiff_t>(face)); break;
    case 1: split(scan, face, bytes); break;
    case 2: scan.positions[vertex] += 0.125 * drawn_vector(bytes, Grain::coarse); break;
    case 3: scan.positions[vertex] += 0x1p-20 * drawn_vector(bytes, Grain::fine); break;
    case 4: scan.positions[vertex] = scan.positions[scan.faces[face][0]]; break;
    default: scan.faces[face][bytes.below(3)] = static_cast<std::int32_t>(vertex); break;
    }
}

} // namespace

Scan drawn_scan(ByteSource& bytes) {
    const auto grain = static_cast<Grain>(bytes.below(grains));
    const int edits = bytes.below(8);
    const double unit = std::ldexp(1.0, bytes.below(8) == 0 ? bytes.bits<std::int8_t>() : 0);
    Scan scan = drawn_surface(bytes, grain);
    for (int i = 0; i < edits && !scan.faces.empty(); ++i) {
        edit(scan, bytes);
    }
    const bool is_float32 = !bytes.flag();
    scan.float32 = true;
    for (Vec3& p : scan.positions) {
        p *= unit;
        p = is_float32 && p.cwiseAbs().maxCoeff() < 0x1p127 ? to_float32(p) : p;
        scan.float32 = scan.float32 && foldless::is_float32(p);
    }
    return scan;
}

DecimateOptions drawn_options(ByteSource& bytes) {
    DecimateOptions options = bytes.below(5) == 0 ? paper_options() : DecimateOptions{};
    options.directions = static_cast<Directions>(bytes.below(4));
    options.store_directions = bytes.flag();
    options.placement = static_cast<Placement>(bytes.below(4));
    options.boundary = static_cast<Boundary>(bytes.below(2));
    options.unique_among_fold_free = bytes.below(4) == 0;
    options.orientation_test = bytes.below(4) == 0;
    options.edge_valence_limit = 4 + bytes.below(20);
    if (bytes.flag()) {
        options.target_faces = 1 + bytes.bits<std::uint8_t>();
    }
    if (bytes.below(4) == 0) {
        options.max_displacement = std::abs(bytes.fraction(64));
    }
    options.threads = 1;
    return options;
}

} // namespace foldless::fuzz
