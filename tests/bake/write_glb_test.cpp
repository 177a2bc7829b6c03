#include <foldless/bake/write_glb.h>

#include "../io/file_size_limit.h"
#include "../io/temporary_folder.h"
#include "read_glb.h"
#include "textured_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace foldless {
namespace {

using Names = std::vector<std::string>;

const GlbNotes notes{"foldless 0.1.0", std::nullopt};

std::string bytes_of_glb(const MadeMesh& mesh, const GlbPictures& pictures, const GlbNotes& said = notes) {
    const TemporaryFolder folder;
    stage_glb(folder.path() / "b.glb", mesh.textured(), pictures, said).commit();
    EXPECT_EQ(folder.names(), Names{"b.glb"});
    return bytes_of(folder.path() / "b.glb");
}

Glb written(const MadeMesh& mesh, const GlbPictures& pictures = {}, const GlbNotes& said = notes) {
    return parse_glb(bytes_of_glb(mesh, pictures, said));
}

GlbPictures both_pictures() {
    return {one_pixel_png(), one_pixel_png() + "12"}; // of different lengths, neither a multiple of four
}

template <class Vector>
std::vector<float> floats(const Vector& vector) {
    std::vector<float> rounded;
    for (const double number : vector) {
        rounded.push_back(static_cast<float>(number));
    }
    return rounded;
}

/// Whether the corners of each face have the position, direction and texture coordinates of the mesh.
void expect_corners(const Glb& glb, const MadeMesh& mesh) {
    const auto positions = attribute(glb, "POSITION");
    const auto directions = attribute(glb, "_DISPLACEMENT_DIRECTION");
    const auto normals = attribute(glb, "NORMAL");
    const auto uv = attribute(glb, "TEXCOORD_0");
    const auto corners = indices(glb);
    ASSERT_EQ(corners.size(), 3 * mesh.base.faces.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::int32_t vertex = mesh.base.faces[i / 3][i % 3];
        EXPECT_EQ(positions.at(corners[i]), floats(mesh.base.positions[vertex]));
        EXPECT_EQ(directions.at(corners[i]), floats(mesh.base.directions[vertex]));
        EXPECT_EQ(normals.at(corners[i]), floats(mesh.base.directions[vertex].normalized()));
        EXPECT_EQ(uv.at(corners[i]), floats(mesh.uv[i / 3][i % 3]));
    }
}

double length(const std::vector<float>& vector) {
    return Eigen::Vector3f(vector[0], vector[1], vector[2]).cast<double>().norm();
}

TEST(GlbWriter, HoldsWhatIsKnownOfEachCorner) {
    expect_corners(written(square()), square());
    expect_corners(written(cut_grid(9)), cut_grid(9));
    expect_corners(written(cut_grid(9), both_pictures()), cut_grid(9));
}

TEST(GlbWriter, HasOneVertexForAllThatIsEqual) {
    const Glb glb = written(cut_grid(9), both_pictures());
    std::set<std::vector<float>> different;
    const auto positions = attribute(glb, "POSITION");
    const auto uv = attribute(glb, "TEXCOORD_0");
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        std::vector<float> all = positions[vertex];
        all.insert(all.end(), uv[vertex].begin(), uv[vertex].end());
        different.insert(all);
    }
    EXPECT_EQ(different.size(), positions.size());
    EXPECT_EQ(positions.size(), 10U * 10U + 10U);
}

TEST(GlbWriter, RoundsDoublePositions) {
    MadeMesh mesh = square();
    mesh.base.float32 = false;
    mesh.base.positions[2] = {0.1, 1 + 1e-12, 1e-60};
    const Glb glb = written(mesh);
    EXPECT_EQ(attribute(glb, "POSITION").at(2), (std::vector<float>{0.1F, 1, 0}));
}

TEST(GlbWriter, KnowsTheBoundsOfThePositionsToTheLastBit) {
    MadeMesh mesh = cut_grid(4);
    mesh.base.positions.emplace_back(1000, 1000, 1000); // of no face, so not in the file
    mesh.base.directions.emplace_back(0, 0, 1);
    const Glb glb = written(mesh);
    std::vector<float> least(3, std::numeric_limits<float>::infinity());
    std::vector<float> most(3, -std::numeric_limits<float>::infinity());
    for (const auto& position : attribute(glb, "POSITION")) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], position[axis]);
            most[axis] = std::max(most[axis], position[axis]);
        }
    }
    const auto& accessor =
        glb.json["accessors"][glb.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>()];
    EXPECT_EQ(accessor["min"].get<std::vector<double>>(), std::vector<double>(least.begin(), least.end()));
    EXPECT_EQ(accessor["max"].get<std::vector<double>>(), std::vector<double>(most.begin(), most.end()));
}

