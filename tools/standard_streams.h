/// \file
/// Standard output and standard error as they may be found: closed, full, or a pipe that nobody reads.
#pragma once

#include <string_view>

namespace foldless {

/// Puts something harmless in the place of a standard stream that is closed. Otherwise the next file that is opened
/// would become standard output, and messages would end up in it.
void open_closed_streams();

/// Writes a result to standard output, all of it. If nobody reads the pipe, the program ends as others do: by SIGPIPE.
/// \throws UnwritableFile
void write_result(std::string_view text);

} // namespace foldless
