/// \file
/// How often the scan covers each component of the base mesh.
#pragma once

#include <foldless/verify/association.h>
#include <foldless/verify/findings.h>
#include <foldless/verify/meshes.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace foldless::verification {

/// If every scan triangle is mapped homeomorphically (theorem B), the scan covers each component of the base mesh a
/// constant number of times (theorem C). A frozen face or a kept vertex, which has one pre-image, shows that the number
/// is one; with a trimmed border the number is not constant. A component without any of these is counted at its lowest
/// vertex: the scan triangles that hold it inside, and the scan vertices on its pillar. Not by pillars that pierce:
/// those may belong to another sheet.
class Degree {
public:
    Degree(const BaseFaces& base, const Meshes& meshes);

    /// Counts the base vertices inside one scan triangle; from any thread.
    void count(const std::vector<std::int32_t>& inside);

    /// The number of times that the component of a base face is covered is decided otherwise.
    void settle(std::int32_t face);

    /// `degree` for every component that is not covered exactly once.
    void check(const Association& association, Findings& findings) const;

private:
    struct Component {
        std::int32_t vertex; ///< the lowest
        bool is_settled = false;
    };
    const BaseFaces* base_;
    std::vector<std::int32_t> component_;  ///< per base face
    std::vector<std::int32_t> counted_as_; ///< per base vertex: the component that is counted there, or -1
    std::vector<Component> components_;
    std::unique_ptr<std::atomic<std::int32_t>[]> counts_;
};

} // namespace foldless::verification