TEST(GlbWriter, StartsEachPartAtAMultipleOfFourBytes) {
    const Glb glb = written(loose_triangles(1), both_pictures()); // three indices of two bytes
    std::size_t end = 0;
    for (const auto& view : glb.json["bufferViews"]) {
        const auto offset = view.value("byteOffset", std::size_t{0});
        EXPECT_EQ(offset % 4, 0U);
        EXPECT_GE(offset, end);
        EXPECT_LT(offset, end + 4);
        end = offset + view["byteLength"].get<std::size_t>();
    }
    EXPECT_EQ(glb.json["buffers"][0]["byteLength"], end);
    EXPECT_FALSE(glb.json["buffers"][0].contains("uri"));
    EXPECT_LT(glb.bytes.size(), end + 4);
}

TEST(GlbWriter, TakesLargerIndicesWhereSmallOnesDoNotDo) {
    const auto type = [](const Glb& glb) {
        return glb.json["accessors"][glb.json["meshes"][0]["primitives"][0]["indices"].get<int>()]["componentType"];
    };
    const Glb small = written(loose_triangles(21845));
    EXPECT_EQ(attribute(small, "POSITION").size(), 65535U);
    EXPECT_EQ(type(small), 5123);
    EXPECT_EQ(indices(small).back(), 65534U) << "65535 is no index of 16 bits";
    const MadeMesh mesh = loose_triangles(21846);
    const Glb large = written(mesh);
    EXPECT_EQ(type(large), 5125);
    EXPECT_EQ(indices(large).back(), 65537U);
    expect_corners(large, mesh);
}

TEST(GlbWriter, HasUnitNormalsAndTangentsWhateverTheMesh) {
    for (const MadeMesh& mesh : {square(), cut_grid(7), degenerate_mesh()}) {
        const Glb glb = written(mesh, both_pictures());
        for (const auto& normal : attribute(glb, "NORMAL")) {
            EXPECT_NEAR(length(normal), 1, 1e-6);
        }
        for (const auto& tangent : attribute(glb, "TANGENT")) {
            EXPECT_NEAR(length(tangent), 1, 1e-6);
            EXPECT_EQ(std::abs(tangent[3]), 1);
        }
    }
}

TEST(GlbWriter, KeepsDirectionsAsTheyAreStored) {
    const MadeMesh mesh = degenerate_mesh();
    const Glb glb = written(mesh);
    const auto directions = attribute(glb, "_DISPLACEMENT_DIRECTION");
    const auto corners = indices(glb);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        EXPECT_EQ(directions.at(corners[i]), floats(mesh.base.directions[mesh.base.faces[i / 3][i % 3]]));
    }
}

TEST(GlbWriter, HasNoDirectionsWhereVerticesHaveNone) {
    MadeMesh mesh = square();
    mesh.base.directions.clear();
    mesh.base.face_directions.assign(2, Vec3(0, 1, 0));
    const Glb glb = written(mesh);
    EXPECT_FALSE(glb.json["meshes"][0]["primitives"][0]["attributes"].contains("_DISPLACEMENT_DIRECTION"));
    EXPECT_EQ(attribute(glb, "NORMAL"), std::vector(4, std::vector<float>{0, 0, 1})) << "those of the faces";
}

TEST(GlbWriter, EmbedsPicturesAsTheyAre) {
    const GlbPictures pictures = both_pictures();
    const Glb glb = written(square(), pictures);
    const auto& material = glb.json["materials"].at(0);
    EXPECT_EQ(glb.json["meshes"][0]["primitives"][0]["material"], 0);
    const auto picture = [&](const nlohmann::json& texture_info) {
        const auto& texture = glb.json["textures"].at(texture_info.at("index").get<int>());
        EXPECT_EQ(glb.json["samplers"].at(texture.at("sampler").get<int>()),
                  (nlohmann::json{{"magFilter", 9729}, {"minFilter", 9729}, {"wrapS", 33071}, {"wrapT", 33071}}));
        const auto& image = glb.json["images"].at(texture.at("source").get<int>());
        EXPECT_EQ(image.at("mimeType"), "image/png");
        return view_bytes(glb, image.at("bufferView"));
    };
    EXPECT_EQ(picture(material.at("normalTexture")), *pictures.normal_png);
    EXPECT_EQ(picture(material.at("pbrMetallicRoughness").at("baseColorTexture")), *pictures.colour_png);
    EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0);
    EXPECT_EQ(material["pbrMetallicRoughness"].value("roughnessFactor", 1.0), 1) << "the default of glTF";
}

