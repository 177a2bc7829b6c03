/// \file
/// Room for what is known during one question.
#pragma once

#include <cstddef>
#include <vector>

namespace foldless {

/// Empties a vector that is filled again and again, and gives back its room if that is much. The last patches of a
/// decimation hold much of the scan; what each part of a question takes is then not kept while others need theirs.
template <class Value>
void clear_scratch(std::vector<Value>& values) {
    constexpr std::size_t much = std::size_t{1} << 20; // bytes
    if (values.capacity() * sizeof(Value) > much) {
        values = std::vector<Value>(); // {} would assign an empty list and keep the room
    } else {
        values.clear();
    }
}

} // namespace foldless
