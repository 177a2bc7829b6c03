/// \file
/// Edges asked by several threads before it is their turn.
#pragma once

#include <foldless/decimate/edge_asker.h>
#include <foldless/decimate/edge_queue.h>
#include <foldless/decimate/index_map.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace foldless {

/// Answers for the decimation loop, which takes edges one after the other. While it waits for one, all threads ask the
/// edges that are likely to come next; an answer is used only if nothing that it depends on has changed in between. So
/// the loop does the same whatever the number of threads, and an edge asked in vain costs time only.
class AnswersAhead {
public:
    /// As many threads as the arena has in which this is called. \pre what `state` refers to outlives this
    explicit AnswersAhead(const AskedState& state);

    /// The answer for the edge that was just taken from the queue, as of now.
    [[nodiscard]] const EdgeAnswer& answer(std::int32_t edge, EdgeQueue& queue);

    /// Must be told of every patch before it is carried out.
    void about_to_change(const Patch& patch);

    /// Must be told when faces and edges have new numbers: no answer stands.
    void forget();

private:
    struct Slot {
        std::int32_t edge = -1;
        std::uint32_t asked_at = 0; ///< as many changes before
        std::size_t effort = 0;
        EdgeAnswer answer;
    };
    [[nodiscard]] Slot* find(std::int32_t edge);
    [[nodiscard]] bool stands(const Slot& slot) const;
    void choose(std::int32_t edge, EdgeQueue& queue);
    void keep_those_apart();
    void star_of(std::int32_t edge);
    void ask_chosen();
    [[nodiscard]] std::size_t effort_of(std::int32_t edge) const;
    void ask(Slot& slot, std::size_t thread);

    AskedState state_;
    std::vector<std::optional<EdgeAsker>> askers_; ///< one per thread that has asked
    std::vector<Slot> slots_;                      ///< as many as edges are asked ahead
    std::uint32_t changes_ = 0;
    std::vector<std::uint32_t> changed_at_; ///< per base face, the number of the last change of it

    std::vector<std::int32_t> next_; ///< edges, the one that is needed first
    std::vector<Slot*> chosen_;      ///< those to be asked
    IndexMap near_;                  ///< vertices around edges
    std::vector<std::int32_t> star_; ///< vertices around one edge
};

} // namespace foldless
