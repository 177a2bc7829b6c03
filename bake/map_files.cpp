#include <foldless/bake/map_files.h>

#include <foldless/bake/textured_mesh.h>
#include <foldless/bake/write_glb.h>
#include <foldless/bake/write_textured_obj.h>

#include <foldless/images/image_size.h>
#include <foldless/images/read_exr.h>
#include <foldless/images/read_png.h>
#include <foldless/images/write_exr.h>
#include <foldless/images/write_png.h>
#include <foldless/io/errors.h>
#include <foldless/io/file_bytes.h>
#include <foldless/io/printable.h>
#include <foldless/io/write_mesh.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace foldless {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "foldless maps";
constexpr int format_version = 1;
constexpr double vector_mid_level = 0.5; // what Blender, Maya and others take for zero

/// value = stored * scale - mid_level * scale
struct Encoding {
    double scale;
    double mid_level;

    [[nodiscard]] float encoded(float value) const {
        return static_cast<float>(static_cast<double>(value) / scale + mid_level);
    }
    [[nodiscard]] Metadata metadata() const { return {{"scale", scale}, {"midLevel", mid_level}}; }
    [[nodiscard]] Json json(const char* file) const {
        return {{"file", file}, {"scale", scale}, {"mid_level", mid_level}};
    }
};

/// From 0 to 1.
Encoding whole_range(const Image& image) {
    const auto [least, most] = std::minmax_element(image.values.begin(), image.values.end());
    const double scale = static_cast<double>(*most) - static_cast<double>(*least);
    return scale > 0.0 ? Encoding{scale, -static_cast<double>(*least) / scale}
                       : Encoding{1.0, -static_cast<double>(*least)};
}

/// From 0 to 1 with the mid-level 0.5.
Encoding around_zero(const Image& image) {
    double size = 0.0;
    for (const float value : image.values) {
        size = std::max(size, std::abs(static_cast<double>(value)));
    }
    return {size > 0.0 ? 2.0 * size : 1.0, vector_mid_level};
}

Image encoded(const Image& image, const Encoding& encoding) {
    Image result = image;
    for (float& value : result.values) {
        value = encoding.encoded(value);
    }
    return result;
}

Json chart_json(const Chart& chart) {
    return {chart.corner, chart.x, chart.y, chart.lattice.columns, chart.lattice.rows, chart.turned ? 1 : 0};
}

class Stager {
public:
    Stager(const std::filesystem::path& folder, const BakedAtlas& baked, const std::string& generator)
        : folder_(folder), baked_(baked), maps_(*baked.maps),
          generator_(generator), json_{{"format", format_name}, {"version", format_version}, {"generator", generator}} {
    }

    std::vector<AtomicFile> stage() {
        json_["atlas"] = {{"size", baked_.atlas->size}, {"gutter", baked_.atlas->gutter}};
        json_["samples"] = maps_.samples;
        json_["uncovered"] = maps_.uncovered;
        stage_displacement();
        stage_vector();
        stage_normal();
        stage_colour();
        stage_mesh();
        json_["charts"] = Json::array();
        for (const Chart& chart : baked_.atlas->charts) {
            json_["charts"].push_back(chart_json(chart));
        }
        files_.push_back(stage_text(folder_ / "maps.json", json_.dump() + '\n'));
        return std::move(files_);
    }

private:
    void stage_displacement() {
        const Encoding as_it_is{1.0, 0.0};
        files_.push_back(stage_exr(folder_ / "displacement.exr", maps_.displacement, as_it_is.metadata()));
        json_["displacement"] = as_it_is.json("displacement.exr");
        const Encoding sixteen_bits = whole_range(maps_.displacement);
        files_.push_back(stage_png(folder_ / "displacement.png", encoded(maps_.displacement, sixteen_bits), {16, {}},
                                   sixteen_bits.metadata()));
        json_["displacement_16_bits"] = sixteen_bits.json("displacement.png");
        files_.push_back(stage_png(folder_ / "mask.png", maps_.mask, {8, {}}, {}));
        json_["mask"] = {{"file", "mask.png"}};
    }

    void stage_vector() {
        if (!maps_.vector.values.empty()) {
            const Encoding encoding = around_zero(maps_.vector);
            files_.push_back(stage_exr(folder_ / "vector.exr", encoded(maps_.vector, encoding), encoding.metadata()));
            json_["vector"] = encoding.json("vector.exr");
        }
    }

    void stage_normal() {
        if (!maps_.normal.values.empty()) {
            const Encoding encoding{2.0, 0.5};
            files_.push_back(stage_png(folder_ / "normal_object.png", encoded(maps_.normal, encoding), {8, {}}, {}));
            json_["normal_object"] = encoding.json("normal_object.png");
            pictures_.normal_png = png_bytes(encoded(maps_.tangent_normal, encoding), {8, {}}, {});
            files_.push_back(stage_text(folder_ / "normal_tangent.png", *pictures_.normal_png));
            json_["normal_tangent"] = encoding.json("normal_tangent.png");
        }
    }

