#include <foldless/report/violations_ply.h>

#include <foldless/report/version.h>

#include <gtest/gtest.h>

#include <string>

namespace foldless {

namespace {

Scan scan_of_two_triangles() {
    return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

BaseMesh base_of_one_triangle() {
    BaseMesh base;
    base.positions = {{0.1, 0, 5}, {1, 0, 5}, {1, 1, 5}};
    base.faces = {{2, 0, 1}};
    return base;
}

VerifyResult result_with(const std::vector<LocatedViolation>& located) {
    VerifyResult result;
    result.located = located;
    for (const LocatedViolation& found : located) {
        ++result.violations[static_cast<std::size_t>(found.violation)];
    }
    return result;
}

std::string ply(const VerifyResult& result) {
    return violations_ply(result, base_of_one_triangle(), scan_of_two_triangles());
}

std::string header(const std::string& comments, int vertices, int faces) {
    return "ply\nformat ascii 1.0\ncomment foldless " + std::string(version()) + "\n" + comments + "element vertex " +
           std::to_string(vertices) +
           "\nproperty double x\nproperty double y\nproperty double z\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int violation\n"
           "element face " +
           std::to_string(faces) + "\nproperty list uchar int vertex_indices\nproperty int violation\nend_header\n";
}

TEST(ViolationsPly, IsEmptyWithoutViolations) {
    EXPECT_EQ(ply({}), header("", 0, 0));
}

TEST(ViolationsPly, HasThePositionAndTheFacesThatAreNamed) {
    const VerifyResult result = result_with({
        {Violation::no_preimage, 3, -1, -1, Vec3(0.1, 1e-300, -2.5)},
        {Violation::trace, -1, 1, 0, Vec3(0.5, 0.25, 0)},
    });
    EXPECT_EQ(ply(result), header("comment violation 4 no_preimage\ncomment violation 8 trace\n", 8, 2) +
                               "0.1 1e-300 -2.5 230 25 25 4\n"
                               "0.5 0.25 0 230 25 25 8\n"
                               "0 0 0 255 165 0 8\n"
                               "1 1 0 255 165 0 8\n"
                               "0 1 0 255 165 0 8\n"
                               "1 1 5 30 90 255 8\n"
                               "0.1 0 5 30 90 255 8\n"
                               "1 0 5 30 90 255 8\n"
                               "3 2 3 4 8\n"
                               "3 5 6 7 8\n");
}

TEST(ViolationsPly, NamesATopologyThatDiffersWithoutAPoint) {
    EXPECT_EQ(ply(result_with({{Violation::topology}})), header("comment violation 0 topology\n", 0, 0));
}

} // namespace

} // namespace foldless
