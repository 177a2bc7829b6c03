/// \file
/// What happens when a signal ends the program.
#pragma once

namespace foldless {

/// From here on a signal that ends the program removes its temporary files first. A signal that was ignored when the
/// program started (nohup) stays ignored. Messages to a pipe that nobody reads, and files that grow beyond the limit
/// of the system, become errors of the write.
void handle_signals();

} // namespace foldless
