#include <foldless/io/read_ply.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace foldless {
namespace {

const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

const std::string ascii_triangle = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                   "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                   "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

void expect_triangle(const ReadScan& read) {
    EXPECT_EQ(read.scan.positions, corners);
    EXPECT_EQ(read.scan.faces, (std::vector<Triangle>{{0, 1, 2}}));
}

/// Bytes of numbers in one order.
class Bytes {
public:
    explicit Bytes(std::endian order) : order_(order) {}
    template <class Number>
    Bytes& add(std::initializer_list<Number> numbers) {
        for (const Number number : numbers) {
            char stored[sizeof(Number)];
            std::memcpy(stored, &number, sizeof(Number));
            if (order_ != std::endian::native) {
                std::reverse(stored, stored + sizeof(Number));
            }
            text_.append(stored, sizeof(Number));
        }
        return *this;
    }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::endian order_;
    std::string text_;
};

std::string binary_header(std::endian order, const std::string& elements) {
    const std::string format = order == std::endian::little ? "binary_little_endian" : "binary_big_endian";
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::string float_elements = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                   "element face 1\nproperty list uchar int vertex_indices\n";

std::string binary_triangle(std::endian order = std::endian::little) {
    Bytes data(order);
    data.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}).add<std::uint8_t>({3}).add<std::int32_t>({0, 1, 2});
    return binary_header(order, float_elements) + data.text();
}

TEST(PlyReader, ReadsAscii) {
    expect_triangle(scan_of("a.ply", ascii_triangle));
    expect_triangle(scan_of("a.PLY", ascii_triangle));
}

TEST(PlyReader, ReadsBinaryOfBothOrders) {
    expect_triangle(scan_of("a.ply", binary_triangle(std::endian::little)));
    expect_triangle(scan_of("a.ply", binary_triangle(std::endian::big)));
}

TEST(PlyReader, ReadsEveryScalarTypeAndList) {
    const std::string elements = "element vertex 3\nproperty char x\nproperty double y\nproperty uint16 z\n"
                                 "property list ushort double weights\n"
                                 "element face 1\nproperty short material\nproperty list int32 uint8 vertex_index\n";
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        Bytes data(order);
        data.add<std::int8_t>({-1}).add<double>({0.1}).add<std::uint16_t>({65535, 2}).add<double>({7, 8});
        data.add<std::int8_t>({1}).add<double>({-0.0}).add<std::uint16_t>({0, 0});
        data.add<std::int8_t>({0}).add<double>({1e300}).add<std::uint16_t>({1, 0});
        data.add<std::int16_t>({-5}).add<std::int32_t>({3}).add<std::uint8_t>({2, 1, 0});
        const ReadScan read = scan_of("a.ply", binary_header(order, elements) + data.text());
        EXPECT_EQ(read.scan.positions, (std::vector<Vec3>{{-1, 0.1, 65535}, {1, -0.0, 0}, {0, 1e300, 1}}));
        EXPECT_EQ(read.scan.faces, (std::vector<Triangle>{{2, 1, 0}}));
        EXPECT_FALSE(read.scan.float32);
    }
}

TEST(PlyReader, SkipsWhatItDoesNotKnowAndSaysSo) {
    const std::string text =
        "ply\nformat ascii 1.0\ncomment element vertex 9\nobj_info any thing\n"
        "element camera 1\nproperty float view_px\nproperty list uchar int ids\n"
        "element vertex 3\nproperty uchar red\nproperty float x\nproperty float nx\nproperty float y\n"
        "property float z\nproperty float confidence\nelement nothing 1000000000000\n"
        "element face 1\nproperty list uchar float texcoord\n"
        "property list uchar int vertex_indices\nend_header\n"
        "1.5 2 3 4\n255 0 7 0 0 1\n255 1 7 0 0 1\n255 0 7 1 0 1\n1 0.5 3 0 1 2\n";
    const ReadScan read = scan_of("a.ply", text);
    expect_triangle(read);
    EXPECT_EQ(read.notes.ignored,
              (std::vector<std::string>{"element 'camera'", "colours", "normals", "property 'confidence'",
                                        "element 'nothing'", "texture coordinates"}));
}

