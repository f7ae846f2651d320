#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "dupin/blends/resolve.h"
#include "dupin/io/exchange.h"
#include "exchange/exchange_model.h"
#include "exchange/part_faces.h"

namespace dupin::exchange {

/// Names of parts and ends, in the order of their first use.
class Labels {
 public:
  [[nodiscard]] std::uint32_t label(const std::string& name);
  /// All of them, in colours that are chosen for parts by their names, or else tell them apart, and
  /// by other names, as of meshes, where there are any.
  [[nodiscard]] std::vector<Label> coloured(const std::map<std::string, std::string>& chosen,
                                            const std::map<std::string, std::string>& others) const;

 private:
  std::map<std::string, std::uint32_t> numbers_;
  std::vector<std::string> names_;
};

/// The parts as closed surfaces: those that share rings or a hub as one, or every part (with its
/// hub) by itself. Throws Error{boolean_failed} naming a part that has surfaces that cannot be
/// written yet.
[[nodiscard]] BodyUnion bodies_of(const Assembly& assembly, const ResolvedAssembly& resolved,
                                  double tolerance, bool is_by_part, Labels& labels,
                                  SurfaceCount& count);

/// All lengths times `factor`.
void scale(BodyUnion& bodies, double factor);
void scale(NurbsSurface& surface, double factor);

}  // namespace dupin::exchange
