#include <foldless/io/write_mesh.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace foldless {
namespace {

double float_value(float value) {
    return static_cast<double>(value);
}

// Numbers whose bits are easily lost: a third, a denormal, minus zero, the largest.
BaseMesh sample() {
    const double third = float_value(1.0F / 3.0F);
    const double least = float_value(std::numeric_limits<float>::denorm_min());
    const double most = float_value(std::numeric_limits<float>::max());
    BaseMesh base;
    base.positions = {{third, 0, 0}, {1, -0.0, 0}, {0, 1, least}, {-most, 1, 1}};
    base.directions = {{0, 0, 1}, {third, -third, 2}, {-0.0, 0, most}, {0, least, 1}};
    base.scan_vertex = {5, -1, 2147483647, 0};
    base.faces = {{0, 1, 2}, {2, 1, 3}};
    base.ranges = {{-third, third}, {0, 0}};
    return base;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return std::ranges::equal(a, b, [&](const Vec3& p, const Vec3& q) {
        return bits(p.x()) == bits(q.x()) && bits(p.y()) == bits(q.y()) && bits(p.z()) == bits(q.z());
    });
}

BaseMesh written_and_read(const std::string& name, const BaseMesh& base) {
    const TemporaryFolder folder;
    write_base_mesh(folder.path() / name, base, {"one", "two"});
    EXPECT_EQ(folder.names(), (std::vector<std::string>{name}));
    return read_base_mesh(folder.path() / name).base;
}

TEST(BaseMeshWriter, KeepsEveryBitInPly) {
    const BaseMesh base = sample();
    const BaseMesh read = written_and_read("b.PLY", base);
    EXPECT_TRUE(same_bits(read.positions, base.positions));
    EXPECT_TRUE(same_bits(read.directions, base.directions));
    EXPECT_EQ(read.scan_vertex, base.scan_vertex);
    EXPECT_EQ(read.faces, base.faces);
    ASSERT_EQ(read.ranges.size(), 2U);
    EXPECT_EQ(read.ranges[0].lo, base.ranges[0].lo);
    EXPECT_EQ(read.ranges[0].hi, base.ranges[0].hi);
    EXPECT_TRUE(read.float32);
}

TEST(BaseMeshWriter, KeepsEveryBitOfDoublePositions) {
    BaseMesh base = sample();
    base.positions[1] = {0.1, std::numeric_limits<double>::denorm_min(), -1e308};
    base.float32 = false;
    for (const char* name : {"b.ply", "b.obj"}) {
        const BaseMesh read = written_and_read(name, base);
        EXPECT_TRUE(same_bits(read.positions, base.positions)) << name;
        EXPECT_FALSE(read.float32) << name;
    }
}

TEST(BaseMeshWriter, KeepsEveryBitInObj) {
    const BaseMesh base = sample();
    const BaseMesh read = written_and_read("b.Obj", base);
    EXPECT_TRUE(same_bits(read.positions, base.positions));
    EXPECT_TRUE(same_bits(read.directions, base.directions));
    EXPECT_EQ(read.faces, base.faces);
    EXPECT_TRUE(read.ranges.empty());
    EXPECT_TRUE(read.float32);
}

TEST(BaseMeshWriter, WritesObjAsDocumented) {
    BaseMesh base = sample();
    base.positions = {{0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-5F}};
    base.directions.assign(4, Vec3(0, 0, 1));
    const TemporaryFolder folder;
    write_base_mesh(folder.path() / "b.obj", base, {"foldless 0.1.0"});
    EXPECT_EQ(
        bytes_of(folder.path() / "b.obj"),
        "# foldless 0.1.0\nv 0.5 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 9.999999747378752e-06\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n"
        "vn 0 0 1\nf 1//1 2//2 3//3\nf 3//3 2//2 4//4\n");
}

TEST(BaseMeshWriter, WritesThePlyHeaderAsDocumented) {
    const TemporaryFolder folder;
    write_base_mesh(folder.path() / "b.ply", sample(), {"foldless 0.1.0", "two\nlines\r"});
    const std::string bytes = bytes_of(folder.path() / "b.ply");
    const std::string header =
        "ply\nformat binary_little_endian 1.0\ncomment foldless 0.1.0\ncomment two lines \nelement vertex 4\n"
        "property float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float "
        "nz\n"
        "property int scan_vertex\nelement face 2\nproperty list uchar int vertex_indices\nproperty float t_min\n"
        "property float t_max\nend_header\n";
    EXPECT_EQ(bytes.substr(0, header.size()), header);
    EXPECT_EQ(bytes.size(), header.size() + 4 * (6 * 4 + 4) + 2 * (1 + 3 * 4 + 2 * 4));
    EXPECT_EQ(bytes.substr(header.size() + 24, 4), std::string("\5\0\0\0", 4)) << "the scan vertex of the first vertex";
}

TEST(BaseMeshWriter, WritesConstantDirectionsAsFaceProperties) {
    BaseMesh base = sample();
    base.directions.clear();
    base.face_directions = {{0, 0, 1}, {0, 3, 0}};
    const BaseMesh read = written_and_read("b.ply", base);
    EXPECT_TRUE(read.directions.empty());
    EXPECT_TRUE(same_bits(read.face_directions, base.face_directions));
    EXPECT_EQ(read.ranges.size(), 2U);
    const TemporaryFolder folder;
    EXPECT_THROW(write_base_mesh(folder.path() / "b.obj", base, {}), UnwritableFile);
    EXPECT_THROW(require_writable_base_mesh(folder.path() / "b.obj", true), UnwritableFile);
    EXPECT_TRUE(folder.names().empty());
}

TEST(BaseMeshWriter, LeavesOutWhatIsAbsent) {
    BaseMesh base = sample();
    base.ranges.clear();
    base.scan_vertex.clear();
    const BaseMesh read = written_and_read("b.ply", base);
    EXPECT_TRUE(read.ranges.empty());
    EXPECT_TRUE(read.scan_vertex.empty());
}

TEST(BaseMeshWriter, RefusesWhatTheFileWouldRound) {
    const TemporaryFolder folder;
    const auto message = [&](const BaseMesh& base) {
        return message_of<UnwritableFile>([&] { write_base_mesh(folder.path() / "b.ply", base, {}); });
    };
    const std::string rounded =
        (folder.path() / "b.ply").string() + ": cannot be written: the base mesh has values that float32 does not hold";
    BaseMesh base = sample();
    base.positions[0].x() = 0.1;
    EXPECT_EQ(message(base), rounded);
    base = sample();
    base.directions[0].x() = 0.1;
    EXPECT_EQ(message(base), rounded);
    base = sample();
    base.ranges[0].lo = -0.1;
    EXPECT_EQ(message(base), rounded);
    base.ranges[0].lo = std::nan("");
    EXPECT_EQ(message(base), rounded);
    base = sample();
    base.directions.pop_back();
    EXPECT_EQ(message(base),
              (folder.path() / "b.ply").string() + ": cannot be written: the arrays of the base mesh differ in length");
    EXPECT_TRUE(folder.names().empty());
}

TEST(BaseMeshWriter, RefusesOtherExtensions) {
    const TemporaryFolder folder;
    for (const char* name : {"b", "b.off", "b.stl", "b.glb"}) {
        EXPECT_THROW(write_base_mesh(folder.path() / name, sample(), {}), UnwritableFile) << name;
        EXPECT_THROW(require_writable_base_mesh(folder.path() / name, false), UnwritableFile) << name;
    }
    EXPECT_NO_THROW(require_writable_base_mesh(folder.path() / "b.OBJ", false));
    EXPECT_TRUE(folder.names().empty());
}

TEST(BaseMeshWriter, WritesTheSameBytesEveryTime) {
    const TemporaryFolder folder;
    write_base_mesh(folder.path() / "a.ply", sample(), {"c"});
    write_base_mesh(folder.path() / "b.ply", sample(), {"c"});
    EXPECT_EQ(bytes_of(folder.path() / "a.ply"), bytes_of(folder.path() / "b.ply"));
}

TEST(CorrespondenceWriter, WritesOneVertexPerScanVertex) {
    const TemporaryFolder folder;
    Scan scan;
    scan.positions = {{0, 0, 0}, {1, 0, 0}};
    const Correspondence correspondence{{3, -1}, {{0.1, 0.2, 0.7}, {0, 0, 0}}, {0.1, 0}};
    const auto path = folder.path() / "c.ply";
    write_correspondence(path, scan, correspondence);
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
                               "property float y\nproperty float z\nproperty int base_face\nproperty double alpha0\n"
                               "property double alpha1\nproperty double alpha2\nproperty double t\nend_header\n";
    EXPECT_EQ(bytes_of(path).substr(0, header.size()), header);
    EXPECT_EQ(bytes_of(path).size(), header.size() + 2 * (3 * 4 + 4 + 4 * 8));
    EXPECT_EQ(read_scan(path).scan.positions, scan.positions);

    scan.float32 = false;
    scan.positions[1].x() = 0.1;
    write_correspondence(path, scan, correspondence);
    EXPECT_EQ(read_scan(path).scan.positions, scan.positions);
}

TEST(CorrespondenceWriter, RefusesArraysOfAnotherLength) {
    const TemporaryFolder folder;
    Scan scan;
    scan.positions = {{0, 0, 0}};
    EXPECT_THROW(write_correspondence(folder.path() / "c.ply", scan, {{0}, {{1, 0, 0}}, {}}), UnwritableFile);
    EXPECT_TRUE(folder.names().empty());
}

TEST(TextWriter, ReplacesTheWholeFile) {
    const TemporaryFolder folder;
    const auto path = folder.file("r.json", "something longer that was there before");
    write_text(path, "{}\n");
    EXPECT_EQ(bytes_of(path), "{}\n");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"r.json"}));
}

TEST(Staging, LeavesTheTargetAloneUntilItIsCommitted) {
    const TemporaryFolder folder;
    const auto path = folder.file("b.ply", "old");
    {
        const AtomicFile dropped = stage_base_mesh(path, sample(), {});
        EXPECT_EQ(bytes_of(path), "old");
        EXPECT_EQ(bytes_of(dropped.temporary_path()).substr(0, 4), "ply\n") << "the whole file can be read back";
    }
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"b.ply"}));
    EXPECT_EQ(bytes_of(path), "old");
    AtomicFile staged = stage_base_mesh(path, sample(), {});
    staged.commit();
    EXPECT_EQ(read_base_mesh(path).base.faces, sample().faces);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"b.ply"}));
}

} // namespace
} // namespace foldless
