// What the fuzzers `decimate` and `verify` make of an input, so that a failure can become a test: show_case INPUT
// The scan goes to standard output as OFF, the options to standard error.

#include "drawn_scan.h"

#include <foldless/report/option_names.h>

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>

namespace foldless::fuzz {
namespace {

void show(const Scan& scan) {
    fmt::print("OFF\n{} {} 0\n", scan.positions.size(), scan.faces.size());
    for (const Vec3& p : scan.positions) {
        fmt::print("{} {} {}\n", p.x(), p.y(), p.z());
    }
    for (const auto& [a, b, c] : scan.faces) {
        fmt::print("3 {} {} {}\n", a, b, c);
    }
}

void show(const DrawnCase& drawn) {
    const DecimateOptions& options = drawn.options;
    fmt::print(stderr, "directions {}, store {}, placement {}, boundary {}, unique {}, orientation {}, valence {}\n",
               option_name(options.directions), options.store_directions, option_name(options.placement),
               option_name(options.boundary), options.unique_among_fold_free, options.orientation_test,
               options.edge_valence_limit);
    fmt::print(stderr, "faces {}, max displacement {}, further {}, float32 {}\n", options.target_faces.value_or(0),
               options.max_displacement.value_or(-1), drawn.further, drawn.scan.float32);
    show(drawn.scan);
}

} // namespace
} // namespace foldless::fuzz

int main(int count, char** arguments) {
    if (count != 2) {
        fmt::print(stderr, "usage: show_case INPUT\n");
        return 2;
    }
    std::ifstream file(arguments[1], std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const foldless::fuzz::ByteSource source(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    foldless::fuzz::show(foldless::fuzz::DrawnCase(source));
    return 0;
}
