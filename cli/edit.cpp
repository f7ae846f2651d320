#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <optional>

#include <CLI/App.hpp>

#include "commands.h"
#include "dupin/blends/edit_chain.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/edit_json.h"
#include "dupin/io/place_json.h"
#include "dupin/io/report_json.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "output.h"
#include "placement_options.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

struct EditArguments {
  std::string file, output, part, move, twist;
  bool on_locus = false;
  PlacementArguments placement;
};

/// "4=1,2,3": a sphere and numbers.
template <std::size_t kCount>
struct Change {
  std::size_t sphere = 0;
  std::array<double, kCount> values{};
};

template <class Number>
bool read_number(std::string_view& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_read = error == std::errc() && end != text.data();
  text.remove_prefix(std::size_t(end - text.data()));
  return is_read;
}

template <std::size_t kCount>
Change<kCount> change(std::string_view option, const std::string& typed, std::string_view form) {
  Change<kCount> result;
  std::string_view text = typed;
  bool is_read = read_number(text, result.sphere);
  char before = '=';
  for (double& value : result.values) {
    is_read = is_read && !text.empty() && text.front() == before;
    if (is_read) {
      text.remove_prefix(1);
      is_read = read_number(text, value) && std::isfinite(value);
    }
    before = ',';
  }
  if (!is_read || !text.empty()) {
    throw UsageError(std::string(option) + " takes " + std::string(form) + ", not '" + typed + "'");
  }
  return result;
}

std::vector<PeArc> pieces(const Assembly& assembly, std::uint32_t part) {
  const ResolvedAssembly resolved = resolve(assembly);
  const auto found = std::find_if(resolved.parts.begin(), resolved.parts.end(),
                                  [&](const ResolvedPart& p) { return p.index == part; });
  return cyclide_pieces(found->shape);
}

CyclideChainThrough edited_chain(const EditArguments& arguments, const Assembly& assembly,
                                 std::uint32_t part) {
  if (arguments.move.empty() == arguments.twist.empty()) {
    throw UsageError(
        "edit needs either --move or --twist, or else --translate, --rotate or --scale");
  }
  if (arguments.on_locus && arguments.move.empty()) {
    throw UsageError("--on-locus is for --move");
  }
  if (!arguments.move.empty()) {
    const auto [sphere, to] = change<4>("--move", arguments.move, "SPHERE=X,Y,Z,RADIUS");
    return move_sphere(assembly, part, sphere, {{to[0], to[1], to[2]}, to[3]}, arguments.on_locus);
  }
  const auto [sphere, degrees] = change<1>("--twist", arguments.twist, "SPHERE=DEGREES");
  return twist_chain(assembly, part, sphere, degrees[0] / 180 * std::numbers::pi);
}

// What differs is compared bit by bit in the document that will be written.
EditReport compared(const Assembly& before, const Assembly& after, std::uint32_t part) {
  const auto old_pieces = pieces(before, part), new_pieces = pieces(after, part);
  const auto& old_chain = std::get<CyclideChainThrough>(before.parts[part].shape);
  const auto& new_chain = std::get<CyclideChainThrough>(after.parts[part].shape);
  EditReport report;
  report.part = before.parts[part].name;
  report.pieces = new_pieces.size();
  for (std::size_t i = 0; i < report.pieces; ++i) {
    if (!(old_pieces[i] == new_pieces[i])) {
      report.changed.push_back(i);
    }
  }
  for (std::size_t i = 0; i < new_chain.spheres.size(); ++i) {
    if (!(old_chain.spheres[i] == new_chain.spheres[i])) {
      report.spheres.push_back({i, new_chain.spheres[i]});
    }
  }
  return report;
}

void print_edit(std::ostream& out, const EditReport& report) {
  print_row(out, "part", report.part);
  std::string changed;
  for (const std::size_t piece : report.changed) {
    changed += (changed.empty() ? "" : ", ") + std::to_string(piece);
  }
  print_row(out, "changed pieces",
            (changed.empty() ? "none" : changed) + " of 0 to " + std::to_string(report.pieces - 1));
  for (const auto& [sphere, value] : report.spheres) {
    print_row(out, "sphere " + std::to_string(sphere),
              place_text(value.m) + ", radius " + number(value.r));
  }
  print_row(out, "written", report.file);
}

