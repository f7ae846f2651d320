#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "assembly/document_bounds.h"
#include "assembly/part_context.h"

namespace dupin::assembly {

/// A vector whose part across another one is, relatively, no larger than this has none but what
/// rounding made of it: a few units of 2^-53, and what the coordinates' own last digits leave.
inline constexpr double kNoDirection = 0x1p-40;

/// Throws Error{invalid_argument} with the part's name and the place of one of its keys.
[[noreturn]] void fail(const PartContext& context, std::string_view key,
                       const std::string& message);

/// Each fails if what the key says is something else.
void check_positive(const PartContext& context, double value, std::string_view key);
void check_finite(const PartContext& context, const Vec3& v, std::string_view key);

/// Fails if `what` deviates by more than the assembly's tolerance.
void check_within_tolerance(const PartContext& context, double deviation, std::string_view key,
                            const std::string& what);

/// Of a blend's end speeds, where they are given as "k" and "l".
void check_speeds(const PartContext& context, const std::optional<double>& k,
                  const std::optional<double>& l);

/// Whether a port's part ends in a right cylinder or cone, or another canal surface of its slope.
[[nodiscard]] bool is_right(const PartContext& context, const PortReference& port);

/// The ring of a port whose part ends in a right cylinder or cone, or another canal surface of its
/// slope; fails for oblique ones.
[[nodiscard]] const Ring& right_end(const PartContext& context, const PortReference& port,
                                    std::string_view key);

}  // namespace dupin::assembly
