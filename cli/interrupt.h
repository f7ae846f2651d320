#pragma once

#include <string>

#include <sys/types.h>

namespace dupin::cli {

/// From now on a signal that would end the program ends it with exit code 130 and leaves no file
/// that is not whole; a closed pipe and a crash end it as they always do, but leave none either.
/// Once a file has taken its place, only a second signal ends the program, as a success if all that
/// is expected is in its place: what is missing is the report. Too large a file (SIGXFSZ) is an
/// error of writing. A signal that was ignored, or has a handler, stays so.
void end_on_signals();

/// A file is to be put there, which has not begun. Of a few.
void expect_file(const std::string& path);

/// What it then says on standard error, "dupin: interrupted" if not told; for programs, as JSON.
void say_on_interrupt(const std::string& text);

/// The process with this id, and all that it starts, ends before this one, which asks it to and
/// waits, where a signal ends this one. Of a few hundred at once; others end soon after.
void end_before(pid_t child);
/// It has ended.
void forget_child(pid_t child);

/// It then says nothing on the way, for a process of several, one of which says why they end.
void end_without_words();

/// Whether the report has lost its reader after the file took its place.
[[nodiscard]] bool has_lost_reader();

}  // namespace dupin::cli
