#include <foldless/io/scan_appearance.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace foldless {
namespace {

using Colours = std::vector<Eigen::Vector3f>;
using Notes = std::vector<std::string>;
using Paths = std::vector<std::filesystem::path>;
using Numbers = std::vector<std::int32_t>;

struct UV {
    float u;
    float v;
};

constexpr float none = std::numeric_limits<float>::quiet_NaN();

bool same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

void expect_texture(const ReadColouredScan& read, const std::vector<std::array<UV, 3>>& expected) {
    ASSERT_EQ(read.appearance.texture_coordinates.size(), expected.size());
    for (std::size_t face = 0; face < expected.size(); ++face) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector2f found = read.appearance.texture_coordinates[face][i];
            EXPECT_TRUE(same(found.x(), expected[face][i].u)) << face << " " << i << ": " << found.x();
            EXPECT_TRUE(same(found.y(), expected[face][i].v)) << face << " " << i << ": " << found.y();
        }
    }
}

void expect_bare(const ReadColouredScan& read) {
    EXPECT_TRUE(read.appearance.vertex_colours.empty());
    EXPECT_TRUE(read.appearance.texture_coordinates.empty());
    EXPECT_TRUE(read.appearance.textures.empty());
    EXPECT_TRUE(read.appearance.texture_of_face.empty());
}

/// A PLY triangle, or as many faces as there are lines; `vertices` and `faces` are what follows in a line.
struct PlyParts {
    std::string comments;
    std::string vertex_properties;
    std::array<std::string, 3> vertices;
    std::string face_properties;
    std::vector<std::string> faces{"3 0 1 2"};
};

std::string ply(const PlyParts& parts) {
    std::string text = "ply\nformat ascii 1.0\n" + parts.comments +
                       "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
                       parts.vertex_properties + "element face " + std::to_string(parts.faces.size()) +
                       "\nproperty list uchar int vertex_indices\n" + parts.face_properties + "end_header\n";
    const char* const corners[] = {"0 0 0 ", "1 0 0 ", "0 1 0 "};
    for (std::size_t i = 0; i < 3; ++i) {
        text += corners[i] + parts.vertices[i] + "\n";
    }
    for (const std::string& face : parts.faces) {
        text += face + "\n";
    }
    return text;
}

std::string properties(const std::string& type, const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        text.append("property ").append(type).append(" ").append(name).append("\n");
    }
    return text;
}

