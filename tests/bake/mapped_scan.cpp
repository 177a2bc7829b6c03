#include "mapped_scan.h"

#include <foldless/models/make_model.h>

#include <gtest/gtest.h>

#include <utility>

namespace foldless::test {

MappedScan mapped(const Scan& scan, const BaseMesh& base) {
    VerifyOptions options;
    options.threads = 1;
    MappedSurface surface = map_surface(base, scan, options);
    EXPECT_TRUE(surface.certificate.certified());
    return {scan, base, std::move(surface.map)};
}

MappedScan decimated(const Scan& scan, DecimateOptions options) {
    options.threads = 1;
    return mapped(scan, decimate(scan, options).base);
}

MappedScan decimated_model(Shape shape, std::int64_t faces, std::size_t target) {
    DecimateOptions options;
    options.target_faces = target;
    return decimated(to_scan(make_model({shape, faces, {}})), options);
}

} // namespace foldless::test