/// Puts the whole document elsewhere.
ExitCode run_placement(const EditArguments& arguments, const CommonOptions& common) {
  if (!arguments.move.empty() || !arguments.twist.empty() || !arguments.part.empty() ||
      arguments.on_locus) {
    throw UsageError(
        "--translate, --rotate and --scale are for the whole document, not beside --move, --twist, "
        "--on-locus or --part; edit twice");
  }
  const Input input = read_input(arguments.file);
  const Unit unit = parse_assembly(input.bytes, input.name).unit;
  const PlacedDocument after =
      placed_document(input.bytes, input.name, placement(arguments.placement, unit));
  (void)resolve(parse_assembly(after.text, input.name));
  write_text(arguments.output, after.text);
  const PlacedDocumentReport report{arguments.output, unit, {after.is_exact, after.largest_move}};
  std::ostream& out = report_stream(arguments.output);
  if (common.json) {
    out << to_json(report) << '\n';
  } else if (!common.quiet) {
    print_row(out, "placed", placement_text(after.is_exact, after.largest_move, symbol(unit)));
    print_row(out, "written", report.file);
  }
  return ExitCode::ok;
}

ExitCode run_edit(const EditArguments& arguments, const CommonOptions& common) {
  refuse_tolerance("edit", common);
  if (!arguments.placement.empty()) {
    return run_placement(arguments, common);
  }
  const Input input = read_input(arguments.file);
  const Assembly before = parse_assembly(input.bytes, input.name);
  const std::uint32_t part =
      find_chain(before, arguments.part.empty() ? std::nullopt : std::optional(arguments.part));
  const std::string text =
      with_chain(input.bytes, input.name, part, edited_chain(arguments, before, part));
  EditReport report = compared(before, parse_assembly(text, input.name), part);
  report.file = arguments.output;
  write_text(arguments.output, text);
  std::ostream& out = report_stream(arguments.output);
  if (common.json) {
    out << to_json(report) << '\n';
  } else if (!common.quiet) {
    print_edit(out, report);
  }
  return ExitCode::ok;
}

}  // namespace

void add_edit(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "edit", "Change a chain of cyclides in a document, or put the document elsewhere");
  const auto arguments = std::make_shared<EditArguments>();
  command->add_option("FILE", arguments->file, "assembly document; - for standard input")
      ->type_name("")
      ->required();
  command->add_option("-o,--output", arguments->output, "new document; - for standard output")
      ->type_name("OUT")
      ->required();
  command->add_option("--part", arguments->part, "The chain's name, if there are several")
      ->type_name("NAME");
  command->add_option("--move", arguments->move, "Move or resize a sphere, counted from 0")
      ->type_name("SPHERE=X,Y,Z,RADIUS");
  command->add_flag("--on-locus", arguments->on_locus,
                    "Change two pieces only: the nearest place that these allow");
  command
      ->add_option("--twist", arguments->twist,
                   "Turn what follows a junction about the axis of its\ntangent cone")
      ->type_name("SPHERE=DEGREES");
  add_placement_options(*command, arguments->placement);
  command->footer(
      "Spheres count from 0 as in the document. Three pieces change when a junction moves (two "
      "with\n"
      "--on-locus), of a chain with kneecaps those through the sphere; all others stay the same "
      "bit\n"
      "by bit, and so does the rest of the document. Moves, turns and changes of size are for all\n"
      "of it; each number is rounded once.\n\n"
      "Examples:\n"
      "  dupin edit hook.json --move 4=1.1,2.5,0.2,0.8 -o new.json\n"
      "  dupin edit hook.json --move 6=2.1,0.9,0.1,0.97 --on-locus -o new.json\n"
      "  dupin edit plant.json --part hook --twist 6=25 -o twisted.json\n"
      "  dupin edit pump.json --rotate 0,0,1,90 --translate 1.5m,0,-20mm -o placed.json\n"
      "  dupin edit hook.json --move 4=1.1,2.5,0.2,0.8 -o - -q | dupin build - -o hook.stl");
  command->callback([arguments, command, &action] {
    arguments->placement.collect(*command);
    action = [arguments](const CommonOptions& common) { return run_edit(*arguments, common); };
  });
}

}  // namespace dupin::cli
