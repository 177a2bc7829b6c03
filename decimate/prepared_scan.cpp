#include <foldless/decimate/prepared_scan.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace foldless {

PreparedScan::PreparedScan(const Scan& scan) : scan_(&scan), topology_(scan), normals_(scan.faces.size()) {
    using Faces = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Faces(0, scan.faces.size()), [&](const Faces& faces) {
        for (std::size_t f = faces.begin(); f < faces.end(); ++f) {
            normals_[f] = CoarseNormal(ScanNormal(triangle(static_cast<std::int32_t>(f))));
        }
    });
}

} // namespace foldless
