#pragma once

namespace dupin::cli {

/// From now on a signal that would end the program ends it with exit code 130 and leaves no file
/// that is not whole; a closed pipe and a crash end it as they always do, but leave none either.
/// Once a file has taken its place, only a second signal ends the program, and as a success: what
/// is missing is the report. Too large a file (SIGXFSZ) is an error of writing. A signal that was
/// ignored, or has a handler, stays so.
void end_on_signals();

/// It then says nothing on the way, for a process of several, one of which says why they end.
void end_without_words();

/// Whether the report has lost its reader after the file took its place.
[[nodiscard]] bool has_lost_reader();

}  // namespace dupin::cli
