#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "dupin/io/exchange.h"
#include "output.h"

namespace CLI {
class App;
}

namespace dupin::cli {

/// Whether a file that is to be written is STEP: by --format, or else by its extension, .step or
/// .stp.
[[nodiscard]] bool is_step(const OutputArguments& arguments);

/// The extension of a path, in lower case.
[[nodiscard]] std::string lower_extension(const std::string& path);

/// Throws UsageError for an extension that is none of these: what is written would be called what
/// it is not. Names without one, such as those of devices, will do.
void refuse_other_extensions(const std::string& path, std::span<const std::string_view> known);

/// Adds --solids.
void add_solids_option(CLI::App& command, std::string& solids);

/// What becomes a solid; united, if nothing is said. Throws UsageError for what only meshes have:
/// a list of patches.
[[nodiscard]] ExchangeSolids exchange_solids(const OutputArguments& arguments,
                                             const std::string& solids);

/// Writes the file in one step, and says in the report where. Throws OutputError.
void write_exchange(ExchangeFile& file, const std::string& path);

void print_exchange(std::ostream& out, const ExchangeReport& report, const std::string& unit);

}  // namespace dupin::cli
