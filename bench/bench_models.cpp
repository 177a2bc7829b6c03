#include <foldless/bench/bench_models.h>

#include <foldless/models/make_model.h>

namespace foldless {

Model bench_model(Shape shape, std::int64_t faces) {
    constexpr double noise = 0.02; // mean edge lengths: the faces turn by some degrees, and none turns over
    return make_model({shape, faces, {.noise = noise}});
}

DecimateOptions bench_options() {
    DecimateOptions options;
    options.threads = 1;
    return options;
}

} // namespace foldless
