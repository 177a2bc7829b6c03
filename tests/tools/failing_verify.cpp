/// \file
/// A verify() that fails, and with it map_surface(), which the same file has. It takes the place of the real one, as it
/// is linked before the library that has that.

#include <foldless/verify/surface_map.h>
#include <foldless/verify/verify.h>

#include <new>
#include <stdexcept>

namespace foldless {

namespace {

constexpr std::size_t faces_of_a_bug = 4;        // a tetrahedron
constexpr std::size_t faces_of_a_deep_bug = 8;   // an octahedron
constexpr std::size_t faces_without_memory = 20; // an icosahedron

void fail(const char* what) {
    throw std::logic_error(what);
}

void fail_where_nobody_can_catch() noexcept {
    fail("deep bug");
}

} // namespace

VerifyResult verify(const BaseMesh&, const Scan& scan, const VerifyOptions&) {
    switch (scan.faces.size()) {
    case faces_of_a_bug: fail("bug"); break;
    case faces_of_a_deep_bug: fail_where_nobody_can_catch(); break;
    case faces_without_memory: throw std::bad_alloc();
    }
    VerifyResult result;
    result.violations[static_cast<std::size_t>(Violation::orientation)] = 41;
    result.violations[static_cast<std::size_t>(Violation::border)] = 1;
    result.located = {{Violation::border, 7, -1, 9, Vec3(0.5, -1.5, 2.0)}};
    return result;
}

MappedSurface map_surface(const BaseMesh& base, const Scan& scan, const VerifyOptions& options) {
    return {verify(base, scan, options), {}};
}

} // namespace foldless
