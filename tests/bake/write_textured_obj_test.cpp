#include <foldless/bake/write_textured_obj.h>

#include <foldless/io/read_mesh.h>

#include "../io/file_size_limit.h"
#include "../io/temporary_folder.h"
#include "textured_meshes.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace foldless {
namespace {

using Names = std::vector<std::string>;

const MtlPictures all_pictures{"colour.png", "normal.png", "maps/displacement.png"};

void write(const std::filesystem::path& path, const MadeMesh& mesh, const MtlPictures& pictures = {}) {
    std::vector<AtomicFile> files = stage_textured_obj(path, mesh.textured(), pictures, {});
    commit_all(files);
}

/// The texture coordinates of each face in a file, by the words of the format; v up.
std::vector<std::array<Eigen::Vector2d, 3>> texture_coordinates(const std::string& text) {
    std::vector<Eigen::Vector2d> values;
    std::vector<std::array<Eigen::Vector2d, 3>> faces;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "vt") {
            auto& value = values.emplace_back();
            words >> value.x() >> value.y();
        } else if (word == "f") {
            auto& corners = faces.emplace_back();
            for (Eigen::Vector2d& corner : corners) {
                words >> word;
                corner = values.at(std::stoul(word.substr(word.find('/') + 1)) - 1);
            }
        }
    }
    return faces;
}

TEST(TexturedObjWriter, WritesBothFilesAsDocumented) {
    MadeMesh mesh = square();
    mesh.base.directions[2] = {0.5, 0, 2};
    mesh.uv[1][0] = {0, 0.25};
    const TemporaryFolder folder;
    const auto path = folder.path() / "b.obj";
    std::vector<AtomicFile> files = stage_textured_obj(path, mesh.textured(), all_pictures, {"one", "two\nlines"});
    commit_all(files);
    EXPECT_EQ(folder.names(), (Names{"b.mtl", "b.obj"}));
    EXPECT_EQ(bytes_of(path), "# one\n# two lines\nmtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                              "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0.75\nvt 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0.5 0 2\nvn 0 0 1\n"
                              "usemtl base\nf 1/1/1 2/2/2 3/3/3\nf 1/4/1 3/3/3 4/5/4\n");
    EXPECT_EQ(bytes_of(folder.path() / "b.mtl"),
              "newmtl base\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd colour.png\nnorm normal.png\nmap_Bump normal.png\n"
              "disp maps/displacement.png\n");
}

TEST(TexturedObjWriter, NamesNoPictureThatIsNotThere) {
    const TemporaryFolder folder;
    write(folder.path() / "b.obj", square());
    EXPECT_EQ(bytes_of(folder.path() / "b.mtl"), "newmtl base\nKd 1 1 1\nKs 0 0 0\nillum 1\n");
}

TEST(TexturedObjWriter, IsReadBackAsTheSameBaseMesh) {
    MadeMesh mesh = cut_grid(8);
    mesh.base.positions[5] = {0.1, std::numeric_limits<double>::denorm_min(), -1e308};
    mesh.base.positions.emplace_back(1, 2, 3); // of no face
    mesh.base.directions.emplace_back(0, 0, 0);
    const TemporaryFolder folder;
    write(folder.path() / "b.OBJ", mesh, all_pictures);
    const BaseMesh read = read_base_mesh(folder.path() / "b.OBJ").base;
    EXPECT_EQ(read.positions, mesh.base.positions);
    EXPECT_EQ(read.directions, mesh.base.directions);
    EXPECT_EQ(read.faces, mesh.base.faces);
}

TEST(TexturedObjWriter, HoldsTheTextureCoordinatesOfEachCorner) {
    const MadeMesh mesh = cut_grid(8);
    const TemporaryFolder folder;
    write(folder.path() / "b.obj", mesh);
    const auto read = texture_coordinates(bytes_of(folder.path() / "b.obj"));
    ASSERT_EQ(read.size(), mesh.uv.size());
    for (std::size_t face = 0; face < read.size(); ++face) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2d& uv = mesh.uv[face][corner];
            EXPECT_EQ(read[face][corner], Eigen::Vector2d(uv.x(), 1 - uv.y()));
        }
    }
}

