#include <foldless/io/material_library.h>

#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

namespace foldless {
namespace {

Material only_material(const std::string& statement) {
    const std::vector<Material> materials = read_material_library("newmtl a\n" + statement, "f");
    EXPECT_EQ(materials.size(), 1U) << statement;
    return materials.at(0);
}

TEST(MaterialLibrary, NamesAPictureForEachMaterial) {
    const auto materials =
        read_material_library("# a\nnewmtl first\nKd 1 0 0\nmap_Kd a.png\n\nnewmtl bare\nmap_Bump b.png\n"
                              "newmtl last one # here\r\n\tMAP_KD c d.png\r\n",
                              "f");
    ASSERT_EQ(materials.size(), 3U);
    EXPECT_EQ(materials[0].name, "first");
    EXPECT_EQ(materials[0].picture, "a.png");
    EXPECT_EQ(materials[1].name, "bare");
    EXPECT_EQ(materials[1].picture, "");
    EXPECT_EQ(materials[2].name, "last one");
    EXPECT_EQ(materials[2].picture, "c d.png");
}

TEST(MaterialLibrary, PassesOverTheOptionsOfAPicture) {
    for (const char* options : {"-s 1 1 1", "-o 0.5", "-t 1 2", "-mm 0 1 -bm 2", "-clamp on", "-blendu off -blendv off",
                                "-imfchan l", "-boost 2 -texres 512 -type sphere -cc on", "-s 1 1 1 -o 0 0 0"}) {
        for (const char* name : {"a.png", "a b.png", "-a.png", "2 b.png x", "..\\a.png"}) {
            const bool number_first = name[0] == '2'; // it cannot be told from a number of the option
            if (number_first && std::string(options).find("1 1 1") == std::string::npos) {
                continue;
            }
            const Material material = only_material(std::string("map_Kd ") + options + " " + name);
            EXPECT_EQ(material.picture, name) << options;
            EXPECT_TRUE(material.has_options) << options;
        }
    }
    EXPECT_FALSE(only_material("map_Kd a.png -s 1 1 1").has_options);
    EXPECT_EQ(only_material("map_Kd -x 1 a.png").picture, "-x 1 a.png");
    EXPECT_EQ(only_material("map_Kd -s 1 1 1").picture, "");
    EXPECT_EQ(only_material("map_Kd").picture, "");
}

TEST(MaterialLibrary, TakesTheLastPictureOfAMaterial) {
    EXPECT_EQ(only_material("map_Kd -s 2 2 2 a.png\nmap_Kd b.png").picture, "b.png");
    EXPECT_FALSE(only_material("map_Kd -s 2 2 2 a.png\nmap_Kd b.png").has_options);
}

TEST(MaterialLibrary, HasNoMaterialsInOtherText) {
    EXPECT_TRUE(read_material_library("", "f").empty());
    EXPECT_TRUE(read_material_library("map_Kd a.png\n{\"newmtl\": 1}\n", "f").empty());
    EXPECT_EQ(message_of<UnreadableFile>([] { static_cast<void>(read_material_library("newmtl a\n\x01\n", "f")); }),
              "f: line 2: byte 0x01 is not text");
}

} // namespace
} // namespace foldless
