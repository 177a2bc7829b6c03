#include <foldless/io/material_library.h>

#include <foldless/io/numbers.h>
#include <foldless/io/text_cursor.h>

#include <algorithm>
#include <array>

namespace foldless {

namespace {

/// An option of a picture, with the values that follow it: so many words, and then so many numbers at most.
struct PictureOption {
    std::string_view name;
    int words;
    int numbers;
};

// -o, -s and -t take one to three numbers. A name that is a number is therefore not told from them; who has one may
// write ./1.
constexpr std::array<PictureOption, 13> picture_options{{
    {"-blendu", 1, 0},
    {"-blendv", 1, 0},
    {"-cc", 1, 0},
    {"-clamp", 1, 0},
    {"-imfchan", 1, 0},
    {"-type", 1, 0},
    {"-boost", 0, 1},
    {"-bm", 0, 1},
    {"-texres", 0, 1},
    {"-mm", 0, 2},
    {"-o", 0, 3},
    {"-s", 0, 3},
    {"-t", 0, 3},
}};

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return lower;
}

const PictureOption* option_of(std::string_view token) {
    const auto found = std::ranges::find(picture_options, token, &PictureOption::name);
    return found == picture_options.end() ? nullptr : &*found;
}

/// Takes the options in front of the name.
bool skip_options(TextCursor& cursor) {
    bool found = false;
    while (const PictureOption* option = option_of(cursor.peek())) {
        found = true;
        static_cast<void>(cursor.token());
        for (int i = 0; i < option->words; ++i) {
            static_cast<void>(cursor.token());
        }
        for (int i = 0; i < option->numbers && parse_double(cursor.peek()).ok(); ++i) {
            static_cast<void>(cursor.token());
        }
    }
    return found;
}

} // namespace

std::vector<Material> read_material_library(std::string_view text, const std::string& name) {
    TextCursor cursor(text, name, {.comments = true});
    std::vector<Material> materials;
    while (cursor.next_line()) {
        const std::string keyword = lower_case(cursor.token());
        if (keyword == "newmtl") {
            materials.push_back({std::string(cursor.rest_of_line()), "", false});
        } else if (keyword == "map_kd" && !materials.empty()) {
            materials.back().has_options = skip_options(cursor);
            materials.back().picture = cursor.rest_of_line();
        }
    }
    return materials;
}

} // namespace foldless
