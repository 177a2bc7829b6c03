#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foldless {
namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

const std::string header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty int scan_vertex\n"
    "element face 1\nproperty list uchar int vertex_indices\n";
const std::string whole = header + "property float t_min\nproperty float t_max\nend_header\n"
                                   "0 0 0 0 0 1 7\n1 0 0 0 0 2 -1\n0 1 0 0 0 3 9\n3 0 1 2 -0.5 0.25\n";
const std::vector<Vec3> directions{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}};

std::string unreadable_base(const std::string& name, const std::string& text) {
    return message_of<UnreadableFile>([&] { static_cast<void>(base_mesh_of(name, text)); });
}

std::string refused_base(const std::string& name, const std::string& text) {
    const std::string message = message_of<RefusedMesh>([&] { static_cast<void>(base_mesh_of(name, text)); });
    return message.substr(message.find(name) == std::string::npos ? 0 : message.find(name));
}

TEST(BaseMeshReader, ReadsDirectionsRangesAndScanVerticesOfPly) {
    const auto [base, notes] = base_mesh_of("b.ply", whole);
    EXPECT_EQ(base.directions, directions);
    EXPECT_EQ(base.scan_vertex, (std::vector<std::int32_t>{7, -1, 9}));
    ASSERT_EQ(base.ranges.size(), 1U);
    EXPECT_EQ(base.ranges[0].lo, -0.5);
    EXPECT_EQ(base.ranges[0].hi, 0.25);
    EXPECT_TRUE(base.face_directions.empty());
    EXPECT_TRUE(base.float32);
    EXPECT_TRUE(notes.ignored.empty());
}

TEST(BaseMeshReader, ReadsMeshesOfOtherProgramsWithoutRanges) {
    const std::string foreign = replaced(header, "property int scan_vertex\n", "property uchar red\n") +
                                "end_header\n0 0 0 0 0 1 255\n1 0 0 0 0 2 0\n0 1 0 0 0 3 0\n3 0 1 2\n";
    const auto [base, notes] = base_mesh_of("b.ply", foreign);
    EXPECT_EQ(base.directions, directions);
    EXPECT_TRUE(base.scan_vertex.empty());
    EXPECT_TRUE(base.ranges.empty());
    EXPECT_EQ(notes.ignored, (std::vector<std::string>{"colours"}));
}

TEST(BaseMeshReader, ReadsDirectionsOfFacesAndGivesThemToAllFacesOfAFan) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
        "property double z\nelement face 1\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property list uchar int vertex_indices\nproperty float t_min\nproperty float t_max\n"
        "end_header\n0 0 0\n0.1 0 0\n0.1 0.1 0\n0 0.1 0\n0 0 5 4 0 1 2 3 -1 1\n";
    const auto [base, notes] = base_mesh_of("b.ply", text);
    EXPECT_TRUE(base.directions.empty());
    EXPECT_EQ(base.face_directions, (std::vector<Vec3>{{0, 0, 5}, {0, 0, 5}}));
    EXPECT_EQ(base.ranges.size(), 2U);
    EXPECT_EQ(base.ranges[1].hi, 1.0);
    EXPECT_EQ(notes.fanned_polygons, 1U);
    EXPECT_FALSE(base.float32);
}

TEST(BaseMeshReader, PrefersDirectionsOfVerticesToThoseOfFaces) {
    const std::string text = header + "property float nx\nproperty float ny\nproperty float nz\nend_header\n"
                                      "0 0 0 0 0 1 7\n1 0 0 0 0 2 -1\n0 1 0 0 0 3 9\n3 0 1 2 1 0 0\n";
    const auto [base, notes] = base_mesh_of("b.ply", text);
    EXPECT_EQ(base.directions, directions);
    EXPECT_TRUE(base.face_directions.empty());
    EXPECT_EQ(notes.ignored, (std::vector<std::string>{"face normals"}));
}

