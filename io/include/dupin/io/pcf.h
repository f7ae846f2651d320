#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/piping_line.h"

namespace dupin {

/// What the bores of a file are. ASME B36.10M has the outside diameters of nominal ones.
enum class BoreMeaning {
  automatic,  ///< nominal if they are names of sizes, else outside diameters; doubtful ones as most
  outside,    ///< diameters
  nominal,    ///< DN, or NPS in inches, or NPS in inches written in millimetres
};

/// A piping file as it was read.
struct PcfFile {
  PipingLine line;
  std::vector<SourceNote> notes;               ///< what bores were taken for
  std::vector<SourceNote> unknown;             ///< lines that were not understood
  std::map<std::string, std::size_t> kinds;    ///< components by their keyword
  std::map<std::string, std::size_t> skipped;  ///< records that are known not to be solids
};

/// What is said of a piping file, as it is read and as it is made into an assembly, or of a graph.
struct SourceNotes {
  std::vector<SourceNote> bores, notes, unknown;
};

/// What a piping file was made into.
struct PcfReport {
  PcfFile file;           ///< without its line
  PipingNetwork network;  ///< without its assembly
  double snap = 0, bridge = 0;
  bool is_strict = false;  ///< lines that were not understood are findings

  /// Components left out, ends that belong together and do not meet, and what is not understood
  /// if that is to count.
  [[nodiscard]] std::size_t findings() const;
};

/// Whether the file's extension, in any case, is ".pcf".
[[nodiscard]] bool is_pcf_file(const std::filesystem::path& file);

/// Whether the text has a line of units, as every piping file, and is no JSON. O(n).
[[nodiscard]] bool is_pcf_text(std::string_view text);

/// A Piping Component File of ISOGEN; docs/pcf.md says what is read of it and how. Lengths become
/// millimetres. `source` names the text in messages.
///
/// Throws Error{parse_failed} with "source:line" for numbers that are none or out of range and for
/// units that are missing or unknown. O(n log n).
[[nodiscard]] PcfFile parse_pcf(std::string_view text, const std::string& source = {},
                                BoreMeaning bores = BoreMeaning::automatic);

/// Gives each component that has no wall the one of its thickest end in a schedule of ASME B36.10M,
/// "40" or "STD", and notes sizes that are not made so, which keep none. Throws
/// Error{invalid_argument} for other schedules, and if no component has a size that is made in it.
/// O(n).
void give_walls(PcfFile& file, const std::string& schedule);

}  // namespace dupin
