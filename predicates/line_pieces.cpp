#include <foldless/predicates/line_pieces.h>

namespace foldless {
namespace {

/// Whether both ends of the piece are the same point of one wall.
bool is_a_point(const LinePiece& piece) {
    return (piece.from.at.walls & piece.to.at.walls) != 0 && compare(piece.from.at.t, piece.to.at.t) == Sign::zero;
}

} // namespace

LinePieces::LinePieces(std::int32_t triangle, const PrismoidPoint& start) {
    pieces_.push_back({triangle, {start, true}, {}});
}

void LinePieces::cross(int wall, const Displacement& t, std::int32_t next, int wall_of_next) {
    pieces_.back().to = {{t, wall_bit(wall)}, false};
    pieces_.push_back({next, {{t, wall_bit(wall_of_next)}, false}, {}});
}

std::vector<LinePiece> LinePieces::end(const PrismoidPoint& at) {
    pieces_.back().to = {at, true};
    if (pieces_.size() > 1 && is_a_point(pieces_.front())) {
        pieces_.erase(pieces_.begin());
        pieces_.front().from.is_of_line = true;
    }
    if (pieces_.size() > 1 && is_a_point(pieces_.back())) {
        pieces_.pop_back();
        pieces_.back().to.is_of_line = true;
    }
    return std::move(pieces_);
}

} // namespace foldless