TEST(GlbWriter, HasNoMoreThanIsAskedFor) {
    const Glb plain = written(square());
    for (const char* absent : {"images", "textures", "samplers", "animations", "extensionsUsed"}) {
        EXPECT_FALSE(plain.json.contains(absent)) << absent;
    }
    EXPECT_FALSE(plain.json["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
    EXPECT_FALSE(plain.json["meshes"][0].contains("extras"));
    const Glb coloured = written(square(), {std::nullopt, one_pixel_png()});
    EXPECT_EQ(coloured.json["images"].size(), 1U);
    EXPECT_FALSE(coloured.json["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
    EXPECT_FALSE(coloured.json["materials"][0].contains("normalTexture"));
}

TEST(GlbWriter, SaysWhatItIsTold) {
    const std::string extras =
        R"({"displacement": {"file": "d.png", "scale": 0.1, "bias": -3, "many": 3000000000, "list": [1, true, "ä"]}})";
    const Glb glb = written(square(), {}, {"foldless 0.1.0", extras});
    EXPECT_EQ(glb.json["asset"], (nlohmann::json{{"generator", "foldless 0.1.0"}, {"version", "2.0"}}));
    EXPECT_EQ(glb.json["meshes"][0]["extras"], (nlohmann::json{{"foldless", nlohmann::json::parse(extras)}}));
    EXPECT_EQ(glb.json["scenes"], nlohmann::json::parse(R"([{"nodes": [0]}])"));
    EXPECT_EQ(glb.json["scene"], 0);
    EXPECT_EQ(glb.json["nodes"], nlohmann::json::parse(R"([{"mesh": 0}])"));
}

TEST(GlbWriter, WritesTheSameBytesEveryTime) {
    EXPECT_EQ(bytes_of_glb(cut_grid(5), both_pictures()), bytes_of_glb(cut_grid(5), both_pictures()));
}

std::string refusal(const MadeMesh& mesh, const GlbNotes& said = notes) {
    const TemporaryFolder folder;
    const std::string message = message_of<UnwritableFile>(
        [&] { static_cast<void>(stage_glb(folder.path() / "b.glb", mesh.textured(), {}, said)); });
    EXPECT_TRUE(folder.names().empty());
    const std::string start = (folder.path() / "b.glb").string() + ": cannot be written: ";
    return message.starts_with(start) ? message.substr(start.size()) : message;
}

TEST(GlbWriter, RefusesMeshesThatContradictThemselves) {
    MadeMesh mesh = square();
    mesh.uv.pop_back();
    EXPECT_EQ(refusal(mesh), "the arrays of the textured mesh differ in length");
    mesh = square();
    mesh.base.directions.pop_back();
    EXPECT_EQ(refusal(mesh), "the arrays of the textured mesh differ in length");
    for (const std::int32_t index : {-1, 4}) {
        mesh = square();
        mesh.base.faces[1][2] = index;
        EXPECT_EQ(refusal(mesh), "the base mesh has a face whose vertex is out of range");
    }
    EXPECT_EQ(refusal(MadeMesh()), "glTF has no meshes without faces");
}

TEST(GlbWriter, RefusesNumbersThatItHasNoPlaceFor) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double number : {nan, -std::numeric_limits<double>::infinity(), 1e39}) {
        const char* reason = number == 1e39 ? "the textured mesh has numbers beyond those of float32"
                                            : "the textured mesh has numbers that are not finite";
        MadeMesh mesh = square();
        mesh.base.positions[3].y() = number;
        EXPECT_EQ(refusal(mesh), reason);
        mesh = square();
        mesh.base.directions[3].z() = number;
        EXPECT_EQ(refusal(mesh), reason);
        mesh = square();
        mesh.uv[1][2].x() = number;
        EXPECT_EQ(refusal(mesh), reason);
    }
}

TEST(GlbWriter, RefusesExtrasThatAreNoObject) {
    for (const char* text : {"", "{", "3", "[]", "null", "{\"a\": \"\xff\"}"}) {
        EXPECT_EQ(refusal(square(), {"", text}), "what is to be said about the mesh is no JSON object") << text;
    }
}

TEST(GlbWriter, LeavesTheOldFileUntilItIsCommitted) {
    const TemporaryFolder folder;
    const auto path = folder.file("b.glb", "old");
    {
        const AtomicFile dropped = stage_glb(path, square().textured(), {}, notes);
        EXPECT_EQ(bytes_of(path), "old");
        EXPECT_NO_THROW(static_cast<void>(parse_glb(bytes_of(dropped.temporary_path())))) << "it is all there";
    }
    EXPECT_EQ(bytes_of(path), "old");
    EXPECT_EQ(folder.names(), Names{"b.glb"});
}

TEST(GlbWriter, LeavesTheOldFileWhenThereIsNoMoreRoom) {
    const TemporaryFolder folder;
    const auto path = folder.file("b.glb", "old");
    const GlbPictures pictures{std::string(std::size_t{3} << 20, 'x'), std::nullopt};
    for (const rlim_t limit : {0, 4096, 1 << 20}) {
        const FileSizeLimit full(limit);
        EXPECT_EQ(message_of<UnwritableFile>(
                      [&] { static_cast<void>(stage_glb(path, square().textured(), pictures, notes)); }),
                  path.string() + ": cannot be written: File too large");
        EXPECT_EQ(bytes_of(path), "old");
        EXPECT_EQ(folder.names(), Names{"b.glb"});
    }
}

TEST(GlbWriter, RefusesTargetsThatAreNoFiles) {
    const TemporaryFolder folder;
    EXPECT_THROW(static_cast<void>(stage_glb(folder.path(), square().textured(), {}, notes)), UnwritableFile);
    EXPECT_THROW(static_cast<void>(stage_glb(folder.path() / "x" / "b.glb", square().textured(), {}, notes)),
                 UnwritableFile);
}

} // namespace
} // namespace foldless
