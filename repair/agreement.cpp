#include <foldless/repair/agreement.h>

#include <foldless/io/corner.h>
#include <foldless/io/edge_table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

namespace foldless {

namespace {

constexpr std::int32_t none = -1;

/// What lies across the three sides of a face, those from corners 0, 1 and 2 to the next.
struct Sides {
    std::array<std::int32_t, 3> face{none, none, none}; ///< none unless the side has two faces
    std::array<bool, 3> agrees{};                       ///< the face across runs along the side the other way
};

std::uint32_t side_of(const Triangle& face, std::int32_t a, std::int32_t b) {
    return runs_along(face, a, b) ? place_of(face, a) : place_of(face, b);
}

std::vector<Sides> sides_of(const Scan& scan) {
    std::vector<Sides> sides(scan.faces.size());
    const EdgeTable edges(scan.faces, scan.positions.size());
    edges.for_each_edge([&](std::int32_t a, std::int32_t b, std::span<const EdgeTable::Entry> entries) {
        if (entries.size() != 2) {
            return;
        }
        const std::array<std::int32_t, 2> pair{entries[0].face, entries[1].face};
        const bool agrees = runs_along(scan.faces[pair[0]], a, b) != runs_along(scan.faces[pair[1]], a, b);
        for (std::size_t i = 0; i < 2; ++i) {
            const std::uint32_t side = side_of(scan.faces[pair[i]], a, b);
            sides[pair[i]].face[side] = pair[1 - i];
            sides[pair[i]].agrees[side] = agrees;
        }
    });
    return sides;
}

/// Decides part by part which faces are turned over.
class Turning {
public:
    explicit Turning(const Scan& scan) : sides_(sides_of(scan)), state_(scan.faces.size(), State::unknown) {
        for (std::size_t face = 0; face < state_.size(); ++face) {
            if (state_[face] == State::unknown) {
                grow(static_cast<std::int32_t>(face));
                turn_fewer();
            }
        }
    }

    [[nodiscard]] bool turned(std::size_t face) const { return state_[face] == State::turned; }

private:
    enum class State : std::uint8_t { unknown, kept, turned };

    static State opposite(State state) { return state == State::kept ? State::turned : State::kept; }

    /// Goes from face to face, first over all sides that agree: a search by the number of sides on the way that do not.
    void grow(std::int32_t seed) {
        part_.clear();
        std::deque<std::pair<std::int32_t, State>> front{{seed, State::kept}};
        while (!front.empty()) {
            const auto [face, state] = front.front();
            front.pop_front();
            if (state_[face] != State::unknown) {
                continue;
            }
            state_[face] = state;
            part_.push_back(face);
            for (std::size_t i = 0; i < 3; ++i) {
                const std::int32_t next = sides_[face].face[i];
                if (next == none || state_[next] != State::unknown) {
                    continue;
                }
                if (sides_[face].agrees[i]) {
                    front.emplace_front(next, state);
                } else {
                    front.emplace_back(next, opposite(state));
                }
            }
        }
    }

    void turn_fewer() {
        std::size_t turned_faces = 0;
        for (const std::int32_t face : part_) {
            turned_faces += state_[face] == State::turned ? 1 : 0;
        }
        if (2 * turned_faces <= part_.size()) {
            return;
        }
        for (const std::int32_t face : part_) {
            state_[face] = opposite(state_[face]);
        }
    }

    std::vector<Sides> sides_;
    std::vector<State> state_;
    std::vector<std::int32_t> part_; ///< the faces of the part at hand
};

} // namespace

void turn_faces(Scan& scan, RepairCounts& counts) {
    const Turning turning(scan);
    for (std::size_t face = 0; face < scan.faces.size(); ++face) {
        if (turning.turned(face)) {
            std::swap(scan.faces[face][1], scan.faces[face][2]);
            ++counts.turned_faces;
        }
    }
}

} // namespace foldless
