/// \file
/// foldless_bench_memory: peak memory of whole runs on models of doubling size, the scan itself included, the program
/// as it starts left out.

#include <foldless/bench/bench_models.h>
#include <foldless/bench/peak_memory.h>

#include <fmt/format.h>

#include <exception>

namespace foldless {
namespace {

struct MemoryUse {
    std::int64_t faces;
    std::size_t bytes;
};

MemoryUse measure(Shape shape, std::int64_t faces) {
    const Model model = bench_model(shape, faces); // a few bytes: the scan is made by the child
    const std::size_t idle = peak_memory_of([] {});
    const std::size_t busy = peak_memory_of(
        [&] { [[maybe_unused]] const DecimateResult result = decimate(to_scan(model), bench_options()); });
    return {model.faces(), busy - idle};
}

void print_table() {
    fmt::print("{:<14}{:>10}{:>12}{:>14}\n", "shape", "faces", "MB", "bytes/face");
    for (const Shape shape : {Shape::bumpy_sphere, Shape::torus}) {
        for (const std::int64_t faces : doubling_sizes) {
            const MemoryUse use = measure(shape, faces);
            const auto bytes = static_cast<double>(use.bytes);
            fmt::print("{:<14}{:>10}{:>12.1f}{:>14.0f}\n", name_of(shape), use.faces, bytes / 1e6,
                       bytes / static_cast<double>(use.faces));
        }
    }
}

} // namespace
} // namespace foldless

int main() {
    try {
        foldless::print_table();
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "foldless_bench_memory: {}\n", error.what());
        return 1;
    }
}
