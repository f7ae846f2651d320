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
#include "document.h"
#include "dupin/blends/edit_chain.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/avoided_meshes.h"
#include "dupin/io/edit_json.h"
#include "dupin/io/place_json.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
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
  std::optional<double> margin;

  [[nodiscard]] double least_margin() const { return margin.value_or(kEditMargin); }
};

/// What is said before anything is read.
void refuse_contradictions(const EditArguments& arguments) {
  if (!arguments.placement.empty()) {
    if (!arguments.move.empty() || !arguments.twist.empty() || !arguments.part.empty() ||
        arguments.on_locus || arguments.margin) {
      throw UsageError(
          "--translate, --rotate and --scale are for the whole document, not beside --move, "
          "--twist, --on-locus, --part or --margin; edit twice");
    }
    return;
  }
  if (arguments.move.empty() == arguments.twist.empty()) {
    throw UsageError(
        "edit needs either --move or --twist, or else --translate, --rotate or --scale");
  }
  if (arguments.on_locus && arguments.move.empty()) {
    throw UsageError("--on-locus is for --move");
  }
  if (!(arguments.least_margin() >= 0 && arguments.least_margin() < 1)) {
    throw UsageError("--margin takes a number of at least 0 and less than 1");
  }
}

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

double at_places(double value) { return rounded(value, kPlaceDigits); }

/// "4=1.1,2.5,0.2,0.8".
std::string sphere_text(std::size_t sphere, const PeVector& at) {
  const auto text = [](double value) { return decimal(value, kPlaceDigits); };
  return std::to_string(sphere) + "=" + text(at.m.x()) + "," + text(at.m.y()) + "," +
         text(at.m.z()) + "," + text(at.r);
}

/// What was asked for, and how to go a share of the way there.
class Edit {
 public:
  Edit(const EditArguments& arguments, const Assembly& before, std::uint32_t part)
      : arguments_(arguments), before_(before), part_(part) {
    const auto& spheres = std::get<CyclideChainThrough>(before.parts[part].shape).spheres;
    if (!arguments.move.empty()) {
      const auto [sphere, to] = change<4>("--move", arguments.move, "SPHERE=X,Y,Z,RADIUS");
      sphere_ = sphere;
      to_ = {{to[0], to[1], to[2]}, to[3]};
      from_ = sphere < spheres.size() ? spheres[sphere] : to_;
    } else {
      const auto [sphere, degrees] = change<1>("--twist", arguments.twist, "SPHERE=DEGREES");
      sphere_ = sphere;
      degrees_ = degrees[0];
    }
  }

  [[nodiscard]] CyclideChainThrough whole() const { return chain(to_, degrees_); }

  /// A share of the way, at numbers as they are printed.
  [[nodiscard]] CyclideChainThrough chain_at(double share) const {
    return chain(place(share), at_places(share * degrees_));
  }

  /// "--move 4=1.1,2.5,0.2,0.8".
  [[nodiscard]] std::string option_at(double share) const {
    if (arguments_.move.empty()) {
      return "--twist " + std::to_string(sphere_) + "=" + decimal(share * degrees_, kPlaceDigits);
    }
    return "--move " + sphere_text(sphere_, place(share));
  }

  [[nodiscard]] bool is_sound(double share, bool build_all) const {
    try {
      Assembly after = before_;
      after.parts[part_].shape = share == 0 ? before_.parts[part_].shape : chain_at(share);
      check_edit(after, part_, arguments_.least_margin(), build_all);
      return true;
    } catch (const Error& error) {
      if (error.code() == Errc::cancelled) {
        throw;
      }
      return false;
    }
  }

  [[nodiscard]] std::string place_in_document() const {
    return document_place(before_, part_, "spheres/" + std::to_string(sphere_));
  }
  [[nodiscard]] std::string action() const {
    return "sphere " + std::to_string(sphere_) +
           (arguments_.move.empty() ? " cannot be turned about so far: "
                                    : " cannot be moved there: ");
  }

 private:
  [[nodiscard]] PeVector place(double share) const {
    const PeVector there = from_ + share * (to_ - from_);
    return {{at_places(there.m.x()), at_places(there.m.y()), at_places(there.m.z())},
            at_places(there.r)};
  }
  [[nodiscard]] CyclideChainThrough chain(const PeVector& to, double degrees) const {
    return arguments_.move.empty()
               ? twist_chain(before_, part_, sphere_, degrees / 180 * std::numbers::pi)
               : move_sphere(before_, part_, sphere_, to, arguments_.on_locus);
  }