TEST(ScanAppearance, IsEmptyOfABareFile) {
    expect_bare(coloured_scan_of("a.ply", ply({})));
    expect_bare(coloured_scan_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    expect_bare(coloured_scan_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
    const ReadColouredScan stl =
        coloured_scan_of("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                  "endloop\nendfacet\nendsolid\n");
    expect_bare(stl);
    EXPECT_EQ(stl.scan.faces.size(), 1U);
    EXPECT_EQ(stl.notes.ignored, (Notes{"normals"}));
}

TEST(PlyAppearance, ReadsColoursOfEveryType) {
    struct Typed {
        const char* type;
        std::array<std::string, 3> vertices;
    };
    const Typed cases[] = {
        {"uchar", {"255 51 0", "0 255 0", "0 0 255"}}, {"ushort", {"65535 13107 0", "0 65535 0", "0 0 65535"}},
        {"int", {"255 51 0", "0 255 0", "0 0 255"}},   {"float", {"1 0.2 0", "0 1 0", "0 0 1"}},
        {"float", {"255 51 0", "0 255 0", "0 0 255"}}, {"double", {"1 0.2 0", "0 1 0", "0 0 1"}}};
    for (const auto& [type, vertices] : cases) {
        for (const std::vector<std::string>& names : {std::vector<std::string>{"red", "green", "blue"},
                                                      {"diffuse_red", "diffuse_green", "diffuse_blue"},
                                                      {"r", "g", "b"}}) {
            const ReadColouredScan read = coloured_scan_of("a.ply", ply({.comments = {},
                                                                         .vertex_properties = properties(type, names),
                                                                         .vertices = vertices,
                                                                         .face_properties = {}}));
            EXPECT_EQ(read.appearance.vertex_colours, (Colours{{1, 0.2F, 0}, {0, 1, 0}, {0, 0, 1}}))
                << type << names[0];
            EXPECT_TRUE(read.notes.ignored.empty());
        }
    }
}

TEST(PlyAppearance, TakesDarkBytesForBytes) {
    const std::string text = ply({.comments = {},
                                  .vertex_properties = properties("uchar", {"red", "green", "blue"}),
                                  .vertices = {"1 1 1", "0 0 1", "0 0 0"},
                                  .face_properties = {}});
    EXPECT_EQ(coloured_scan_of("a.ply", text).appearance.vertex_colours[1], Eigen::Vector3f(0, 0, 1 / 255.0F));
}

TEST(PlyAppearance, ReadsBinaryColoursAndTextures) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment TextureFile a.png\ncomment TextureFile b.png\n"
                        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
                        properties("uchar", {"red", "green", "blue", "alpha"}) +
                        "element face 1\nproperty list uchar float texcoord\nproperty list uchar int vertex_indices\n"
                        "property char texnumber\nend_header\n";
    const auto add = [&bytes](auto... values) {
        const auto add_one = [&bytes](auto value) {
            char stored[sizeof(value)];
            std::memcpy(stored, &value, sizeof(value));
            bytes.append(stored, sizeof(value));
        };
        (add_one(values), ...);
    };
    static_assert(std::endian::native == std::endian::little);
    for (const float x : {0.0F, 1.0F, 2.0F}) {
        add(x, x * x, 0.0F, std::uint8_t{255}, std::uint8_t{0}, std::uint8_t{51}, std::uint8_t{255});
    }
    add(std::uint8_t{6}, 0.0F, 0.25F, 1.0F, 0.5F, -1.0F, 2.0F);
    add(std::uint8_t{3}, std::int32_t{0}, std::int32_t{1}, std::int32_t{2}, std::int8_t{1});
    const ReadColouredScan read = coloured_scan_of("a.ply", bytes);
    EXPECT_EQ(read.appearance.vertex_colours, Colours(3, {1, 0, 0.2F}));
    expect_texture(read, {{{{0, 0.25F}, {1, 0.5F}, {-1, 2}}}});
    EXPECT_EQ(read.appearance.texture_of_face, (Numbers{1}));
    EXPECT_EQ(read.notes.ignored, (Notes{"alpha"}));
}

TEST(PlyAppearance, ReadsTextureCoordinatesOfVertices) {
    for (const std::vector<std::string>& names :
         {std::vector<std::string>{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
        const ReadColouredScan read = coloured_scan_of("a.ply", ply({.comments = "comment TextureFile a.png\n",
                                                                     .vertex_properties = properties("float", names),
                                                                     .vertices = {"0 0.5", "1 0", "-2 3"},
                                                                     .face_properties = {},
                                                                     .faces = {"3 2 0 1"}}));
        expect_texture(read, {{{{-2, 3}, {0, 0.5F}, {1, 0}}}});
        EXPECT_EQ(read.appearance.texture_of_face, (Numbers{0}));
        EXPECT_TRUE(read.notes.ignored.empty());
    }
}

TEST(PlyAppearance, FansTextureCoordinatesAndNumbersWithTheirPolygon) {
    const std::string text =
        "ply\nformat ascii 1.0\ncomment TextureFile a.png\ncomment TextureFile b c.png\nelement vertex 4\n"
        "property float x\nproperty float y\nproperty float z\nelement face 3\nproperty list uchar int vertex_indices\n"
        "property list uchar float texcoord\nproperty int texnumber\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
        "4 0 1 2 3 8 0 0 1 0 1 1 0 1 1\n3 0 1 2 0 -1\n3 2 1 0 6 5 5 6 6 7 7 0\n";
    const ReadColouredScan read = coloured_scan_of("a.ply", text);
    EXPECT_EQ(read.scan.faces, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {2, 1, 0}}));
    expect_texture(read, {{{{0, 0}, {1, 0}, {1, 1}}},
                          {{{0, 0}, {1, 1}, {0, 1}}},
                          {{{none, none}, {none, none}, {none, none}}},
                          {{{5, 5}, {6, 6}, {7, 7}}}});
    EXPECT_EQ(read.appearance.texture_of_face, (Numbers{1, 1, -1, 0}));
    ASSERT_EQ(read.appearance.textures.size(), 2U);
    EXPECT_EQ(read.appearance.textures[1].filename(), "b c.png");
    EXPECT_EQ(read.appearance.textures[1].parent_path(), read.appearance.textures[0].parent_path());
}

TEST(PlyAppearance, NotesOnlyWhatItStillIgnores) {
    struct Noted {
        PlyParts parts;
        Notes notes;
    };
    const std::string bytes = properties("uchar", {"red", "green", "blue"});
    const std::array<std::string, 3> black{"0 0 0", "0 0 0", "0 0 0"};
    const std::array<std::string, 3> pair{"0 0", "0 0", "0 0"};
    const Noted cases[] = {
        {{"", bytes, black, "", {"3 0 1 2"}}, {}},
        {{"", properties("uchar", {"red", "green"}), pair, "", {"3 0 1 2"}}, {"colours"}},
        {{"", properties("uchar", {"red", "green"}) + "property float blue\n", black, "", {"3 0 1 2"}}, {"colours"}},
        {{"", properties("float", {"s", "v"}), pair, "", {"3 0 1 2"}}, {"texture coordinates"}},
        {{"", "property list uchar float s\nproperty float t\n", {"0 0", "0 0", "0 0"}, "", {"3 0 1 2"}},
         {"texture coordinates"}},
        {{"", "", {}, bytes, {"3 0 1 2 1 1 1"}}, {"face colours"}},
        {{"", "", {}, "property int texnumber\n", {"3 0 1 2 7"}}, {"texture numbers"}},
        {{"", "", {}, "property float texcoord\n", {"3 0 1 2 7"}}, {"texture coordinates"}},
        {{"comment TextureFile a\ncomment TextureFile b\n", "", {}, "", {"3 0 1 2"}}, {"textures but the first"}},
        {{"", properties("float", {"nx", "quality"}), pair, "", {"3 0 1 2"}}, {"normals", "property 'quality'"}},
    };
    for (const auto& [parts, notes] : cases) {
        EXPECT_EQ(coloured_scan_of("a.ply", ply(parts)).notes.ignored, notes) << ply(parts);
    }
}

TEST(PlyAppearance, TakesTheFirstSetOfNames) {
    const std::string text =
        ply({.comments = {},
             .vertex_properties =
                 properties("float", {"diffuse_red", "diffuse_green", "diffuse_blue", "red", "green", "blue"}),
             .vertices = {"0 0 0 1 1 1", "0 0 0 1 1 1", "0 0 0 1 1 1"},
             .face_properties = {}});
    const ReadColouredScan read = coloured_scan_of("a.ply", text);
    EXPECT_EQ(read.appearance.vertex_colours, Colours(3, {1, 1, 1}));
    EXPECT_EQ(read.notes.ignored, (Notes{"colours"}));
}

TEST(PlyAppearance, LeavesOtherCommentsAlone) {
    for (const char* comment : {"comment TextureFile\n", "comment TextureFiles a.png\n", "comment textures: a.png\n",
                                "obj_info a\n", "comment \x01\x02\n", "comment Texture\n"}) {
        const ReadColouredScan read = coloured_scan_of(
            "a.ply", ply({.comments = comment, .vertex_properties = {}, .vertices = {}, .face_properties = {}}));
        EXPECT_TRUE(read.appearance.textures.empty()) << comment;
    }
}

TEST(PlyAppearance, IsUnreadableWhereNumbersAreNone) {
    const std::string colours = properties("float", {"red", "green", "blue"});
    const std::string textured = "property list uchar double texcoord\nproperty int texnumber\n";
    struct Malformed {
        PlyParts parts;
        const char* message;
    };
    const Malformed cases[] = {
        {{"", colours, {"0 0 0", "0 nan 0", "0 0 0"}, "", {"3 0 1 2"}}, "line 14: a colour is not a finite number"},
        {{"", colours, {"0 0 0", "0 inf 0", "0 0 0"}, "", {"3 0 1 2"}}, "line 14: a colour is not a finite number"},
        {{"", colours, {"0 0 0", "0 x 0", "0 0 0"}, "", {"3 0 1 2"}}, "line 14: 'x' for green is not a number"},
        {{"", colours + "property float red\n", {"0 0 0 0", "0 0 0 0", "0 0 0 0"}, "", {"3 0 1 2"}},
         "line 14: property 'red' of element 'vertex' is declared twice"},
        {{"", properties("double", {"s", "t"}), {"0 0", "0 0", "0 1e300"}, "", {"3 0 1 2"}},
         "line 14: a texture coordinate is not a finite number"},
        {{"comment TextureFile a\n", "", {}, textured, {"3 0 1 2 6 0 0 0 0 nan 0 0"}},
         "line 16: a texture coordinate is not a finite number"},
        {{"comment TextureFile a\n", "", {}, textured, {"3 0 1 2 4 0 0 0 0 0"}},
         "line 16: texcoord has 4 values for 3 corners"},
        {{"comment TextureFile a\n", "", {}, textured, {"3 0 1 2 8 0 0 0 0 0 0 0 0 0"}},
         "line 16: texcoord has 8 values for 3 corners"},
        {{"comment TextureFile a\n", "", {}, textured, {"3 0 1 2 0 1"}},
         "line 16: texnumber 1 is neither a texture nor -1 (1 texture)"},
        {{"comment TextureFile a\n", "", {}, textured, {"3 0 1 2 0 -2"}},
         "line 16: texnumber -2 is neither a texture nor -1 (1 texture)"},
    };
    for (const auto& [parts, message] : cases) {
        EXPECT_EQ(unreadable_colours("a.ply", ply(parts)), std::string("a.ply: ") + message);
    }
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ObjAppearance, ReadsColoursBehindTheCoordinates) {
    const ReadColouredScan read =
        coloured_scan_of("a.obj", "v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1 # blue\nv 0 1 0 0.25 1 1 1\nf 1 2 3\n");
    EXPECT_EQ(read.appearance.vertex_colours, (Colours{{1, 0.5F, 0}, {0, 0, 1}, {0.25F, 1, 1}}));
    EXPECT_EQ(read.notes.ignored, (Notes{"alpha"}));
    const ReadColouredScan bytes = coloured_scan_of("a.obj", "v 0 0 0 255 0 51\n");
    EXPECT_EQ(bytes.appearance.vertex_colours, (Colours{{1, 0, 0.2F}}));
}

TEST(ObjAppearance, TellsWeightsFromColours) {
    for (const auto& [vertex, note] : {std::pair{"v 0 0 0 1", "vertex weights"}, std::pair{"v 0 0 0 1 1", "colours"},
                                       std::pair{"v 0 0 0 1 1 1 1 1", "colours"}}) {
        const ReadColouredScan read = coloured_scan_of("a.obj", vertex);
        EXPECT_TRUE(read.appearance.vertex_colours.empty()) << vertex;
        EXPECT_EQ(read.notes.ignored, (Notes{note})) << vertex;
    }
    const ReadColouredScan some = coloured_scan_of("a.obj", "v 0 0 0 1 1 1\nv 1 1 1\n");
    EXPECT_TRUE(some.appearance.vertex_colours.empty());
    EXPECT_EQ(some.notes.ignored, (Notes{"colours, which some vertices lack"}));
}

TEST(ObjAppearance, ReadsTextureCoordinatesOfCorners) {
    const std::string text = square + "vt 0 0.5\nvt 1 0 0\nvt 0.25\n";
    for (const char* face : {"f 1/1 2/2 3/3", "f 1/1/1 2/2/9 3/3/-7", "f 1/-3 2/-2 3/-1"}) {
        const ReadColouredScan read = coloured_scan_of("a.obj", text + face + "\n");
        expect_texture(read, {{{{0, 0.5F}, {1, 0}, {0.25F, 0}}}});
        EXPECT_TRUE(read.notes.ignored.empty()) << face;
        EXPECT_TRUE(read.appearance.texture_of_face.empty());
    }
    expect_texture(coloured_scan_of("a.obj", "f 1/2 2/1 3/2\n" + text), {{{{1, 0}, {0, 0.5F}, {1, 0}}}});
    expect_texture(coloured_scan_of("a.obj", text + "f 1/1 2 3//1\nf 1 2 3\n"),
                   {{{{0, 0.5F}, {none, none}, {none, none}}}, {{{none, none}, {none, none}, {none, none}}}});
    expect_texture(coloured_scan_of("a.obj", text + "f 1 2 3\n"), {});
}

TEST(ObjAppearance, NotesTextureIndicesOfAFileWithoutTextureCoordinates) {
    const ReadColouredScan read = coloured_scan_of("a.obj", square + "f 1/1 2/2 3/9\n");
    expect_bare(read);
    EXPECT_EQ(read.notes.ignored, (Notes{"texture indices that name nothing"}));
}

TEST(ObjAppearance, FansTextureCoordinatesWithTheirPolygon) {
    const ReadColouredScan read =
        coloured_scan_of("a.obj", square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/4 2/3 3/2 4/1\n");
    expect_texture(read, {{{{0, 1}, {1, 1}, {1, 0}}}, {{{0, 1}, {1, 0}, {0, 0}}}});
}

TEST(ObjAppearance, IsUnreadableWhereNumbersAreNone) {
    struct Malformed {
        const char* line;
        const char* message;
    };
    const Malformed cases[] = {
        {"vt", "u is missing"},
        {"vt nan 0", "u is not a finite number"},
        {"vt 0 1e300", "v is not a finite number"},
        {"vt 0 x", "'x' for v is not a number"},
        {"v 0 0 0 1 -inf 1", "a colour is not a finite number"},
        {"f 1/2 2/1 3/1\nvt 0 0", "texture index 2 is out of range (1 texture coordinates)"},
        {"f 1/0 2/1 3/1", "texture index 0 is out of range (0 texture coordinates)"},
        {"f 1/-1 2 3", "texture index -1 is out of range (0 texture coordinates)"},
        {"f 1/x 2 3", "'x' for a texture index is not an integer"},
        {"f 1 2 3//x", "'x' for a normal index is not an integer"},
    };
    for (const auto& [line, message] : cases) {
        EXPECT_EQ(unreadable_colours("a.obj", square + line + "\n"), std::string("a.obj: line 5: ") + message) << line;
    }
}

/// An OBJ in a folder of its own, with other files beside it.
class TexturedObj : public testing::Test {
protected:
    [[nodiscard]] ReadColouredScan read(const std::string& statements) const {
        return read_coloured_scan(folder_.file("a.obj", square + statements));
    }
    [[nodiscard]] std::filesystem::path in_folder(const char* name) const { return folder_.path() / name; }

    TemporaryFolder folder_;
};

TEST_F(TexturedObj, FindsThePicturesOfItsMaterials) {
    folder_.file("m.mtl",
                 "newmtl a b\nmap_Kd -s 1 1 1 c d.png\nnewmtl e\nmap_Kd f.png\nnewmtl again\nmap_Kd c d.png\n");
    const ReadColouredScan read_scan =
        read("mtllib m.mtl\nf 1 2 3\nusemtl a b\nf 1 2 3 4\nusemtl e\nf 1 2 3\nusemtl again\n"
             "f 1 2 3\nusemtl a b # c\nf 1 2 3\n");
    EXPECT_EQ(read_scan.appearance.textures, (Paths{in_folder("c d.png"), in_folder("f.png")}));
    EXPECT_EQ(read_scan.appearance.texture_of_face, (Numbers{-1, 0, 0, 1, 0, 0}));
    EXPECT_EQ(read_scan.notes.ignored, (Notes{"texture options"}));
}

TEST_F(TexturedObj, NotesMaterialsWithoutAPicture) {
    folder_.file("m.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nmap_Kd b.png\n");
    const ReadColouredScan some = read("mtllib m.mtl\nusemtl a\nf 1 2 3\nusemtl unknown\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    EXPECT_EQ(some.appearance.texture_of_face, (Numbers{-1, -1, 0}));
    EXPECT_EQ(some.notes.ignored, (Notes{"materials without a picture"}));
    const ReadColouredScan none_at_all = read("mtllib m.mtl\nusemtl a\nf 1 2 3\n");
    expect_bare(none_at_all);
    EXPECT_EQ(none_at_all.notes.ignored, (Notes{"materials without a picture"}));
}

TEST_F(TexturedObj, NotesALibraryThatCannotBeRead) {
    folder_.file("binary.mtl", "newmtl a\n\x01\n");
    for (const char* name : {"missing.mtl", "binary.mtl", ".", "/dev/null"}) {
        const ReadColouredScan read_scan = read(std::string("mtllib ") + name + "\nmtllib " + name + "\nf 1 2 3\n");
        expect_bare(read_scan);
        EXPECT_EQ(read_scan.scan.faces.size(), 1U);
        EXPECT_EQ(read_scan.notes.ignored,
                  (Notes{std::string("material library '") + name + "', which cannot be read"}));
    }
    expect_bare(read("mtllib\nf 1 2 3\n"));
}

TEST_F(TexturedObj, FindsLibrariesWithBlanksAndSeveralInALine) {
    folder_.file("m n.mtl", "newmtl a\nmap_Kd a.png\n");
    folder_.file("o.mtl", "newmtl b\nmap_Kd b.png\n");
    folder_.file("p.mtl", "newmtl b\nmap_Kd late.png\nnewmtl c\nmap_Kd c.png\n");
    const ReadColouredScan read_scan =
        read("mtllib m n.mtl\nmtllib o.mtl  p.mtl\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl c\nf 1 2 3\n");
    EXPECT_EQ(read_scan.appearance.textures, (Paths{in_folder("a.png"), in_folder("b.png"), in_folder("c.png")}));
    EXPECT_EQ(read_scan.appearance.texture_of_face, (Numbers{0, 1, 2}));
    EXPECT_TRUE(read_scan.notes.ignored.empty());
}

TEST_F(TexturedObj, LooksForPicturesInTheirFolderAndBesideTheScan) {
    std::filesystem::create_directories(in_folder("sub/deep"));
    folder_.file("sub/m.mtl",
                 "newmtl a\nmap_Kd deep\\a.png\nnewmtl b\nmap_Kd C:\\scans\\b.png\nnewmtl c\nmap_Kd sub/c.png\n"
                 "newmtl d\nmap_Kd missing/d.png\n");
    folder_.file("sub/deep/a.png", "a");
    folder_.file("b.png", "b");
    folder_.file("sub/c.png", "c");
    std::string uses;
    for (const char* name : {"a", "b", "c", "d"}) {
        uses.append("usemtl ").append(name).append("\nf 1 2 3\n");
    }
    EXPECT_EQ(
        read("mtllib sub\\m.mtl\n" + uses).appearance.textures,
        (Paths{in_folder("sub/deep/a.png"), in_folder("b.png"), in_folder("sub/c.png"), in_folder("missing/d.png")}));
}

TEST(OffAppearance, ReadsColoursAsTheHeaderSays) {
    struct Coloured {
        const char* header;
        std::array<const char*, 3> extras;
        Notes notes;
    };
    const Coloured cases[] = {
        {"COFF", {"255 0 51", "0 0 0", "0 0 255"}, {}},
        {"COFF", {"255 0 51 255", "0 0 0 0", "0 0 255 1"}, {"alpha"}},
        {"COFF", {"1.0 0.0 0.2", "0 0 0", "0 0 1"}, {}},
        {"COFF", {"1 0 0.2 1", "0 0 0 1", "0 0 1 1"}, {"alpha"}},
        {"OFF", {"1 0 0.2", "0 0 0", "0 0 1"}, {}},
        {"CNOFF", {"0 0 1 1 0 0.2", "0 0 1 0 0 0", "0 0 1 0 0 1"}, {"normals"}},
    };
    for (const auto& [header, extras, notes] : cases) {
        const ReadColouredScan read =
            coloured_scan_of("a.off", std::string(header) + "\n3 1 0\n0 0 0 " + extras[0] + "\n1 0 0 " + extras[1] +
                                          "# a\n0 1 0 " + extras[2] + "\n3 0 1 2\n");
        EXPECT_EQ(read.appearance.vertex_colours, (Colours{{1, 0, 0.2F}, {0, 0, 0}, {0, 0, 1}})) << header << extras[0];
        EXPECT_EQ(read.notes.ignored, notes) << header << extras[0];
    }
}

TEST(OffAppearance, ReadsTextureCoordinatesOfVertices) {
    const ReadColouredScan read = coloured_scan_of(
        "a.off",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1 0 0.5\n1 0 0 0 0 1 1 1 1 1 2 3\n0 1 0 0 0 1 1 1 1 1 4 5\n3 2 0 1 9\n");
    expect_texture(read, {{{{4, 5}, {0, 0.5F}, {2, 3}}}});
    EXPECT_EQ(read.appearance.vertex_colours, Colours(3, {1, 1, 1}));
    EXPECT_EQ(read.notes.ignored, (Notes{"normals", "alpha", "face colours"}));
    const ReadColouredScan plain =
        coloured_scan_of("a.off", "STOFF\n3 1 0\n0 0 0 0 0.5\n1 0 0 2 3\n0 1 0 4 5\n3 2 0 1\n");
    expect_texture(plain, {{{{4, 5}, {0, 0.5F}, {2, 3}}}});
    EXPECT_TRUE(plain.notes.ignored.empty());
}

TEST(OffAppearance, NotesWhatIsNoColour) {
    struct Noted {
        const char* header;
        const char* extras;
        Notes notes;
    };
    const Noted cases[] = {
        {"COFF", "7", {"colours"}}, {"COFF", "1 1 1 1 1 1 1 1 1 1 1 1 1", {"colours"}}, {"COFF", "", {}},
        {"NOFF", "1", {"normals"}}, {"NOFF", "0 0 1 1", {"normals", "colours"}},        {"STOFF", "1", {}},
    };
    for (const auto& [header, extras, notes] : cases) {
        const ReadColouredScan read =
            coloured_scan_of("a.off", std::string(header) + "\n1 0 0\n0 0 0 " + extras + "\n");
        expect_bare(read);
        EXPECT_EQ(read.notes.ignored, notes) << header << extras;
    }
}

TEST(OffAppearance, IsUnreadableWhereNumbersAreNone) {
    EXPECT_EQ(unreadable_colours("a.off", "COFF\n1 0 0\n0 0 0 1 nan 1\n"),
              "a.off: line 3: a colour or texture coordinate is not a finite number");
    EXPECT_EQ(unreadable_colours("a.off", "COFF\n1 0 0\n0 0 0 1 red 1\n"),
              "a.off: line 3: 'red' for a colour is not a number");
}

TEST(ScanAppearance, DoesNotChangeWhatAPlainScanNotes) {
    const std::string obj = "mtllib a.mtl\nv 0 0 0 1 1 1\nvt nan\nusemtl a\nf 1/9 1/9 1/9\n";
    EXPECT_EQ(scan_of("a.obj", obj).notes.ignored, (Notes{"materials", "colours", "texture coordinates"}));
    const std::string text = ply({.comments = "comment TextureFile a\n",
                                  .vertex_properties = properties("float", {"red", "green", "blue", "alpha", "s", "t"}),
                                  .vertices = {"nan 0 0 0 0 0", "0 0 0 0 0 0", "0 0 0 0 0 0"},
                                  .face_properties = "property list uchar float texcoord\nproperty int texnumber\n",
                                  .faces = {"3 0 1 2 1 0 77"}});
    EXPECT_EQ(scan_of("a.ply", text).notes.ignored, (Notes{"colours", "texture coordinates"}));
}

} // namespace
} // namespace foldless
