#include <foldless/tools/distinct_files.h>

#include <foldless/io/printable.h>
#include <foldless/tools/wrong_usage.h>

#include <fmt/format.h>

#include <new>
#include <system_error>

namespace foldless {

namespace {

/// Without memory nothing is known of a file, least of all that it is another.
void require_memory(const std::error_code& error) {
    if (error == std::errc::not_enough_memory) {
        throw std::bad_alloc();
    }
}

std::filesystem::path resolved(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(path, error);
    require_memory(error);
    std::filesystem::path found = std::filesystem::weakly_canonical(absolute, error);
    require_memory(error);
    return found;
}

/// Whether two names stand for one file, existing or not.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) {
        return true;
    }
    require_memory(error);
    const std::filesystem::path resolved_a = resolved(a);
    return !resolved_a.empty() && resolved_a == resolved(b);
}

} // namespace

void require_distinct_files(const std::vector<NamedFile>& outputs, const std::vector<NamedFile>& inputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (const auto& [name, path] : inputs) {
            if (is_same_file(outputs[i].second, path)) {
                throw WrongUsage(fmt::format("{} would overwrite {} {}", outputs[i].first, name, printable(path)));
            }
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (is_same_file(outputs[i].second, outputs[j].second)) {
                throw WrongUsage(fmt::format("{} and {} name the same file", outputs[j].first, outputs[i].first));
            }
        }
    }
}

} // namespace foldless
