#include "dupin/io/exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "dupin/kernel/check.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exchange/bodies.h"
#include "exchange/module_loader.h"

namespace dupin {
namespace exchange {
namespace {

constexpr std::string_view kNothingWritten = "; no STEP file was written. ";

constexpr std::string_view kUnited =
    "leave out --solids, which tries to unite it; every mesh format has the union";

void refuse_region(const Assembly& assembly, Region region) {
  if (region != Region::outer) {
    throw Error(Errc::boolean_failed,
                "solids of runs or parts alone are those of the outer region, and this is its " +
                    std::string(name(region)) + " region; no STEP file was written: ask for " +
                    "--region outer, or " + std::string(kUnited),
                {}, assembly.source);
  }
}

void refuse_fillets(const Assembly& assembly) {
  const auto fillet = std::ranges::find_if(assembly.parts, [](const Part& part) {
    return std::holds_alternative<FilletBetween>(part.shape);
  });
  if (fillet != assembly.parts.end()) {
    throw Error(
        Errc::boolean_failed,
        "solids of runs or parts alone have no fillets, and this part is one; no STEP file was "
        "written: " +
            std::string(kUnited),
        fillet->name, document_place(assembly, std::uint32_t(fillet - assembly.parts.begin())));
  }
}

// What a build makes where no region is asked for.
Region usual_region(const Assembly& assembly) {
  const bool says_wall = assembly.wall || std::ranges::any_of(assembly.parts, [](const Part& part) {
                           return part.wall.value_or(0) > 0;
                         });
  return says_wall ? Region::metal : Region::outer;
}

// Runs and parts alone are those of the outer surface, without fillets.
bool can_be_alone(const Model& model) {
  return model.operation == Operation::none && model.whole.fillets.empty();
}

std::string model_name(const Assembly& assembly) {
  const std::string stem = std::filesystem::path(assembly.source).stem().string();
  return stem.empty() || stem == "-" ? "assembly" : stem;
}

// Meshes are coarser by this than NURBS have to be: cubics come near at little cost.
constexpr double kLoftedPart = 10;

struct Made {
  Model model;
  SurfaceCount count;
};

Made model_of(const Assembly& assembly, const Built& built, const ExchangeOptions& options) {
  const double tolerance = options.tolerance.value_or(assembly.tolerance) / kLoftedPart;
  const SmoothRegion region = smooth_region(assembly, built);
  Made made;
  Labels labels;
  const bool by_part = options.solids == ExchangeSolids::parts;
  const auto bodies = [&](const ResolvedAssembly& parts) {
    BodyUnion all = bodies_of(assembly, parts, tolerance, by_part, labels, made.count);
    scale(all, millimetres(assembly.unit));
    return all;
  };
  Model& model = made.model;
  model.name = model_name(assembly);
  model.is_united = options.solids == ExchangeSolids::united;
  model.whole = bodies(region.whole);
  if (region.region != Region::outer) {
    model.operation = region.region == Region::fluid ? Operation::intersect : Operation::subtract;
    model.tools = bodies(region.inside);
    model.kept = bodies(region.kept);
  }
  model.labels = labels.coloured(options.colours, assembly.patches);
  if (!model.is_united && !can_be_alone(model)) {
    throw Error(Errc::boolean_failed,
                "solids of runs or parts alone are written of the outer region of assemblies "
                "without fillets");
  }
  return made;
}

// What a failure is about, if it names a part.
Error refusal(const Assembly& assembly, const Written& written) {
  const auto part = std::ranges::find(assembly.parts, written.at, &Part::name);
  const std::string place =
      part == assembly.parts.end()
          ? std::string()
          : document_place(assembly, std::uint32_t(part - assembly.parts.begin()));
  return Error(Errc::boolean_failed, written.fault, written.at, place);
}

// The mesh and the file both keep to the smooth surface, so that what lies between them is no
// thicker than both distances, over the larger of both areas.
void compare(const Assembly& assembly, const Built& built, ExchangeReport& report) {
  double area = 0;
  std::size_t shells = 0;
  std::int64_t euler_number = 0;
  for (const ExchangedSolid& solid : report.solids) {
    area += solid.area;
    shells += solid.shells;
    euler_number += solid.euler_number;
  }
  const double distance = mesh_error(built) + report.error_bound + report.edge_tolerance;
  report.expected_volume = built.solid.volume();
  report.volume_bound = distance * std::max(area, built.solid.area());
  const auto require = [&](std::string_view what, auto found, auto exact, bool is_same) {
    if (!is_same) {
      throw Error(Errc::boolean_failed,
                  "what OpenCASCADE unites has the " + std::string(what) + " " +
                      decimal(double(found), kMessageDigits) + ", and the exact solid has " +
                      decimal(double(exact), kMessageDigits),
                  {}, assembly.source);
    }
  };
  const Solid& exact = built.solid;
  require("number of solids", report.solids.size(), exact.components(),
          report.solids.size() == exact.components());
  require("number of shells", shells, exact.shells(), shells == exact.shells());
  require("Euler number", euler_number, exact.euler_number(), euler_number == exact.euler_number());
  require("volume", report.volume, exact.volume(),
          std::abs(report.volume - exact.volume()) <= report.volume_bound);
}

ExchangeReport report_of(const Written& written, const SurfaceCount& count, double millimetre) {
  ExchangeReport report;
  report.format = "STEP AP214";
  report.exact_surfaces = count.exact;
  report.lofted_surfaces = count.lofted;
  report.error_bound = count.error;
  report.edge_tolerance = written.tolerance / millimetre;
  for (const WrittenSolid& solid : written.solids) {
    report.solids.push_back({solid.name, solid.volume / std::pow(millimetre, 3),
                             solid.area / std::pow(millimetre, 2), solid.faces, solid.shells,
                             solid.euler_number});
    report.volume += report.solids.back().volume;
    report.faces += solid.faces;
  }
  return report;
}

// With all lengths times `factor`. Throws Error{boolean_failed} saying what is wrong, not what
// would do.
ExchangeFile attempted(const Assembly& assembly, const Built& built, const ExchangeOptions& options,
                       double factor = 1) {
  Made made = model_of(assembly, built, options);
  for (BodyUnion* bodies : {&made.model.whole, &made.model.tools, &made.model.kept}) {
    scale(*bodies, factor);
  }
  Written written = loaded_module().write_solids(made.model);
  if (!written.fault.empty()) {
    throw refusal(assembly, written);
  }
  ExchangeFile file{std::move(written.bytes),
                    report_of(written, made.count, factor * millimetres(assembly.unit))};
  if (options.solids == ExchangeSolids::united) {
    compare(assembly, built, file.report);
  }
  return file;
}

// The first that is written with all lengths times `factor`.
std::optional<ExchangeSolids> what_does(const Assembly& assembly, const Built& built,
                                        ExchangeOptions options,
                                        std::span<const ExchangeSolids> all, double factor) {
  for (const ExchangeSolids solids : all) {
    try {
      options.solids = solids;
      (void)attempted(assembly, built, options, factor);
      return solids;
    } catch (const Error& error) {
      if (error.code() != Errc::boolean_failed) {
        throw;
      }
    }
  }
  return std::nullopt;
}

// Whether it has rings so small that OpenCASCADE's tolerances may matter: only then are other
// sizes worth the time.
bool is_small(const Model& model) {
  constexpr double kSmall = 0.01;
  return std::ranges::any_of(model.whole.bodies, [](const Body& body) {
    return std::ranges::any_of(body.rings, [](const RingCurve& ring) {
      return std::min(ring.first, ring.second) < kSmall;
    });
  });
}

// What else there is, of which all was tried: what has failed is not tried again as it is.
std::string advice(const Assembly& assembly, const Built& built, const ExchangeOptions& options) {
  using enum ExchangeSolids;
  constexpr double kLarger = 1000;
  const auto option = [](ExchangeSolids solids) { return "--solids " + std::string(name(solids)); };
  std::vector<ExchangeSolids> all{runs, parts, united};
  const auto own = std::ranges::find(all, options.solids);
  std::rotate(all.begin(), own, own + 1);
  if (const auto other = what_does(assembly, built, options, std::span(all).subspan(1), 1)) {
    return option(*other) + " writes " +
           (*other == runs    ? "what shares rings each by itself"
            : *other == parts ? "each part by itself"
                              : "it") +
           ", and every mesh format has the union";
  }
  if (!is_small(model_of(assembly, built, {options.tolerance}).model)) {
    return "Every mesh format has the union";
  }
  const auto larger = what_does(assembly, built, options, all, kLarger);
  return (larger
              ? "It is too small for OpenCASCADE, whose tolerances are 1e-7 mm: with lengths 1000 "
                "times as large" +
                    std::string(assembly.unit == Unit::millimetre ? ", \"units\": \"m\"," : "") +
                    (*larger == options.solids ? "" : " and " + option(*larger)) +
                    " it is written. "
              : "") +
         "Every mesh format has the union";
}

std::string surfaces_file(const std::vector<NamedNurbs>& parts, Unit unit, bool iges) {
  std::vector<NamedSurface> all;
  for (const NamedNurbs& part : parts) {
    for (std::size_t i = 0; i < part.form.surfaces.size(); ++i) {
      const std::string number = part.form.surfaces.size() > 1 ? "." + std::to_string(i + 1) : "";
      all.push_back({part.part + number, part.form.surfaces[i]});
      scale(all.back().surface, millimetres(unit));
    }
  }
  const Written written = loaded_module().write_surfaces("surfaces", all, iges);
  if (!written.fault.empty()) {
    throw Error(Errc::boolean_failed, written.fault, written.at);
  }
  return written.bytes;
}

}  // namespace
}  // namespace exchange

std::string_view name(ExchangeSolids solids) {
  constexpr std::array<std::string_view, 3> kNames{"united", "runs", "parts"};
  return kNames.at(std::size_t(solids));
}

bool can_exchange() { return exchange::find_module() != nullptr; }

void require_exchange(const Assembly& assembly, std::optional<Region> region,
                      ExchangeSolids solids) {
  (void)exchange::loaded_module();
  if (solids == ExchangeSolids::united) {
    return;
  }
  exchange::refuse_region(assembly, region.value_or(exchange::usual_region(assembly)));
  if (!assembly.is_of_network) {  // whose build may leave fillets out
    exchange::refuse_fillets(assembly);
  }
}

ExchangeFile step_file(const Assembly& assembly, const Built& built,
                       const ExchangeOptions& options) {
  const UsualArithmetic usual;
  if (options.tolerance && !(*options.tolerance > 0 && std::isfinite(*options.tolerance))) {
    throw Error(Errc::invalid_argument, "the tolerance must be positive and finite, not " +
                                            decimal(*options.tolerance, kMessageDigits));
  }
  require_exchange(assembly, built.region, options.solids);  // else nothing need be tried
  if (options.solids != ExchangeSolids::united) {
    exchange::refuse_fillets(assembly);
  }
  try {
    return exchange::attempted(assembly, built, options);
  } catch (const Error& error) {
    if (error.code() != Errc::boolean_failed) {
      throw;
    }
    throw Error(error.code(),
                error.message() + std::string(exchange::kNothingWritten) +
                    exchange::advice(assembly, built, options),
                error.part(), error.where());
  }
}

std::string surfaces_step(const std::vector<NamedNurbs>& parts, Unit unit) {
  const UsualArithmetic usual;
  return exchange::surfaces_file(parts, unit, false);
}

std::string surfaces_iges(const std::vector<NamedNurbs>& parts, Unit unit) {
  const UsualArithmetic usual;
  return exchange::surfaces_file(parts, unit, true);
}

}  // namespace dupin
