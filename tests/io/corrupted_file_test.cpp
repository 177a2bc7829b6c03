#include <foldless/io/complete_appearance.h>
#include <foldless/io/defects.h>
#include <foldless/io/file_type.h>
#include <foldless/io/raw_mesh.h>
#include <foldless/io/read_obj.h>
#include <foldless/io/read_off.h>
#include <foldless/io/read_ply.h>
#include <foldless/io/read_stl.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace foldless {
namespace {

struct Sample {
    const char* name;
    std::string bytes;
};

std::string binary_ply() {
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
                               "property float y\nproperty float z\nelement face 2\nproperty list uchar int "
                               "vertex_indices\nproperty float t_min\nproperty float t_max\nend_header\n";
    const std::string face("\3\0\0\0\0\1\0\0\0\2\0\0\0\0\0\0\0\0\0\0\0", 21);
    return header + std::string(36, '\0') + face + face;
}

std::string coloured_binary_ply() {
    const std::string header =
        "ply\nformat binary_big_endian 1.0\ncomment TextureFile a b.png\nelement vertex 3\n"
        "property float x\nproperty float y\nproperty float z\nproperty ushort red\n"
        "property ushort green\nproperty ushort blue\nelement face 1\nproperty list uchar int "
        "vertex_indices\nproperty list uchar float texcoord\nproperty uchar texnumber\nend_header\n";
    const std::string face("\3\0\0\0\0\0\0\0\1\0\0\0\2\6", 14);
    return header + std::string(3 * 18, '\0') + face + std::string(24 + 1, '\0');
}

const Sample samples[] = {
    {"a.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty double y\nproperty int z\n"
              "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
              "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n4 0 1 3 2\n"},
    {"b.ply", binary_ply()},
    {"c.ply",
     "ply\nformat ascii 1.0\ncomment TextureFile a.png\nelement vertex 4\nproperty float x\nproperty float y\n"
     "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty float s\n"
     "property float t\nelement face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
     "property int texnumber\nend_header\n0 0 0 1 2 3 0 1\n1 0 0 1 2 3 1 0\n0 1 0 1 2 3 0 0\n1 1 0 1 2 3 1 1\n"
     "3 0 1 2 0 0\n4 0 1 3 2 8 1 1 0 0 1 0 1 0 -1\n"},
    {"d.ply", coloured_binary_ply()},
    {"b.obj", "mtllib a.mtl\nv 0 0 0 1 0.5 0\nv 1 0 0 1 0 0\nv 0 1 0 0 0 1\nv 1 1 0 0 0 0\nvt 0.5 1\nvt 1\nusemtl a b\n"
              "f 1/1 2/2 3/-1\nf -4/1 -3/2 -1/-1 -2/1\n"},
    {"b.off",
     "STCOFF\n4 2 0\n0 0 0 255 0 0 0 1\n1 0 0 9 9 9 0 0\n0 1 0 0 0 1 1 1\n1 1 0 1 2 3 1 0\n3 0 1 2 9\n4 0 1 3 2\n"},
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf -4 -3 -1 -2\n"},
    {"a.off", "COFF\n4 2 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 0 1\n3 0 1 2 9\n4 0 1 3 2\n"},
    {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
              "endsolid\n"},
    {"b.stl", std::string(80, 'h') + std::string("\1\0\0\0", 4) + std::string(50, '\0')},
};

std::string corrupted(std::string bytes, std::mt19937& random) {
    const std::string replacements = "0123456789-+.eE \n\r/#\\xnai\x7f\xff";
    const auto below = [&random](std::size_t end) { return random() % end; };
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        const std::size_t at = below(bytes.size());
        switch (below(4)) {
        case 0: bytes.erase(at, 1 + below(4)); break;
        case 1: bytes.insert(at, 1 + below(3), replacements[below(replacements.size())]); break;
        default: bytes[at] = below(2) == 0 ? replacements[below(replacements.size())] : static_cast<char>(below(256));
        }
        bytes += bytes.empty() ? " " : "";
    }
    return bytes;
}

RawMesh read(std::string_view name, std::string_view bytes, Content content) {
    switch (file_type(name)) {
    case FileType::ply: return read_ply(bytes, "f", content);
    case FileType::obj: return read_obj(bytes, "f", content);
    case FileType::off: return read_off(bytes, "f", content);
    default: return read_stl(bytes, "f");
    }
}

void expect_sound(const RawAppearance& appearance, const RawMesh& mesh) {
    const auto fits = [](std::size_t size, std::size_t count) { return size == 0 || size == count; };
    EXPECT_TRUE(fits(appearance.colours.size(), mesh.positions.size()));
    EXPECT_TRUE(fits(appearance.texture_coordinates.size(), mesh.faces.size()));
    EXPECT_TRUE(fits(appearance.material_of_face.size(), mesh.faces.size()));
    EXPECT_TRUE(std::ranges::all_of(appearance.colours, [](const Eigen::Vector3f& colour) {
        return colour.minCoeff() >= 0.0F && colour.maxCoeff() <= 1.0F; // false for NaN
    }));
    EXPECT_TRUE(std::ranges::all_of(appearance.material_of_face, [&](std::int32_t material) {
        return material >= -1 && material < static_cast<std::int32_t>(appearance.materials.size());
    }));
}

/// Reads and inspects, from memory that ends with the bytes, so that a sanitizer sees what is read behind them. What is
/// wrong must come as an exception with a message of one line; what is read must have indices in range.
void expect_read_or_refused(std::string_view name, std::string_view bytes) {
    const std::vector<char> exact(bytes.begin(), bytes.end());
    for (const Content content : {Content::scan, Content::coloured_scan, Content::base_mesh}) {
        try {
            RawMesh mesh = read(name, {exact.data(), exact.size()}, content);
            static_cast<void>(refused_polygons_text(mesh));
            complete_appearance(mesh);
            expect_sound(mesh.appearance, mesh);
            EXPECT_EQ(inspect({mesh.positions, mesh.faces, false}).defects.index_out_of_range, 0U);
        } catch (const UnreadableFile& error) {
            EXPECT_EQ(std::string(error.what()).find_first_of("\n\r"), std::string::npos) << error.what();
        }
    }
}

TEST(CorruptedFile, SamplesAreWholeBeforeTheyAreCorrupted) {
    for (const auto& [name, bytes] : samples) {
        EXPECT_GT(scan_of(name, bytes).scan.faces.size(), 0U) << name;
        EXPECT_GT(coloured_scan_of(name, bytes).scan.faces.size(), 0U) << name;
    }
}

TEST(CorruptedFile, IsReadOrRefusedInOneLine) {
    constexpr int rounds = 5000;
    std::mt19937 random(20230914);
    for (int round = 0; round < rounds; ++round) {
        for (const auto& [name, bytes] : samples) {
            SCOPED_TRACE(testing::Message() << name << " in round " << round);
            expect_read_or_refused(name, corrupted(bytes, random));
        }
    }
}

TEST(CorruptedFile, CutAnywhereIsReadOrRefusedInOneLine) {
    for (const auto& [name, bytes] : samples) {
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            expect_read_or_refused(name, bytes.substr(0, size));
        }
    }
}

TEST(CorruptedFile, UnderAnyOtherNameIsReadOrRefusedInOneLine) {
    for (const auto& [name, bytes] : samples) {
        for (const char* other : {"x.ply", "x.obj", "x.off", "x.stl"}) {
            expect_read_or_refused(other, bytes);
        }
    }
}

} // namespace
} // namespace foldless
