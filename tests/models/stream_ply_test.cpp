#include <foldless/io/read_mesh.h>
#include <foldless/models/make_model.h>
#include <foldless/models/stream_ply.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>

namespace foldless {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

template <typename T>
T take(const std::string& bytes, std::size_t& at) {
    T value{};
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}

/// Compares every number after the header with the scan, bit for bit; the file ends with the last face.
template <typename Coordinate>
void expect_body(const std::string& bytes, const Scan& scan) {
    const std::string end = "end_header\n";
    std::size_t at = bytes.find(end) + end.size();
    ASSERT_EQ(bytes.size() - at, scan.positions.size() * 3 * sizeof(Coordinate) + scan.faces.size() * 13);
    for (const Vec3& position : scan.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(static_cast<double>(take<Coordinate>(bytes, at)), position[axis]);
        }
    }
    for (const Triangle& face : scan.faces) {
        ASSERT_EQ(take<std::uint8_t>(bytes, at), 3);
        ASSERT_EQ(take<Triangle>(bytes, at), face);
    }
}

TEST(StreamPly, WritesWhatIsInMemoryBitForBit) {
    const TemporaryFolder folder;
    for (const Shape shape : all_shapes) {
        for (const bool float32 : {true, false}) {
            const Model model = make_model({shape, 4000, {0.1, 5, float32}});
            stream_ply(folder / "scan.ply", model, {"a comment"});
            const std::string bytes = bytes_of(folder / "scan.ply");
            EXPECT_NE(bytes.find("comment a comment\n"), std::string::npos);
            EXPECT_NE(bytes.find(float32 ? "property float x\n" : "property double x\n"), std::string::npos);
            if (float32) {
                expect_body<float>(bytes, to_scan(model));
            } else {
                expect_body<double>(bytes, to_scan(model));
            }
        }
    }
}

TEST(StreamPly, ReadScanGivesItBack) {
    const TemporaryFolder folder;
    const Model model = make_model({Shape::cylinder, 4000, {0.1, 5, true}});
    stream_ply(folder / "scan.ply", model, {});
    const Scan expected = to_scan(model);
    const Scan scan = read_scan(folder / "scan.ply").scan;
    EXPECT_EQ(scan.positions, expected.positions);
    EXPECT_EQ(scan.faces, expected.faces);
    EXPECT_TRUE(scan.float32);
}

TEST(StreamPly, ChunksLeaveNoSeam) {
    const TemporaryFolder folder;
    const Model model = make_model({Shape::torus, 300'000, {}}); // some six chunks
    stream_ply(folder / "scan.ply", model, {});
    expect_body<float>(bytes_of(folder / "scan.ply"), to_scan(model));
}

TEST(StreamPly, SameSeedSameBytesOtherSeedOtherBytes) {
    const TemporaryFolder folder;
    const auto written = [&](double noise, std::uint64_t seed) {
        stream_ply(folder / "scan.ply", make_model({Shape::knot, 5000, {noise, seed, true}}), {});
        return bytes_of(folder / "scan.ply");
    };
    EXPECT_EQ(written(0.1, 1), written(0.1, 1));
    EXPECT_NE(written(0.1, 1), written(0.1, 2));
    EXPECT_NE(written(0.1, 1), written(0, 1));
    EXPECT_EQ(written(0, 1), written(0, 2));
}

TEST(StreamPly, RefusesWhatIsNoRegularFile) {
    const TemporaryFolder folder;
    const Model model = make_model({Shape::torus, 100, {}});
    std::filesystem::create_directory(folder / "scan.ply");
    EXPECT_THROW(stream_ply(folder / "scan.ply", model, {}), UnwritableFile);
    EXPECT_THROW(stream_ply(folder / "absent/scan.ply", model, {}), UnwritableFile);
    EXPECT_THROW(stream_ply("/dev/full", model, {}), UnwritableFile);
    EXPECT_EQ(folder.entries(), 1U);
}

} // namespace
} // namespace foldless