  const EditArguments& arguments_;
  const Assembly& before_;
  std::uint32_t part_;
  std::size_t sphere_ = 0;
  PeVector from_, to_;
  double degrees_ = 0;
};

// How far the edit can go, found by halving; sound steps need not be all of them.
std::string farthest(const Edit& edit) {
  constexpr int kHalvings = 10, kBuilds = 8;
  if (!edit.is_sound(0, false)) {
    return "; the chain is no better as it is, see --margin";
  }
  double sound = 0, unsound = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (sound + unsound) / 2;
    (edit.is_sound(middle, false) ? sound : unsound) = middle;
  }
  // What looks sound may not build: then halving goes on, by builds.
  double built = 0;
  for (int i = 0; i < kBuilds && built < sound; ++i) {
    const double share = i == 0 ? sound : (built + unsound) / 2;
    (edit.is_sound(share, true) ? built : unsound) = share;
  }
  if (built == 0) {
    return "; no sound place was found on the way there";
  }
  return "; the farthest that was found to be sound is " + edit.option_at(built) + ", " +
         decimal(100 * built, 3) + "% of the way";
}

// Usage and numbers out of range are said as they are; what does not fit, with what would.
template <class Work>
auto or_farthest(const Edit& edit, const std::string& part, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (error.code() != Errc::infeasible_blend && error.code() != Errc::irregular_surface) {
      throw;
    }
    const std::string action =
        error.message().find(" cannot be moved there: ") == std::string::npos ? edit.action() : "";
    throw Error(error.code(),
                action + (error.part().empty() || error.part() == part ? "" : error.part() + ": ") +
                    error.message() + farthest(edit),
                part, action.empty() ? error.where() : edit.place_in_document());
  }
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

std::string turned_text(const TurnedPiece& turned) {
  std::string text = "piece " + std::to_string(turned.piece) + " turns away from sphere " +
                     std::to_string(turned.bias_sphere) + ", which asks for the other segment";
  if (!turned.remedy) {
    return text + "; no move of its junctions was found that leads there";
  }
  return text + "; --move " + sphere_text(turned.remedy->first, turned.remedy->second) +
         " would lead there";
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
  for (const TurnedPiece& turned : report.turned) {
    print_row(out, "warning", turned_text(turned));
  }
  print_row(out, "written", report.file);
}

/// Puts the whole document elsewhere.
ExitCode run_placement(const EditArguments& arguments, const CommonOptions& common) {
  const Input input = read_input(arguments.file);
  const Assembly before = parse_assembly(input.bytes, input.name);
  require_meshes_not_written(before);
  const Unit unit = before.unit;
  const PlacedDocument after = placed_document(
      input.bytes, input.name, placement(arguments.placement, std::string(symbol(unit))));
  check_placement(parse_assembly(after.text, input.name));
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
  refuse_contradictions(arguments);
  if (!arguments.placement.empty()) {
    return run_placement(arguments, common);
  }
  const Input input = read_input(arguments.file);
  const Assembly before = parse_assembly(input.bytes, input.name);
  require_meshes_not_written(before);
  const std::uint32_t part =
      find_chain(before, arguments.part.empty() ? std::nullopt : std::optional(arguments.part));
  const Edit edit(arguments, before, part);
  const std::string text = or_farthest(edit, before.parts[part].name, [&] {
    std::string written = with_chain(input.bytes, input.name, part, edit.whole());
    check_edit(parse_assembly(written, input.name), part, arguments.least_margin());
    return written;
  });
  const Assembly after = parse_assembly(text, input.name);
  EditReport report = compared(before, after, part);
  report.turned = turned_pieces(after, part, arguments.least_margin());
  report.file = arguments.output;
  // What no path has is read, or written, in the working directory.
  const auto place = [](const std::string& path) { return output_path(path) == "-" ? "" : path; };
  write_text(arguments.output,
             with_meshes_seen_from(text, place(arguments.file), place(arguments.output)));
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
  command
      ->add_option("--margin", arguments->margin,
                   "Refuse an edit that leaves a margin 1 - kappa R below this;\n1/64 unless given")
      ->type_name("NUMBER");
  command->footer(
      "Spheres count from 0 as in the document. Three pieces change when a junction moves (two "
      "with\n"
      "--on-locus), of a chain with kneecaps those through the sphere; all others stay the same "
      "bit\n"
      "by bit, and so does the rest of the document. Moves, turns and changes of size are for all\n"
      "of it; each number is rounded once. What build would refuse is not written.\n\n"
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
