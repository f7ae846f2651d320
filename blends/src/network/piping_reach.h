#pragma once

#include "network/piping_spans.h"

namespace dupin::network {

/// Lengthens pipes that end, joined to nothing, on or in the wall of another one until they reach
/// its axis: branches that are welded on, and taps. Noted. These, and olets, become branches of the
/// runs. O(n log n) for n spans, and
/// the spans beside each end along x.
void reach_runs(const PipingLine& line, const PipingOptions& options, PipingSpans& spans,
                LineNotes& notes);

}  // namespace dupin::network
