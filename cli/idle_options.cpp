#include "idle_options.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "contact_options.h"
#include "exchange_options.h"
#include "exit_code.h"
#include "solver_options.h"

namespace dupin::cli {
namespace {

/// The name of an option, and whether it is given.
using Typed = std::pair<std::string_view, bool>;

void refuse_given(std::initializer_list<Typed> options, const std::string& why) {
  for (const auto& [option, is_given] : options) {
    if (is_given) {
      throw UsageError(std::string(option) + " " + why);
    }
  }
}

void refuse_rounding(const RoundingArguments& rounding, const std::string& why) {
  refuse_given({{"--origin", !rounding.origin.empty()},
                {"--grid", !rounding.grid.empty()},
                {"--rounding-tolerance", !rounding.tolerance.empty()}},
               why);
}

void refuse_solver(const SolverArguments& solver, const std::string& why) {
  refuse_given({{"--size", !solver.size.empty()},
                {"--distance", !solver.distance.empty()},
                {"--angle", solver.angle.has_value()},
                {"--sharp", solver.sharp.has_value()}},
               why);
}

void refuse_idle_of_step(const BuildArguments& arguments) {
  const std::string triangles =
      "is for triangles, and a STEP file has smooth surfaces; leave it out, or write a mesh";
  refuse_given({{"--quality", !arguments.quality.empty()}}, triangles);
  refuse_solver(arguments.solver, triangles);
  refuse_rounding(arguments.rounding,
                  "is for the points of a mesh, and a STEP file has smooth surfaces; leave it out, "
                  "or write a mesh");
  refuse_given({{"--verify", !arguments.output.verification.empty()},
                {"--no-verify", arguments.output.no_verify}},
               "is for meshes, and a STEP file is read back and checked in any case; leave it out");
  const ContactChoice contacts = contact_choice(arguments.contacts, {});
  refuse_given({{"--contacts separate", contacts.kind == ContactChoice::Kind::separate},
                {"--contacts bridge", contacts.kind == ContactChoice::Kind::bridge}},
               "changes the solid of a mesh, and a STEP file has the surfaces as they are; refuse "
               "and report would do, or write a mesh");
}

}  // namespace

void refuse_idle_of_volume(const RoundingArguments& rounding, const OutputArguments& output) {
  refuse_rounding(rounding,
                  "is for surfaces, and the points of tetrahedra are written as they are; leave it "
                  "out, or write a surface");
  refuse_given({{"--verify full", output.verification == name(Verification::full)}},
               "is for surfaces, and tetrahedra are compared when they are read back; leave it "
               "out, or write a surface");
}

void refuse_idle_options(const BuildArguments& arguments) {
  refuse_idle_insulation(arguments.walls, arguments.region);
  if (is_step(arguments.output)) {
    refuse_idle_of_step(arguments);
  } else if (is_volume(arguments.output)) {
    refuse_idle_of_volume(arguments.rounding, arguments.output);
    refuse_given(
        {{"--quality cad", !arguments.quality.empty() && arguments.quality != kForSolvers}},
        "is for surfaces, and tetrahedra are always for solvers; leave it out, or write a "
        "surface");
  } else if (arguments.quality != kForSolvers) {
    refuse_solver(arguments.solver,
                  "is for meshes for solvers; give --quality cfd, or write tetrahedra (.msh, "
                  ".vtu)");
  }
}

}  // namespace dupin::cli
