#include <foldless/io/comment_line.h>

#include <algorithm>

namespace foldless {

std::string comment_line(std::string comment) {
    std::ranges::replace_if(
        comment, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return comment;
}

} // namespace foldless