TEST(PlyReader, SkipsUnknownBinaryElementsWithAndWithoutLists) {
    Bytes data(std::endian::little);
    data.add<double>({1, 2}).add<std::uint8_t>({2}).add<std::int16_t>({8, 9}).add<std::uint8_t>({0});
    data.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}).add<std::uint8_t>({3}).add<std::int32_t>({0, 1, 2});
    const std::string elements = "element a 2\nproperty double q\nelement b 2\nproperty list uchar short q\n";
    expect_triangle(scan_of("a.ply", binary_header(std::endian::little, elements + float_elements) + data.text()));
}

TEST(PlyReader, ReadsFacesThatComeBeforeTheirVertices) {
    expect_triangle(scan_of("a.ply", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
                                     "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                     "end_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0"));
}

TEST(PlyReader, ReadsEveryKindOfLineEndAndBlank) {
    for (const char* line_end : {"\r\n", "\r", "\n\n", " \t\n"}) {
        std::string text;
        for (const char c : ascii_triangle) {
            c == '\n' ? text += line_end : text += c;
        }
        expect_triangle(scan_of("a.ply", text));
    }
    expect_triangle(scan_of("a.ply", "\xef\xbb\xbf" + ascii_triangle));
    expect_triangle(scan_of("a.ply", replaced(ascii_triangle, "1 0 0", "\t1\t 0  +0e5\t")));
    expect_triangle(scan_of("a.ply", ascii_triangle.substr(0, ascii_triangle.size() - 1)));
}

TEST(PlyReader, FindsTheBinaryDataBehindEveryKindOfLineEnd) {
    // The first data byte is a line feed, which belongs to the data unless a carriage return of the same line is before
    // it.
    Bytes data(std::endian::little);
    data.add<std::uint8_t>({10}).add<float>({0, 0, 0});
    const std::string header =
        "element vertex 1\nproperty uchar x\nproperty float q\nproperty float y\nproperty float z\n";
    for (const char* line_end : {"\n", "\r\n", "\r"}) {
        std::string text;
        for (const char c : binary_header(std::endian::little, header)) {
            c == '\n' ? text += line_end : text += c;
        }
        EXPECT_EQ(scan_of("a.ply", text + data.text()).scan.positions, (std::vector<Vec3>{{10, 0, 0}}));
    }
}

TEST(PlyReader, KeepsEveryBitOfDoublesAndRoundsFloatsOnce) {
    const std::string doubles = "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty float y\n"
                                "property float z\nend_header\n0.1 0.1 1.00000005960464477540\n";
    const ReadScan read = scan_of("a.ply", doubles);
    EXPECT_EQ(read.scan.positions[0].x(), 0.1);
    EXPECT_EQ(read.scan.positions[0].y(), static_cast<double>(0.1F));
    EXPECT_EQ(read.scan.positions[0].z(), static_cast<double>(std::nextafter(1.0F, 2.0F)));
    EXPECT_FALSE(read.scan.float32);
}

TEST(PlyReader, FindsDoublesThatAreFloats) {
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
                               "property double z\nend_header\n";
    EXPECT_TRUE(scan_of("a.ply", header + "0.5 -3 1e-45\n").scan.float32 == false)
        << "1e-45 rounds to a denormal float";
    EXPECT_TRUE(scan_of("a.ply", header + "0.5 -3 16777216\n").scan.float32);
    EXPECT_FALSE(scan_of("a.ply", header + "0.5 -3 16777217\n").scan.float32);
    EXPECT_FALSE(scan_of("a.ply", header + "1e39 0 0\n").scan.float32);
}

TEST(PlyReader, ReadsNumbersThatAreNotFinite) {
    const ReadScan read = scan_of("a.ply", replaced(ascii_triangle, "1 0 0", "nan -inf Infinity"));
    EXPECT_TRUE(std::isnan(read.scan.positions[1].x()));
    EXPECT_EQ(read.scan.positions[1].y(), -std::numeric_limits<double>::infinity());
}

TEST(PlyReader, FansConvexPolygonsAndCountsThem) {
    const std::string text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty int x\nproperty int y\nproperty int z\n"
                             "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
                             "0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n3 0 1 2\n5 0 1 2 3 4\n";
    const ReadScan read = scan_of("a.ply", text);
    EXPECT_EQ(read.scan.faces, (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
    EXPECT_EQ(read.notes.fanned_polygons, 1U);
    EXPECT_EQ(refused("a.ply", replaced(text, "3 1 0", "1 1 0")), "a.ply: 1 polygon is not convex and planar");
    EXPECT_EQ(refused("a.ply", replaced(text, "3 1 0", "3 1 1")), "a.ply: 1 polygon is not convex and planar");
    EXPECT_EQ(refused("a.ply", replaced(text, "3 0 1 2", "2 0 1")), "a.ply: 1 face has fewer than three corners");
    EXPECT_EQ(refused("a.ply", replaced(text, "3 0 1 2", "0")), "a.ply: 1 face has fewer than three corners");
}

struct Malformed {
    const char* from;
    const char* to;
    const char* message;
};

TEST(PlyReader, RefusesMalformedAsciiFiles) {
    const Malformed cases[] = {
        {"ply\n", "plx\n", "line 1: a PLY file starts with a line 'ply'"},
        {"ascii", "ebcdic", "line 2: unknown format 'ebcdic'"},
        {"1.0", "2.0", "line 2: the format version is not 1.0"},
        {"format ascii 1.0\n", "", "line 8: the header names no format"},
        {"vertex 3", "vertex", "line 3: the count is missing"},
        {"vertex 3", "vertex -3", "line 3: element 'vertex' has a negative count"},
        {"vertex 3", "vertex three", "line 3: 'three' for the count is not a number"},
        {"vertex 3", "vertex 3.5", "line 3: '3.5' for the count is not an integer"},
        {"vertex 3", "vertex 99999999999999999999", "line 3: '99999999999999999999' for the count is too large"},
        {"vertex 3", "vertex 9223372036854775807",
         "line 10: element 'vertex' cannot have 9223372036854775807 instances in the 27 bytes that are left"},
        {"vertex 3", "vertex 2147483648",
         "line 10: element 'vertex' cannot have 2147483648 instances in the 27 bytes that are left"},
        {"vertex 3", "vertex 4", "line 13: unexpected '2' at the end of the line"},
        {"vertex 3", "vertex 2", "line 12: unexpected '1' at the end of the line"},
        {"vertex 3", "vertex 0", "line 10: unexpected '0' at the end of the line"},
        {"vertex 3", "vertices 3", "line 10: the header has no element 'vertex'"},
        {"face 1", "face 2", "line 14: the file ends after 1 of 2 instances of element 'face'"},
        {"face 1", "face 0", "line 13: data behind the last element of the header"},
        {"element face", "element vertex", "line 12: element 'vertex' is declared twice"},
        {"element vertex 3\n", "", "line 3: a property comes before the first element"},
        {"float x", "floaty x", "line 4: unknown type 'floaty'"},
        {"float x", "float", "line 4: a name is missing"},
        {"float x", "float x y", "line 4: unexpected 'y' at the end of the line"},
        {"float x", "float w", "line 10: element 'vertex' has no property 'x'"},
        {"float y", "float x", "line 10: property 'x' of element 'vertex' is declared twice"},
        {"float x", "list uchar float x", "line 10: property 'x' of element 'vertex' is of the wrong kind"},
        {"list uchar int", "list float int", "line 8: the length of a list is not an integer"},
        {"list uchar int", "list uchar float", "line 12: the vertex indices are not integers"},
        {"list uchar int", "int", "line 12: property 'vertex_indices' of element 'face' is of the wrong kind"},
        {"vertex_indices", "corners", "line 12: element 'face' has no list 'vertex_indices'"},
        {"end_header", "end_of_header", "line 9: unknown header line 'end_of_header'"},
        {"1 0 0", "1 0", "line 11: z is missing"},
        {"1 0 0", "1 0 0 0", "line 11: unexpected '0' at the end of the line"},
        {"1 0 0", "1 0,5 0", "line 11: '0,5' for y is not a number"},
        {"1 0 0", "1 1e39 0", "line 11: '1e39' for y is too large"},
        {"3 0 1 2", "3 0 1 3", "line 13: vertex index 3 is out of range (3 vertices)"},
        {"3 0 1 2", "3 0 1 -1", "line 13: vertex index -1 is out of range (3 vertices)"},
        {"3 0 1 2", "3 0 1 4294967297", "line 13: vertex index 4294967297 is out of range (3 vertices)"},
        {"3 0 1 2", "3 0 1 1.5", "line 13: '1.5' for vertex_indices is not an integer"},
        {"3 0 1 2", "3 0 1", "line 13: vertex_indices is missing"},
        {"3 0 1 2", "4 0 1 2", "line 13: vertex_indices is missing"},
        {"3 0 1 2", "-3 0 1 2", "line 13: list 'vertex_indices' cannot have -3 values"},
        {"3 0 1 2", "4000000000 0 1 2", "line 13: list 'vertex_indices' cannot have 4000000000 values"},
        {"3 0 1 2", "3 0 1 2\n3 0 1 2", "line 14: data behind the last element of the header"},
    };
    for (const auto& [from, to, message] : cases) {
        EXPECT_EQ(unreadable("a.ply", replaced(ascii_triangle, from, to)), std::string("a.ply: ") + message) << to;
    }
}

TEST(PlyReader, NamesAPropertyInOneShortLineWhateverItsName) {
    const std::string name = "a\x7f\xc3" + std::string(100, 'x');
    const std::string file = replaced(
        replaced(ascii_triangle, "element face", "property int " + name + "\nelement face"), "1 0 0", "1 0 0 !");
    const std::string known = "a??" + std::string(37, 'x') + "...";
    EXPECT_EQ(unreadable("a.ply", replaced(file, "0 0 0", "0 0 0 1")),
              "a.ply: line 12: '!' for " + known + " is not a number");
    EXPECT_EQ(unreadable("a.ply", file), "a.ply: line 11: " + known + " is missing");
}

TEST(PlyReader, RefusesMalformedBinaryFiles) {
    const Malformed cases[] = {
        {"vertex 3", "vertex 5", "byte 169: element 'vertex' cannot have 5 instances in the 49 bytes that are left"},
        {"vertex 3", "vertex 9000000000000000000",
         "byte 187: element 'vertex' cannot have 9000000000000000000 instances in the 49 bytes that are left"},
        {"vertex 3", "vertex 2", "byte 194: data behind the last element of the header"},
        {"face 1", "face 2", "byte 218: the file ends after 1 of 2 instances of element 'face'"},
        {"face 1", "face 0", "byte 205: data behind the last element of the header"},
        {"face 1", "face 4000000000",
         "byte 214: element 'face' cannot have 4000000000 instances in the 13 bytes that are left"},
        {"uchar int", "int int", "byte 203: list 'vertex_indices' cannot have 3 values"},
        {"uchar int", "uchar char", "byte 210: data behind the last element of the header"},
        {"little", "big", "byte 207: vertex index 16777216 is out of range (3 vertices)"},
    };
    for (const auto& [from, to, message] : cases) {
        EXPECT_EQ(unreadable("a.ply", replaced(binary_triangle(), from, to)), std::string("a.ply: ") + message) << to;
    }
    EXPECT_EQ(unreadable("a.ply", binary_triangle() + "more"),
              "a.ply: byte 218: data behind the last element of the header");
    expect_triangle(scan_of("a.ply", binary_triangle() + "\r\n"));
}

TEST(PlyReader, RefusesAFileCutAtAnyByte) {
    for (const std::string& whole : {ascii_triangle, binary_triangle()}) {
        for (std::size_t size = 1; size + 1 < whole.size(); ++size) {
            EXPECT_THROW(static_cast<void>(read_ply(whole.substr(0, size), "a.ply", Content::scan)), UnreadableFile)
                << size;
        }
    }
}

} // namespace
} // namespace foldless