TEST(BaseMeshReader, RefusesPlyThatCannotBeABaseMesh) {
    EXPECT_EQ(refused_base("b.ply", replaced(whole, "float nz", "float q")),
              "b.ply: the mesh has no displacement directions");
    EXPECT_EQ(refused_base("b.ply", replaced(whole, "0 0 2 -1", "0 nan 2 -1")),
              "b.ply: 1 displacement direction is not finite");
    for (const char* range : {"0.5 0.25", "nan 0.25", "-0.5 nan", "-inf 0", "0 inf"}) {
        EXPECT_EQ(refused_base("b.ply", replaced(whole, "-0.5 0.25", range)),
                  "b.ply: 1 displacement range is not finite or has t_min > t_max")
            << range;
    }
    EXPECT_EQ(base_mesh_of("b.ply", replaced(whole, "-0.5 0.25", "0.25 0.25")).base.ranges[0].lo, 0.25);
}

TEST(BaseMeshReader, DoesNotReadScanVerticesThatCannotBe) {
    for (const char* index : {"-2", "2147483648", "-4294967297"}) {
        EXPECT_NE(unreadable_base("b.ply", replaced(whole, "0 0 2 -1", std::string("0 0 2 ") + index)), "no error");
    }
    EXPECT_NE(unreadable_base("b.ply", replaced(replaced(whole, "int scan", "float scan"), "2 -1", "2 nan")),
              "no error");
    EXPECT_NE(unreadable_base("b.ply", replaced(replaced(whole, "int scan", "float scan"), "2 -1", "2 0.5")),
              "no error");
    EXPECT_EQ(base_mesh_of("b.ply", replaced(whole, "0 0 2 -1", "0 0 2 2147483647")).base.scan_vertex[1], 2147483647);
}

TEST(BaseMeshReader, DoesNotReadHalfARange) {
    EXPECT_NE(unreadable_base("b.ply", replaced(whole, "float t_max", "float other")), "no error");
}

const std::string obj_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 1\nvn 0 0 2\nvn 0 0 3\nvn 0 0 2\n";

TEST(BaseMeshReader, ReadsTheNormalThatAllCornersOfAVertexName) {
    // Normal 4 has the value of normal 2, so the two faces agree at vertex 2.
    const auto [base, notes] = base_mesh_of("b.obj", obj_vertices + "f 1//1 2//2 3//3\nf 2/1/4 4//1 3//3\n");
    EXPECT_EQ(base.directions, (std::vector<Vec3>{{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 1}}));
    EXPECT_TRUE(base.scan_vertex.empty());
    EXPECT_TRUE(base.ranges.empty());
    EXPECT_TRUE(notes.ignored.empty());
}

TEST(BaseMeshReader, ReadsNormalsOfPolygonsAndNegativeIndices) {
    const auto [base, notes] = base_mesh_of("b.obj", obj_vertices + "f 1//-4 2//-3 4//-2 3//-1\n");
    EXPECT_EQ(base.faces.size(), 2U);
    EXPECT_EQ(base.directions, (std::vector<Vec3>{{0, 0, 1}, {0, 0, 2}, {0, 0, 2}, {0, 0, 3}}));
}

TEST(BaseMeshReader, RefusesObjWithoutOneNormalForEachVertex) {
    EXPECT_EQ(refused_base("b.obj", obj_vertices + "f 1 2 3\n"), "b.obj: the mesh has no displacement directions");
    EXPECT_EQ(refused_base("b.obj", obj_vertices + "f 1//1 2//2 3//3\nf 2//1 4//1 3//3\n"),
              "b.obj: no displacement directions: 1 vertex has several normals");
    EXPECT_EQ(refused_base("b.obj", obj_vertices + "f 1//1 2//2 3//3\nf 2//2 4 3//3\n"),
              "b.obj: no displacement directions: 1 vertex has no normal");
    EXPECT_NE(unreadable_base("b.obj", obj_vertices + "f 1//1 2//2 3//5\n"), "no error");
    EXPECT_NE(unreadable_base("b.obj", obj_vertices + "f 1//1 2//2 3//0\n"), "no error");
    EXPECT_NE(unreadable_base("b.obj", obj_vertices + "vn 0 1\nf 1//1 2//2 3//3\n"), "no error");
}

TEST(BaseMeshReader, RefusesFormatsWithoutDirections) {
    EXPECT_EQ(refused_base("b.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n"),
              "b.off: the mesh has no displacement directions");
    EXPECT_EQ(refused_base("b.stl", "solid\nendsolid\n"), "b.stl: the mesh has no displacement directions");
}

} // namespace
} // namespace foldless
