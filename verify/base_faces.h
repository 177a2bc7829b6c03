/// \file
/// The base mesh prepared for questions: which faces represent themselves, which move, and what lies across their
/// walls.
#pragma once

#include <foldless/verify/meshes.h>

#include <foldless/predicates/sign.h>
#include <foldless/predicates/vector.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foldless::verification {

/// A base face that is displaced.
struct MovingFace {
    Triangle corners;
    std::array<std::int32_t, 3> across; ///< the moving face across the wall opposite each corner, or -1
    BaseTriangle triangle;
    Range range;                    ///< {1, -1}, which holds nothing, if the stored one is empty or not a number
    Sign jacobian = Sign::negative; ///< positive if J > 0 on the prismoid (C0)

    [[nodiscard]] bool is_fold_free() const { return jacobian == Sign::positive; }
};

/// A base face whose corners are kept and, in this cyclic order, the corners of a scan face, and whose range is [0, 0],
/// is frozen: it represents that scan face by itself, and both are taken out. All other faces are moving.
class BaseFaces {
public:
    /// Without ranges every face that can be frozen is, and the others hold nothing until set_range(). What `meshes`
    /// refers to must outlive this.
    explicit BaseFaces(const Meshes& meshes);

    [[nodiscard]] const BaseMesh& mesh() const { return meshes_.base; }
    [[nodiscard]] const Adjacency& adjacency() const { return meshes_.base_adjacency; }
    [[nodiscard]] bool constant_directions() const { return !meshes_.base.face_directions.empty(); }

    [[nodiscard]] bool is_kept(std::int32_t vertex) const { return meshes_.kept.scan_of[vertex] >= 0; }
    [[nodiscard]] bool is_moving(std::int32_t face) const { return index_[face] >= 0; }
    /// \pre is_moving(face)
    [[nodiscard]] const MovingFace& face(std::int32_t face) const { return faces_[index_[face]]; }
    [[nodiscard]] const std::vector<std::int32_t>& moving() const { return moving_; }
    [[nodiscard]] std::size_t frozen_count() const { return meshes_.base.faces.size() - moving_.size(); }
    [[nodiscard]] bool scan_face_is_frozen(std::int32_t scan_face) const { return frozen_scan_faces_[scan_face]; }

    /// Judges C0 anew. \pre is_moving(face)
    void set_range(std::int32_t face, Range range);

private:
    [[nodiscard]] MovingFace prepare(std::int32_t face) const;

    Meshes meshes_;
    std::vector<std::int32_t> index_; ///< per base face: where it is in moving_ and faces_, or -1
    std::vector<std::int32_t> moving_;
    std::vector<MovingFace> faces_;
    std::vector<bool> frozen_scan_faces_;
};

} // namespace foldless::verification
