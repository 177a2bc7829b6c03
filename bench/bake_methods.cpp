/// \file
/// foldless_bench_bake_methods: the same maps baked by both methods, in turns, in one process; a table as markdown.

#include <foldless/bake/atlas_maps.h>
#include <foldless/bench/bench_models.h>
#include <foldless/io/bounding_box.h>
#include <foldless/io/read_mesh.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace foldless;

/// The exit codes of foldless, as far as they apply.
enum Outcome : int { done = 0, internal_error = 1, wrong_usage = 2, unreadable = 3, refused = 4 };

struct Arguments {
    std::vector<std::string> models;
    int atlas = 2048;
    int rounds = 3;
};

/// A scan, its base mesh and an atlas for both methods.
struct Subject {
    Scan scan;
    BaseMesh base;
    SurfaceMap map;
    Atlas atlas;
};

Subject subject(const std::string& model, int size) {
    Subject result;
    result.scan = read_scan(model).scan;
    result.base = decimate(result.scan, bench_options()).base;
    MappedSurface mapped = map_surface(result.base, result.scan);
    if (!mapped.certificate.certified()) {
        throw std::runtime_error(model + ": its base mesh is not certified");
    }
    result.map = std::move(mapped.map);
    result.atlas = make_atlas(result.base, {size, 2});
    return result;
}

/// Maps, and the processor seconds that they took.
struct Baked {
    AtlasMaps maps;
    double seconds;
};