    void stage_colour() {
        if (!maps_.colour.values.empty()) {
            pictures_.colour_png = png_bytes(maps_.colour, {8, PngColour::srgb}, {});
            files_.push_back(stage_text(folder_ / "color.png", *pictures_.colour_png));
            json_["color"] = {{"file", "color.png"}};
        }
    }

    void stage_mesh() {
        const TexturedMesh textured{baked_.base, texture_coordinates(*baked_.atlas)};
        MtlPictures pictures;
        pictures.displacement = "displacement.png";
        if (!maps_.colour.values.empty()) {
            pictures.colour = "color.png";
        }
        if (!maps_.normal.values.empty()) {
            pictures.normal = "normal_tangent.png";
        }
        std::vector<AtomicFile> mesh = stage_textured_obj(folder_ / "base.obj", textured, pictures, {generator_});
        std::move(mesh.begin(), mesh.end(), std::back_inserter(files_));
        const GlbNotes notes{generator_, json_.dump()}; // without the charts
        files_.push_back(stage_glb(folder_ / "base.glb", textured, pictures_, notes));
        json_["mesh"] = "base.obj";
    }

    const std::filesystem::path& folder_;
    const BakedAtlas& baked_;
    const AtlasMaps& maps_;
    const std::string& generator_;
    Json json_;
    GlbPictures pictures_;
    std::vector<AtomicFile> files_;
};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
    throw UnreadableFile(fmt::format("{}: {}", printable(file), why));
}

/// A whole number from 0 to `most`.
int whole_number(const Json& json, int most) {
    if (!json.is_number_integer() || json < 0 || json > most) {
        throw std::invalid_argument(fmt::format("{} is not a whole number from 0 to {}", json.dump(), most));
    }
    return json.get<int>();
}

/// A chart whose texels, but for the gutter, lie in the picture.
Chart chart_from(const Json& json, int size) {
    std::array<int, 6> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = whole_number(json.at(i), size);
    }
    const Chart chart{numbers[0], {numbers[3], numbers[4]}, numbers[1], numbers[2], numbers[5] != 0};
    const bool is_sound = chart.corner < 3 && chart.lattice.columns >= 1 && chart.lattice.rows >= 1;
    const auto is_inside = [&](const std::array<int, 2>& texel) {
        // The interpolation looks one texel beyond the long edge.
        return texel[0] >= 0 && texel[0] < size && texel[1] >= 0 && texel[1] < size;
    };
    if (!is_sound || !is_inside({chart.x, chart.y}) ||
        !is_inside(chart.texel(chart.lattice.columns, chart.lattice.rows))) {
        throw std::invalid_argument("a chart is not in the picture");
    }
    return chart;
}

Atlas atlas_from(const Json& json, std::size_t faces) {
    if (json.at("format") != format_name || json.at("version") != format_version) {
        throw std::invalid_argument("not maps of this version of foldless");
    }
    Atlas atlas;
    atlas.size = whole_number(json.at("atlas").at("size"), static_cast<int>(longest_side));
    atlas.gutter = whole_number(json.at("atlas").at("gutter"), atlas.size);
    for (const Json& chart : json.at("charts")) {
        atlas.charts.push_back(chart_from(chart, atlas.size));
    }
    if (atlas.charts.size() != faces) {
        throw std::invalid_argument(
            fmt::format("{} charts, but the base mesh has {} faces", atlas.charts.size(), faces));
    }
    return atlas;
}

Atlas read_atlas(const std::filesystem::path& file, std::size_t faces) {
    const FileBytes bytes(file);
    try {
        return atlas_from(Json::parse(bytes.bytes()), faces);
    } catch (const Json::exception& error) {
        refuse(file, error.what());
    } catch (const std::invalid_argument& error) {
        refuse(file, error.what());
    }
}

void require_scalar(const std::filesystem::path& file, const Image& image, const Atlas& atlas) {
    if (image.width != atlas.size || image.height != atlas.size || image.channels.size() != 1) {
        refuse(file, fmt::format("not a picture of {0} x {0} texels with one channel", atlas.size));
    }
}

} // namespace

std::vector<AtomicFile> stage_maps(const std::filesystem::path& folder, const BakedAtlas& baked,
                                   const std::string& generator) {
    return Stager(folder, baked, generator).stage();
}

DisplacementMaps read_maps(const std::filesystem::path& folder, std::size_t faces) {
    DisplacementMaps maps{read_atlas(folder / "maps.json", faces), {}, {}};
    maps.displacement = read_exr(folder / "displacement.exr").image;
    require_scalar(folder / "displacement.exr", maps.displacement, maps.atlas);
    maps.mask = read_png(folder / "mask.png").image;
    require_scalar(folder / "mask.png", maps.mask, maps.atlas);
    return maps;
}

} // namespace foldless