TEST(TexturedObjWriter, LeavesOutDirectionsThatAreNotThere) {
    MadeMesh mesh = square();
    mesh.base.directions.clear();
    const TemporaryFolder folder;
    write(folder.path() / "b.obj", mesh);
    const std::string text = bytes_of(folder.path() / "b.obj");
    EXPECT_EQ(text.find("vn"), std::string::npos);
    EXPECT_NE(text.find("f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"), std::string::npos);
    EXPECT_EQ(read_scan(folder.path() / "b.obj").scan.faces, mesh.base.faces);
}

std::string refusal(const std::string& name, const MadeMesh& mesh, const MtlPictures& pictures = {}) {
    const TemporaryFolder folder;
    const auto path = folder.path() / name;
    const std::string message = message_of<UnwritableFile>([&] { write(path, mesh, pictures); });
    EXPECT_TRUE(folder.names().empty());
    const std::string start = path.string() + ": cannot be written: ";
    return message.starts_with(start) ? message.substr(start.size()) : message;
}

TEST(TexturedObjWriter, RefusesNamesThatReadersTakeForSomethingElse) {
    const auto reason = [](const std::string& name) {
        return "the name \"" + name + "\" cannot stand in OBJ and MTL files, where blanks and some signs end it";
    };
    EXPECT_EQ(refusal("my base.obj", square()), reason("my base.mtl"));
    EXPECT_EQ(refusal("#1.obj", square()), reason("#1.mtl"));
    for (const char* name : {"", "a b.png", "-bm", "a\\b", "a#b", "\"a\""}) {
        EXPECT_EQ(refusal("b.obj", square(), {name, {}, {}}), reason(name));
        EXPECT_EQ(refusal("b.obj", square(), {{}, name, {}}), reason(name));
        EXPECT_EQ(refusal("b.obj", square(), {{}, {}, name}), reason(name));
    }
    EXPECT_EQ(refusal("b.obj", square(), {"a\nKd", {}, {}}), reason("a?Kd"));
    EXPECT_EQ(refusal("b.mtl", square()), "the name of an OBJ file ends in .obj");
}

TEST(TexturedObjWriter, TakesOtherNames) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "my folder");
    const auto path = folder.path() / "my folder" / "grün-1.2.obj";
    EXPECT_NO_THROW(write(path, square(), {"grün.png", {}, {}}));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "my folder" / "grün-1.2.mtl"));
}

TEST(TexturedObjWriter, RefusesMeshesThatItCannotHold) {
    MadeMesh mesh = square();
    mesh.uv.pop_back();
    EXPECT_EQ(refusal("b.obj", mesh), "the arrays of the textured mesh differ in length");
    mesh = square();
    mesh.base.faces[0][0] = 4;
    EXPECT_EQ(refusal("b.obj", mesh), "the base mesh has a face whose vertex is out of range");
    mesh = square();
    mesh.uv[0][0].y() = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal("b.obj", mesh), "the textured mesh has numbers that are not finite");
    mesh = square();
    mesh.base.directions.clear();
    mesh.base.face_directions.assign(2, Vec3(0, 0, 1));
    EXPECT_EQ(refusal("b.obj", mesh), "OBJ has no room for constant face directions");
}

TEST(TexturedObjWriter, LeavesTheOldFilesWhenOneCannotBeWritten) {
    const TemporaryFolder folder;
    const auto path = folder.file("b.obj", "old");
    std::filesystem::create_directory(folder.path() / "b.mtl");
    EXPECT_EQ(message_of<UnwritableFile>([&] { write(path, square()); }),
              (folder.path() / "b.mtl").string() + ": cannot be written: is a folder");
    EXPECT_EQ(bytes_of(path), "old");
    std::filesystem::remove(folder.path() / "b.mtl");
    static_cast<void>(folder.file("b.mtl", "old too"));
    {
        const FileSizeLimit full(200); // the materials have room, the mesh has not
        EXPECT_EQ(message_of<UnwritableFile>([&] { write(path, cut_grid(9)); }),
                  path.string() + ": cannot be written: File too large");
    }
    static_cast<void>(stage_textured_obj(path, square().textured(), {}, {}));
    EXPECT_EQ(bytes_of(path), "old");
    EXPECT_EQ(bytes_of(folder.path() / "b.mtl"), "old too");
    EXPECT_EQ(folder.names(), (Names{"b.mtl", "b.obj"}));
}

} // namespace
} // namespace foldless