Baked bake(const Subject& subject, const ScanSurface& surface, BakeMethod method) {
    AtlasMapsOptions options;
    options.method = method;
    options.normal = false;
    options.threads = 1;
    const std::clock_t start = std::clock();
    AtlasMaps maps = bake_atlas(subject.base, surface, subject.map, subject.atlas, options);
    return {std::move(maps), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

/// The edges of a base mesh that belong to one face alone, and their vertices.
class Border {
public:
    explicit Border(const BaseMesh& base) : base_(base), vertices_(base.positions.size()) {
        for (const Triangle& face : base.faces) {
            for (int k = 0; k < 3; ++k) {
                edges_.emplace(face[k], face[(k + 1) % 3]);
            }
        }
        for (const auto& [from, to] : edges_) {
            if (!edges_.contains({to, from})) {
                vertices_[from] = vertices_[to] = true;
            }
        }
    }

    /// Whether a sample of the chart of a face lies on it.
    [[nodiscard]] bool has(std::size_t face, const Chart& chart, const Vec3& weights) const {
        for (int k = 0; k < 3; ++k) {
            const std::int32_t corner = base_.faces[face][(chart.corner + k) % 3];
            const std::int32_t from = base_.faces[face][(chart.corner + k + 1) % 3];
            const std::int32_t to = base_.faces[face][(chart.corner + k + 2) % 3];
            const bool on_edge = weights[k] == 0.0 && !edges_.contains({to, from});
            if (on_edge || (weights[k] == weights.sum() && vertices_[corner])) {
                return true;
            }
        }
        return false;
    }

private:
    const BaseMesh& base_;
    std::set<std::pair<std::int32_t, std::int32_t>> edges_; ///< of all faces, as they go around them
    std::vector<bool> vertices_;
};

/// Of samples that one or both methods displace.
struct Comparison {
    std::size_t missed = 0;   ///< by rays, though the inverse method displaces them
    std::size_t border = 0;   ///< of these, on a border of the base mesh
    std::size_t both = 0;     ///< displaced by both
    std::size_t apart = 0;    ///< of these, by more than `far`
    double largest = 0.0;     ///< difference of the places on the scan, in diagonals
    double sum_squares = 0.0; ///< of these differences

    static constexpr double far = 1e-6; ///< diagonals: more than float32 explains where the scan is not steep

    void add(double difference) {
        ++both;
        apart += difference > far ? 1 : 0;
        largest = std::max(largest, difference);
        sum_squares += difference * difference;
    }
    [[nodiscard]] double rms() const { return both == 0 ? 0.0 : std::sqrt(sum_squares / static_cast<double>(both)); }
};

/// What the maps hold at a texel of a sample.
struct SampleTexel {
    bool is_covered;
    Vec3 vector; ///< t d, model units

    SampleTexel(const AtlasMaps& maps, const std::array<int, 2>& texel) {
        const auto index = static_cast<std::size_t>(texel[1] * maps.mask.width + texel[0]);
        is_covered = maps.mask.values[index] == 1.0F;
        vector = Eigen::Vector3f(&maps.vector.values[3 * index]).cast<double>();
    }
};

/// Only samples inside the charts: the gutter is none of the methods' work.
Comparison compared(const Subject& subject, const AtlasMaps& inverse, const AtlasMaps& direct) {
    const double diagonal = bounding_box_diagonal(subject.scan);
    const Border border(subject.base);
    Comparison result;
    for (std::size_t face = 0; face < subject.atlas.charts.size(); ++face) {
        const Chart& chart = subject.atlas.charts[face];
        for (int j = 0; j <= chart.lattice.rows; ++j) {
            for (int i = 0; i <= chart.lattice.last_column(j); ++i) {
                const SampleTexel one(inverse, chart.texel(i, j));
                const SampleTexel other(direct, chart.texel(i, j));
                if (one.is_covered && other.is_covered) {
                    result.add((one.vector - other.vector).norm() / diagonal);
                } else if (one.is_covered) {
                    ++result.missed;
                    result.border += border.has(face, chart, chart.lattice.weights(i, j)) ? 1 : 0;
                }
            }
        }
    }
    return result;
}

void print_head() {
    fmt::print("| scan | faces | base faces | samples | inverse CPU s | direct CPU s | ratio | missed by rays | of "
               "these on a border | "
               "several places | further apart than 10^-6 | largest difference | RMS difference |\n"
               "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
}

void print_row(const std::string& model, const Arguments& arguments) {
    const Subject subject = ::subject(model, arguments.atlas);
    const std::vector<Eigen::Vector3f> no_colours;
    const ScanSurface surface(subject.scan, no_colours);
    std::vector<double> inverse_seconds;
    std::vector<double> direct_seconds;
    std::vector<double> ratios;
    Baked inverse;
    Baked direct;
    for (int round = 0; round < arguments.rounds; ++round) {
        inverse = bake(subject, surface, BakeMethod::inverse);
        direct = bake(subject, surface, BakeMethod::direct);
        inverse_seconds.push_back(inverse.seconds);
        direct_seconds.push_back(direct.seconds);
        ratios.push_back(direct.seconds / inverse.seconds);
    }
    const Comparison comparison = compared(subject, inverse.maps, direct.maps);
    fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {} | {} | {} | {} | {:.1e} | {:.1e} |\n",
               std::filesystem::path(model).stem().string(), subject.scan.faces.size(), subject.base.faces.size(),
               inverse.maps.samples, median(inverse_seconds), median(direct_seconds), median(ratios), comparison.missed,
               comparison.border, direct.maps.contested, comparison.apart, comparison.largest, comparison.rms());
    std::fflush(stdout);
}

void declare(CLI::App& app, Arguments& arguments) {
    app.name("foldless_bench_bake_methods");
    app.add_option("MODEL", arguments.models, "scans")->required();
    app.add_option("--atlas", arguments.atlas, "texels on a side (default: 2048)")->check(CLI::Range(16, 16384));
    app.add_option("--rounds", arguments.rounds, "times that both bake (default: 3)")->check(CLI::Range(1, 100));
}

/// One line, and the code that goes with it.
int complain(const std::exception& error, int code) {
    fmt::print(stderr, "foldless_bench_bake_methods: {}\n", error.what());
    return code;
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app("Scans are decimated until every edge is refused, and baked by both methods: a table as markdown.");
    try {
        declare(app, arguments);
        app.parse(argc, argv);
        print_head();
        for (const std::string& model : arguments.models) {
            print_row(model, arguments);
        }
        return done;
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? done : wrong_usage;
    } catch (const foldless::UnreadableFile& error) {
        return complain(error, unreadable);
    } catch (const foldless::RefusedMesh& error) {
        return complain(error, refused);
    } catch (const std::exception& error) {
        return complain(error, internal_error);
    }
}
