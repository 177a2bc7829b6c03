#include <foldless/io/write_obj.h>

#include <foldless/io/comment_line.h>

#include <fmt/format.h>

#include <iterator>

namespace foldless {

namespace {

void write_vectors(AtomicFile& file, const char* keyword, const std::vector<Vec3>& vectors) {
    fmt::memory_buffer line;
    for (const Vec3& v : vectors) {
        line.clear();
        fmt::format_to(std::back_inserter(line), "{} {} {} {}\n", keyword, v.x(), v.y(), v.z());
        file.write({line.data(), line.size()});
    }
}

void write_faces(AtomicFile& file, const BaseMesh& base) {
    const char* format = base.directions.empty() ? "f {0} {1} {2}\n" : "f {0}//{0} {1}//{1} {2}//{2}\n";
    fmt::memory_buffer line;
    for (const auto& [a, b, c] : base.faces) {
        line.clear();
        fmt::format_to(std::back_inserter(line), fmt::runtime(format), a + std::int64_t{1}, b + std::int64_t{1},
                       c + std::int64_t{1});
        file.write({line.data(), line.size()});
    }
}

} // namespace

void write_obj(AtomicFile& file, const BaseMesh& base, const std::vector<std::string>& comments) {
    for (const std::string& comment : comments) {
        file.write("# " + comment_line(comment) + "\n");
    }
    write_vectors(file, "v", base.positions);
    write_vectors(file, "vn", base.directions);
    write_faces(file, base);
}

} // namespace foldless
